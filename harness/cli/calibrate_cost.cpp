// SPDX-License-Identifier: Apache-2.0
// lamina calibrate: what each kind of work costs on a device, fitted to what compare measures of the built-in scenes, or to
// records that are there. The model is kept in the cache.
#include "harness/cli/calibrate_cost.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <set>

#include "harness/cli/commands.h"
#include "harness/cli/common.h"
#include "harness/cli/compare.h"
#include "harness/core/disk_cache.h"
#include "harness/core/stop_signals.h"
#include "harness/core/text.h"
#include "harness/record/record.h"

namespace lamina {
namespace {

constexpr double contradiction = 2;     // times what is predicted, or its inverse
constexpr double max_mean_error = 0.1;  // of a model that is good enough to contradict a time

struct CalibrateOptions {
  std::vector<std::filesystem::path> records;  // folders of runs, or their record.jsonl; empty: measures the scenes
  std::vector<std::string> scenes;             // empty: all built-in ones
  CompareOptions measuring;
};

std::string cache_key(const std::string& backend, const std::string& device) {
  return "cost_model_" + hash_hex(backend + "\n" + device);
}

// Of a scene, what its first view tells of effects that no scene before it calls for.
struct MeasuredScene {
  std::string name;
  Scene scene;
  Plan plan;
  std::vector<const EffectManifest*> effects;
};

// The scenes that tell of every effect with several variants, each effect in one.
std::vector<MeasuredScene> measured_scenes(const Library& library, const CompareOptions& options,
                                           const std::vector<std::string>& scenes) {
  std::set<std::string> left;
  for (const EffectManifest& effect : library.effects)
    if (effect.variants.size() > 1) left.insert(effect.name);
  std::vector<MeasuredScene> measured;
  for (const std::string& name : scenes.empty() ? builtin_scenes() : scenes) {
    if (left.empty()) break;
    SceneOptions one = options.scene;
    one.scene = name;
    Scene scene = load_scene_for(one, library);
    scene.views.resize(1);
    Plan plan = plan_for(one, library, scene, options.aspect());
    std::vector<const EffectManifest*> effects = compared_effects(plan);
    std::erase_if(effects, [&](const EffectManifest* effect) { return left.erase(effect->name) == 0; });
    if (!effects.empty()) measured.push_back({name, std::move(scene), std::move(plan), std::move(effects)});
  }
  return measured;
}

// Measures each scene as compare does, and adds its folder. Returns whether all were measured: false after Ctrl-C.
bool measure(const CalibrateOptions& options, std::vector<std::filesystem::path>& folders) {
  const Library library = load_library_for(options.measuring.scene);
  const std::vector<MeasuredScene> scenes = measured_scenes(library, options.measuring, options.scenes);
  for (const auto& [name, scene, plan, effects] : scenes) {
    CompareOptions one = options.measuring;
    one.scene.scene = name;
    one.out = options.measuring.out / name;
    fmt::print("calibrate: {}, {} of {} scenes\n", name, folders.size() + 1, scenes.size());
    if (measure_costs({library, scene, plan, effects}, one) != 0) return false;
    folders.push_back(one.out);
  }
  return true;
}

void print(const CostModel& model) {
  fmt::print(
      "\n{} ({}), by what is {}: frames of variants that the fit has not seen are told within {:.1f}% in the mean ({:.1f}% "
      "in the median), at a rank correlation of {:.3f}; {} frames of {} variants\n",
      model.backend, model.device, model.counted == CountedWork::issued ? "issued" : "executed", 100 * model.judged.mean_error,
      100 * model.judged.median_error, model.judged.rank_correlation, model.judged.frames, model.judged.variants);
  fmt::print("  {:<40} {:>12} {:>26}\n", "one", "ns", "95% interval");
  for (const auto& [kind, weight] : model.weights)
    fmt::print("  {:<40} {:>12.4g} {:>12.4g} to {:<10.4g}\n", kind, weight.ns, weight.low, weight.high);
}

int run_calibrate(const CalibrateOptions& options) {
  std::vector<std::filesystem::path> folders = options.records;
  if (folders.empty() && !measure(options, folders)) {
    fmt::print(stderr, "lamina: stopped; nothing was fitted\n");
    return 128 + StopSignals::stopped_by();
  }
  std::map<std::pair<std::string, std::string>, std::vector<CellRow>> cells;  // by backend and device
  for (const std::filesystem::path& given : folders) {
    const Record record = read_record(std::filesystem::is_directory(given) ? given / "record.jsonl" : given);
    for (const CellRow& cell : record.cells)
      if (!shown_samples_ms(record, cell).empty()) cells[{cell.backend, cell.device}].push_back(cell);
  }
  if (cells.empty())
    throw Error(
        ErrorKind::bad_input, "calibrate", folders.front().string(),
        "holds no frame that was timed, with those given beside it; measure with times, on a machine that lets the timer "
        "be certified");
  for (const auto& [where, rows] : cells) {
    CostModel model = fit_cost_model(timed_frames(rows));
    std::tie(model.backend, model.device) = where;
    keep_cost_model(options.measuring.cache, model);
    print(model);
  }
  return 0;
}

}  // namespace

std::optional<CostModel> kept_cost_model(const std::filesystem::path& cache, const std::string& backend,
                                         const std::string& device) {
  DiskCache kept(cache);
  const std::string key = cache_key(backend, device);
  const std::optional<std::string> bytes = kept.find(key);
  if (!bytes) return std::nullopt;
  try {
    return cost_model_from_json(nlohmann::json::parse(*bytes, nullptr, false), kept.file_of(key).string());
  } catch (const Error&) {
    return std::nullopt;
  }
}

void keep_cost_model(const std::filesystem::path& cache, const CostModel& model) {
  DiskCache kept(cache);
  const std::string key = cache_key(model.backend, model.device);
  kept.keep(key, to_json(model).dump(2) + "\n");
  for (const std::string& warning : kept.take_warnings()) fmt::print(stderr, "lamina: warning: {}\n", warning);
}

void note_times_that_counts_do_not_tell(const CostModel& model, std::span<CellRow> rows) {
  if (model.judged.mean_error > max_mean_error) return;
  for (CellRow& row : rows) {
    const std::vector<double> frame_ms = row.failed || !row.timed ? std::vector<double>{} : frame_samples_ms(row.passes);
    std::vector<std::string> unknown;
    const double predicted = predicted_ms(model, row.passes, &unknown);
    if (frame_ms.empty() || !unknown.empty() || !(predicted > 0)) continue;
    const double ratio = median(frame_ms) / predicted;
    if (ratio > contradiction || ratio < 1 / contradiction)
      row.notes.push_back(
          fmt::format("takes {:.2g} times what its counts predict on this device ({:.3g} ms)", ratio, predicted));
  }
}

Command add_calibrate(CLI::App& program) {
  auto options = std::make_shared<CalibrateOptions>();
  CompareOptions& measuring = options->measuring;
  measuring.width_px = measuring.height_px = 256;
  measuring.out = "lamina-calibrate";
  CLI::App& command = *program.add_subcommand(
      "calibrate", "What each kind of work costs on this device: fitted to measured passes, and kept for predictions");
  command
      .add_option("RECORD", options->records, "Runs to fit to (folders, or their record.jsonl); default: scenes are measured")
      ->type_name(placeholder::record);
  command
      .add_option("--scene", options->scenes,
                  "Only this scene (may be given again); default: built-in ones that call for every effect, each effect in one")
      ->type_name(placeholder::scene);
  add_out(command, measuring.out, "Folder for the runs, one a scene");
  add_backends(command, measuring);
  add_size(command, measuring);
  add_rounds(command, measuring.rounds, "a backend and scene");
  add_cache(command, measuring.cache);
  return {&command, [=, &command](const std::string& typed) {
            CompareOptions& measured = options->measuring;
            measured.command = typed;
            if (command.count("--budget") == 0) measured.rounds.budget_s = quick_budget_s;
            if (command.count("--precision") == 0) measured.rounds.precision = quick_precision;
            measured.truth_rays = 0;
            return run_calibrate(*options);
          }};
}

}  // namespace lamina
