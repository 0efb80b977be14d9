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
#include "harness/cli/choice_run.h"
#include "harness/cli/commands.h"
#include "harness/cli/common.h"
#include "harness/cli/devices.h"
#include "harness/core/text.h"
#include "harness/plan/configuration_file.h"
#include "harness/record/kept_certificate.h"
#include "harness/sweep/answers.h"

namespace lamina {
namespace {

constexpr double doubt_without = 0.05;  // of times that were measured
constexpr double max_doubt = 0.5;

struct ChooseOptions : CellOptions {
  std::string budget;               // "4ms"
  std::vector<std::string> limits;  // METRIC=NUMBER
  std::optional<double> min_ssim, max_flip;
  std::string to = "baseline";
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

// The space that is searched, and what its options are.
struct Search {
  std::vector<const EffectManifest*> effects;
  std::vector<std::vector<const VariantManifest*>> options;  // by effect, beside the space's
  ChoiceSpace space;
  double doubt = doubt_without;
  std::vector<std::string> left_out;  // variants that cannot be chosen, with the reason

  Choice baseline() const { return Choice(effects.size(), 0); }
  const VariantManifest& variant(const Choice& choice, size_t effect) const { return *options[effect][choice[effect]]; }
  Configuration configuration(const Plan& plan, const Choice& choice) const {
    std::map<std::string, const VariantManifest*, std::less<>> variants;
    for (size_t e = 0; e < effects.size(); ++e) variants[effects[e]->name] = &variant(choice, e);
    return configuration_of(plan, variants);
  }
};

std::string words_of(const Search& search, const Choice& choice) {
  std::string words;
  for (size_t e = 0; e < choice.size(); ++e) words += (e > 0 ? " + " : "") + search.variant(choice, e).name;
  return words;
}

std::string figures_of(const Outcome& outcome) {
  const double psnr = worst_error(outcome, "psnr_db");
  return fmt::format("{:9.4g} ms  SSIM {:.4f}  FLIP {:.4f}  PSNR {}", worst_ms(outcome), worst_error(outcome, "ssim"),
                     worst_error(outcome, "flip"), std::isinf(psnr) ? "inf" : fmt::format("{:.1f} dB", psnr));
}

// Medians of the rounds, in units of one time of the baselines, so that batches that ran at another speed agree.
void set_times(Outcome& outcome, const ChoiceRun::Times& times, const ChoiceRun::Times& baselines,
               const Outcome& of_baselines) {
  for (size_t view = 0; view < outcome.size(); ++view)
    outcome[view].ms = of_baselines[view].ms * ratio_interval(times[view], baselines[view]).median;
}

// Draws each variant alone, and tells its time: by the model from its counts, or without a model by the fewest rounds.
Search singles_of(const std::vector<const EffectManifest*>& effects, const Plan& plan, ChoiceRun& run,
                  const std::optional<CostModel>& model, const RoundOptions& rounds, const Tell& tell) {
  RoundOptions fewest = rounds;
  fewest.budget_s = 0;
  Search search{.effects = effects};
  const Configuration baselines = configuration_of(plan, {});
  Outcome& base = search.space.baseline = run.errors_of(baselines);
  const ChoiceRun::Times base_times = run.times_of({baselines}, rounds).front();
  for (size_t view = 0; view < base.size(); ++view) base[view].ms = median(base_times[view]);
  const auto base_counts = run.counts_of(baselines);
  for (const EffectManifest* effect : effects) {
    std::vector<const VariantManifest*>& kept = search.options.emplace_back();
    kept.push_back(&effect->baseline());
    std::vector<ChoiceOption>& options = search.space.effects.emplace_back(ChoiceEffect{effect->name, {}}).options;
    options.push_back({effect->baseline().name, base});
    for (const VariantManifest& variant : effect->variants) {
      if (variant.baseline) continue;
      tell(static_cast<double>(search.options.size() - 1) / static_cast<double>(effects.size()), "drawing " + variant.name);
      const Configuration alone = configuration_with(plan, variant);
      try {
        Outcome single = run.errors_of(alone);
        if (model) {
          const auto counts = run.counts_of(alone);
          for (size_t view = 0; view < single.size(); ++view) {
            const double before = predicted_ms(*model, base_counts[view]), after = predicted_ms(*model, counts[view]);
            single[view].ms = base[view].ms * (before > 0 ? after / before : 1);
          }
        } else {
          const std::vector<ChoiceRun::Times> times = run.times_of({baselines, alone}, fewest);
          set_times(single, times[1], times[0], base);
        }
        options.push_back({variant.name, std::move(single)});
        kept.push_back(&variant);
      } catch (const Error& error) {
        search.left_out.push_back(fmt::format("{}: {}", variant.name, error.what()));
      }
    }
  }
  if (model) search.doubt = std::clamp(2 * model->judged.mean_error, doubt_without, max_doubt);
  return search;
}

// Measures choices in rounds beside the baselines.
ChoiceSearch searched(const Search& search, const ChoiceGoal& goal, const Plan& plan, ChoiceRun& run,
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
Outcome held_out(Backend& backend, const Library& library, const Search& search, const Choice& choice, ShaderCache& shaders,
                 const ChooseOptions& options, const Scene& seen, const Tell& tell) {
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
void print_prices(const ChoiceSearch& known, const Search& search, const Choice& choice) {
  fmt::print("\nwhat the next 0.01 of SSIM costs, predicted:\n");
  for (size_t e = 0; e < choice.size(); ++e) {
    const std::optional<Price> price = next_price(known, search.space, choice, e);
    fmt::print("  {:<20} {}\n", search.effects[e]->name,
               price ? fmt::format("{:+.4g} ms, by {}", price->ms, search.options[e][price->option]->name)
                     : "nothing here has less error");
  }
}

void print_savings(ChoiceRun& run, const Search& search, const RoundOptions& rounds) {
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
bool print_found(const ChoiceSearch& known, const Search& search, const ChoiceGoal& goal, const Choice& best) {
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
void print_confirmed(ChoiceRun& run, const ChoiceSearch& known, const Search& search, const ChoiceGoal& goal, const Plan& plan,
                     const Choice& best, const Scene& scene, const RoundOptions& rounds) {
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
  const Search search = singles_of(effects, plan, run, model, options.rounds, tell);
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

  std::map<std::string, std::string> variants;
  for (size_t e = 0; e < effects.size(); ++e) variants[effects[e]->name] = search.variant(best, e).name;
  const std::filesystem::path file = options.out / "configuration.toml";
  write_file_atomically(file, configuration_text(scene.source, variants));
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
  add_truth(command, *options);
  add_seed(command, options->rounds.seed);
  add_validation(command, *options);
  return {&command, [=](const std::string& typed) {
            options->command = typed;
            return run_choose(*options);
          }};
}

}  // namespace lamina
