// SPDX-License-Identifier: Apache-2.0
#include "harness/measure/rounds.h"

#include <algorithm>
#include <numeric>
#include <random>

#include "harness/core/stopwatch.h"

namespace lamina {
namespace {

// Whether every ratio to a baseline is known to `precision`.
bool precise_enough(const std::vector<Arm>& arms, const std::vector<ArmSamples>& samples, double precision) {
  for (size_t i = 0; i < arms.size(); ++i) {
    if (!arms[i].baseline || *arms[i].baseline == i) continue;
    const ArmSamples& base = samples[*arms[i].baseline];
    if (!samples[i].failure.empty() || !base.failure.empty()) continue;
    const Interval ratio = ratio_interval(samples[i].frame_ms, base.frame_ms);
    if ((ratio.high - ratio.low) / 2 > precision * ratio.median) return false;
  }
  return true;
}

void run_arm(const Arm& arm, ArmSamples& samples, double& device_ms) {
  try {
    const FrameTimes times = arm.run();
    samples.pass_ms.resize(times.pass_ms.size());
    for (size_t pass = 0; pass < times.pass_ms.size(); ++pass) samples.pass_ms[pass].push_back(times.pass_ms[pass]);
    samples.frame_ms.push_back(std::accumulate(times.pass_ms.begin(), times.pass_ms.end(), 0.0));
    device_ms += samples.frame_ms.back();
  } catch (const Error& error) {
    samples = {};
    samples.failure = error.what();
  }
}

size_t fewest(const RoundOptions& options) { return std::max(options.min_rounds, min_rounds_for_95); }

double expected_round_s(const std::vector<Arm>& arms) {
  double ms = 0;
  for (const Arm& arm : arms) ms += arm.expected_ms;
  return ms / 1000;
}

}  // namespace

double part_done(double elapsed_s, double round_s, const RoundOptions& options) {
  const double all_s = std::max(options.budget_s, static_cast<double>(fewest(options)) * round_s);
  return all_s > 0 ? std::clamp(elapsed_s / all_s, 0.0, 1.0) : 1;
}

RoundsResult run_rounds(const std::vector<Arm>& arms, const RoundOptions& options,
                        const std::function<void(double)>& progress) {
  RoundsResult result;
  result.arms.resize(arms.size());
  std::vector<size_t> order(arms.size() + (options.beside ? 1 : 0));  // what is beside is the last
  std::iota(order.begin(), order.end(), size_t{0});
  std::mt19937_64 random(options.seed);
  const Stopwatch watch;
  double beside_s = 0, round_s = expected_round_s(arms);
  const auto tell = [&] {
    if (progress) progress(part_done(watch.elapsed_s() - beside_s, round_s, options));
  };
  while (result.rounds < options.max_rounds) {
    const double elapsed_s = watch.elapsed_s() - beside_s;
    if (result.rounds >= fewest(options) &&
        (elapsed_s > options.budget_s || precise_enough(arms, result.arms, options.precision)))
      break;
    if (result.rounds > 0 && options.stop && options.stop()) break;
    if (result.rounds > 0) round_s = elapsed_s / static_cast<double>(result.rounds);
    tell();
    for (size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);  // Fisher and Yates
    for (const size_t arm : order) {
      if (arm == arms.size()) {
        const Stopwatch beside;
        options.beside();
        beside_s += beside.elapsed_s();
      } else if (result.arms[arm].failure.empty()) {
        run_arm(arms[arm], result.arms[arm], result.device_ms);
        tell();
      }
    }
    ++result.rounds;
  }
  result.wall_ms = watch.elapsed_ms() - 1000 * beside_s;
  return result;
}

}  // namespace lamina
