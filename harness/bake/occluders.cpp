// SPDX-License-Identifier: Apache-2.0
#include "harness/bake/occluders.h"

#include "harness/bake/occluders_embree.h"
#include "harness/core/bytes.h"
#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/scene/default_views.h"

namespace lamina {
namespace {

constexpr float bias_of_radius = 1e-4f;

}  // namespace

Occluders::Occluders(const Scene& scene) {
  auto handles = std::make_shared<Handles>("bake");
  std::string hashed;
  for (const Object& object : scene.objects) {
    if (object.mesh.indices.empty() || !object.blocks_light) continue;
    const EmbreeScene::Triangles held = handles->attach(object);
    hashed += hash_hex(bytes_of(held.positions)) + hash_hex(bytes_of(held.indices));
  }
  handles->commit();
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
