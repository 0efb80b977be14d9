// SPDX-License-Identifier: Apache-2.0
// The processes of a gate: which run, for how long, and what all of them have: a device, its timer's certificate, the scene
// there, frames that are timed against each other.
#pragma once

#include <random>
#include <set>

#include "harness/backend/backend.h"
#include "harness/cli/effect_run.h"
#include "harness/cli/gate.h"
#include "harness/record/kept_certificate.h"

namespace lamina {

// A backend with the scene on it, in the child.
class GateProcess {
 public:
  // Opens and, where the task says so, certifies the timer, for a share of the budget: what is then open goes on between
  // rounds. Throws Error where the backend does not open. `shaders`: the folder of the certificate's.
  GateProcess(const GateTask& task, const std::filesystem::path& shaders, const GateOptions& options);
  // Emits {"timer":..} where it was certified here, {"certified":..}, its rounds, where it is still open, and {"messages":..},
  // what the API's checker said, with the seconds that rounds and the certificate took and after which frames were ready.
  // Nothing may follow.
  void end(const EmitLine& emit);
  // Whether the timer is certified, or may yet be.
  bool may_time() const { return !certificate || certificate->is_open() || certificate->row().ok; }

  const GateTask& task;
  const GateOptions& options;
  const Stopwatch watch;
  std::unique_ptr<Backend> backend;
  std::unique_ptr<PendingCertificate> certificate;  // null: none was asked for
  std::mt19937_64 random;                           // of the orders: another seed in each process
  double rounds_s = 0;                              // without the certificate's between them
  double ready_s = 0;

  // A tree's scene on the device; trees with one scene share it.
  SceneOnDevice scene_of(const Tree& tree);

 private:
  struct SceneThere {
    SceneThere(Backend& backend, const Tree& tree, const CellOptions& options);
    Bakes bakes;
    SceneResources resources;
  };
  std::map<const Scene*, std::unique_ptr<SceneThere>> scenes_;
};

// Frames of one effect or variant that are timed against the first of them.
struct TimedFrames {
  std::string effect, variant;  // variant "": the frames are the effect's variants
  std::vector<std::string> names;
  std::vector<PairedFrame> frames;
  std::unique_ptr<PairedFrames> paired;

  void add(std::string_view name, ReadyFrame& ready, size_t same_passes = 0);
  std::string view;  // that is drawn
  PairsRow row(const GateProcess& process) const;
};

// The frames of a process by tree and variant, each made when it is first asked for.
class ProcessFrames {
 public:
  explicit ProcessFrames(GateProcess& process) : process_(process) {}

  struct Wanted {
    std::string_view name;  // among those that are timed
    Tree* tree;
    const VariantManifest* variant;
    size_t copy = 0;  // another one of the same tree and variant is another frame
    size_t same_passes = 0;
  };
  // These, to be timed against the first. Those that are not there yet are made in shuffled order. Those that have the same
  // targets draw into those of one of them: the place of targets in memory moves the time of a pass by up to 17%, and the frame
  // that is made first is mostly the slower one. Where trees draw other pictures, only frames of one tree do: a pass may take
  // another time for another input.
  TimedFrames timed(const std::vector<Wanted>& wanted, bool same_pictures = true);

 private:
  ReadyFrame& get(const Wanted& wanted, const Frame* like);

  GateProcess& process_;
  std::map<std::tuple<const Tree*, const VariantManifest*, size_t>, std::unique_ptr<ReadyFrame>> made_;
};

std::vector<PairsRow> rows_of(const std::vector<TimedFrames>& all, const GateProcess& process);

// Whether these have been timed for long enough; a further whole frame of all that are timed would take about `further_s`.
using Enough = std::function<bool(const TimedFrames&, double further_s)>;
// Times rounds of all of them in shuffled order, of each until `enough` says so of it, asked after every whole frame. Cuts the
// frames on the first call; later ones begin anew. A signal to stop ends the rounds after a whole frame.
void time_rounds(GateProcess& process, std::vector<TimedFrames>& all, const Enough& enough, const PieceOptions& pieces = {});

// Whether these may stop: the error of each of their ratios is less than 0.6 of its margin. That is about how far processes
// differ, so that more rounds tell less than another process in the same time.
bool precise_enough(const TimedFrames& timed, const GateProcess& process, const LimitsFile& limits);

// Runs `work` in children: one on every backend for counts and pictures; if options.times, and these do not fail the gate by
// `fails`, options.processes that time, each with its share of the budget, or as few as fit into it; then, while `undecided`
// names cells or a timer's certificate is open, and there is time for as short a process as has been, more of them for these.
// Without `undecided` two run in any case. The report is written within the budget too. Backends take turns, or run side by
// side where the options say so. One on which a process fails is left alone after it. A signal to stop ends what runs, and no
// more is run. Pairs are of backends whose timers were certified.
GateMeasurements measure_in_processes(const GateOptions& options, const Stopwatch& watch,
                                      const std::function<void(const GateTask&, const EmitLine&)>& work,
                                      const std::function<bool(const GateMeasurements&)>& fails,
                                      const std::function<std::set<TimedCell>(const std::vector<PairsRow>&)>& undecided);

}  // namespace lamina
