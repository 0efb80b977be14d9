// SPDX-License-Identifier: Apache-2.0
// lamina stress: the shaders' functions over hard inputs, on every backend, against a reference that is better than they are.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "harness/cli/commands.h"
#include "harness/core/text.h"
#include "harness/measure/timer_certificate.h"
#include "harness/stress/cap_pictures.h"
#include "harness/stress/cap_stress.h"

namespace lamina {
namespace {

constexpr size_t timing_rounds = 12;
constexpr size_t timed_inputs = 1 << 16;

struct Row {
  std::string backend, variant, set;
  size_t points = 0;
  CapErrors errors;
};

// One line a variant and backend; what an approximation loses, and what a call costs.
struct Cost {
  std::string backend, variant;
  std::optional<Interval> ns;
};

std::string input_text(const CapInput& input) { return fmt::format("{} {} {}", input.r0, input.r1, input.d); }

void write_csv(const std::filesystem::path& file, const std::vector<Row>& rows, const std::vector<Cost>& costs) {
  std::string text =
      "backend,variant,set,points,max_over,max_under,mean_absolute,rms,most_eps,most_eps_kappa,negative,nonfinite,not_zero,"
      "worst_over_r0,worst_over_r1,worst_over_d,worst_under_r0,worst_under_r1,worst_under_d,ns_per_call,ns_low,ns_high\n";
  for (const Row& row : rows) {
    const CapErrors& e = row.errors;
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", row.backend, row.variant, row.set,
                        row.points, e.max_over, e.max_under, e.mean_absolute, e.rms, e.most_eps, e.most_eps_kappa, e.negative,
                        e.nonfinite, e.not_zero, e.worst_over.r0, e.worst_over.r1, e.worst_over.d, e.worst_under.r0,
                        e.worst_under.r1, e.worst_under.d);
    const auto cost = std::find_if(costs.begin(), costs.end(),
                                   [&](const Cost& c) { return c.backend == row.backend && c.variant == row.variant; });
    text +=
        cost != costs.end() && cost->ns ? fmt::format(",{},{},{}\n", cost->ns->median, cost->ns->low, cost->ns->high) : ",,,\n";
  }
  write_file_atomically(file, text);
}

void print_set(const CapSet& set, const std::vector<Row>& rows) {
  fmt::print("\n{}: {} ({} points)\n", set.name, set.what, set.inputs.size());
  fmt::print("{:<16} {:<8} {:>9} {:>9} {:>9} {:>9} {:>10} {:>10} {:>9} {:>10}  {}\n", "variant", "backend", "max over",
             "max under", "mean", "rms", "eps", "eps kappa", "negative", "non-finite", "worst r0 r1 d");
  for (const Row& row : rows) {
    if (row.set != set.name) continue;
    const CapErrors& e = row.errors;
    fmt::print("{:<16} {:<8} {:>9.3g} {:>9.3g} {:>9.2g} {:>9.2g} {:>10.3g} {:>10.3g} {:>9} {:>10}  {}\n", row.variant,
               row.backend, e.max_over, e.max_under, e.mean_absolute, e.rms, e.most_eps, e.most_eps_kappa, e.negative,
               e.nonfinite, input_text(e.max_over > -e.max_under ? e.worst_over : e.worst_under));
  }
}

// Times every variant on the first set's inputs, as many as timed_inputs (they are repeated); nothing where the timer cannot be
// trusted.
std::vector<Cost> time_variants(Backend& backend, const std::filesystem::path& shaders,
                                const std::vector<std::string>& variants, const std::vector<CapInput>& inputs, uint64_t seed) {
  std::vector<Cost> costs;
  for (const std::string& variant : variants) costs.push_back({backend.info().backend, variant, std::nullopt});
  const TimerRow timer = certify_timer(backend, shaders);
  if (!timer.ok) {
    fmt::print(stderr, "lamina: {}: no times are given: {} (1x, 2x, 4x, 8x work took {:.3f} of linear)\n",
               backend.info().backend, timer.reason, fmt::join(timer.linearity, ", "));
    return costs;
  }
  std::vector<CapInput> repeated(timed_inputs);
  for (size_t i = 0; i < repeated.size(); ++i)
    repeated[i] = inputs[i * 7919 % inputs.size()];  // a prime: neighbours take different ways
  std::vector<std::unique_ptr<CapRunner>> runners;
  std::vector<CapRunner*> pointers;
  for (const std::string& variant : variants) {
    runners.push_back(std::make_unique<CapRunner>(backend, shaders, variant));
    runners.back()->areas(repeated);
    pointers.push_back(runners.back().get());
  }
  const std::vector<Interval> ns = nanoseconds_per_call(pointers, timing_rounds, seed);
  for (size_t i = 0; i < costs.size(); ++i) costs[i].ns = ns[i];
  return costs;
}

}  // namespace

int run_stress_caps(const StressOptions& options) {
  const std::filesystem::path shaders = home_folder() / "shaders";
  std::vector<std::string> variants = cap_variants(shaders);
  check_variant_names("stress", options.variants, variants);
  if (!options.variants.empty()) variants = options.variants;
  std::vector<CapSet> sets;
  if (!options.points.empty())
    sets.push_back(read_cap_points(options.points));
  else if (options.grid_steps > 0)
    sets.push_back(make_cap_grid(options.grid_steps));
  else
    sets = make_cap_sets(options.count, options.seed);
  make_run_folder("stress", options.out);

  std::vector<CapTruth> truths;
  for (const CapSet& set : sets) truths.push_back(truth_of(set));
  std::vector<CapSlice> slices;
  if (options.points.empty()) slices = make_cap_slices();

  std::vector<Row> rows;
  std::vector<Cost> costs;
  bool complained = false;
  for (const std::string& name : options.backends) {
    std::string failure;
    const auto backend = try_open_backend(name, {options.device, options.validation}, failure);
    if (!backend) continue;
    Progress progress(name);
    for (size_t i = 0; i < variants.size(); ++i) {
      progress.show(static_cast<double>(i) / static_cast<double>(variants.size()), variants[i]);
      CapRunner runner(*backend, shaders, variants[i]);
      for (size_t s = 0; s < sets.size(); ++s)
        rows.push_back({name, variants[i], sets[s].name, sets[s].inputs.size(),
                        judge_caps(sets[s].inputs, runner.areas(sets[s].inputs), truths[s])});
      write_cap_pictures(runner, slices, options.out / "images", fmt::format("{}-{}", variants[i], name));
    }
    const std::vector<Cost> timed = time_variants(*backend, shaders, variants, sets.front().inputs, options.seed);
    costs.insert(costs.end(), timed.begin(), timed.end());
    for (const std::string& message : backend->take_messages()) {
      fmt::print(stderr, "lamina: {}: {}\n", name, message);
      complained = true;
    }
  }
  if (rows.empty()) throw_no_backend("stress");

  fmt::print(
      "caps: the area that two spherical caps share. Errors are of the smaller cap's area; eps = 2^-23 of it; eps kappa: of "
      "the area itself, over eps times its condition number.\n");
  for (const CapSet& set : sets) print_set(set, rows);
  fmt::print("\nnanoseconds per call [95%], over {} points of '{}'\n", timed_inputs, sets.front().name);
  for (const Cost& cost : costs)
    fmt::print("{:<16} {:<8} {}\n", cost.variant, cost.backend,
               cost.ns ? fmt::format("{:>8.3g} [{:.3g}, {:.3g}]", cost.ns->median, cost.ns->low, cost.ns->high) : "       -");
  write_csv(options.out / "stress.csv", rows, costs);
  if (std::string(LAMINA_BUILD_NAME) != "release")
    fmt::print("warning: the build is '{}', not 'release': its times do not count\n", LAMINA_BUILD_NAME);
  fmt::print("\ntable: {}\n", (options.out / "stress.csv").string());
  const bool uncertified = std::any_of(costs.begin(), costs.end(), [](const Cost& cost) { return !cost.ns; });
  return complained || uncertified ? 1 : 0;
}

}  // namespace lamina
