// SPDX-License-Identifier: Apache-2.0
#include "harness/measure/timer_certificate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

#include "harness/measure/statistics.h"
#include "harness/shader/shader.h"

namespace lamina {
namespace {

constexpr size_t multiples = 4;  // 1x, 2x, 4x, 8x
constexpr uint32_t size_px = 256;
// What the 1x pass lasts. A pass has a fixed cost too (waking threads: half a millisecond, up to three on a busy machine);
// where that shows, the work is made longer before the timer is blamed.
constexpr std::array<double, 2> one_ms = {40, 120};
constexpr int first_taps = 16, max_taps = 1 << 20;
constexpr size_t min_rounds = 5, max_rounds = 7;

// The passes and all that they need on the device, given back at the end.
class Workload {
 public:
  Workload(Backend& backend, const std::filesystem::path& shaders) : backend_(backend) {
    const Api api = backend.info().api;
    const CompiledShader vertex = compile_shader({shaders / "common/fullscreen.vert", Stage::vertex, api, {}, {shaders}});
    const CompiledShader fragment = compile_shader({shaders / "measure/work.frag", Stage::fragment, api, {}, {shaders}});
    std::vector<std::byte> texels(size_px * size_px * 4);
    std::mt19937 random(1);  // any texture without structure
    for (std::byte& texel : texels) texel = static_cast<std::byte>(random() & 255);
    source_ = backend.create_texture({"timer source", size_px, size_px, 1, Format::rgba8_unorm, false, false}, {{texels}});
    for (TextureId& target : targets_)
      target = backend.create_texture({"timer target", size_px, size_px, 1, Format::rgba8_unorm, true, false});
    for (BufferId& taps : taps_) taps = backend.create_buffer("timer taps", BufferUse::uniform, 4 * sizeof(int));
    pipeline_ = backend.create_pipeline({.name = "timer work",
                                         .stages = {{Stage::vertex, vertex.spirv}, {Stage::fragment, fragment.spirv}},
                                         .bindings = {{3, BindingKind::uniform_buffer}, {4, BindingKind::texture}},
                                         .colors = {Format::rgba8_unorm}});
  }
  ~Workload() {
    backend_.destroy(pipeline_);
    for (const BufferId taps : taps_) backend_.destroy(taps);
    for (const TextureId target : targets_) backend_.destroy(target);
    backend_.destroy(source_);
  }
  Workload(const Workload&) = delete;
  Workload& operator=(const Workload&) = delete;

  void set_base_taps(int taps) {
    for (size_t k = 0; k < multiples; ++k) {
      const std::array<int, 4> block = {taps << k, 0, 0, 0};
      backend_.write_buffer(taps_[k], std::as_bytes(std::span(block)));
    }
  }

  // Runs the passes in the order given; times come back by multiple.
  std::pair<std::vector<double>, double> run(std::span<const size_t> order) {
    std::vector<Pass> passes;
    for (const size_t k : order) {
      Pass pass;
      pass.name = "timer work";
      pass.colors = {{targets_[k], 0, Load::discard, {}}};
      Draw draw;
      draw.pipeline = pipeline_;
      draw.buffers = {{3, taps_[k], BindingKind::uniform_buffer}};
      draw.textures = {{4, source_, {Filter::linear, Wrap::repeat}}};
      draw.count = 3;
      pass.draws = {draw};
      passes.push_back(std::move(pass));
    }
    const RunTimes times = backend_.run(passes, Timing::bracketed);
    std::vector<double> by_multiple(multiples, 0);
    for (size_t i = 0; i < order.size(); ++i) by_multiple[order[i]] = times.pass_ms[i];
    return {by_multiple, times.wall_ms};
  }

 private:
  Backend& backend_;
  TextureId source_;
  PipelineId pipeline_;
  std::array<TextureId, multiples> targets_;
  std::array<BufferId, multiples> taps_;
};

// Doubles the work until it can be measured, then sets the 1x pass to last `ms_wanted`. The first run of each compiles and is
// not looked at.
void set_duration(Workload& work, double ms_wanted) {
  const std::array<size_t, 1> first = {0};
  const std::array<size_t, multiples> all = {0, 1, 2, 3};
  for (int taps = first_taps;; taps *= 2) {
    work.set_base_taps(taps);
    work.run(first);
    const double ms = std::min(work.run(first).first[0], work.run(first).first[0]);
    if (ms < ms_wanted / 4 && taps < max_taps) continue;
    if (ms > 0) work.set_base_taps(static_cast<int>(std::clamp(taps * ms_wanted / ms, 1.0, static_cast<double>(max_taps))));
    break;
  }
  work.run(all);
}

// More rounds only help a machine that is busy with other things.
TimerRow measure(Workload& work, std::mt19937& random) {
  std::vector<std::vector<double>> times_ms;
  std::vector<double> wall_ms;
  std::array<size_t, multiples> order = {0, 1, 2, 3};
  TimerRow row;
  while (times_ms.size() < max_rounds && !row.ok) {
    for (size_t i = multiples - 1; i > 0; --i) std::swap(order[i], order[random() % (i + 1)]);
    const auto [times, wall] = work.run(order);
    times_ms.push_back(times);
    wall_ms.push_back(wall);
    if (times_ms.size() >= min_rounds) row = judge_timer(times_ms, wall_ms);
  }
  return row;
}

}  // namespace

TimerRow judge_timer(const std::vector<std::vector<double>>& times_ms, const std::vector<double>& wall_ms) {
  if (times_ms.empty() || times_ms.size() != wall_ms.size())
    throw Error(ErrorKind::failed, "timer", "certificate", "no rounds were measured");
  TimerRow row;
  std::vector<double> sums_over_wall;
  std::vector<std::vector<double>> shares(multiples);
  std::vector<double> ones_ms;
  for (size_t round = 0; round < times_ms.size(); ++round) {
    const double sum = std::accumulate(times_ms[round].begin(), times_ms[round].end(), 0.0);
    ones_ms.push_back(times_ms[round][0]);
    sums_over_wall.push_back(wall_ms[round] > 0 ? sum / wall_ms[round] : 0);
    for (size_t k = 0; k < multiples; ++k) shares[k].push_back(sum > 0 ? times_ms[round][k] / sum : 0);
  }
  const double one = median(shares[0]);
  const double whole = (1 << multiples) - 1;
  bool linear = one > 0;
  double attribution = 0;
  for (size_t k = 0; k < multiples; ++k) {
    const double multiple = 1 << k, share = median(shares[k]);
    row.linearity.push_back(one > 0 ? share / (multiple * one) : 0);
    linear = linear && std::abs(row.linearity.back() - 1) <= linearity_tolerance;
    attribution = std::max(attribution, std::abs(share * whole / multiple - 1));
  }
  row.one_ms = median(ones_ms);
  row.additivity = median(sums_over_wall);
  row.attribution = attribution;
  if (!linear)
    row.reason = "time is not proportional to work";
  else if (std::abs(*row.additivity - 1) > additivity_tolerance)
    row.reason = "the passes' times do not add up to the wall time";
  row.ok = row.reason.empty();
  return row;
}

TimerRow certify_timer(Backend& backend, const std::filesystem::path& shaders) {
  Workload work(backend, shaders);
  std::mt19937 random(7);  // any seed: the orders need only differ
  TimerRow row;
  for (const double ms : one_ms) {
    set_duration(work, ms);
    row = measure(work, random);
    if (row.ok) break;
  }
  row.backend = backend.info().backend;
  return row;
}

}  // namespace lamina
