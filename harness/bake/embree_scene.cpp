// SPDX-License-Identifier: Apache-2.0
#include "harness/bake/embree_scene.h"

#include <algorithm>
#include <limits>

#include "harness/core/error.h"
#include "harness/core/text.h"

namespace lamina {
namespace {

struct TrianglesContext {
  RTCIntersectContext embree;  // first: Embree hands back its address
  std::vector<EmbreeScene::TriangleId>* triangles;
};

// Keeps the triangle and lets the ray go on.
void keep_triangle(const RTCFilterFunctionNArguments* arguments) {
  if (arguments->valid[0] != -1) return;
  auto* context = reinterpret_cast<TrianglesContext*>(arguments->context);
  context->triangles->push_back(
      {RTCHitN_geomID(arguments->hit, arguments->N, 0), RTCHitN_primID(arguments->hit, arguments->N, 0)});
  arguments->valid[0] = 0;
}

}  // namespace

EmbreeScene::EmbreeScene(const char* named, RTCSceneFlags flags) : device(rtcNewDevice(nullptr)), stage(named) {
  if (!device) throw Error(ErrorKind::failed, stage, "Embree", "cannot be started");
  scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | flags));
}

EmbreeScene::~EmbreeScene() {
  if (scene) rtcReleaseScene(scene);
  if (device) rtcReleaseDevice(device);
}

EmbreeScene::Triangles EmbreeScene::attach(size_t vertices, size_t triangles, const std::string& subject,
                                           const std::function<void(const Triangles&)>& fill) {
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* positions = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), vertices));
  auto* indices = static_cast<uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t), triangles));
  if (!positions || !indices) throw Error(ErrorKind::failed, stage, subject, "Embree has no memory left for its triangles");
  const Triangles held{{positions, 3 * vertices}, {indices, 3 * triangles}};
  fill(held);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  return held;
}

EmbreeScene::Triangles EmbreeScene::attach(const Object& object) {
  const Mesh& mesh = object.mesh;
  return attach(mesh.vertices.size(), mesh.indices.size() / 3, fmt::format("object '{}'", object.name),
                [&](const Triangles& held) {
                  for (size_t i = 0; i < mesh.vertices.size(); ++i) {
                    const glm::vec3 world = object.world_from_object * glm::vec4(mesh.vertices[i].position, 1);
                    std::copy_n(&world.x, 3, &held.positions[3 * i]);
                  }
                  std::copy_n(mesh.indices.begin(), held.indices.size(), held.indices.begin());
                });
}

void EmbreeScene::commit() {
  rtcCommitScene(scene);
  if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE)
    throw Error(ErrorKind::failed, stage, "Embree",
                fmt::format("cannot build its hierarchy (error {})", static_cast<int>(error)));
}

RTCRayHit EmbreeScene::ray_from(glm::dvec3 origin, glm::dvec3 direction) {
  RTCRayHit ray{};
  ray.ray.org_x = static_cast<float>(origin.x), ray.ray.org_y = static_cast<float>(origin.y);
  ray.ray.org_z = static_cast<float>(origin.z);
  ray.ray.dir_x = static_cast<float>(direction.x), ray.ray.dir_y = static_cast<float>(direction.y);
  ray.ray.dir_z = static_cast<float>(direction.z);
  ray.ray.tfar = std::numeric_limits<float>::infinity();
  ray.ray.mask = ~0u;
  ray.hit.geomID = ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  return ray;
}

RTCRayHit EmbreeScene::first_hit(glm::dvec3 origin, glm::dvec3 direction, RTCFilterFunctionN filter) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.filter = filter;
  RTCRayHit ray = ray_from(origin, direction);
  rtcIntersect1(scene, &context, &ray);
  return ray;
}

std::vector<EmbreeScene::TriangleId> EmbreeScene::triangles_along(glm::dvec3 origin, glm::dvec3 direction) const {
  std::vector<TriangleId> triangles;
  TrianglesContext context;
  rtcInitIntersectContext(&context.embree);
  context.embree.filter = keep_triangle;
  context.triangles = &triangles;
  RTCRayHit ray = ray_from(origin, direction);
  rtcIntersect1(scene, &context.embree, &ray);
  std::ranges::sort(triangles);
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  return triangles;
}

}  // namespace lamina
