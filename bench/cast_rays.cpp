// SPDX-License-Identifier: Apache-2.0
// Rays a second of the bake, against Embree alone on the very same rays: made beforehand, cast by the same number of threads,
// and nothing done with what they meet. In pairs within one run; prints the median ratio with its 95% interval.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

#include "harness/bake/occluders_embree.h"
#include "harness/bake/visibility.h"
#include "harness/core/stopwatch.h"
#include "harness/manifest/library.h"
#include "harness/measure/statistics.h"

namespace {

using namespace lamina;

constexpr size_t rays = 1024, max_points = 1024, rounds = 15, grain = 16;
constexpr uint64_t seed = 1;

template <class Work>
double seconds(Work&& work) {
  const Stopwatch watch;
  work();
  return watch.elapsed_s();
}

std::vector<RTCRay8> packets_of(const Visibility& visibility, float bias_m) {
  std::vector<RTCRay8> packets;
  for (size_t p = 0; p < visibility.points(); ++p) {
    const glm::mat3 frame = visibility.frame(p);
    const glm::vec3 origin = visibility.point(p).position + visibility.point(p).normal * bias_m;
    for (size_t first = 0; first < rays; first += 8) {
      RTCRay8& packet = packets.emplace_back();
      for (size_t i = 0; i < 8; ++i) {
        const glm::vec3 d = frame * visibility.directions()[first + i];
        packet.org_x[i] = origin.x, packet.org_y[i] = origin.y, packet.org_z[i] = origin.z;
        packet.dir_x[i] = d.x, packet.dir_y[i] = d.y, packet.dir_z[i] = d.z;
        packet.tnear[i] = 0, packet.time[i] = 0;
        packet.mask[i] = ~0u, packet.flags[i] = 0;
      }
    }
  }
  return packets;
}

void cast_bare(RTCScene scene, std::vector<RTCRay8>& packets) {
  tbb::parallel_for(tbb::blocked_range<size_t>(0, packets.size(), grain * rays / 8), [&](const auto& range) {
    alignas(32) const int valid[8] = {-1, -1, -1, -1, -1, -1, -1, -1};
    for (size_t i = range.begin(); i < range.end(); ++i) {
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
      rtcOccluded8(valid, scene, &context, &packets[i]);
    }
  });
}

}  // namespace

int main(int argc, char** argv) {
  const Library library = load_library(LAMINA_SOURCE_DIR, effect_code());
  const Scene scene = load_scene(argc > 1 ? argv[1] : "terrain", library);
  const Occluders occluders(scene);
  std::vector<SurfacePoint> points = vertex_points(scene.objects.front()).points;
  // Points from all over the object.
  std::vector<SurfacePoint> some;
  for (size_t i = 0; i < std::min(max_points, points.size()); ++i)
    some.push_back(points[i * points.size() / std::min(max_points, points.size())]);
  Visibility visibility(some, rays, seed);
  std::vector<RTCRay8> packets = packets_of(visibility, occluders.default_bias_m());
  std::vector<double> ratios, ours_per_s;
  for (size_t round = 0; round <= rounds; ++round) {
    for (RTCRay8& packet : packets) std::fill(packet.tfar, packet.tfar + 8, std::numeric_limits<float>::infinity());
    double bare = 0, ours = 0;
    const auto run_bare = [&] { bare = seconds([&] { cast_bare(occluders.handles().scene, packets); }); };
    const auto run_ours = [&] {
      ours = seconds([&] { visibility.cast(occluders, occluders.default_bias_m(), [](double) {}); });
    };
    round % 2 ? (run_bare(), run_ours()) : (run_ours(), run_bare());
    if (round == 0) continue;  // warms up
    ratios.push_back(bare / ours);
    ours_per_s.push_back(static_cast<double>(some.size() * rays) / ours * 1e-6);
  }
  const Interval ratio = median_interval(ratios), speed = median_interval(ours_per_s);
  fmt::print("{}: {} rays; {:.2f} million a second [{:.2f}, {:.2f}], {:.3f} of Embree alone [{:.3f}, {:.3f}]\n", scene.name,
             some.size() * rays, speed.median, speed.low, speed.high, ratio.median, ratio.low, ratio.high);
  return 0;
}
