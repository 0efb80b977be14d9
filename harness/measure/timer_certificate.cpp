// SPDX-License-Identifier: Apache-2.0
#include "harness/measure/timer_certificate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

#include "harness/core/stopwatch.h"
#include "harness/measure/statistics.h"
#include "harness/shader/shader.h"

namespace lamina {
namespace {

constexpr std::array<int, 5> multiples = {0, 1, 2, 4, 8};  // of the work
constexpr size_t kinds = multiples.size();
static_assert(timer_passes.size() == kinds);
constexpr int passes_a_frame = std::accumulate(timer_passes.begin(), timer_passes.end(), 0);
constexpr int whole = std::inner_product(multiples.begin(), multiples.end(), timer_passes.begin(), 0);  // of the work, in a frame
constexpr uint32_t size_px = 256;
// What the 1x pass lasts, and how many rounds are run at most. At rest passes of 12 ms tell enough, within two seconds. On a
// machine that is busy with other things a pass waits for slices of time, of some milliseconds each: longer passes and more
// rounds tell its time all the same. Measured beside builds that kept both cores busy, the quartiles of a pass of 45 ms lay 10%
// apart and those of one of 125 ms 4%.
struct Effort {
  double one_ms;
  size_t max_rounds;
};
constexpr std::array<Effort, 3> efforts = {{{12, 9}, {40, 12}, {120, 40}}};
// Greatest share of the 1x pass that the pass without work takes too: waking threads takes half a millisecond, up to three on a
// busy machine. A timer that gives every pass the same time has a share of 1.
constexpr double max_fixed_share = 0.25;
constexpr double confidence = 0.95;
constexpr int first_taps = 16, max_taps = 1 << 20;

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
    for (size_t k = 0; k < kinds; ++k) {
      const std::array<int, 4> block = {taps * multiples[k], 0, 0, 0};
      backend_.write_buffer(taps_[k], std::as_bytes(std::span(block)));
    }
  }

  // Runs the passes of the kinds given, in that order. Gives the time of all passes of each kind, and the wall time.
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
    std::vector<double> by_kind(kinds, 0);
    for (size_t i = 0; i < order.size(); ++i) by_kind[order[i]] += times.pass_ms[i];
    return {by_kind, times.wall_ms};
  }

 private:
  Backend& backend_;
  TextureId source_;
  PipelineId pipeline_;
  std::array<TextureId, kinds> targets_;
  std::array<BufferId, kinds> taps_;
};

// The kind of each pass of a frame.
std::vector<size_t> passes_in_order() {
  std::vector<size_t> order;
  for (size_t k = 0; k < kinds; ++k) order.insert(order.end(), static_cast<size_t>(timer_passes[k]), k);
  return order;
}

// Doubles the work until it can be measured, then sets the 1x pass to last `ms_wanted`. The first run of each compiles and is
// not looked at.
void set_duration(Workload& work, double ms_wanted) {
  const std::array<size_t, 1> one = {1};
  for (int taps = first_taps;; taps *= 2) {
    work.set_base_taps(taps);
    work.run(one);
    const double ms = std::min(work.run(one).first[1], work.run(one).first[1]);
    if (ms < ms_wanted / 4 && taps < max_taps) continue;
    if (ms > 0) work.set_base_taps(static_cast<int>(std::clamp(taps * ms_wanted / ms, 1.0, static_cast<double>(max_taps))));
    break;
  }
  work.run(passes_in_order());
}

// More rounds only help a machine that is busy with other things.
TimerRow measure(Workload& work, size_t max_rounds, const Stopwatch& watch, double max_s, std::mt19937& random) {
  std::vector<std::vector<double>> times_ms;
  std::vector<double> wall_ms;
  std::vector<size_t> order = passes_in_order();
  TimerRow row;
  while (times_ms.size() < max_rounds && !row.ok && (times_ms.size() < min_rounds_for_95 || watch.elapsed_s() < max_s)) {
    std::shuffle(order.begin(), order.end(), random);
    const auto [times, wall] = work.run(order);
    times_ms.push_back(times);
    wall_ms.push_back(wall);
    if (times_ms.size() >= min_rounds_for_95) row = judge_timer(times_ms, wall_ms);
  }
  return row;
}

// Of a claim that an interval makes or does not make; the worst of several is the greatest.
enum class Certainty : uint8_t { holds, open, fails };
Certainty within(const Interval& interval, double expected, double tolerance) {
  const double low = expected * (1 - tolerance), high = expected * (1 + tolerance);
  if (interval.high < low || interval.low > high) return Certainty::fails;
  return interval.coverage >= confidence && interval.low >= low && interval.high <= high ? Certainty::holds : Certainty::open;
}

}  // namespace

TimerRow judge_timer(const std::vector<std::vector<double>>& times_ms, const std::vector<double>& wall_ms) {
  if (times_ms.empty() || times_ms.size() != wall_ms.size())
    throw Error(ErrorKind::failed, "timer", "certificate", "no rounds were measured");
  std::vector<double> sums_over_wall, ones_ms;
  std::array<std::vector<double>, kinds> shares;  // of the frame's time
  for (size_t round = 0; round < times_ms.size(); ++round) {
    const double sum = std::accumulate(times_ms[round].begin(), times_ms[round].end(), 0.0);
    ones_ms.push_back(times_ms[round][1] / timer_passes[1]);
    sums_over_wall.push_back(wall_ms[round] > 0 ? sum / wall_ms[round] : 0);
    for (size_t k = 0; k < kinds; ++k) shares[k].push_back(sum > 0 ? times_ms[round][k] / sum : 0);
  }
  TimerRow row;
  row.one_ms = median(ones_ms);
  const double fixed = median(shares[0]) / timer_passes[0], per_work = (1 - passes_a_frame * fixed) / whole;
  row.fixed_share = per_work > 0 ? fixed / (fixed + per_work) : 1;
  Certainty linear = row.fixed_share <= max_fixed_share ? Certainty::holds : Certainty::fails;
  for (size_t k = 1; k < kinds; ++k) {
    const double expected = timer_passes[k] * (fixed + per_work * multiples[k]);
    const Interval share = widest_interval(shares[k], confidence);
    row.linearity.push_back(expected > 0 ? share.median / expected : 0);
    linear = std::max(linear, expected > 0 ? within(share, expected, linearity_tolerance) : Certainty::fails);
  }
  row.attribution = 0;
  for (const double linearity : row.linearity) row.attribution = std::max(*row.attribution, std::abs(linearity - 1));
  const Interval additivity = widest_interval(sums_over_wall, confidence);
  row.additivity = additivity.median;
  const Certainty adds_up = within(additivity, 1, additivity_tolerance);
  if (linear == Certainty::fails)
    row.reason = "time is not proportional to work";
  else if (adds_up == Certainty::fails)
    row.reason = "the passes' times do not add up to the wall time";
  else if (linear == Certainty::open || adds_up == Certainty::open)
    row.reason = "the machine is too busy to tell whether time is proportional to work";
  row.ok = row.reason.empty();
  return row;
}

TimerRow certify_timer(Backend& backend, const std::filesystem::path& shaders, double max_s) {
  const Stopwatch watch;
  Workload work(backend, shaders);
  std::mt19937 random(7);  // any seed: the orders need only differ
  TimerRow row;
  for (const Effort& effort : efforts) {
    set_duration(work, effort.one_ms);
    row = measure(work, effort.max_rounds, watch, max_s, random);
    if (row.ok || watch.elapsed_s() > max_s) break;
  }
  row.backend = backend.info().backend;
  return row;
}

}  // namespace lamina
