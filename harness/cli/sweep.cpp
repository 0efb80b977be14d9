// SPDX-License-Identifier: Apache-2.0
// lamina sweep: every variant at every point of a grid of parameters, on every backend; what has been done stays done. The
// whole flow, top to bottom.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "harness/cli/commands.h"
#include "harness/cli/common.h"
#include "harness/cli/devices.h"
#include "harness/cli/effect_run.h"
#include "harness/cli/planned.h"
#include "harness/cli/run_line.h"
#include "harness/cli/run_timer.h"
#include "harness/cli/sweep_end.h"
#include "harness/core/stop_signals.h"
#include "harness/core/stopwatch.h"
#include "harness/core/text.h"
#include "harness/scene/digest.h"
#include "harness/sweep/answers.h"
#include "harness/sweep/sweep_record.h"

namespace lamina {
namespace {

struct SweepOptions {
  CellOptions compare;
  RoundOptions rounds{.budget_s = 4, .precision = 0.05};  // of a timed point
  std::vector<std::string> sets;                          // PATH=VALUES
  bool zip = false;
  std::vector<std::string> views;                   // by name; empty: all
  std::vector<std::string> limits = {"ssim=0.98"};  // METRIC=NUMBER
  Shard shard;
  Schedule time{0}, fetches{8}, pictures{8};  // which points get rounds, counts, pictures
};

Scene scene_of(const SweepOptions& options, const Library& library) {
  Scene scene = load_scene_for(options.compare.scene, library);
  std::vector<std::string> names;
  for (const View& view : scene.views) names.push_back(view.name);
  for (const std::string& name : options.views)
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw Error(ErrorKind::bad_input, "sweep", "--view", unknown_name("view", name, names));
  if (!options.views.empty())
    std::erase_if(scene.views, [&](const View& view) {
      return std::find(options.views.begin(), options.views.end(), view.name) == options.views.end();
    });
  return scene;
}

SweepPoints points_from(const SweepOptions& options) {
  SweepPoints points;
  points.zip = options.zip;
  for (const std::string& text : options.sets) points.parameters.push_back(parse_swept(text));
  return points;
}

// Every file that shaders and manifests are made of, and the scene.
std::string inputs_hash(const SweepOptions& options, const Scene& scene) {
  std::vector<std::filesystem::path> folders = {home_folder() / "variants", home_folder() / "shaders"};
  folders.insert(folders.end(), options.compare.scene.variants_dirs.begin(), options.compare.scene.variants_dirs.end());
  std::string text = scene_digest(scene);
  for (const std::filesystem::path& folder : folders) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.is_regular_file() && entry.path().extension() != ".md") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const std::filesystem::path& file : files)
      text += std::filesystem::relative(file, folder).string() + hash_hex(read_file(file, "sweep"));
  }
  return hash_hex(text);
}

// All must open here: a backend that is missing is known before anything runs.
std::vector<DeviceInfo> all_devices(const SweepOptions& options) {
  const std::vector<ProbedBackend> backends = probe_backends(options.compare);
  for (const ProbedBackend& backend : backends)
    if (!backend.device)
      throw Error(ErrorKind::no_device, "sweep", backend.name,
                  fmt::format("{}; name those that are here with --backend", backend.failure));
  std::vector<DeviceInfo> devices = devices_of(backends);
  check_size("sweep", options.compare, devices);
  return devices;
}

SweepRow sweep_row(const SweepOptions& options, const SweepPoints& points, const std::vector<Limit>& limits) {
  SweepRow row;
  for (const SweptParameter& parameter : points.parameters)
    row.parameters.push_back({parameter.path, parameter.unit, parameter.values});
  row.zip = points.zip;
  row.points = points.count();
  row.shard_index = options.shard.index, row.shard_count = options.shard.count;
  row.limits = limits;
  return row;
}

// `inputs` is a hash of all that the cells follow from.
nlohmann::ordered_json sweep_run_line(const SweepOptions& options, const Scene& scene,
                                      const std::vector<const EffectManifest*>& effects, const std::vector<DeviceInfo>& devices,
                                      const std::string& inputs) {
  nlohmann::ordered_json line = run_line(options.compare, options.rounds, false, scene, all_ran(devices));
  nlohmann::ordered_json& settings = line["settings"];
  settings["backends"] = options.compare.backends;
  settings["effects"] = settings["variants"] = settings["views"] = nlohmann::ordered_json::array();
  for (const EffectManifest* effect : effects) {
    settings["effects"].push_back(effect->name);
    for (const VariantManifest& variant : effect->variants)
      if (is_compared(variant, options.compare)) settings["variants"].push_back(effect->name + "/" + variant.name);
  }
  for (const View& view : scene.views) settings["views"].push_back(view.name);
  settings["time"] = words_of(options.time);
  settings["fetches"] = words_of(options.fetches);
  settings["pictures"] = words_of(options.pictures);
  line["inputs"] = inputs;
  return line;
}

// What is done, what is left, and the worst error, for the progress line.
struct Tally {
  size_t done = 0, all = 0, failed = 0, messages = 0;
  double worst_ssim = 1;

  void add(const CellRow& row) {
    ++done;
    failed += row.failed;
    if (row.error_covered) worst_ssim = std::min(worst_ssim, row.error_covered->ssim);
  }
  double fraction() const { return static_cast<double>(done) / static_cast<double>(all); }
  std::string words(const std::string& point) const {
    return fmt::format("{} of {} cells, at {}, worst SSIM {:.4f}", done, all, point, worst_ssim);
  }
};

struct Sweep {
  const SweepOptions& options;
  const Library& library;
  SweptScene& scenes;
  const std::vector<const EffectManifest*>& effects;
  const std::set<CellKey>& earlier;
  RecordWriter& record;
  Tally& tally;
};

bool is_left(const Sweep& sweep, const std::string& backend, const EffectManifest& effect, const std::string& variant,
             const std::string& view, size_t point) {
  return !sweep.earlier.contains({backend, effect.name, variant, view, point});
}

size_t cells_left(const Sweep& sweep, const std::string& backend, const EffectManifest& effect, size_t point) {
  size_t cells = 0;
  if (!sweep.options.shard.has(point)) return cells;
  for (const VariantManifest& variant : effect.variants)
    for (const View& view : sweep.scenes.scene().views)
      cells += is_compared(variant, sweep.options.compare) && is_left(sweep, backend, effect, variant.name, view.name, point);
  return cells;
}

size_t cells_left(const Sweep& sweep, const std::string& backend) {
  size_t cells = 0;
  for (const EffectManifest* effect : sweep.effects)
    for (size_t point = 0; point < sweep.scenes.points().count(); ++point) cells += cells_left(sweep, backend, *effect, point);
  return cells;
}

MeasuredPoint measured_point(const Sweep& sweep, size_t point, bool times_may_count) {
  const SweepOptions& options = sweep.options;
  return {.params = sweep.scenes.params(point),
          .words = sweep.scenes.words_at(point),
          .timed = options.time.has(point) && times_may_count,
          .counted = options.fetches.has(point) || options.time.has(point),
          .pictured = options.pictures.has(point),
          .picture_suffix = fmt::format("-{}", point)};
}

// One backend: every point of the shard, every effect. Pictures are kept before the line that names them. Returns false where a
// signal stopped it.
bool run_backend(const std::string& name, const Sweep& sweep, Progress& progress) {
  const SweepOptions& options = sweep.options;
  if (cells_left(sweep, name) == 0) return true;
  const std::unique_ptr<Backend> backend = open_backend(name, {options.compare.device, options.compare.validation});
  std::optional<RunTimer> timer;
  double certifying_s = 0;  // which no line of a sweep tells
  if (options.time.every > 0) {
    progress.show(0, "certifying the timer");
    timer.emplace(*backend, sweep.library.shaders, options.compare.cache, certifying_s, [&](const TimerRow& row) {
      sweep.record.append(to_json(row));
      if (!row.ok)
        fmt::print(stderr,
                   "lamina: {}: the timer's certificate failed ({}), so these cells get errors and no times; for times run "
                   "again into another folder, on a machine that is less busy\n",
                   name, row.reason);
    });
  }
  SweptSceneOnDevice there(*backend, sweep.scenes, sweep.library, options.compare);
  ShaderCache shaders(backend->info().api, sweep.library.shaders);
  const Tell tell = [&](double, const std::string& what) { progress.show(sweep.tally.fraction(), what); };
  bool go_on = true;
  for (const EffectManifest* effect : sweep.effects) {
    const Stopwatch watch;
    size_t cells = 0;
    EffectRun run(*backend, *effect, shaders, options.compare, "images", tell);
    for (size_t point = 0; point < sweep.scenes.points().count() && go_on; ++point) {
      if (cells_left(sweep, name, *effect, point) == 0) continue;
      std::string failure;  // of the point: all its cells fail, the next points go on
      try {
        there.go_to(point, [&] { run.release(); });
      } catch (const std::exception& error) {
        failure = error.what();
      }
      run.start(there.here(), measured_point(sweep, point, timer && timer->may_be_good()), failure);
      run.prepare();
      run.count();
      RoundOptions rounds = options.rounds;
      if (timer) rounds.beside = timer->beside();
      if (run.time(rounds).rounds > 0 && timer && !timer->settle()) run.forget_times();
      const auto wanted = [&](const std::string& variant, const std::string& view) {
        return is_left(sweep, name, *effect, variant, view, point);
      };
      const auto done = [&](const CellRow& row) {
        append_row(sweep.record, row);
        sweep.tally.add(row), ++cells;
        progress.show(sweep.tally.fraction(), sweep.tally.words(sweep.scenes.words(point)));
        return StopSignals::stopped_by() == 0;
      };
      go_on = run.score({.wanted = wanted, .done = done});
    }
    if (cells == 0) continue;
    const double wall_ms = watch.elapsed_ms();
    fmt::print("{}: {} cells of {} in {:.1f} s, {:.3f} times device ({:.1f} s), read-back ({:.1f} s) and metrics ({:.1f} s)\n",
               name, cells, effect->name, wall_ms / 1000, wall_ms / run.spent().sum(), run.spent().device / 1000,
               run.spent().read_back / 1000, run.spent().metrics / 1000);
    if (!go_on) break;
  }
  if (timer) timer->settle();  // nothing was timed
  for (const std::string& message : backend->take_messages()) {
    fmt::print(stderr, "lamina: {}: {}\n", name, message);
    ++sweep.tally.messages;
  }
  return go_on;
}

int run_sweep(const SweepOptions& options) {
  const StopSignals signals("\nlamina: finishing the cell; a second Ctrl-C stops at once\n");  // which loses that cell alone
  pin_rasterizer_threads();
  const Library library = load_library_for(options.compare.scene);
  SweptScene scenes(scene_of(options, library), library, points_from(options));
  const Scene& scene = scenes.scene();
  const Plan plan = plan_for(options.compare.scene, library, scene);  // what no view sees now, another point may show
  const std::vector<const EffectManifest*> effects = compared_effects(plan);
  check_variant_names("sweep", options.compare.variants, variant_names(effects));
  std::vector<Limit> limits;
  for (const std::string& text : options.limits) limits.push_back(parse_limit("sweep", text));
  const std::vector<DeviceInfo> devices = all_devices(options);

  make_run_folder("sweep", options.compare.out);
  const FolderLock lock("sweep", options.compare.out);
  const std::filesystem::path file = options.compare.out / "record.jsonl";
  const nlohmann::ordered_json run = sweep_run_line(options, scene, effects, devices, inputs_hash(options, scene));
  const SweepRow swept = sweep_row(options, scenes.points(), limits);
  const std::optional<Earlier> earlier = continue_record(file, run, swept, scenes.points());
  std::optional<PlanRow> planned;  // before the record is begun: a mistake of a manifest leaves none
  if (!earlier || !earlier->kinds.contains("plan")) {
    ShaderCache shaders(Api::vulkan, library.shaders);
    planned = plan_row(plan, scene, shaders, options.compare);
  }
  RecordWriter record(file, earlier.has_value());
  if (!earlier) record.append(run), record.append(to_json(swept));
  if (planned) record.append(to_json(*planned));

  Tally tally;
  const std::set<CellKey> known = earlier ? earlier->cells : std::set<CellKey>{};
  const Sweep sweep{options, library, scenes, effects, known, record, tally};
  for (const std::string& backend : options.compare.backends) tally.all += cells_left(sweep, backend);
  if (earlier)
    fmt::print("resuming {}: {} cells are there, {} to go{}\n", file.string(), known.size(), tally.all,
               earlier->cut_bytes > 0 ? fmt::format("; a line cut short ({} bytes) was taken off", earlier->cut_bytes) : "");

  Progress progress("sweep");
  for (const std::string& backend : options.compare.backends)
    if (!run_backend(backend, sweep, progress)) {
      fmt::print(stderr, "lamina: stopped; {} of {} cells are done and kept. Go on with the same command:\n  {}\n", tally.done,
                 tally.all, options.compare.command);
      return 128 + StopSignals::stopped_by();
    }
  const bool failed = end_sweep(options.compare.out, record);
  return failed || tally.messages > 0 ? 1 : 0;
}

void add_schedule(CLI::App& command, const std::string& name, Schedule& schedule, const std::string& help) {
  command
      .add_option_function<std::string>(
          name, [name, &schedule](const std::string& text) { schedule = parse_schedule(name, text); }, help)
      ->type_name(placeholder::schedule)
      ->default_str(words_of(schedule));
}

}  // namespace

Command add_sweep(CLI::App& program) {
  auto options = std::make_shared<SweepOptions>();
  options->compare.out = "lamina-sweep";
  CLI::App& command =
      *program.add_subcommand("sweep", "Errors and cost of every variant along parameters; resumes where it was stopped");
  add_scene_name(command, options->compare.scene);
  add_configuration(command, options->compare.scene);
  command
      .add_option(
          "--set", options->sets,
          "PATH=FROM:TO:STEP, PATH=FROM:TO:xFACTOR or PATH=A,B,C (may be given again, for a grid); the moment of the scene "
          "is scene.time, in seconds; 'lamina list --parameters SCENE' names the paths")
      ->type_name(placeholder::set)
      ->required();
  command.add_flag("--zip", options->zip, "Values of several --set in pairs, not as a grid");
  add_schedule(command, "--time", options->time, "Points whose cost is timed: none, all or every:N");
  add_schedule(command, "--fetches", options->fetches,
               "Points whose fetches are counted, besides timed ones: none, all or every:N");
  add_schedule(command, "--pictures", options->pictures, "Points whose pictures are kept: none, all or every:N");
  command.add_option("--limit", options->limits, "METRIC=NUMBER that is good enough (may be given again)")
      ->type_name(placeholder::limit)
      ->capture_default_str();
  command
      .add_option_function<std::string>(
          "--shard", [options = options.get()](const std::string& text) { options->shard = parse_shard(text); },
          "The K-th part of N, K from 1; 'lamina merge' joins them")
      ->type_name(placeholder::shard);
  add_out(command, options->compare.out, "Folder for record, report and pictures; one that holds a part of this sweep");
  add_backends(command, options->compare);
  add_variant(command, options->compare.variants);
  command.add_option("--view", options->views, "Only this view (may be given again)")->type_name(placeholder::view);
  add_variants_dir(command, options->compare.scene);
  add_size(command, options->compare);
  add_rounds(command, options->rounds, "a timed point");
  add_truth(command, options->compare);
  add_alpha(command, options->compare);
  add_seed(command, options->rounds.seed);
  add_validation(command, options->compare);
  return {&command, [=](const std::string& typed) {
            options->compare.command = typed;
            return run_sweep(*options);
          }};
}

}  // namespace lamina
