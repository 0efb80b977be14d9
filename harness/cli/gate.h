// SPDX-License-Identifier: Apache-2.0
// What the commands of the gate share: the options, the two trees, and what a process of measuring hands over.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <set>

#include "harness/cli/common.h"
#include "harness/cli/devices.h"
#include "harness/core/stop_signals.h"
#include "harness/core/stopwatch.h"
#include "harness/gate/child.h"
#include "harness/gate/exact_verdicts.h"
#include "harness/gate/pairs.h"
#include "harness/measure/timer_certificate.h"
#include "harness/record/record.h"

namespace lamina {

struct GateOptions {
  CellOptions compare;             // what is measured, and how exactly
  std::filesystem::path against;   // a folder with variants/ and shaders/: the state before
  std::filesystem::path baseline;  // or a record
  bool update = false;             // write the record in place of checking it
  std::filesystem::path limits;    // a gate file; empty: the defaults
  double budget_s = 60;            // wall time of everything
  size_t processes = 5;            // on each backend, if the budget lasts: each lays out code and memory anew
  double family_error = 0.05;      // chance of any wrong verdict on times
  bool times = true;
  uint64_t seed = 1;  // of the order of rounds
  // Backends at the same time: software rasterizers that run in the caller's thread. Two threads share tiles by chance, which
  // spreads the ratio of a strip to its twin; one each spreads it less, and two cores measure twice as much.
  bool side_by_side = false;
  bool self_test = false;
  bool calibrate = false;
  size_t equal_gates = 200, slower_gates = 40;  // of a calibration: over equal trees; for each slow-down
  std::vector<uint32_t> slow_downs;             // that it looks at, percent; empty: all
};

// Variants and shaders at one state of the code, and the scene as its effects declare it.
struct Tree {
  std::shared_ptr<const Library> owner;
  const Library& library;              // owner's
  std::shared_ptr<const Scene> scene;  // one for trees whose effects declare the same
  Plan plan;                           // points into library
  std::map<Api, ShaderCache> shaders;
};

// One variant, before and after. Null: not there.
struct VariantPair {
  const EffectManifest *effect_before = nullptr, *effect_after = nullptr;
  const VariantManifest *before = nullptr, *after = nullptr;
  bool same_code = false;    // what is executed is the same
  bool same_errors = false;  // and so is that of the baseline and of the truth, which errors are against
  size_t same_passes = 0;    // of the frame, from its first on, that execute the same too
  std::string failure;       // of the one after, where it cannot even be compiled
};

struct TreePair {
  Tree before, after;
  std::vector<VariantPair> variants;  // of the effects that the scene calls for
};

// max_change() of pictures, by backend, effect, variant and view.
using PictureChanges = std::map<std::array<std::string, 4>, double>;

// What one process does on one backend.
struct GateTask {
  std::string backend;
  size_t process = 0;              // among those that time
  size_t processes = 1;            // that will time, if the budget lasts
  bool exact = false;              // counts, pictures and errors; else times
  bool certify = false;            // the timer first
  double until_s = 0;              // seconds of this process's own clock, for everything; its least rounds are run in any case
  std::set<TimedCell> only{};      // what is timed; what has none on this backend, and an empty one: everything
  PictureChanges changes{};        // that are known by then
  TimerRounds certified_so_far{};  // by earlier processes
  bool times(const std::string& effect, const std::string& variant) const;
};

// Where the time of a gate went, s by the host's clock.
struct GateSpent {
  double loading = 0, exact = 0, timing = 0, report = 0;
  double rounds = 0, certifying = 0;  // within timing, on all backends together
  // One line, beside the budget; `backends`: how many ran at the same time.
  std::string words(double all_s, double budget_s, size_t backends) const;
};

// Runs in the child. Emits {"cell":..,"side":"before"|"after"}, {"change":..}, {"pairs":..}, {"timer":..}, {"certified":..} and
// {"messages":.., "rounds_s":..} objects.
void measure_pairs_of_trees(TreePair& trees, const GateTask& task, const GateOptions& options, const LimitsFile& limits,
                            const EmitLine& emit);

// What the processes of a gate have handed over.
struct GateMeasurements {
  std::vector<TimerRow> timers;
  std::vector<CellRow> cells_before, cells_after;
  PictureChanges changes;
  std::vector<PairsRow> pairs;
  std::vector<VerdictRow> failures;  // of backends and processes
  size_t processes = 0;
  GateSpent spent;
  double ready_s = 0;                                   // the longest that a backend took to open and make its frames ready
  std::map<std::string, TimerRounds> certified_so_far;  // by backend, where the certificate is still open
  std::set<std::string> out_of_time;                    // backends on which the budget left no time for rounds

  // The backend's certificate, one: a later process goes on with it. Null: none.
  const TimerRow* timer(const std::string& backend) const;
  bool certified(const std::string& backend) const;  // by that one
};

// Runs processes on every backend until `options.processes` have run on each and times are precise, or the budget is spent.
// Where no variant can have changed, none is run.
// `watch` began with the command.
GateMeasurements measure_trees(TreePair& trees, const GateOptions& options, const LimitsFile& limits, const Stopwatch& watch);

// Whether the variant's cells are drawn and compared: they may differ, or the limits bound their errors.
bool is_drawn(const VariantPair& pair, const Limits& limits);

// The trees of `lamina gate SCENE --against DIR`; shaders of the one after are changed by `change`, where there is one. Throws
// Error(bad_input) where they have no variant in common.
TreePair pair_trees(Library before, Library after, const GateOptions& options, const ShaderCache::Change& change = {});

// The cell of these among `cells`, if there is one.
std::optional<CellRow> find_cell(const std::vector<CellRow>& cells, const std::string& backend, const std::string& effect,
                                 const std::string& variant, const std::string& view);

// All verdicts on two trees.
struct GateResult {
  std::vector<VerdictRow> rows;
  TimeReport times;
};
GateResult judge_trees(const TreePair& trees, const GateMeasurements& measured, const GateOptions& options,
                       const LimitsFile& limits);

// The library with the scene that the options name, its plan, and shader caches for the APIs of these backends. `known`: a tree
// whose scene serves this one too where their effects declare the same.
Tree load_tree(Library library, const CellOptions& options, const Tree* known = nullptr);
// Sorts what a process has handed over into `measured`.
void take_lines(const ChildResult& child, const GateTask& task, GateMeasurements& measured);
VerdictRow judge_timer(const TimerRow& timer);
// The devices of the backends. Throws Error(no_device) where one of them does not open.
std::vector<DeviceInfo> probe_devices(const GateOptions& options);

// The verdict of a gate that a signal has stopped: what is not measured is not judged.
VerdictRow stopped_row();

// The run's line. Its budget and precision of rounds are the defaults: a gate's processes stop by other rules.
nlohmann::ordered_json gate_run_line(const GateOptions& options, const Scene& scene, const std::vector<DeviceInfo>& devices);

// Pins llvmpipe's threads to as many as the stored record's run had where that ran on this machine: else nothing could be
// compared but ratios. To be called before any backend opens.
void pin_threads_of(const Record& stored);

// Whether backends can be measured at the same time and judged by ratios: software rasterizers without threads of their own,
// and a core for each.
bool can_run_side_by_side(const std::vector<DeviceInfo>& devices);

// Each is a whole gate, or many, and returns the exit status.
int run_calibration(GateOptions options);
int run_self_test(GateOptions options);
int run_against_record(GateOptions options, const Stopwatch& watch);

// Appends the rows, each with its sentence.
void append_verdicts(RecordWriter& record, std::vector<VerdictRow> rows);

// Reports from the record in `out`; prints the table, and where the time went since `watch` began. Returns the exit status that
// the record holds, or the signal's that has stopped the gate.
int finish_gate(const GateOptions& options, GateSpent spent, const Stopwatch& watch);

}  // namespace lamina
