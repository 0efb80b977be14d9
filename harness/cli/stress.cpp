// SPDX-License-Identifier: Apache-2.0
// lamina stress: the shaders' functions over hard inputs, on every backend, against a reference that is better than they are.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "commit.h"
#include "harness/cli/commands.h"
#include "harness/cli/common.h"
#include "harness/cli/devices.h"
#include "harness/cli/progress.h"
#include "harness/cli/run_line.h"
#include "harness/core/text.h"
#include "harness/manifest/effect_code.h"
#include "harness/record/function_rows.h"
#include "harness/record/kept_certificate.h"
#include "harness/stress/pictures.h"
#include "harness/stress/point_sets.h"
#include "reports/reports.h"

namespace lamina {
namespace {

struct StressOptions : DeviceOptions {
  std::string family;            // by name, or a family.toml; empty: all
  std::filesystem::path points;  // a file of inputs
  size_t grid_steps = 0;         // of make_grid(); 0 and no file: the sets of the family
  size_t count = 100000;         // inputs a set
  std::vector<std::string> variants;
  std::filesystem::path out = "lamina-out";
  std::filesystem::path cache = default_cache_folder();  // of certificates; empty: none
  uint64_t seed = 1;
  std::string command;  // as the user typed it
};

constexpr size_t timing_rounds = 12;
constexpr size_t timed_points = 1 << 16;

// A family, what goes through its functions, and what comes out.
struct FamilyRun {
  Family family;
  std::vector<FamilyFunction> functions;  // those that are asked for
  std::vector<PointSet> sets;
  std::vector<PointTruth> truths;  // beside the sets
  std::vector<Slice> slices;

  std::vector<FunctionRow> errors;     // of each backend, function and set
  std::vector<FunctionTimeRow> times;  // of each backend and function
  std::vector<TimerRow> timers;        // of each backend
  std::vector<FunctionPictureRow> pictures;
};

FunctionRow row_of(const FunctionSubject& subject, const Family& family, const PointSet& set, const FamilyClaim* claim,
                   const FunctionErrors& e) {
  FunctionRow row{.subject = subject,
                  .scale = family.scale,
                  .set = set.name,
                  .what = set.what,
                  .points = set.points.size(),
                  .max_over = e.max_over,
                  .max_under = e.max_under,
                  .mean_absolute = e.mean_absolute,
                  .rms = e.rms,
                  .max_eps = e.max_eps,
                  .max_eps_kappa = e.max_eps_kappa,
                  .negative = e.negative,
                  .nonfinite = e.nonfinite,
                  .not_zero = e.not_zero,
                  .worst_over = e.worst_over,
                  .worst_under = e.worst_under,
                  .first_fault = e.first_fault.value_or(std::vector<double>{})};
  if (claim) row.bounds = FunctionBounds{claim->over, claim->under, claim->eps_kappa};
  return row;
}

void write_csv(const std::filesystem::path& file, const FamilyRun& run) {
  std::string text =
      "backend,variant,set,points,max_over,max_under,mean_absolute,rms,most_eps,most_eps_kappa,negative,nonfinite,not_zero";
  for (const char* worst : {"worst_over", "worst_under"})
    for (const FamilyInput& input : run.family.inputs) text += fmt::format(",{}_{}", worst, input.name);
  text += ",ns_per_call,ns_low,ns_high\n";
  for (const FunctionRow& row : run.errors) {
    const FunctionSubject& subject = row.subject;
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", subject.backend, subject.variant, row.set, row.points,
                    *row.max_over, *row.max_under, *row.mean_absolute, *row.rms, *row.max_eps, *row.max_eps_kappa, row.negative,
                    row.nonfinite, row.not_zero, fmt::join(row.worst_over, ","), fmt::join(row.worst_under, ","));
    const auto time = std::ranges::find_if(run.times, [&](const FunctionTimeRow& t) {
      return t.subject.backend == subject.backend && t.subject.variant == subject.variant;
    });
    const auto ns = time == run.times.end() ? std::nullopt : time->ns_per_call;
    text += ns ? fmt::format(",{},{},{}\n", ns->median, ns->low, ns->high) : ",,,\n";
  }
  write_file_atomically(file, text);
}

void print_set(const PointSet& set, const FamilyRun& run) {
  fmt::print("\n{}: {} ({} points)\n", set.name, set.what, set.points.size());
  fmt::print("{:<16} {:<8} {:>9} {:>9} {:>9} {:>9} {:>10} {:>10} {:>9} {:>10}  worst {}\n", "variant", "backend", "max over",
             "max under", "mean", "rms", "eps", "eps kappa", "negative", "non-finite",
             fmt::join(run.family.input_names(), " "));
  for (const FunctionRow& row : run.errors) {
    if (row.set != set.name) continue;
    fmt::print("{:<16} {:<8} {:>9.3g} {:>9.3g} {:>9.2g} {:>9.2g} {:>10.3g} {:>10.3g} {:>9} {:>10}  {}\n", row.subject.variant,
               row.subject.backend, *row.max_over, *row.max_under, *row.mean_absolute, *row.rms, *row.max_eps,
               *row.max_eps_kappa, row.negative, row.nonfinite,
               fmt::join(*row.max_over > -*row.max_under ? row.worst_over : row.worst_under, " "));
  }
}

void print_run(const FamilyRun& run) {
  const Family& family = run.family;
  fmt::print("{}: {}. Errors are of {}; eps = 2^-23 of it; eps kappa: of the {} itself, over eps times its condition number.\n",
             family.name, family.title, family.scale, family.value);
  for (const PointSet& set : run.sets) print_set(set, run);
  fmt::print("\nnanoseconds per call [95%], over {} points of '{}'\n", timed_points, run.sets.front().name);
  for (const FunctionTimeRow& time : run.times) {
    const auto& ns = time.ns_per_call;
    fmt::print("{:<16} {:<8} {}\n", time.subject.variant, time.subject.backend,
               ns ? fmt::format("{:>8.3g} [{:.3g}, {:.3g}]", ns->median, ns->low, ns->high) : "       -");
  }
}

// Times every function on the first set's points, as many as timed_points (they are repeated); nothing where `timer` cannot be
// trusted.
std::vector<FunctionTimeRow> time_functions(Backend& backend, const TimerRow& timer, const std::filesystem::path& shaders,
                                            const std::vector<FunctionSubject>& subjects, const FamilyRun& run, uint64_t seed) {
  std::vector<FunctionTimeRow> times;
  for (const FunctionSubject& subject : subjects)
    times.push_back({.subject = subject, .commit = LAMINA_COMMIT, .build = LAMINA_BUILD_NAME});
  if (!timer.ok) {
    fmt::print(stderr, "lamina: {}: no times are given: {} (1x, 2x, 4x, 8x work took {:.3f} of linear)\n",
               backend.info().backend, timer.reason, fmt::join(timer.linearity, ", "));
    for (FunctionTimeRow& row : times) row.reason = timer.reason;
    return times;
  }
  const Points& points = run.sets.front().points;
  Points repeated(points.inputs());
  for (size_t i = 0; i < timed_points; ++i)
    repeated.add(points[i * 7919 % points.size()]);  // a prime: neighbours take different ways
  std::vector<std::unique_ptr<FunctionRunner>> runners;
  std::vector<FunctionRunner*> pointers;
  for (const FunctionSubject& subject : subjects) {
    runners.push_back(std::make_unique<FunctionRunner>(backend, shaders, run.family, subject.variant));
    runners.back()->values(repeated);
    pointers.push_back(runners.back().get());
  }
  const std::vector<std::vector<double>> ns = nanoseconds_per_call(pointers, timing_rounds, seed);
  for (size_t i = 0; i < times.size(); ++i) times[i].ns = ns[i], times[i].ns_per_call = median_interval(ns[i]);
  return times;
}

// The family's functions on a backend that is open and has this timer; what comes out is added to `run`.
void run_functions(Backend& backend, const TimerRow& timer, const std::filesystem::path& shaders, const StressOptions& options,
                   FamilyRun& run) {
  const DeviceInfo info = backend.info();
  const Family& family = run.family;
  Progress progress(info.backend);
  std::vector<FunctionSubject> subjects;
  for (const FamilyFunction& function : run.functions) {
    progress.show(static_cast<double>(subjects.size()) / static_cast<double>(run.functions.size()), function.name);
    const FunctionSubject& subject = subjects.emplace_back(FunctionSubject{.function = family.function,
                                                                           .title = family.title,
                                                                           .variant = function.name,
                                                                           .backend = info.backend,
                                                                           .device = info.device,
                                                                           .baseline = function.baseline});
    FunctionRunner runner(backend, shaders, family, function.name);
    for (size_t s = 0; s < run.sets.size(); ++s) {
      const PointSet& set = run.sets[s];
      const FunctionErrors errors = judge(set.points, runner.values(set.points), run.truths[s]);
      run.errors.push_back(row_of(subject, family, set, function.claim(set.name), errors));
    }
    const std::vector<std::string> files =
        write_pictures(runner, run.slices, options.out / "images", fmt::format("{}-{}", function.name, info.backend));
    for (size_t i = 0; i < files.size(); ++i)
      run.pictures.push_back({.subject = subject,
                              .slice = run.slices[i].name,
                              .axes = run.slices[i].axes,
                              .image = "images/" + files[i],
                              .full_error = run.slices[i].full_error});
  }
  run.timers.push_back(timer);
  const std::vector<FunctionTimeRow> timed = time_functions(backend, timer, shaders, subjects, run, options.seed);
  run.times.insert(run.times.end(), timed.begin(), timed.end());
}

void write_record(const StressOptions& options, const std::vector<ProbedBackend>& backends, const FamilyRun& run) {
  const std::string& function = run.family.function;
  std::vector<nlohmann::ordered_json> lines;
  for (const FunctionRow& row : run.errors) lines.push_back(to_json(row));
  for (const FunctionTimeRow& row : run.times) lines.push_back(to_json(row));
  for (const TimerRow& timer : run.timers) lines.push_back(to_json(FunctionTimerRow{timer, function}));
  for (const FunctionPictureRow& row : run.pictures) lines.push_back(to_json(row));
  nlohmann::ordered_json line = run_line(options.command, backends);
  line["settings"] = {{"count", options.count}, {"seed", options.seed}, {"validation", options.validation}};
  if (!options.points.empty()) line["settings"]["points"] = options.points.string();
  line["warnings"] = nlohmann::ordered_json::array();
  replace_function_lines(options.out / "record.jsonl", function, line, lines);
}

// The one that is asked for, by its name or by its file; all without a name.
std::vector<Family> chosen_families(const StressOptions& options, const std::filesystem::path& shaders) {
  if (options.family.ends_with(".toml")) return {load_family(options.family, effect_code())};
  std::vector<Family> families = load_families(shaders, effect_code());
  if (families.empty()) throw Error(ErrorKind::bad_input, "stress", shaders.string(), "no folder here has a family.toml");
  if (options.family.empty()) return families;
  std::vector<std::string> names;
  for (const Family& family : families) names.push_back(family.name);
  std::erase_if(families, [&](const Family& family) { return family.name != options.family; });
  if (families.empty())
    throw Error(ErrorKind::bad_input, "stress", options.family, unknown_name("family", options.family, names));
  return families;
}

// Families with the functions and points that are asked for. Those without any of the functions are left out.
std::vector<FamilyRun> planned_runs(const StressOptions& options, const std::filesystem::path& shaders) {
  std::vector<FamilyRun> runs;
  std::vector<std::string> functions;
  for (Family& family : chosen_families(options, shaders)) {
    for (const std::string& name : family.function_names()) functions.push_back(name);
    FamilyRun& run = runs.emplace_back();
    run.functions = family.functions;
    std::erase_if(run.functions, [&](const FamilyFunction& function) {
      return !options.variants.empty() && std::ranges::find(options.variants, function.name) == options.variants.end();
    });
    run.family = std::move(family);
  }
  check_variant_names("stress", options.variants, functions);
  std::erase_if(runs, [](const FamilyRun& run) { return run.functions.empty(); });
  if (!options.points.empty() && runs.size() > 1)
    throw Error(ErrorKind::bad_input, "stress", "--points", "a file holds the inputs of one family: name the family too");
  for (FamilyRun& run : runs) {
    if (!options.points.empty())
      run.sets.push_back(read_points(run.family, options.points));
    else if (options.grid_steps > 0)
      run.sets.push_back(make_grid(run.family, options.grid_steps));
    else
      run.sets = make_sets(run.family, options.count, options.seed);
  }
  return runs;
}

int run_stress(const StressOptions& options) {
  pin_rasterizer_threads();
  const std::filesystem::path shaders = home_folder() / "shaders";
  const std::filesystem::path record = options.out / "record.jsonl";
  if (std::filesystem::exists(record)) read_record(record);  // what cannot be added to is said before the work, not after it
  std::vector<FamilyRun> runs = planned_runs(options, shaders);
  const std::vector<ProbedBackend> backends = probe_backends(options);
  require_any("stress", backends);
  const std::vector<DeviceInfo> devices = devices_of(backends);
  make_run_folder("stress", options.out);
  for (FamilyRun& run : runs) {
    for (const PointSet& set : run.sets) run.truths.push_back(truth_of(*run.family.oracle, set));
    if (options.points.empty()) run.slices = make_slices(run.family);
  }

  bool complained = false;
  for (const DeviceInfo& device : devices) {
    const auto backend = open_backend(device.backend, {options.device, options.validation});
    const TimerRow timer = certified_timer(*backend, shaders, options.cache);
    for (FamilyRun& run : runs) run_functions(*backend, timer, shaders, options, run);
    for (const std::string& message : backend->take_messages()) {
      fmt::print(stderr, "lamina: {}: {}\n", device.backend, message);
      complained = true;
    }
  }

  bool uncertified = false;
  std::vector<std::filesystem::path> tables;
  for (const FamilyRun& run : runs) {
    print_run(run);
    tables.push_back(options.out / (options.family.empty() ? fmt::format("stress-{}.csv", run.family.name) : "stress.csv"));
    write_csv(tables.back(), run);
    write_record(options, backends, run);
    uncertified = uncertified || std::ranges::any_of(run.times, [](const FunctionTimeRow& time) { return !time.ns_per_call; });
  }
  write_reports(options.out);
  if (std::string(LAMINA_BUILD_NAME) != "release")
    fmt::print("warning: the build is '{}', not 'release': its times do not count\n", LAMINA_BUILD_NAME);
  fmt::print("\n");
  for (const std::filesystem::path& table : tables) fmt::print("table: {}\n", table.string());
  fmt::print("report: {}\n", (options.out / "index.html").string());
  return complained || uncertified ? 1 : 0;
}

}  // namespace

Command add_stress(CLI::App& program) {
  auto options = std::make_shared<StressOptions>();
  CLI::App& command =
      *program.add_subcommand("stress", "Runs the shaders' functions on hard inputs, and compares them with exact values");
  command
      .add_option(
          "family", options->family,
          "A family of functions, such as caps (the area that two spherical caps share), or a family.toml; all without a name")
      ->type_name(placeholder::family);
  CLI::Option* points =
      command
          .add_option("--points", options->points,
                      "File of inputs and, if known, their right value (caps: r0,r1,d[,area]) instead of the sets")
          ->type_name(placeholder::file);
  CLI::Option* count =
      command.add_option("--count", options->count, "Inputs a set")->capture_default_str()->check(CLI::Range(1000, 4000000));
  command
      .add_option("--grid", options->grid_steps,
                  "An even grid of N values of each input, N from 2 (caps: to 160), instead of the sets")
      ->check(CLI::PositiveNumber)
      ->excludes(points)
      ->excludes(count);
  add_variant(command, options->variants, "Only this function (may be given again)", placeholder::function);
  add_backends(command, *options);
  add_out(command, options->out, "Folder of a run, or a new one: functions are added to its record and report");
  add_cache(command, options->cache);
  add_seed(command, options->seed, "Seed of the inputs");
  add_validation(command, *options);
  return {&command, [=](const std::string& typed) {
            options->command = typed;
            return run_stress(*options);
          }};
}

}  // namespace lamina
