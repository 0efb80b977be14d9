// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/gate_process.h"

#include <algorithm>
#include <limits>

#include "harness/record/kept_certificate.h"
#include "harness/record/record.h"

namespace lamina {
namespace {

constexpr double enough_of_margin = 0.3;
constexpr double max_certificate_share = 0.2;  // of the budget; the next process asks again

}  // namespace

GateProcess::GateProcess(const GateTask& of_task, const std::filesystem::path& shaders, const GateOptions& given,
                         const EmitLine& emit)
    : task(of_task),
      options(given),
      backend(open_backend(task.backend, {options.compare.device, options.compare.validation})),
      certified(!task.certify || certify(*backend, shaders, given, emit)),
      random(options.seed + 7919 * task.process) {}

GateProcess::SceneThere::SceneThere(Backend& backend, const Tree& tree, const CellOptions& options)
    : bakes(*tree.scene, *tree.library.code, DiskCache(options.cache)),
      resources(backend, *tree.scene, tree.library, options.width_px, options.height_px, &bakes) {}

SceneOnDevice GateProcess::scene_of(const Tree& tree) {
  std::unique_ptr<SceneThere>& there = scenes_[tree.scene.get()];
  if (!there) there = std::make_unique<SceneThere>(*backend, tree, options.compare);
  return {tree.scene.get(), &tree.plan, &there->bakes, &there->resources};
}

bool GateProcess::certify(Backend& backend, const std::filesystem::path& shaders, const GateOptions& options,
                          const EmitLine& emit) {
  const TimerRow timer = certified_timer(backend, shaders, options.compare.cache, options.budget_s * max_certificate_share);
  emit({{"timer", to_json(timer)}});
  return timer.ok;
}

void GateProcess::end(const EmitLine& emit) { emit({{"messages", backend->take_messages()}, {"rounds_s", rounds_s}}); }

ReadyFrame& ProcessFrames::get(Tree& tree, const VariantManifest& variant, size_t copy) {
  std::unique_ptr<ReadyFrame>& ready = made_[{&tree, &variant, copy}];
  if (!ready)
    ready = std::make_unique<ReadyFrame>(*process_.scene_of(tree).resources, tree.plan, configuration_with(tree.plan, variant),
                                         tree.shaders.at(process_.backend->info().api));
  return *ready;
}

void TimedFrames::add(std::string_view name, ReadyFrame& ready, size_t same_passes) {
  names.emplace_back(name);
  frames.push_back({&ready.frame, same_passes, ready.pass_ms});
  view = ready.view;
}

PairsRow TimedFrames::row(const GateProcess& process) const {
  return {process.task.process, process.task.backend, effect, variant, view, names, paired->passes()};
}

std::vector<PairsRow> rows_of(const std::vector<TimedFrames>& all, const GateProcess& process) {
  std::vector<PairsRow> rows;
  for (const TimedFrames& timed : all) rows.push_back(timed.row(process));
  return rows;
}

void time_rounds(GateProcess& process, std::vector<TimedFrames>& all, const Enough& enough, const PieceOptions& pieces) {
  const Stopwatch watch;
  for (TimedFrames& each : all)
    if (each.paired)
      each.paired->start_again();
    else
      each.paired = std::make_unique<PairedFrames>(*process.backend, each.frames, 0, pieces);
  std::vector<TimedFrames*> unsure;
  for (TimedFrames& each : all) unsure.push_back(&each);
  while (!unsure.empty()) {
    const Stopwatch whole_frame;
    for (size_t round = 0; round < rounds_a_frame; ++round) {
      std::shuffle(unsure.begin(), unsure.end(), process.random);
      for (TimedFrames* timed : unsure) timed->paired->run_round(process.random);
    }
    const double further_s = whole_frame.elapsed_s();
    std::erase_if(unsure,
                  [&](const TimedFrames* timed) { return StopSignals::stopped_by() != 0 || enough(*timed, further_s); });
  }
  process.rounds_s += watch.elapsed_s();
}

bool precise_enough(const TimedFrames& timed, const GateProcess& process, const LimitsFile& limits) {
  return worst_error(timed.row(process), limits) < enough_of_margin;
}

GateMeasurements measure_in_processes(const GateOptions& options, const Stopwatch& watch,
                                      const std::function<void(const GateTask&, const EmitLine&)>& work,
                                      const std::function<bool(const GateMeasurements&)>& fails,
                                      const std::function<std::set<std::string>(const std::vector<PairsRow>&)>& undecided) {
  GateMeasurements measured;
  std::set<std::string> broken;
  // Tasks that run at the same time, and what they gave.
  const auto run_beside = [&](const std::vector<GateTask>& tasks) {
    std::vector<std::function<void(const EmitLine&)>> works;
    for (const GateTask& task : tasks) works.push_back([&](const EmitLine& emit) { work(task, emit); });
    const std::vector<ChildResult> children = run_in_children(works);
    for (size_t i = 0; i < tasks.size(); ++i) {
      take_lines(children[i], tasks[i], measured);
      if (!children[i].failure.empty()) broken.insert(tasks[i].backend);
    }
  };
  // A process on each of these backends, with an equal share of the time left for this and `rounds` - 1 more of the same.
  const auto run_on = [&](std::vector<std::string> backends, bool exact, size_t rounds) {
    std::erase_if(backends, [&](const std::string& backend) { return broken.contains(backend); });
    std::vector<GateTask> tasks;
    for (size_t i = 0; i < backends.size(); ++i) {
      const double turns = static_cast<double>(options.side_by_side ? rounds : rounds * backends.size() - i);
      tasks.push_back({backends[i], measured.processes, exact, !exact && !measured.certified(backends[i]),
                       (options.budget_s - watch.elapsed_s()) / turns});
      if (!options.side_by_side || i + 1 == backends.size()) run_beside(tasks), tasks.clear();
    }
  };
  const auto stopped = [] { return StopSignals::stopped_by() != 0; };
  run_on(options.compare.backends, true, 1);
  if (stopped() || (fails && fails(measured))) return measured;
  double min_process_s = std::numeric_limits<double>::infinity();  // on all backends
  // Two processes tell how far processes differ. Against a record all are needed: they share the rounds that give an interval.
  const size_t least = undecided ? std::min<size_t>(2, options.processes) : options.processes;
  for (; options.times && !stopped() && measured.processes < options.processes; ++measured.processes) {
    const double begin_s = watch.elapsed_s();
    if (measured.processes >= least && begin_s + min_process_s > options.budget_s) break;
    run_on(options.compare.backends, false, options.processes - measured.processes);
    min_process_s = std::min(min_process_s, watch.elapsed_s() - begin_s);
  }
  while (options.times && !stopped() && undecided && !measured.pairs.empty()) {
    std::vector<std::string> backends;
    for (const std::string& backend : undecided(measured.pairs))
      if (!broken.contains(backend)) backends.push_back(backend);
    const double share =
        options.side_by_side ? 1 : static_cast<double>(backends.size()) / static_cast<double>(options.compare.backends.size());
    if (backends.empty() || options.budget_s - watch.elapsed_s() < min_process_s * share) break;
    run_on(backends, false, 1);
    ++measured.processes;
  }
  return measured;
}

}  // namespace lamina
