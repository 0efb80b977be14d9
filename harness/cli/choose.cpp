// SPDX-License-Identifier: Apache-2.0
// lamina choose: one variant for each effect of a scene, so that the error is least within a budget, or the time least within
// an error. Every variant is drawn and counted once, alone; times are predicted by the device's cost model and errors by adding
// up; the best predicted choices are measured until no other can be the best. The choice is judged again on views and at a
// moment that the search has not seen.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "harness/choose/search.h"
#include "harness/cli/calibrate_cost.h"
#include "harness/cli/commands.h"
#include "harness/cli/common.h"
#include "harness/cli/devices.h"
#include "harness/cli/drawn_options.h"
#include "harness/cli/progress.h"
#include "harness/core/text.h"
#include "harness/plan/configuration_file.h"
#include "harness/record/kept_certificate.h"
#include "harness/sweep/answers.h"

namespace lamina {
namespace {

struct ChooseOptions : CellOptions {
  std::string budget;               // "4ms"
  std::vector<std::string> limits;  // METRIC=NUMBER
  std::optional<double> min_ssim, max_flip;
  std::string to = "baseline";
  bool exhaustive = false;
  RoundOptions rounds{.budget_s = 6, .precision = 0.02};  // of each batch
};

double parse_budget(const std::string& text) {
  double ms = 0;
  char rest = 0;
  std::string number = text;
  if (number.ends_with("ms")) number.resize(number.size() - 2);
  if (std::sscanf(number.c_str(), "%lf%c", &ms, &rest) != 1 || !(ms > 0))
    throw Error(ErrorKind::bad_input, "choose", "--budget",
                fmt::format("'{}' must be a time above 0 in milliseconds, such as 4ms", text));
  return ms;
}

ChoiceGoal goal_of(const ChooseOptions& options) {
  ChoiceGoal goal;
  if (!options.budget.empty()) goal.budget_ms = parse_budget(options.budget);
  if (options.min_ssim) goal.limits.push_back({"ssim", *options.min_ssim});
  if (options.max_flip) goal.limits.push_back({"flip", *options.max_flip});
  for (const std::string& text : options.limits) {
    const Limit limit = parse_limit("choose", text);
    greater_is_better(limit.metric);  // throws for what is no error
    goal.limits.push_back({limit.metric, limit.value});
  }
  if (!goal.budget_ms && goal.limits.empty())
    throw Error(ErrorKind::bad_input, "choose", "goal",
                "give --budget, --min-ssim, --max-flip or --limit: what is the frame allowed to cost, or to lose?");
  if (!goal.limits.empty()) goal.metric = goal.limits.front().metric;
  return goal;
}

std::string words_of(const DrawnOptions& search, const Choice& choice) {
  std::string words;
  for (size_t e = 0; e < choice.size(); ++e) words += (e > 0 ? " + " : "") + search.name(choice, e);
  return words;
}

std::string figures_of(const Outcome& outcome) {
  const double psnr = worst_error(outcome, "psnr_db");
  return fmt::format("{:9.4g} ms  SSIM {:.4f}  FLIP {:.4f}  PSNR {}", worst_ms(outcome), worst_error(outcome, "ssim"),
                     worst_error(outcome, "flip"), std::isinf(psnr) ? "inf" : fmt::format("{:.1f} dB", psnr));
}

// Measures choices in rounds beside the baselines.
ChoiceSearch searched(const DrawnOptions& search, const ChoiceGoal& goal, const Plan& plan, ChoiceRun& run,
                      const RoundOptions& rounds, const Tell& tell) {
  const auto most = static_cast<double>(measured_at_most(search.space.choices()));
  size_t done = 1;
  return search_choices(search.space, goal, search.doubt, [&](const std::vector<Choice>& next) {
    tell(static_cast<double>(done) / most, "measuring choices");
    done += next.size();
    std::vector<Configuration> timed = {configuration_of(plan, {})};
    for (const Choice& choice : next) timed.push_back(search.configuration(plan, choice));
    const std::vector<ChoiceRun::Times> times = run.times_of(timed, rounds);
    std::vector<Outcome> outcomes;
    for (size_t i = 0; i < next.size(); ++i) {
      Outcome& outcome = outcomes.emplace_back(run.errors_of(timed[i + 1]));
      set_times(outcome, times[i + 1], times[0], search.space.baseline);
    }
    return outcomes;
  });
}

// Views half way between the scene's, one after another, and a little off a single one.
std::vector<View> unseen_views(const Scene& scene) {
  std::vector<View> views;
  for (size_t i = 0; i + 1 < std::max<size_t>(scene.views.size(), 2); ++i) {
    View view = scene.views[i];
    const bool single = scene.views.size() == 1;
    const View& next = single ? view : scene.views[i + 1];
    view.eye = single ? view.target + (view.eye - view.target) * 1.15f + 0.1f * glm::length(view.eye - view.target) * view.up
                      : 0.5f * (view.eye + next.eye);
    view.target = 0.5f * (view.target + next.target);
    view.fov_y_degrees = 0.5f * (view.fov_y_degrees + next.fov_y_degrees);
    view.name = single ? view.name + " moved" : fmt::format("between {} and {}", view.name, next.name);
    if (glm::length(view.eye - view.target) > 1e-6f) views.push_back(view);
  }
  return views;
}

// The choice on views, and at a moment, that the search has not seen.
Outcome held_out(Backend& backend, const Library& library, const DrawnOptions& search, const Choice& choice,
                 ShaderCache& shaders, const ChooseOptions& options, const Scene& seen, const Tell& tell) {
  SceneOptions later = options.scene;
  if (seen.moves()) later.time_s = seen.time_s + 0.37f;
  Scene scene = load_scene_for(later, library);
  scene.views = unseen_views(scene);
  const Plan plan = plan_for(options.scene, library, scene, options.aspect());
  Bakes bakes(scene, *library.code, DiskCache(options.cache));
  SceneResources resources(backend, scene, library, options.width_px, options.height_px, &bakes);
  ChoiceRun run({&scene, &plan, &bakes, &resources}, search.effects, shaders, options, options.to == "truth", tell);
  const Configuration configuration = search.configuration(plan, choice);
  Outcome outcome = run.errors_of(configuration);
  const ChoiceRun::Times times = run.times_of({configuration}, options.rounds).front();
  for (size_t view = 0; view < outcome.size(); ++view) outcome[view].ms = median(times[view]);
  return outcome;
}

// Effect by effect: what the next 0.01 of SSIM would cost, by the cheapest other option that has less error.
void print_prices(const ChoiceSearch& known, const DrawnOptions& search, const Choice& choice) {
  fmt::print("\nwhat the next 0.01 of SSIM costs, predicted:\n");
  for (size_t e = 0; e < choice.size(); ++e) {
    const std::optional<Price> price = next_price(known, search.space, choice, e);
    std::string words = "nothing here has less error";
    if (price) {
      const std::string& by = search.space.effects[e].options[price->option].name;
      words = price->gain >= 0.01
                  ? fmt::format("{:+.4g} ms, by {}", price->ms, by)
                  : fmt::format("{:+.4g} ms for {:.4g} more, by {}", price->ms * price->gain / 0.01, price->gain, by);
    }
    fmt::print("  {:<20} {}\n", search.effects[e]->name, words);
  }
}

void print_savings(ChoiceRun& run, const DrawnOptions& search, const RoundOptions& rounds) {
  fmt::print("\nwhat each effect's baseline takes of the frame of baselines, measured by leaving it out:\n");
  for (const EffectManifest* effect : search.effects) {
    try {
      const std::vector<ChoiceRun::Times> times = run.times_without(*effect, rounds);
      double worst = 0;
      for (size_t view = 0; view < times[0].size(); ++view)
        worst = std::max(worst, median(times[0][view]) - median(times[1][view]));
      fmt::print("  {:<20} {:.4g} ms at most\n", effect->name, worst);
    } catch (const Error& error) {
      fmt::print("  {:<20} cannot be left out: {}\n", effect->name, error.what());
    }
  }
}

// What was measured, and the choice, or the nearest where nothing fits. Returns whether it fits.
bool print_found(const ChoiceSearch& known, const DrawnOptions& search, const ChoiceGoal& goal, const Choice& best) {
  std::vector<Choice> choices;
  std::vector<Outcome> outcomes;
  for (const auto& [choice, outcome] : known.measured()) choices.push_back(choice), outcomes.push_back(outcome);
  fmt::print("{} of {} configurations were measured; the worst view counts\n\nthe frontier of what was measured:\n",
             choices.size(), search.space.choices());
  for (const size_t i : frontier_of(outcomes, goal.metric))
    fmt::print("{} {}  {}\n", choices[i] == best ? "*" : " ", figures_of(outcomes[i]), words_of(search, choices[i]));
  for (const std::string& variant : search.left_out) fmt::print("left out: {}\n", variant);
  const Outcome& chosen = known.measured().at(best);
  const bool fits = miss(chosen, goal) == 0;
  fmt::print("\n{}{}: {}\n", fits ? "chosen: " : "nothing fits; the nearest is ", words_of(search, best), figures_of(chosen));
  return fits;
}

// The choice beside the next best of those that fit, in rounds of their own.
void print_confirmed(ChoiceRun& run, const ChoiceSearch& known, const DrawnOptions& search, const ChoiceGoal& goal,
                     const Plan& plan, const Choice& best, const Scene& scene, const RoundOptions& rounds) {
  const Choice* second = nullptr;
  for (const auto& [choice, outcome] : known.measured())
    if (choice != best && miss(outcome, goal) == 0 && (!second || is_better(outcome, known.measured().at(*second), goal)))
      second = &choice;
  if (!second) return;
  const std::vector<ChoiceRun::Times> times =
      run.times_of({search.configuration(plan, *second), search.configuration(plan, best)}, rounds);
  for (size_t view = 0; view < scene.views.size(); ++view) {
    const Interval ratio = ratio_interval(times[1][view], times[0][view]);
    fmt::print("  {}: {:.3f} [{:.3f}, {:.3f}] times the next best, {}\n", scene.views[view].name, ratio.median, ratio.low,
               ratio.high, words_of(search, *second));
  }
}

// Measures all other configurations too, with the fewest rounds, and holds the choice against the best of all.
void print_exhaustive(ChoiceRun& run, ChoiceSearch known, const DrawnOptions& search, const ChoiceGoal& goal, const Plan& plan,
                      const Choice& best, const RoundOptions& rounds, const Tell& tell) {
  RoundOptions fewest = rounds;
  fewest.budget_s = 0;
  const size_t searched = known.measured().size();
  std::vector<Choice> left;
  for (const Choice& choice : all_choices(search.space, goal.metric))
    if (!known.measured().contains(choice)) left.push_back(choice);
  size_t failed = 0;
  for (size_t i = 0; i < left.size(); ++i) {
    tell(static_cast<double>(i) / static_cast<double>(left.size()), "measuring all");
    try {
      const Configuration configuration = search.configuration(plan, left[i]);
      const std::vector<ChoiceRun::Times> times = run.times_of({configuration_of(plan, {}), configuration}, fewest);
      Outcome outcome = run.errors_of(configuration);
      set_times(outcome, times[1], times[0], search.space.baseline);
      known.tell(left[i], outcome);
    } catch (const Error& error) {
      ++failed;
    }
  }
  const Choice of_all = *known.best();
  const Outcome &chosen = known.measured().at(best), &other = known.measured().at(of_all);
  fmt::print("\nof all {} configurations ({} measured by the search, {} that do not run) the best is {}: {}\n",
             search.space.choices(), searched, failed, words_of(search, of_all), figures_of(other));
  if (of_all == best) return;
  // Their times are from different minutes: beside each other they are measured again, in the view where the best takes
  // longest.
  const std::vector<ChoiceRun::Times> times =
      run.times_of({search.configuration(plan, of_all), search.configuration(plan, best)}, rounds);
  const auto longest = std::ranges::max_element(times[0], {}, [](const auto& ms) { return median(ms); });
  const Interval ratio = ratio_interval(times[1][static_cast<size_t>(longest - times[0].begin())], *longest);
  fmt::print("beside it the choice takes {:.3f} [{:.3f}, {:.3f}] times its time, at {:+.4f} {}\n", ratio.median, ratio.low,
             ratio.high, worst_error(chosen, goal.metric) - worst_error(other, goal.metric), goal.metric);
}

int run_choose(const ChooseOptions& options) {
  pin_rasterizer_threads();
  const ChoiceGoal goal = goal_of(options);
  if (options.to != "baseline" && options.to != "truth")
    throw Error(ErrorKind::bad_input, "choose", "--to " + options.to, "is neither baseline nor truth");
  const Library library = load_library_for(options.scene);
  const Scene scene = load_scene_for(options.scene, library);
  const Plan plan = plan_for(options.scene, library, scene, options.aspect());
  std::vector<const EffectManifest*> effects;
  for (const EffectPlan& entry : plan.effects)
    if (entry.called_for && entry.effect->variants.size() > 1) effects.push_back(entry.effect);
  if (effects.empty()) {
    fmt::print("scene {} calls for no effect that has several variants: there is nothing to choose\n", scene.name);
    return 0;
  }
  if (options.to == "truth" && (effects.size() > 1 || effects.front()->truth.empty()))
    throw Error(
        ErrorKind::bad_input, "choose", "--to truth",
        "needs a scene that calls for one effect, which has a truth; a truth is of one effect, so choose --to baseline here");
  const std::vector<ProbedBackend> backends = probe_backends(options);
  require_any("choose", backends);
  check_size("choose", options, devices_of(backends));
  if (backends.size() != 1)
    throw Error(ErrorKind::bad_input, "choose", "--backend", "takes one: what is the best differs between devices");
  make_folder("choose", options.out);

  Progress progress("choosing");
  Bakes bakes(scene, *library.code, DiskCache(options.cache));
  const std::unique_ptr<Backend> backend = open_backend(backends.front().name, {options.device, options.validation});
  const TimerRow timer = certified_timer(*backend, library.shaders, options.cache);
  if (!timer.ok) {
    fmt::print(stderr, "lamina: choose: the timer's certificate failed ({}), so nothing can be chosen by time\n", timer.reason);
    return 1;
  }
  SceneResources resources(*backend, scene, library, options.width_px, options.height_px, &bakes);
  ShaderCache shaders(backend->info().api, library.shaders);
  const std::optional<CostModel> model = kept_cost_model(options.cache, backends.front().name, backend->info().device);
  if (!model)
    fmt::print(
        stderr,
        "lamina: note: no cost model of this device is there, so every variant is timed; 'lamina calibrate' makes one\n");

  const Tell tell = progress.tell();
  ChoiceRun run({&scene, &plan, &bakes, &resources}, effects, shaders, options, options.to == "truth", tell);
  const DrawnOptions search = draw_options(effects, plan, run, model, options.rounds, tell);
  const ChoiceSearch known = searched(search, goal, plan, run, options.rounds, tell);
  const Choice best = *known.best();
  fmt::print("{} on {} ({}), {}x{}: ", scene.name, backends.front().name, backend->info().device, options.width_px,
             options.height_px);
  if (!print_found(known, search, goal, best)) return 1;
  print_confirmed(run, known, search, goal, plan, best, scene, options.rounds);
  fmt::print("on views{} that the search has not seen: {}\n", scene.moves() ? " and at a moment" : "",
             figures_of(held_out(*backend, library, search, best, shaders, options, scene, tell)));
  print_prices(known, search, best);
  if (effects.size() > 1) print_savings(run, search, options.rounds);
  if (options.exhaustive) print_exhaustive(run, known, search, goal, plan, best, options.rounds, tell);

  const std::filesystem::path file = options.out / "configuration.toml";
  write_file_atomically(file, configuration_text(scene.source, library, search.chosen(best)));
  fmt::print("\nconfiguration: {}\n", file.string());
  return 0;
}

}  // namespace

Command add_choose(CLI::App& program) {
  auto options = std::make_shared<ChooseOptions>();
  options->backends = {"vulkan"};
  CLI::App& command = *program.add_subcommand(
      "choose", "One variant for each effect of a scene: the least error within a budget, or the least time within an error");
  add_scene(command, options->scene);
  add_out(command, options->out, "Folder for configuration.toml");
  add_backends(command, *options);
  add_size(command, *options);
  command.add_option("--budget", options->budget, "What a frame may take in its worst view")->type_name("MILLISECONDS");
  command.add_option("--min-ssim", options->min_ssim, "What SSIM must be at least in every view")->check(CLI::Range(0.0, 1.0));
  command.add_option("--max-flip", options->max_flip, "What FLIP may be at most in every view")->check(CLI::Range(0.0, 1.0));
  command.add_option("--limit", options->limits, "METRIC=NUMBER that every view must keep (may be given again)")
      ->type_name(placeholder::limit);
  command.add_option("--to", options->to, "What errors are taken to: baseline or truth")->capture_default_str();
  command.add_flag("--exhaustive", options->exhaustive,
                   "Measure all other configurations too, and hold the choice against the best of all");
  add_truth(command, *options);
  add_seed(command, options->rounds.seed);
  add_validation(command, *options);
  return {&command, [=](const std::string& typed) {
            options->command = typed;
            return run_choose(*options);
          }};
}

}  // namespace lamina
