// SPDX-License-Identifier: Apache-2.0
// lamina compare: every variant of every effect that the scene calls for, on every backend. The whole flow, top to bottom.
#include "harness/cli/compare.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "harness/cli/against_all.h"
#include "harness/cli/calibrate_cost.h"
#include "harness/cli/commands.h"
#include "harness/cli/effect_run.h"
#include "harness/cli/planned.h"
#include "harness/cli/run_line.h"
#include "harness/cli/run_timer.h"
#include "harness/core/stop_signals.h"
#include "harness/core/stopwatch.h"
#include "harness/core/text.h"
#include "harness/record/kept_certificate.h"
#include "harness/sweep/answers.h"
#include "reports/frontier.h"
#include "reports/reports.h"

namespace lamina {
namespace {

// Bakes, or reads what was baked before, everything that variants of these effects want. What cannot be baked fails again, with
// its reason, for the variants that want it.
void bake(const Compared& compared, const CellOptions& options, Bakes& bakes, RecordWriter& record) {
  for (const EffectManifest* effect : compared.effects)
    for (const VariantManifest& variant : effect->variants)
      for (const size_t object : compared.plan.of(effect->name)->objects) {
        if (effect->baker.empty() || !is_compared(variant, options)) continue;
        const size_t known = bakes.stats().size();
        try {
          bakes.baked(*effect, object, variant.bake);
        } catch (const Error& error) {
          if (error.kind() == ErrorKind::bad_input) throw;  // no variant could do better
          continue;
        }
        if (bakes.stats().size() == known) continue;
        const BakeStats& stats = bakes.stats().back();
        record.append(to_json(BakeRow{.effect = effect->name,
                                      .object = compared.scene.objects[object].name,
                                      .what = effect->baker,
                                      .points = stats.points,
                                      .rays = stats.points * stats.rays,
                                      .seconds = stats.seconds,
                                      .from_cache = stats.from_cache}));
      }
  for (const std::string& warning : bakes.cache().take_warnings()) fmt::print(stderr, "lamina: warning: {}\n", warning);
}

// Where the time of a run went, s by the host's clock.
struct WallTimes {
  double loading = 0, baking = 0, certifying = 0, drawing = 0, timing = 0, errors = 0, report = 0;
  std::string words(double all_s) const {
    const double rest = std::max(0.0, all_s - loading - baking - certifying - drawing - timing - errors - report);
    return fmt::format(
        "{:.1f} s: loading {:.1f}, baking {:.1f}, certifying the timer {:.1f}, compiling, drawing and counting {:.1f}, errors "
        "and truth {:.1f}, timing {:.1f}, report {:.1f}, rest {:.1f}",
        all_s, loading, baking, certifying, drawing, errors, timing, report, rest);
  }
};

// What is known of an effect whose measuring was stopped before the end: cells that have their picture.
void append_rows_so_far(const EffectRun& run, RecordWriter& record) {
  for (CellRow& row : run.rows()) {
    if (!row.failed && row.image_hash.empty()) continue;
    row.timed = false;
    row.notes.emplace_back(stopped_note);
    append_row(record, row);
  }
}

bool stopped_by_signal() { return StopSignals::stopped_by() != 0; }

// What is known of each cell.
enum class Known : uint8_t { costs, costs_and_errors };

// One backend: certificate where times are wanted, then each effect, which is taken off `left` when its rows are in the
// record. Appends every row as it is finished. Returns how many messages the API's checker had.
size_t run_backend(const std::string& name, const Compared& compared, Known wanted, std::vector<const EffectManifest*>& left,
                   Bakes& bakes, const CompareOptions& options, RecordWriter& record, WallTimes& spent) {
  const std::unique_ptr<Backend> backend = open_backend(name, {options.device, options.validation});
  Progress progress(name);
  std::optional<RunTimer> timer;
  if (options.times) {
    progress.show(0, "certifying the timer");
    timer.emplace(*backend, compared.library.shaders, options.cache, spent.certifying,
                  [&](const TimerRow& row) { record.append(to_json(row)); });
  }
  SceneResources resources(*backend, compared.scene, compared.library, options.width_px, options.height_px, &bakes);
  const std::optional<CostModel> cost_model = kept_cost_model(options.cache, name, backend->info().device);
  const SceneOnDevice there{&compared.scene, &compared.plan, &bakes, &resources};
  ShaderCache shaders(backend->info().api, compared.library.shaders);
  double timed_s = 0;
  while (!left.empty()) {
    const EffectManifest* effect = left.front();
    EffectRun run(*backend, *effect, shaders, options, "images", progress.tell_or_stop());
    run.start(there, {.timed = timer && timer->may_be_good()});
    RoundsResult rounds;
    try {
      run.prepare();
      run.count();
      if (wanted == Known::costs_and_errors) run.score();
      RoundOptions asked = options.rounds;
      asked.stop = stopped_by_signal;
      if (timer) asked.beside = timer->beside();
      asked.budget_s = std::max(0.0, options.rounds.budget_s - timed_s) / static_cast<double>(left.size());
      rounds = run.time(asked, cost_model ? &*cost_model : nullptr);
      if (timer && rounds.rounds > 0 && !timer->settle()) run.forget_times(), rounds = {};
    } catch (const StopRequested&) {
      append_rows_so_far(run, record);
      throw;
    }
    std::vector<CellRow> rows = run.rows();
    if (cost_model) note_times_that_counts_do_not_tell(*cost_model, rows);
    for (const CellRow& row : rows) append_row(record, row);
    spent.drawing += (run.spent().device - rounds.wall_ms + run.spent().read_back) / 1000;
    spent.errors += run.spent().metrics / 1000;
    spent.timing += rounds.wall_ms / 1000;
    timed_s += rounds.wall_ms / 1000;
    left.erase(left.begin());
    if (!(rounds.device_ms > 0)) continue;
    record.append(to_json(PhaseRow{name, effect->name, rounds.rounds, rounds.wall_ms, rounds.device_ms}));
    fmt::print("{}: {} rounds of {} in {:.1f} s, {:.3f} times the device time measured\n", name, rounds.rounds, effect->name,
               rounds.wall_ms / 1000, rounds.wall_ms / rounds.device_ms);
  }
  if (timer) timer->settle();  // nothing was timed
  const std::vector<std::string> messages = backend->take_messages();
  for (const std::string& message : messages) fmt::print(stderr, "lamina: {}: {}\n", name, message);
  return messages.size();
}

// Failed rows for a backend that cannot run at all.
std::vector<CellRow> failed_rows(const std::string& backend, const Compared& compared, const EffectManifest& effect,
                                 const CellOptions& options, const std::string& reason) {
  std::vector<CellRow> rows;
  for (const VariantManifest& variant : effect.variants) {
    if (!is_compared(variant, options)) continue;
    for (const View& view : compared.scene.views)
      fail(rows.emplace_back(blank_row(backend, "", compared.scene, compared.library, view, variant, options)), reason);
  }
  return rows;
}

// The run line's settings.limits.
nlohmann::ordered_json limit_settings(const std::vector<std::string>& texts) {
  nlohmann::ordered_json settings = nlohmann::ordered_json::object();
  for (const std::string& text : texts) {
    const Limit limit = parse_limit("compare", text);
    if (!error_metric(limit.metric))
      throw Error(ErrorKind::bad_input, "compare", "--limit " + text,
                  "limits the error to the baseline: ssim, psnr_db, flip, max_linear or rmse_linear");
    settings[limit.metric] = limit.value;
  }
  return settings;
}

// What --quick looks at where no variant is named: what the effects say, and the user's own. Empty: all.
std::vector<std::string> quick_variants(const std::vector<const EffectManifest*>& effects) {
  std::vector<std::string> names;
  size_t all = 0;
  for (const EffectManifest* effect : effects) {
    for (const std::string& name : effect->quick)
      if (!effect->variant(name))
        throw Error(ErrorKind::bad_input, "variants", effect->file.string(),
                    "quick: " + unknown_name("variant", name, variant_names({effect})));
    for (const VariantManifest& variant : effect->variants) {
      const bool is_own = variant.file.parent_path() != effect->file.parent_path();
      if (variant.baseline || is_own || effect->quick.empty() || std::ranges::count(effect->quick, variant.name) > 0)
        names.push_back(effect->name + "/" + variant.name);
      ++all;
    }
  }
  if (names.size() == all) return {};
  fmt::print(stderr, "lamina: note: --quick looks at {} of {} variants; others by --variant\n", names.size(), all);
  return names;
}

// A record with the run's line and the plan's.
RecordWriter begin_run(const Compared& compared, const CompareOptions& options, const std::vector<ProbedBackend>& backends,
                       const nlohmann::ordered_json& limits) {
  ShaderCache shaders(Api::vulkan, compared.library.shaders);
  const PlanRow planned = plan_row(compared.plan, compared.scene, shaders, options);
  nlohmann::ordered_json run = run_line(options, options.rounds, options.quick, compared.scene, backends);
  run["settings"]["limits"] = limits;
  RecordWriter record = begin_record("compare", options.out, run, planned);
  for (const std::string& warning : compared.scene.warnings) fmt::print(stderr, "lamina: note: {}\n", warning);
  return record;
}

std::unique_ptr<Bakes> baked(const Compared& compared, const CompareOptions& options, RecordWriter& record) {
  const auto progress = std::make_shared<Progress>("baking");
  auto bakes =
      std::make_unique<Bakes>(compared.scene, *compared.library.code, DiskCache(options.cache),
                              [progress](double fraction, const std::string& what) { progress->show(fraction, what); });
  bake(compared, options, *bakes, record);
  return bakes;
}

// Every backend in turn, until a signal stops them. Returns how many messages the APIs' checkers had.
size_t run_backends(const Compared& compared, Known wanted, const std::vector<ProbedBackend>& backends, Bakes& bakes,
                    const CompareOptions& options, RecordWriter& record, WallTimes& spent) {
  size_t messages = 0;
  for (const ProbedBackend& backend : backends) {
    if (StopSignals::stopped_by() != 0) break;
    std::string failure = backend.failure;
    std::vector<const EffectManifest*> left = compared.effects;
    try {
      if (failure.empty()) messages += run_backend(backend.name, compared, wanted, left, bakes, options, record, spent);
    } catch (const StopRequested&) {
      break;
    } catch (const Error& error) {
      if (error.stage() == "record") throw;  // the disk's failure, not the backend's
      failure = error.what();
    }
    if (failure.empty()) continue;
    for (const EffectManifest* effect : left)
      for (const CellRow& row : failed_rows(backend.name, compared, *effect, options, failure)) record.append(to_json(row));
  }
  return messages;
}

}  // namespace

std::vector<ProbedBackend> usable_backends(const CompareOptions& options) {
  std::vector<ProbedBackend> backends = probe_backends(options);
  require_any("compare", backends);
  if (options.first_backend && backends.size() > 1) {
    backends = {*std::ranges::find_if(backends, [](const ProbedBackend& backend) { return backend.device.has_value(); })};
    fmt::print(stderr, "lamina: note: --quick looks at {} alone; others by --backend\n", backends.front().name);
  }
  check_size("compare", options, devices_of(backends));
  return backends;
}

int measure_costs(const Compared& compared, const CompareOptions& options) {
  pin_rasterizer_threads();
  WallTimes untold;
  const std::vector<ProbedBackend> backends = usable_backends(options);
  RecordWriter record = begin_run(compared, options, backends, limit_settings(options.limits));
  const std::unique_ptr<Bakes> bakes = baked(compared, options, record);
  const StopSignals signals(report_on_stop);
  run_backends(compared, Known::costs, backends, *bakes, options, record, untold);
  return StopSignals::stopped_by();
}

int run_compare(const CompareOptions& given) {
  CompareOptions options = given;
  pin_rasterizer_threads();
  const Stopwatch watch;
  WallTimes spent;
  const nlohmann::ordered_json limits = limit_settings(options.limits);
  const Library library = load_library_for(options.scene);
  const Scene scene = load_scene_for(options.scene, library);
  const Plan plan = plan_for(options.scene, library, scene, options.aspect());
  const Compared compared{library, scene, plan, compared_effects(plan)};
  check_variant_names("compare", options.variants, variant_names(compared.effects));
  if (options.quick && options.variants.empty()) options.variants = quick_variants(compared.effects);
  const std::vector<ProbedBackend> backends = usable_backends(options);
  RecordWriter record = begin_run(compared, options, backends, limits);
  spent.loading = watch.elapsed_s();
  const std::unique_ptr<Bakes> bakes = baked(compared, options, record);
  spent.baking = watch.elapsed_s() - spent.loading;

  const StopSignals signals(report_on_stop);
  const size_t messages = run_backends(compared, Known::costs_and_errors, backends, *bakes, options, record, spent);

  const double before_report_s = watch.elapsed_s();
  write_reports(options.out);
  const Record written = read_record(options.out / "record.jsonl");
  spent.report = watch.elapsed_s() - before_report_s;
  fmt::print("{}\ntook {}\nreport: {}\n", terminal_table(written, ::isatty(STDOUT_FILENO) == 1), spent.words(watch.elapsed_s()),
             (options.out / "index.html").string());
  if (StopSignals::stopped_by() != 0) {
    fmt::print(stderr, "lamina: stopped; the record and the report hold what was measured until then\n");
    return 128 + StopSignals::stopped_by();
  }
  const bool failed = std::ranges::any_of(written.cells, &CellRow::failed);
  const bool uncertified = !std::ranges::all_of(written.timers, &TimerRow::ok);
  return failed || uncertified || messages > 0 ? 1 : 0;
}

Command add_compare(CLI::App& program) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App& command = *program.add_subcommand(
      "compare", "Every variant of every effect the scene calls for, on every backend: table, record, report");
  add_scene(command, options->scene);
  add_configuration(command, options->scene);
  add_out(command, options->out);
  add_backends(command, *options);
  add_variant(command, options->variants);
  add_size(command, *options);
  command.add_flag(
      "--quick", options->quick,
      "Stop sooner: at intervals of 5%, or after 4 s a backend (--precision and --budget change that); compare only the "
      "variants that an effect names for this, where it names any and --variant is not given, on the first backend that "
      "opens, where no --backend is given");
  add_rounds(command, options->rounds, "a backend");
  CLI::Option* no_time = command.add_flag("!--no-time", options->times, "Counts, pictures and errors alone");
  command
      .add_option("--limit", options->limits,
                  "METRIC=NUMBER that a variant must keep against the baseline to be recommended (may be given again)")
      ->type_name(placeholder::limit)
      ->capture_default_str();
  add_truth(command, *options);
  add_alpha(command, *options);
  add_seed(command, options->rounds.seed);
  add_validation(command, *options);
  CLI::Option* against_all =
      command.add_flag("--against-all-effects", options->against_all,
                       "In place of variants: the frame with only what the scene calls for, against the frame in which every "
                       "effect runs that can; fails where their pictures differ");
  CLI::Option* watch = command
                           .add_flag("--watch", options->watch,
                                     "Draw again what a changed shader, manifest or scene file touches, into a page that "
                                     "loads itself again; the first backend, "
                                     "no truth unless --truth-rays says so; Ctrl-C ends with the record")
                           ->excludes(against_all);
  command.add_option("--view", options->views, "View that is watched (may be given again; default: the first)")
      ->type_name(placeholder::view)
      ->needs(watch);
  command.add_flag("--timed", options->timed, "Time what is watched, within 1 s unless --budget says otherwise")
      ->needs(watch)
      ->excludes(no_time);
  return {&command, [=, &command](const std::string& typed) {
            options->command = typed;
            const auto quick_default = [&](const char* name) { return options->quick && command.count(name) == 0; };
            if (quick_default("--budget")) options->rounds.budget_s = quick_budget_s;
            if (quick_default("--precision")) options->rounds.precision = quick_precision;
            if (quick_default("--truth-rays")) options->truth_rays = 64;
            options->first_backend = quick_default("--backend");
            if (options->against_all) return run_against_all(*options);
            if (options->watch) {
              if (command.count("--truth-rays") == 0) options->truth_rays = 0;
              if (command.count("--budget") == 0) options->rounds.budget_s = 1;
              return run_watch(*options);
            }
            return run_compare(*options);
          }};
}

}  // namespace lamina
