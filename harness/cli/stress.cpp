// SPDX-License-Identifier: Apache-2.0
// lamina stress: the shaders' functions over hard inputs, on every backend, against a reference that is better than they are.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "commit.h"
#include "harness/cli/run_line.h"
#include "harness/core/text.h"
#include "harness/measure/timer_certificate.h"
#include "harness/record/function_rows.h"
#include "harness/stress/cap_bounds.h"
#include "harness/stress/cap_pictures.h"
#include "harness/stress/cap_stress.h"
#include "reports/reports.h"

namespace lamina {
namespace {

constexpr const char *cap_function = "cap_intersection", *cap_title = "the area that two spherical caps share";
constexpr size_t timing_rounds = 12;
constexpr size_t timed_inputs = 1 << 16;

struct Results {
  std::vector<FunctionRow> errors;     // of each backend, variant and set
  std::vector<FunctionTimeRow> times;  // of each backend and variant
  std::vector<TimerRow> timers;        // of each backend
  std::vector<FunctionPictureRow> pictures;
};

FunctionRow row_of(const FunctionSubject& subject, const CapSet& set, const CapErrors& e) {
  const auto point = [](const CapInput& input) { return std::array<double, 3>{input.r0, input.r1, input.d}; };
  return {.subject = subject,
          .scale = "the smaller cap's area",
          .set = set.name,
          .what = set.what,
          .points = set.inputs.size(),
          .max_over = e.max_over,
          .max_under = e.max_under,
          .mean_absolute = e.mean_absolute,
          .rms = e.rms,
          .most_eps = e.most_eps,
          .most_eps_kappa = e.most_eps_kappa,
          .negative = e.negative,
          .nonfinite = e.nonfinite,
          .not_zero = e.not_zero,
          .worst_over = point(e.worst_over),
          .worst_under = point(e.worst_under),
          .first_fault = e.first_fault ? std::optional(point(*e.first_fault)) : std::nullopt,
          .bounds = cap_bounds(subject.variant, set.name)};
}

void write_csv(const std::filesystem::path& file, const Results& results) {
  std::string text =
      "backend,variant,set,points,max_over,max_under,mean_absolute,rms,most_eps,most_eps_kappa,negative,nonfinite,not_zero,"
      "worst_over_r0,worst_over_r1,worst_over_d,worst_under_r0,worst_under_r1,worst_under_d,ns_per_call,ns_low,ns_high\n";
  for (const FunctionRow& row : results.errors) {
    const FunctionSubject& subject = row.subject;
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", subject.backend, subject.variant, row.set, row.points,
                        row.max_over, row.max_under, row.mean_absolute, row.rms, row.most_eps, row.most_eps_kappa, row.negative,
                        row.nonfinite, row.not_zero, fmt::join(row.worst_over, ","), fmt::join(row.worst_under, ","));
    const auto time = std::ranges::find_if(results.times, [&](const FunctionTimeRow& t) {
      return t.subject.backend == subject.backend && t.subject.variant == subject.variant;
    });
    const auto ns = time == results.times.end() ? std::nullopt : time->ns_per_call;
    text += ns ? fmt::format(",{},{},{}\n", ns->median, ns->low, ns->high) : ",,,\n";
  }
  write_file_atomically(file, text);
}

void print_set(const CapSet& set, const std::vector<FunctionRow>& rows) {
  fmt::print("\n{}: {} ({} points)\n", set.name, set.what, set.inputs.size());
  fmt::print("{:<16} {:<8} {:>9} {:>9} {:>9} {:>9} {:>10} {:>10} {:>9} {:>10}  {}\n", "variant", "backend", "max over",
             "max under", "mean", "rms", "eps", "eps kappa", "negative", "non-finite", "worst r0 r1 d");
  for (const FunctionRow& row : rows) {
    if (row.set != set.name) continue;
    fmt::print("{:<16} {:<8} {:>9.3g} {:>9.3g} {:>9.2g} {:>9.2g} {:>10.3g} {:>10.3g} {:>9} {:>10}  {}\n", row.subject.variant,
               row.subject.backend, row.max_over, row.max_under, row.mean_absolute, row.rms, row.most_eps, row.most_eps_kappa,
               row.negative, row.nonfinite, fmt::join(row.max_over > -row.max_under ? row.worst_over : row.worst_under, " "));
  }
}

// Times every variant on the first set's inputs, as many as timed_inputs (they are repeated); nothing where `timer` cannot be
// trusted.
std::vector<FunctionTimeRow> time_variants(Backend& backend, const TimerRow& timer, const std::filesystem::path& shaders,
                                           const std::vector<FunctionSubject>& subjects, const std::vector<CapInput>& inputs,
                                           uint64_t seed) {
  std::vector<FunctionTimeRow> times;
  for (const FunctionSubject& subject : subjects)
    times.push_back({.subject = subject, .commit = LAMINA_COMMIT, .build = LAMINA_BUILD_NAME});
  if (!timer.ok) {
    fmt::print(stderr, "lamina: {}: no times are given: {} (1x, 2x, 4x, 8x work took {:.3f} of linear)\n",
               backend.info().backend, timer.reason, fmt::join(timer.linearity, ", "));
    for (FunctionTimeRow& row : times) row.reason = timer.reason;
    return times;
  }
  std::vector<CapInput> repeated(timed_inputs);
  for (size_t i = 0; i < repeated.size(); ++i)
    repeated[i] = inputs[i * 7919 % inputs.size()];  // a prime: neighbours take different ways
  std::vector<std::unique_ptr<CapRunner>> runners;
  std::vector<CapRunner*> pointers;
  for (const FunctionSubject& subject : subjects) {
    runners.push_back(std::make_unique<CapRunner>(backend, shaders, subject.variant));
    runners.back()->areas(repeated);
    pointers.push_back(runners.back().get());
  }
  const std::vector<std::vector<double>> ns = nanoseconds_per_call(pointers, timing_rounds, seed);
  for (size_t i = 0; i < times.size(); ++i) times[i].ns = ns[i], times[i].ns_per_call = median_interval(ns[i]);
  return times;
}

// Every variant on a backend that is open; its rows are added to `results`. `baseline` is a variant's name.
void run_variants(Backend& backend, const std::filesystem::path& shaders, const std::vector<std::string>& variants,
                  const std::string& baseline, const std::vector<CapSet>& sets, const std::vector<CapTruth>& truths,
                  const std::vector<CapSlice>& slices, const StressOptions& options, Results& results) {
  const DeviceInfo info = backend.info();
  Progress progress(info.backend);
  std::vector<FunctionSubject> subjects;
  for (const std::string& variant : variants) {
    progress.show(static_cast<double>(subjects.size()) / static_cast<double>(variants.size()), variant);
    const FunctionSubject& subject = subjects.emplace_back(FunctionSubject{.function = cap_function,
                                                                           .title = cap_title,
                                                                           .variant = variant,
                                                                           .backend = info.backend,
                                                                           .device = info.device,
                                                                           .baseline = variant == baseline});
    CapRunner runner(backend, shaders, variant);
    for (size_t s = 0; s < sets.size(); ++s)
      results.errors.push_back(row_of(subject, sets[s], judge_caps(sets[s].inputs, runner.areas(sets[s].inputs), truths[s])));
    const std::vector<std::string> files =
        write_cap_pictures(runner, slices, options.out / "images", fmt::format("{}-{}", variant, info.backend));
    for (size_t i = 0; i < files.size(); ++i)
      results.pictures.push_back({.subject = subject,
                                  .slice = fmt::format("r1 = {}", slices[i].r1),
                                  .axes = "r0 from 0 to pi to the right, d from 0 to pi upwards",
                                  .image = "images/" + files[i],
                                  .full_error = full_error});
  }
  const TimerRow& timer = results.timers.emplace_back(certify_timer(backend, shaders));
  const std::vector<FunctionTimeRow> timed =
      time_variants(backend, timer, shaders, subjects, sets.front().inputs, options.seed);
  results.times.insert(results.times.end(), timed.begin(), timed.end());
}

void write_record(const StressOptions& options, const std::vector<DeviceInfo>& devices, const Results& results) {
  std::vector<nlohmann::ordered_json> lines;
  for (const FunctionRow& row : results.errors) lines.push_back(to_json(row));
  for (const FunctionTimeRow& row : results.times) lines.push_back(to_json(row));
  for (const TimerRow& timer : results.timers) lines.push_back(function_timer_line(cap_function, timer));
  for (const FunctionPictureRow& row : results.pictures) lines.push_back(to_json(row));
  replace_function_lines(options.out / "record.jsonl", cap_function, run_line(options, devices), lines);
  write_reports(options.out);
}

}  // namespace

int run_stress_caps(const StressOptions& options) {
  const std::filesystem::path shaders = home_folder() / "shaders";
  std::vector<std::string> variants = cap_variants(shaders);
  const std::string baseline = variants.front();
  check_variant_names("stress", options.variants, variants);
  if (!options.variants.empty()) variants = options.variants;
  const std::filesystem::path record = options.out / "record.jsonl";
  if (std::filesystem::exists(record)) read_record(record);  // what cannot be added to is said before the work, not after it
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

  Results results;
  std::vector<DeviceInfo> devices;
  bool complained = false;
  for (const std::string& name : options.backends) {
    std::string failure;
    const auto backend = try_open_backend(name, {options.device, options.validation}, failure);
    if (!backend) continue;
    devices.push_back(backend->info());
    run_variants(*backend, shaders, variants, baseline, sets, truths, slices, options, results);
    for (const std::string& message : backend->take_messages()) {
      fmt::print(stderr, "lamina: {}: {}\n", name, message);
      complained = true;
    }
  }
  if (results.errors.empty()) throw_no_backend("stress");

  fmt::print(
      "caps: the area that two spherical caps share. Errors are of the smaller cap's area; eps = 2^-23 of it; eps kappa: of "
      "the area itself, over eps times its condition number.\n");
  for (const CapSet& set : sets) print_set(set, results.errors);
  fmt::print("\nnanoseconds per call [95%], over {} points of '{}'\n", timed_inputs, sets.front().name);
  for (const FunctionTimeRow& time : results.times) {
    const auto& ns = time.ns_per_call;
    fmt::print("{:<16} {:<8} {}\n", time.subject.variant, time.subject.backend,
               ns ? fmt::format("{:>8.3g} [{:.3g}, {:.3g}]", ns->median, ns->low, ns->high) : "       -");
  }
  write_csv(options.out / "stress.csv", results);
  write_record(options, devices, results);
  if (std::string(LAMINA_BUILD_NAME) != "release")
    fmt::print("warning: the build is '{}', not 'release': its times do not count\n", LAMINA_BUILD_NAME);
  fmt::print("\ntable: {}\nreport: {}\n", (options.out / "stress.csv").string(), (options.out / "index.html").string());
  const bool uncertified = std::ranges::any_of(results.times, [](const FunctionTimeRow& time) { return !time.ns_per_call; });
  return complained || uncertified ? 1 : 0;
}

}  // namespace lamina
