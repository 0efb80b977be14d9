// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/gate_process.h"

#include <algorithm>
#include <limits>

#include "harness/record/kept_certificate.h"
#include "harness/record/record.h"

namespace lamina {
namespace {

constexpr double enough_of_margin = 0.6;
constexpr double max_certificate_share = 0.4;  // of a process, before its rounds
constexpr double report_s = 1;                 // of the budget: writing the record and the report
constexpr double min_rounds_s = 1;             // of a process, at a guess

}  // namespace

GateProcess::GateProcess(const GateTask& of_task, const std::filesystem::path& shaders, const GateOptions& given)
    : task(of_task),
      options(given),
      backend(open_backend(task.backend, {options.compare.device, options.compare.validation})),
      random(options.seed + 7919 * task.process) {
  if (!task.certify) return;
  const auto stop = [] { return StopSignals::stopped_by() != 0; };
  certificate = std::make_unique<PendingCertificate>(*backend, shaders, options.compare.cache, stop, task.certified_so_far);
  certificate->measure_alone(std::min(certificate_alone_s, max_certificate_share * task.until_s));
}

GateProcess::SceneThere::SceneThere(Backend& backend, const Tree& tree, const CellOptions& options)
    : bakes(*tree.scene, *tree.library.code, DiskCache(options.cache)),
      resources(backend, *tree.scene, tree.library, options.width_px, options.height_px, &bakes) {}

SceneOnDevice GateProcess::scene_of(const Tree& tree) {
  std::unique_ptr<SceneThere>& there = scenes_[tree.scene.get()];
  if (!there) there = std::make_unique<SceneThere>(*backend, tree, options.compare);
  return {tree.scene.get(), &tree.plan, &there->bakes, &there->resources};
}

void GateProcess::end(const EmitLine& emit) {
  if (certificate) certificate->measure_alone(certificate->spent_s() + task.until_s - watch.elapsed_s());
  if (certificate) emit({{"timer", to_json(certificate->row())}});
  if (certificate && certificate->is_open()) {
    const TimerRounds rounds = certificate->rounds();
    emit({{"certified", {{"effort", rounds.effort}, {"times_ms", rounds.times_ms}, {"wall_ms", rounds.wall_ms}}}});
  }
  emit({{"messages", backend->take_messages()},
        {"rounds_s", rounds_s},
        {"certifying_s", certificate ? certificate->spent_s() : 0.0},
        {"ready_s", ready_s}});
}

TimedFrames ProcessFrames::timed(const std::vector<Wanted>& wanted, bool same_pictures) {
  std::vector<Wanted> order = wanted;
  std::shuffle(order.begin(), order.end(), process_.random);
  std::stable_partition(order.begin(), order.end(), [&](const Wanted& each) {
    return made_.contains({each.tree, each.variant, each.copy});
  });
  std::map<const Tree*, const Frame*> first;
  for (const Wanted& each : order) {
    const Frame*& like = first[same_pictures ? nullptr : each.tree];
    const Frame& frame = get(each, like).frame;
    if (!like) like = &frame;
  }
  TimedFrames timed{wanted.front().variant->effect, wanted.front().variant->name, {}, {}, nullptr, {}};
  for (const Wanted& each : wanted) timed.add(each.name, get(each, nullptr), each.same_passes);
  return timed;
}

ReadyFrame& ProcessFrames::get(const Wanted& wanted, const Frame* like) {
  std::unique_ptr<ReadyFrame>& ready = made_[{wanted.tree, wanted.variant, wanted.copy}];
  if (!ready) {
    Tree& tree = *wanted.tree;
    ready = std::make_unique<ReadyFrame>(*process_.scene_of(tree).resources, tree.plan,
                                         configuration_with(tree.plan, *wanted.variant),
                                         tree.shaders.at(process_.backend->info().api), Parameters{}, Timing::bracketed, like);
  }
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
  double certifying_s = 0;
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
    if (process.certificate) {
      const Stopwatch certifying;
      process.certificate->run_round();
      certifying_s += certifying.elapsed_s();
    }
    std::erase_if(unsure,
                  [&](const TimedFrames* timed) { return StopSignals::stopped_by() != 0 || enough(*timed, further_s); });
  }
  process.rounds_s += watch.elapsed_s() - certifying_s;
}

bool precise_enough(const TimedFrames& timed, const GateProcess& process, const LimitsFile& limits) {
  return worst_error(timed.row(process), limits) < enough_of_margin;
}

GateMeasurements measure_in_processes(const GateOptions& options, const Stopwatch& watch,
                                      const std::function<void(const GateTask&, const EmitLine&)>& work,
                                      const std::function<bool(const GateMeasurements&)>& fails,
                                      const std::function<std::set<TimedCell>(const std::vector<PairsRow>&)>& undecided) {
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
  const double end_s = options.budget_s - report_s;
  // A process on each of these backends, with an equal share of the time left for this and `rounds` - 1 more of the same.
  std::set<TimedCell> only;
  const auto run_on = [&](std::vector<std::string> backends, bool exact, size_t rounds) {
    std::erase_if(backends, [&](const std::string& backend) { return broken.contains(backend); });
    std::vector<GateTask> tasks;
    for (size_t i = 0; i < backends.size(); ++i) {
      const double turns = static_cast<double>(options.side_by_side ? rounds : rounds * backends.size() - i);
      tasks.push_back({.backend = backends[i],
                       .process = measured.processes,
                       .processes = measured.processes + rounds,
                       .exact = exact,
                       .certify = !exact && !measured.certified(backends[i]),
                       .until_s = std::max(0.0, end_s - watch.elapsed_s()) / turns,
                       .only = only,
                       .changes = measured.changes});
      if (const auto open = measured.certified_so_far.find(backends[i]); open != measured.certified_so_far.end())
        tasks.back().certified_so_far = open->second;
      if (!options.side_by_side || i + 1 == backends.size()) run_beside(tasks), tasks.clear();
    }
  };
  const auto stopped = [] { return StopSignals::stopped_by() != 0; };
  const double begin_s = watch.elapsed_s();
  run_on(options.compare.backends, true, 1);
  measured.spent.exact = watch.elapsed_s() - begin_s;
  if (!options.times || stopped() || (fails && fails(measured))) return measured;

  // How long a process takes at least, on all backends: at first by what it took to make frames ready.
  double process_s =
      (measured.ready_s + min_rounds_s) * static_cast<double>(options.side_by_side ? 1 : options.compare.backends.size());
  const auto fitting = [&] { return static_cast<size_t>(std::max(0.0, end_s - watch.elapsed_s()) / process_s); };
  // Two processes tell how far processes differ; fewer tell nothing. Against a record they share the rounds that give an
  // interval.
  constexpr size_t min_processes = 2;
  size_t wanted = std::min(options.processes, fitting());
  if (wanted < min_processes) wanted = undecided ? 0 : std::min(min_processes, options.processes);
  if (wanted == 0) measured.out_of_time.insert(options.compare.backends.begin(), options.compare.backends.end());
  const auto run_timed = [&](const std::vector<std::string>& backends, size_t rounds) {
    const double process_begin_s = watch.elapsed_s();
    run_on(backends, false, rounds);
    ++measured.processes;
    const double share =
        options.side_by_side ? 1 : static_cast<double>(backends.size()) / static_cast<double>(options.compare.backends.size());
    const double took_s = (watch.elapsed_s() - process_begin_s) / share;
    process_s = measured.processes == 1 ? took_s : std::min(process_s, took_s);
  };
  while (!stopped() && measured.processes < wanted) {
    if (undecided && measured.processes >= min_processes && fitting() == 0) break;
    run_timed(options.compare.backends, wanted - measured.processes);
    wanted = std::max(wanted, std::min(options.processes, measured.processes + fitting()));
  }
  while (!stopped() && undecided && !measured.pairs.empty()) {
    only = undecided(measured.pairs);  // what is decided leaves its time to the rest
    std::set<std::string> open;
    for (const TimedCell& cell : only) open.insert(cell[0]);
    for (const auto& [backend, rounds] : measured.certified_so_far) open.insert(backend);
    std::erase_if(open, [&](const std::string& backend) { return broken.contains(backend); });
    const double share =
        options.side_by_side ? 1 : static_cast<double>(open.size()) / static_cast<double>(options.compare.backends.size());
    if (open.empty() || end_s - watch.elapsed_s() < process_s * share) break;
    run_timed({open.begin(), open.end()}, 1);
  }
  std::erase_if(measured.pairs, [&](const PairsRow& row) { return !measured.certified(row.backend); });
  measured.spent.timing = watch.elapsed_s() - begin_s - measured.spent.exact;
  return measured;
}

}  // namespace lamina
