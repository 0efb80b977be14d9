// SPDX-License-Identifier: Apache-2.0
// The commands, each in a file of its own; main.cpp reads their options.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/backend/backend.h"
#include "harness/core/disk_cache.h"
#include "harness/plan/plan.h"
#include "harness/sweep/points.h"

namespace lamina {

// What commands that look at a scene have in common.
struct SceneOptions {
  std::string scene = "heart";
  std::optional<float> time_s;
  std::vector<std::filesystem::path> variants_dirs;
};

struct CompareOptions {
  SceneOptions scene;
  std::filesystem::path out = "lamina-out";
  std::vector<std::string> backends = {"vulkan", "osmesa"};
  std::vector<std::string> variants;  // by name; empty: all. The baseline is always there.
  std::string device;
  uint32_t width_px = 512, height_px = 512;
  bool quick = false;
  double budget_s = 20;     // of the timed rounds, a backend and effect
  double precision = 0.01;  // half width of each ratio's interval, relative
  uint64_t seed = 1;
  size_t truth_rays = 256;                               // a pixel and light; 0: no truth
  std::filesystem::path cache = default_cache_folder();  // of bakes and truths; empty: none
  bool validation = false;
  std::string command;  // as the user typed it
};

struct SweepOptions {
  CompareOptions compare{.out = "lamina-sweep", .budget_s = 4, .precision = 0.05};  // budget and precision: a timed point
  std::vector<std::string> sets;                                                    // PATH=VALUES
  bool zip = false;
  std::vector<std::string> views;                   // by name; empty: all
  std::vector<std::string> limits = {"ssim=0.98"};  // METRIC=NUMBER
  Shard shard;
  Schedule time{0}, fetches{8}, pictures{8};  // which points get rounds, counts, pictures
};

struct StressOptions {
  std::string family;            // by name, or a family.toml; empty: all
  std::filesystem::path points;  // a file of inputs
  size_t grid_steps = 0;         // of make_grid(); 0 and no file: the sets of the family
  size_t count = 100000;         // inputs a set
  std::vector<std::string> variants;
  std::vector<std::string> backends = {"vulkan", "osmesa"};
  std::string device;
  std::filesystem::path out = "lamina-out";
  uint64_t seed = 1;
  bool validation = false;
  std::string command;  // as the user typed it
};

struct GateOptions {
  CompareOptions compare;          // what is measured, and how; its budget_s and precision are not used
  std::filesystem::path against;   // a folder with variants/ and shaders/: the state before
  std::filesystem::path baseline;  // or a record
  bool update = false;             // write the record in place of checking it
  std::filesystem::path limits;    // a gate file; empty: the defaults
  double budget_s = 60;            // wall time of everything
  size_t processes = 5;            // at least, on each backend: each lays out code and memory anew
  double family_error = 0.05;      // chance of any wrong verdict on times
  bool times = true;
  // Backends at the same time: software rasterizers that run in the caller's thread. Two threads share tiles by chance, which
  // spreads the ratio of a strip to its twin; one each spreads it less, and two cores measure twice as much.
  bool side_by_side = false;
  bool exact = true, certify = true;  // counts, pictures and errors; the timer
  bool calibrate = false;
  size_t equal_gates = 200, slower_gates = 40;  // of a calibration: over equal trees; for each slow-down
};

struct HistoryOptions {
  std::vector<std::filesystem::path> records;  // run folders or record files
  std::filesystem::path csv;                   // empty: none
};

struct ReportCommand {
  std::vector<std::filesystem::path> records;  // folders of runs, or their record.jsonl
  std::filesystem::path out;                   // empty: each run's own folder
  bool single_file = false;
};

// Difference pictures are |test - baseline| of display values times this; records and reports state it.
inline constexpr double difference_gain = 4;

// Each returns the exit status, and throws Error.
int run_compare(const CompareOptions& options);
int run_gate(const GateOptions& options);
int run_sweep(const SweepOptions& options);
// Joins the records of shards in `out`.
int run_merge(const std::vector<std::filesystem::path>& records, const std::filesystem::path& out);
int run_stress(const StressOptions& options);
int run_plan(const SceneOptions& options);
int run_list(const SceneOptions& options);
int run_list_parameters(const SceneOptions& options);
int run_report(const ReportCommand& options);
int run_history(const HistoryOptions& options);

// Whether the options ask for this variant; a baseline is always compared.
bool is_compared(const VariantManifest& variant, const CompareOptions& options);

// Effects with something to compare; where there are none, whatever the scene calls for, so that its picture and cost are
// known.
std::vector<const EffectManifest*> compared_effects(const Plan& plan);
std::vector<std::string> variant_names(const std::vector<const EffectManifest*>& effects);
// Throws Error(bad_input) where the frame is larger than the device can draw.
void check_size(std::string_view stage, const CompareOptions& options, const DeviceInfo& device);

// The folder that holds variants/ and shaders/: LAMINA_HOME in the environment, else the source folder of this build.
std::filesystem::path home_folder();
Library load_library_for(const SceneOptions& options);
// Throws Error(bad_input) for the first of `wanted` that is not in `known`, with the nearest known name. `stage` is the
// command.
void check_variant_names(std::string_view stage, const std::vector<std::string>& wanted, const std::vector<std::string>& known);
// Makes `out` and its images/, which may be there. Throws Error(bad_input) where they cannot be made or written.
void make_run_folder(std::string_view stage, const std::filesystem::path& out);
// The backend, or null where it does not open here: then standard error and `failure` say why. Throws Error(bad_input) for a
// name that is none.
std::unique_ptr<Backend> try_open_backend(std::string_view name, const BackendOptions& options, std::string& failure);
[[noreturn]] void throw_no_backend(std::string_view stage);
// A scene that has objects and views, or Error(bad_input).
Scene load_scene_for(const SceneOptions& options, const Library& library);

// One line on standard error that is written over, with the fraction done and the time left; silent where no person watches.
class Progress {
 public:
  explicit Progress(std::string title);
  ~Progress();
  void show(double fraction, const std::string& what);

 private:
  std::string title_;
  bool watched_;
  double start_s_;
};

}  // namespace lamina
