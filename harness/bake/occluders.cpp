// SPDX-License-Identifier: Apache-2.0
#include "harness/bake/occluders.h"

#include <cstring>

#include "harness/bake/occluders_embree.h"
#include "harness/core/bytes.h"
#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/scene/default_views.h"

namespace lamina {
namespace {

constexpr float bias_of_radius = 1e-4f;

}  // namespace

EmbreeTriangles attach_triangles(RTCDevice device, RTCScene scene, const Object& object, const char* stage) {
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  const size_t vertices = object.mesh.vertices.size(), triangles = object.mesh.indices.size() / 3;
  auto* positions = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), vertices));
  auto* indices = static_cast<uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t), triangles));
  if (!positions || !indices)
    throw Error(ErrorKind::failed, stage, fmt::format("object '{}'", object.name),
                "Embree has no memory left for its triangles");
  for (size_t i = 0; i < vertices; ++i) {
    const glm::vec3 world = object.world_from_object * glm::vec4(object.mesh.vertices[i].position, 1);
    std::memcpy(positions + 3 * i, &world, sizeof world);
  }
  std::memcpy(indices, object.mesh.indices.data(), 3 * triangles * sizeof(uint32_t));
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  return {{positions, 3 * vertices}, {indices, 3 * triangles}};
}

Occluders::Occluders(const Scene& scene) {
  auto handles = std::make_shared<Handles>();
  handles->device = rtcNewDevice(nullptr);
  if (!handles->device) throw Error(ErrorKind::failed, "bake", "Embree", "cannot be started");
  handles->scene = rtcNewScene(handles->device);
  // No ray slips through an edge that two triangles share.
  rtcSetSceneFlags(handles->scene, RTC_SCENE_FLAG_ROBUST);
  std::string hashed;
  for (const Object& object : scene.objects) {
    if (object.mesh.indices.empty() || !object.blocks_light) continue;
    const EmbreeTriangles held = attach_triangles(handles->device, handles->scene, object, "bake");
    hashed += hash_hex(bytes_of(held.positions)) + hash_hex(bytes_of(held.indices));
  }
  rtcCommitScene(handles->scene);
  if (const RTCError error = rtcGetDeviceError(handles->device); error != RTC_ERROR_NONE)
    throw Error(ErrorKind::failed, "bake", "Embree",
                fmt::format("cannot build its hierarchy (error {})", static_cast<int>(error)));
  handles_ = std::move(handles);
  hash_ = hash_hex(hashed);
  if (!hashed.empty()) default_bias_m_ = bias_of_radius * bounding_sphere(scene.objects).radius;
}

uint32_t Occluders::free_rays(glm::vec3 origin, const Packet& packet_rays, size_t count) const {
  alignas(32) std::array<int, packet> valid;
  RTCRay8 rays;
  for (size_t i = 0; i < packet; ++i) {
    valid[i] = i < count ? -1 : 0;
    rays.org_x[i] = origin.x;
    rays.org_y[i] = origin.y;
    rays.org_z[i] = origin.z;
    rays.dir_x[i] = packet_rays.direction[0][i];
    rays.dir_y[i] = packet_rays.direction[1][i];
    rays.dir_z[i] = packet_rays.direction[2][i];
    rays.tnear[i] = 0;
    rays.tfar[i] = packet_rays.distance_m[i];
    rays.time[i] = 0;
    rays.mask[i] = ~0u;
    rays.flags[i] = 0;
  }
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcOccluded8(valid.data(), handles_->scene, &context, &rays);
  uint32_t free = 0;
  for (size_t i = 0; i < count; ++i) free |= uint32_t{rays.tfar[i] >= 0} << i;  // blocked: minus infinity
  return free;
}

}  // namespace lamina
