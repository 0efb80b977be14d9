// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/watch.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "harness/cli/common.h"
#include "harness/cli/devices.h"
#include "harness/cli/effect_run.h"
#include "harness/cli/run_line.h"
#include "harness/cli/watched_files.h"
#include "harness/core/stop_signals.h"
#include "harness/core/stopwatch.h"
#include "harness/core/text.h"
#include "harness/record/kept_certificate.h"
#include "reports/html/watch_page.h"
#include "reports/reports.h"

namespace lamina {
namespace {

namespace fs = std::filesystem;

Scene watched_scene(const WatchOptions& options, const Library& library) {
  Scene scene = load_scene_for(options.scene, library);
  std::vector<std::string> names;
  for (const View& view : scene.views) names.push_back(view.name);
  for (const std::string& name : options.views)
    if (std::ranges::find(names, name) == names.end())
      throw Error(ErrorKind::bad_input, "compare", "--view", unknown_name("view", name, names));
  const std::vector<std::string> wanted = options.views.empty() ? std::vector{names.front()} : options.views;
  std::erase_if(scene.views, [&](const View& view) { return std::ranges::find(wanted, view.name) == wanted.end(); });
  return scene;
}

// All that manifests and the scene say, on the device.
struct World {
  World(Backend& backend, const WatchOptions& options)
      : library(load_library_for(options.scene)),
        scene(watched_scene(options, library)),
        plan(plan_for(options.scene, library, scene, options.aspect())),
        effects(compared_effects(plan)),
        bakes(scene, *library.code, DiskCache(options.cache)),
        resources(backend, scene, library, options.width_px, options.height_px, &bakes) {
    check_variant_names("compare", options.variants, variant_names(effects));
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  Library library;
  Scene scene;
  Plan plan;
  std::vector<const EffectManifest*> effects;
  Bakes bakes;
  SceneResources resources;
};

// A variant over all changes: what its picture was made from, and what came of it.
struct Watched {
  std::string made_from;  // hashes of its shaders and its manifest's text, or what is wrong with them
  WatchedVariant shown;
};

class Watch {
 public:
  Watch(const WatchOptions& options, Backend& backend, const std::optional<TimerRow>& timer)
      : options_(options),
        backend_(backend),
        timer_(timer),
        world_(std::make_unique<World>(backend, options)),
        shaders_(backend.info().api, world_->library.shaders) {
    state_.what = fmt::format("{} on {} ({}), {}x{}", world_->scene.name, backend.info().backend, backend.info().device,
                              options.width_px, options.height_px);
  }

  // Where files are that count.
  std::vector<fs::path> places() const {
    std::vector<fs::path> places = {world_->library.shaders, home_folder() / "variants"};
    places.insert(places.end(), options_.scene.variants_dirs.begin(), options_.scene.variants_dirs.end());
    if (fs::is_regular_file(options_.scene.scene)) places.emplace_back(options_.scene.scene);
    return places;
  }

  // Draws what these changed files touch, all at first.
  void update(const std::vector<fs::path>& changed) {
    const Stopwatch watch;
    state_.failure.clear();
    const bool of_shaders_alone =
        std::ranges::all_of(changed, [](const fs::path& file) { return file.extension() != ".toml"; });
    try {
      shaders_ = ShaderCache(backend_.info().api, world_->library.shaders);
      if (is_stale_ || !of_shaders_alone) make_world_again();
      for (const EffectManifest* effect : world_->effects) draw_changed(*effect);
    } catch (const Error& error) {
      state_.failure = error.what();
    }
    publish(changed, watch.elapsed_s());
  }

  // The record of what is there now. Returns whether all is well.
  bool write_record() const {
    RecordWriter record(options_.out / "record.jsonl");
    record.append(run_line(options_, options_.rounds, false, world_->scene, all_ran({backend_.info()})));
    if (timer_) record.append(to_json(*timer_));
    bool well = state_.failure.empty();
    for (const EffectManifest* effect : world_->effects)
      for (const VariantManifest& variant : effect->variants) {
        const auto found = watched_.find({effect->name, variant.name});
        if (found == watched_.end()) continue;
        if (found->second.shown.failure.empty()) {
          for (const CellRow& row : found->second.shown.cells) append_row(record, row);
          continue;
        }
        well = false;
        for (const View& view : world_->scene.views) {
          CellRow row = blank_row(backend_.info().backend, backend_.info().device, world_->scene, world_->library, view,
                                  variant, options_);
          fail(row, found->second.shown.failure);
          append_row(record, row);
        }
      }
    return well;
  }

 private:
  // Keeps what was there where the new files have a mistake.
  void make_world_again() {
    is_stale_ = true;
    auto next = std::make_unique<World>(backend_, options_);
    runs_.clear();  // they bind what lies in the old one
    world_ = std::move(next);
    is_stale_ = false;
    for (auto& [key, watched] : watched_) watched.made_from.clear();
  }

  std::string made_from(const VariantManifest& variant) {
    try {
      const Graph graph = make_graph(world_->plan, configuration_with(world_->plan, variant), world_->scene, shaders_);
      return fmt::format("{} {}", fmt::join(graph.shader_hashes(), " "), read_file(variant.file, "variants"));
    } catch (const Error& error) {
      return error.what();
    }
  }

  void draw_changed(const EffectManifest& effect) {
    std::set<std::string> changed, all;
    bool baseline_changed = false;
    for (const VariantManifest& variant : effect.variants) {
      if (!is_compared(variant, options_)) continue;
      Watched& watched = watched_[{effect.name, variant.name}];
      watched.shown.name = variant.name, watched.shown.title = variant.title;
      watched.shown.is_new = false;
      std::string now = made_from(variant);
      if (now != watched.made_from) changed.insert(variant.name), baseline_changed = baseline_changed || variant.baseline;
      watched.made_from = std::move(now);
      all.insert(variant.name);
    }
    if (changed.empty()) return;
    if (baseline_changed) changed = all;  // their errors are against it
    std::unique_ptr<EffectRun>& run = runs_[effect.name];
    if (run) {
      run->start_again(changed);
    } else {
      run = std::make_unique<EffectRun>(backend_, effect, shaders_, options_, "images", [](double, const std::string&) {});
      run->keep_baseline();
      run->start({&world_->scene, &world_->plan, &world_->bakes, &world_->resources},
                 {.timed = options_.timed && timer_ && timer_->ok});
    }
    run->prepare();
    run->count();
    run->score();
    run->time(options_.rounds);
    for (const VariantManifest& variant : effect.variants)
      if (changed.contains(variant.name)) take(run->rows(), effect, variant);
  }

  void take(const std::vector<CellRow>& rows, const EffectManifest& effect, const VariantManifest& variant) {
    Watched& watched = watched_[{effect.name, variant.name}];
    std::vector<CellRow> own;
    for (const CellRow& row : rows)
      if (row.variant == variant.name) own.push_back(row);
    const auto failed = std::ranges::find_if(own, &CellRow::failed);
    watched.shown.failure = failed == own.end() ? "" : failed->reason;
    watched.shown.is_new = true;
    if (failed == own.end()) watched.shown.cells = own;
  }

  void publish(const std::vector<fs::path>& changed, double took_s) {
    std::vector<std::string> names;
    for (const fs::path& file : changed) names.push_back(file.filename().string());
    state_.changed = fmt::format("{}", fmt::join(names, ", "));
    ++state_.generation;
    state_.took_s = took_s;
    state_.variants.clear();
    size_t fresh = 0;
    for (const EffectManifest* effect : world_->effects)
      for (const VariantManifest& variant : effect->variants)
        if (const auto found = watched_.find({effect->name, variant.name}); found != watched_.end()) {
          state_.variants.push_back(found->second.shown);
          fresh += found->second.shown.is_new;
        }
    write_file_atomically(options_.out / "watch.html", watch_page(state_));
    write_file_atomically(options_.out / "watch.js", watch_script(state_));
    for (const WatchedVariant& variant : state_.variants)
      if (variant.is_new && !variant.failure.empty()) fmt::print("{}: {}\n", variant.name, variant.failure);
    if (!state_.failure.empty()) fmt::print("{}\n", state_.failure);
    fmt::print(
        "{}{} in {:.2f} s\n", state_.changed.empty() ? "" : state_.changed + ": ",
        fresh > 0 ? fmt::format("{} variant{} drawn", fresh, fresh == 1 ? "" : "s") : "nothing that executes has changed",
        took_s);
    std::fflush(stdout);
  }

  const WatchOptions& options_;
  Backend& backend_;
  const std::optional<TimerRow> timer_;
  std::unique_ptr<World> world_;
  bool is_stale_ = false;  // a manifest or the scene has a mistake that the world does not have
  ShaderCache shaders_;    // as the files are now
  std::map<std::string, std::unique_ptr<EffectRun>> runs_;          // by effect; in this world
  std::map<std::pair<std::string, std::string>, Watched> watched_;  // by effect and variant
  WatchState state_;
};

}  // namespace

int run_watch(const WatchOptions& options) {
  const StopSignals signals("\nlamina: writing the record\n");
  pin_rasterizer_threads();
  const std::unique_ptr<Backend> backend = open_backend(options.backends.front(), {options.device, options.validation});
  check_size("compare", options, {backend->info()});
  std::optional<TimerRow> timer;
  if (options.timed) timer = certified_timer(*backend, home_folder() / "shaders", options.cache);
  if (timer && !timer->ok) fmt::print(stderr, "lamina: warning: {}; no times are taken\n", timer->reason);

  Watch watch(options, *backend, timer);
  make_new_run_folder("compare", options.out);
  WatchedFiles files(watch.places());
  watch.update({});
  fmt::print("page: {}\nwatching; Ctrl-C ends and writes the record\n", (options.out / "watch.html").string());
  std::fflush(stdout);
  while (StopSignals::stopped_by() == 0) {
    if (const std::vector<fs::path> changed = files.changed(); !changed.empty()) watch.update(changed);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  const bool well = watch.write_record();
  write_reports(options.out);
  fmt::print("report: {}\n", (options.out / "index.html").string());
  return well ? 0 : 1;
}

}  // namespace lamina
