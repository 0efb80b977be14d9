// SPDX-License-Identifier: Apache-2.0
// Options of every command, the environment that software rasterizers need, and errors turned into exit statuses: 0 well; 1 a
// cell or gate failed; 2 bad input or usage; 3 ambiguous; 4 no usable device.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "harness/cli/commands.h"
#include "harness/cli/run_line.h"
#include "harness/core/text.h"

namespace {

namespace fs = std::filesystem;
using namespace lamina;

constexpr uint32_t largest_px = 65536;
constexpr int usage_status = 2;

// A shader cache of this process alone, so that the first frame's cost is the same in every run; gone with the process.
class PrivateShaderCache {
 public:
  PrivateShaderCache() {
    std::string pattern = (fs::temp_directory_path() / "lamina-shaders-XXXXXX").string();
    if (!::mkdtemp(pattern.data())) return;
    folder_ = pattern;
    ::setenv("MESA_SHADER_CACHE_DIR", folder_.c_str(), 1);
  }
  ~PrivateShaderCache() {
    std::error_code ignored;
    if (!folder_.empty()) fs::remove_all(folder_, ignored);
  }
  PrivateShaderCache(const PrivateShaderCache&) = delete;
  PrivateShaderCache& operator=(const PrivateShaderCache&) = delete;

 private:
  std::string folder_;
};

// Pins the number of rasterizer threads, so that the record can say what ran: left alone, software rasterizers use one thread
// for each core of the affinity mask, whatever else limits them. In a gate they use the caller's thread only: see side_by_side
// in GateOptions.
void pin_rasterizer_threads(bool gate) {
  const uint32_t cores = std::min(std::max(std::thread::hardware_concurrency(), 1u), 32u);
  ::setenv("LP_NUM_THREADS", std::to_string(gate ? 0 : cores).c_str(), 0);
}

std::pair<uint32_t, uint32_t> parse_size(const std::string& text) {
  unsigned long width = 0, height = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%lux%lu%c", &width, &height, &rest) != 2 || text.starts_with('-') || width < 1 || height < 1 ||
      width > largest_px || height > largest_px)
    throw Error(ErrorKind::bad_input, "options", "--size",
                fmt::format("'{}' must be WIDTHxHEIGHT, each from 1 to {}", text, largest_px));
  return {static_cast<uint32_t>(width), static_cast<uint32_t>(height)};
}

void add_scene_options(CLI::App& command, SceneOptions& options) {
  command.add_option("scene", options.scene, "Scene file (.toml), glTF model (.glb, .gltf) or built-in scene")
      ->capture_default_str();
  command.add_option("--time", options.time_s, "Moment of the scene, in seconds");
  command.add_option("--variants-dir", options.variants_dirs,
                     "Folder with variants of your own: manifests and shaders (may be given again)");
}

int run(int argc, char** argv) {
  CLI::App app(
      "Lamina: what accuracy costs. Measures real-time translucency techniques: time, texture fetches and errors of every "
      "variant.",
      "lamina");
  app.set_version_flag("--version", LAMINA_VERSION);
  app.require_subcommand(1);

  CompareOptions compare;
  compare.validation = LAMINA_VALIDATION;
  std::string size = "512x512";
  CLI::App& compare_command = *app.add_subcommand(
      "compare", "Every variant of every effect the scene calls for, on every backend: table, record, report");
  add_scene_options(compare_command, compare.scene);
  compare_command.add_option("--out", compare.out, "Folder for record, report and pictures")->capture_default_str();
  compare_command.add_option("--backend", compare.backends, "vulkan, osmesa or egl (may be given again)")
      ->capture_default_str();
  compare_command.add_option("--device", compare.device, "Part of a device's name, or its number in 'lamina list'");
  compare_command.add_option("--variant", compare.variants, "Only this variant and the baseline (may be given again)");
  compare_command.add_option("--size", size, "Size of the frame in pixels")->capture_default_str();
  compare_command.add_flag(
      "--quick", compare.quick,
      "Stop sooner, at wider intervals: 5%, or 4 s a backend, unless --precision or --budget say otherwise");
  CLI::Option* budget = compare_command.add_option("--budget", compare.budget_s, "Seconds of timed rounds a backend")
                            ->capture_default_str()
                            ->check(CLI::Range(0.0, 86400.0));
  CLI::Option* precision =
      compare_command
          .add_option("--precision", compare.precision, "Stop where each ratio's 95% interval has this half width, relative")
          ->capture_default_str()
          ->check(CLI::Range(1e-6, 1.0));
  CLI::Option* truth_rays =
      compare_command.add_option("--truth-rays", compare.truth_rays, "Rays a pixel and light for the truth; 0: no truth")
          ->capture_default_str()
          ->check(CLI::Range(0, 65536));
  compare_command.add_option("--cache", compare.cache, "Folder that keeps bakes and truths; \"\": none")->capture_default_str();
  compare_command.add_option("--seed", compare.seed, "Seed of the order of rounds")->capture_default_str();
  compare_command.add_flag("--validation,!--no-validation", compare.validation,
                           "Check API use: Vulkan's validation layers, OpenGL's debug output");

  GateOptions gate;
  gate.compare.validation = LAMINA_VALIDATION;
  gate.compare.truth_rays = 64;
  std::string gate_size = "512x512";
  CLI::App& gate_command = *app.add_subcommand(
      "gate", "Compares two states of the code; fails where the newer one is slower, fetches more or is less accurate");
  add_scene_options(gate_command, gate.compare.scene);
  CLI::Option* against = gate_command.add_option(
      "--against", gate.against, "Tree of variants/ and shaders/ as they were before, measured in the same run");
  gate_command.add_option("--baseline", gate.baseline, "Record of the state before (record.jsonl or its folder)")
      ->excludes(against);
  gate_command.add_flag("--update", gate.update, "Replace the record that --baseline names, and say what changed");
  gate_command.add_option("--limits", gate.limits, "Gate file (.toml): what is allowed, by effect, variant and backend");
  gate_command.add_option("--out", gate.compare.out, "Folder for record, report and pictures")->capture_default_str();
  gate_command.add_option("--backend", gate.compare.backends, "vulkan, osmesa or egl (may be given again)")
      ->capture_default_str();
  gate_command.add_option("--device", gate.compare.device, "Part of a device's name, or its number in 'lamina list'");
  gate_command.add_option("--variant", gate.compare.variants, "Only this variant and the baseline (may be given again)");
  gate_command.add_option("--size", gate_size, "Size of the frame in pixels")->capture_default_str();
  gate_command.add_option("--budget", gate.budget_s, "Seconds of wall time for everything")
      ->capture_default_str()
      ->check(CLI::Range(1.0, 86400.0));
  gate_command.add_option("--processes", gate.processes, "Processes that measure on each backend, at least")
      ->capture_default_str()
      ->check(CLI::Range(2, 100));
  CLI::Option* calibrate = gate_command.add_flag("--calibrate", gate.calibrate,
                                                 "Measure the gate's own error rates here: gates over equal trees, and over "
                                                 "trees with one slower pass, each within --budget");
  gate_command.add_option("--gates", gate.equal_gates, "Gates over equal trees")->capture_default_str()->needs(calibrate);
  gate_command.add_option("--slower-gates", gate.slower_gates, "Gates for each slow-down of 1, 2, 3, 5 and 10%")
      ->capture_default_str()
      ->needs(calibrate);
  gate_command.add_flag("!--no-time", gate.times, "Counts, pictures and errors alone");
  gate_command.add_option("--truth-rays", gate.compare.truth_rays, "Rays a pixel and light for the truth; 0: no truth")
      ->capture_default_str()
      ->check(CLI::Range(0, 65536));
  gate_command.add_option("--cache", gate.compare.cache, "Folder that keeps bakes and truths; \"\": none")
      ->capture_default_str();
  gate_command.add_option("--seed", gate.compare.seed, "Seed of the order of rounds")->capture_default_str();
  gate_command.add_flag("--validation,!--no-validation", gate.compare.validation,
                        "Check API use: Vulkan's validation layers, OpenGL's debug output");

  SweepOptions sweep;
  sweep.compare.validation = LAMINA_VALIDATION;
  std::string shard, sweep_time = "none", sweep_fetches = "every:8", sweep_pictures = "every:8";
  CLI::App& sweep_command =
      *app.add_subcommand("sweep", "Errors and cost of every variant along parameters; resumes where it was stopped");
  sweep_command
      .add_option("scene", sweep.compare.scene.scene, "Scene file (.toml), glTF model (.glb, .gltf) or built-in scene")
      ->capture_default_str();
  sweep_command
      .add_option(
          "--set", sweep.sets,
          "PATH=FROM:TO:STEP, PATH=FROM:TO:xFACTOR or PATH=A,B,C (may be given again, for a grid); the moment of the scene "
          "is scene.time, in seconds; 'lamina list --parameters SCENE' names the paths")
      ->required();
  sweep_command.add_flag("--zip", sweep.zip, "Values of several --set in pairs, not as a grid");
  sweep_command.add_option("--time", sweep_time, "Points whose cost is timed: none, all or every:N")->capture_default_str();
  sweep_command
      .add_option("--fetches", sweep_fetches, "Points whose fetches are counted, besides timed ones: none, all or every:N")
      ->capture_default_str();
  sweep_command.add_option("--pictures", sweep_pictures, "Points whose pictures are kept: none, all or every:N")
      ->capture_default_str();
  sweep_command.add_option("--limit", sweep.limits, "METRIC=NUMBER that is good enough (may be given again)")
      ->capture_default_str();
  sweep_command.add_option("--shard", shard, "K/N: the K-th part of N, K from 1; 'lamina merge' joins them");
  sweep_command
      .add_option("--out", sweep.compare.out, "Folder for record, report and pictures; one that holds a part of this sweep")
      ->capture_default_str();
  sweep_command.add_option("--backend", sweep.compare.backends, "vulkan, osmesa or egl (may be given again)")
      ->capture_default_str();
  sweep_command.add_option("--device", sweep.compare.device, "Part of a device's name, or its number in 'lamina list'");
  sweep_command.add_option("--variant", sweep.compare.variants, "Only this variant and the baseline (may be given again)");
  sweep_command.add_option("--view", sweep.views, "Only this view (may be given again)");
  sweep_command.add_option("--variants-dir", sweep.compare.scene.variants_dirs,
                           "Folder with variants of your own: manifests and shaders (may be given again)");
  sweep_command.add_option("--size", size, "Size of the frame in pixels")->capture_default_str();
  sweep_command.add_option("--budget", sweep.compare.budget_s, "Seconds of timed rounds a timed point")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 86400.0));
  sweep_command
      .add_option("--precision", sweep.compare.precision, "Stop where each ratio's 95% interval has this half width, relative")
      ->capture_default_str()
      ->check(CLI::Range(1e-6, 1.0));
  sweep_command.add_option("--truth-rays", sweep.compare.truth_rays, "Rays a pixel and light for the truth; 0: no truth")
      ->capture_default_str()
      ->check(CLI::Range(0, 65536));
  sweep_command.add_option("--cache", sweep.compare.cache, "Folder that keeps bakes and truths; \"\": none")
      ->capture_default_str();
  sweep_command.add_option("--seed", sweep.compare.seed, "Seed of the order of rounds")->capture_default_str();
  sweep_command.add_flag("--validation,!--no-validation", sweep.compare.validation,
                         "Check API use: Vulkan's validation layers, OpenGL's debug output");

  std::vector<fs::path> shards;
  fs::path merged = "lamina-sweep";
  CLI::App& merge_command =
      *app.add_subcommand("merge", "Joins the records of a sweep's shards, and gives the answers of the whole sweep");
  merge_command.add_option("record", shards, "Run folders or their record.jsonl")->required();
  merge_command.add_option("--out", merged, "Folder for the joined record, report and pictures")->capture_default_str();

  StressOptions stress;
  stress.validation = LAMINA_VALIDATION;
  CLI::App& stress_command =
      *app.add_subcommand("stress", "Runs the shaders' functions on hard inputs, and compares them with exact values");
  stress_command.add_option(
      "family", stress.family,
      "A family of functions, such as caps (the area that two spherical caps share), or a family.toml; all without a name");
  CLI::Option* points = stress_command.add_option(
      "--points", stress.points, "File of inputs and, if known, their right value (caps: r0,r1,d[,area]) instead of the sets");
  CLI::Option* count = stress_command.add_option("--count", stress.count, "Inputs a set")
                           ->capture_default_str()
                           ->check(CLI::Range(1000, 4000000));
  stress_command
      .add_option("--grid", stress.grid_steps,
                  "An even grid of N values of each input, N from 2 (caps: to 160), instead of the sets")
      ->check(CLI::PositiveNumber)
      ->excludes(points)
      ->excludes(count);
  stress_command.add_option("--variant", stress.variants, "Only this function (may be given again)");
  stress_command.add_option("--backend", stress.backends, "vulkan, osmesa or egl (may be given again)")->capture_default_str();
  stress_command.add_option("--device", stress.device, "Part of a device's name, or its number in 'lamina list'");
  stress_command.add_option("--out", stress.out, "Folder of a run, or a new one: functions are added to its record and report")
      ->capture_default_str();
  stress_command.add_option("--seed", stress.seed, "Seed of the inputs")->capture_default_str();
  stress_command.add_flag("--validation,!--no-validation", stress.validation,
                          "Check API use: Vulkan's validation layers, OpenGL's debug output");

  SceneOptions plan;
  CLI::App& plan_command = *app.add_subcommand("plan", "What the scene calls for and why, and the passes");
  add_scene_options(plan_command, plan);
  SceneOptions list;
  CLI::App& list_command = *app.add_subcommand("list", "Effects, variants, parameters, scenes, backends, devices");
  bool list_parameters = false;
  list_command.add_option("scene", list.scene, "Scene whose parameters are listed")->capture_default_str();
  list_command.add_flag("--parameters", list_parameters, "Every parameter that 'lamina sweep' can set, and nothing else");
  list_command.add_option("--variants-dir", list.variants_dirs, "Folder with variants of your own (may be given again)");
  ReportCommand report;
  CLI::App& report_command =
      *app.add_subcommand("report", "Writes reports again from records; several records side by side with --out");
  report_command.add_option("record", report.records, "Run folders or their record.jsonl")->required();
  report_command.add_option("--out", report.out, "Folder for one report of all records (default: each beside its record)");
  report_command.add_flag("--single-file", report.single_file, "Put the pictures into the page, so that one file is all");
  HistoryOptions history;
  CLI::App& history_command =
      *app.add_subcommand("history", "How each cell's figures changed over records, and at which commit");
  history_command.add_option("record", history.records, "Run folders or their record.jsonl, two or more")->required();
  history_command.add_option("--csv", history.csv, "File for every point of every trend");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : usage_status;
  }
  pin_rasterizer_threads(gate_command.parsed());
  compare.command = gate.compare.command = sweep.compare.command = stress.command =
      command_line({argv + 1, static_cast<size_t>(argc - 1)});
  if (compare_command.parsed()) {
    std::tie(compare.width_px, compare.height_px) = parse_size(size);
    if (compare.quick && budget->count() == 0) compare.budget_s = 4;
    if (compare.quick && precision->count() == 0) compare.precision = 0.05;
    if (compare.quick && truth_rays->count() == 0) compare.truth_rays = 64;
    return run_compare(compare);
  }
  if (gate_command.parsed()) {
    std::tie(gate.compare.width_px, gate.compare.height_px) = parse_size(gate_size);
    return run_gate(gate);
  }
  if (sweep_command.parsed()) {
    std::tie(sweep.compare.width_px, sweep.compare.height_px) = parse_size(size);
    if (!shard.empty()) sweep.shard = parse_shard(shard);
    sweep.time = parse_schedule("--time", sweep_time);
    sweep.fetches = parse_schedule("--fetches", sweep_fetches);
    sweep.pictures = parse_schedule("--pictures", sweep_pictures);
    return run_sweep(sweep);
  }
  if (merge_command.parsed()) return run_merge(shards, merged);
  if (stress_command.parsed()) return run_stress(stress);
  if (plan_command.parsed()) return run_plan(plan);
  if (list_command.parsed()) return list_parameters ? run_list_parameters(list) : run_list(list);
  if (history_command.parsed()) return run_history(history);
  return run_report(report);
}

}  // namespace

int main(int argc, char** argv) {
  const PrivateShaderCache cache;
  try {
    return run(argc, argv);
  } catch (const Error& error) {
    fmt::print(stderr, "lamina: {}\n", error.what());
    return static_cast<int>(error.kind());
  } catch (const std::exception& error) {
    fmt::print(stderr, "lamina: {}\n", error.what());
    return static_cast<int>(ErrorKind::failed);
  }
}
