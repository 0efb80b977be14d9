// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/gate_process.h"

#include <algorithm>

#include "harness/measure/timer_certificate.h"
#include "harness/record/record.h"

namespace lamina {
namespace {

// A further process is not begun for less: most of it would be preparation.
constexpr double least_process_s = 4;

}  // namespace

GateProcess::GateProcess(const GateTask& of_task, const Scene& scene, const std::filesystem::path& shaders,
                         const GateOptions& given, const EmitLine& emit)
    : task(of_task),
      options(given),
      backend(open_backend(task.backend, {options.compare.device, options.compare.validation})),
      certified(!task.certify || certify(*backend, shaders, emit)),
      bakes(scene, DiskCache(options.compare.cache)),
      resources(*backend, scene, options.compare.width_px, options.compare.height_px, &bakes),
      random(options.compare.seed + 7919 * task.process) {}

bool GateProcess::certify(Backend& backend, const std::filesystem::path& shaders, const EmitLine& emit) {
  const TimerRow timer = certify_timer(backend, shaders);
  emit({{"timer", to_json(timer)}});
  return timer.ok;
}

void GateProcess::end(const EmitLine& emit) { emit({{"messages", backend->take_messages()}, {"rounds_s", rounds_s}}); }

Frame& ProcessFrames::get(Tree& tree, const VariantManifest& variant, size_t copy) {
  if (copy == 0)
    for (const auto& [of_tree, run] : runs_)
      if (Frame* frame = of_tree == &tree ? run->frame(variant.name) : nullptr) return *frame;
  std::unique_ptr<ReadyFrame>& ready = made_[{&tree, &variant, copy}];
  if (!ready)
    ready = std::make_unique<ReadyFrame>(process_.resources, tree.plan, variant, tree.shaders.at(process_.backend->info().api));
  return ready->frame;
}

void TimedFrames::add(std::string_view name, Frame& frame) {
  names.emplace_back(name);
  frames.push_back(&frame);
}

PairsRow TimedFrames::row(const GateProcess& process) const {
  return {process.task.process, process.task.backend, effect, variant, process.resources.scene().views.front().name, names,
          paired->passes()};
}

std::vector<PairsRow> rows_of(const std::vector<TimedFrames>& all, const GateProcess& process) {
  std::vector<PairsRow> rows;
  for (const TimedFrames& timed : all) rows.push_back(timed.row(process));
  return rows;
}

void time_rounds(GateProcess& process, std::vector<TimedFrames>& all, const std::function<bool()>& enough) {
  const Stopwatch watch;
  for (TimedFrames& each : all)
    if (each.paired)
      each.paired->start_again();
    else
      each.paired = std::make_unique<PairedFrames>(*process.backend, each.frames, 0);
  std::vector<size_t> order(all.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = i;
  for (size_t round = 0; round < least_rounds || round % rounds_a_frame != 0 || !enough(); ++round) {
    std::shuffle(order.begin(), order.end(), process.random);
    for (const size_t i : order) all[i].paired->run_round(process.random);
  }
  process.rounds_s += watch.elapsed_s();
}

GateMeasurements measure_in_processes(const GateOptions& options, const Stopwatch& watch,
                                      const std::function<void(const GateTask&, const EmitLine&)>& work,
                                      const std::function<std::set<std::string>(const std::vector<PairsRow>&)>& undecided) {
  GateMeasurements measured;
  std::set<std::string> broken;
  // On each of these backends, with an equal share of the time left for this and `rounds` - 1 more of the same.
  const auto run_on = [&](const std::vector<std::string>& backends, size_t rounds) {
    for (size_t i = 0; i < backends.size(); ++i) {
      if (broken.contains(backends[i])) continue;
      const double share = (options.budget_s - watch.elapsed_s()) / static_cast<double>(rounds * backends.size() - i);
      const bool first = measured.processes == 0;
      const GateTask task{backends[i], measured.processes, options.certify && options.times && !measured.certified(backends[i]),
                          options.exact && first, share};
      const ChildResult child = run_in_child([&](const EmitLine& emit) { work(task, emit); });
      take_lines(child, task, measured);
      if (!child.failure.empty()) broken.insert(backends[i]);
    }
    ++measured.processes;
  };
  for (size_t left = options.times ? options.processes : 1; left > 0; --left) run_on(options.compare.backends, left);
  while (options.times && undecided && !measured.pairs.empty()) {
    std::vector<std::string> backends;
    for (const std::string& backend : undecided(measured.pairs))
      if (!broken.contains(backend)) backends.push_back(backend);
    if (backends.empty() || options.budget_s - watch.elapsed_s() < least_process_s * static_cast<double>(backends.size()))
      break;
    run_on(backends, 1);
  }
  return measured;
}

}  // namespace lamina
