// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/effect_run.h"

#include <fmt/format.h>
#include <tbb/parallel_for_each.h>

#include <algorithm>

#include "harness/core/stopwatch.h"
#include "harness/graph/inputs.h"
#include "harness/quality/judged_picture.h"

namespace lamina {
namespace {

// Two, so that a grid that goes back and forth between layers apart and layers together builds nothing twice; few, so that a
// long sweep takes no more memory than a short one.
constexpr size_t max_prepared = 2;

constexpr size_t once_repetitions = 6;  // enough for an interval

// Adds the time that its scope takes.
class Clock {
 public:
  explicit Clock(double& sum_ms) : sum_ms_(sum_ms) {}
  ~Clock() { sum_ms_ += watch_.elapsed_ms(); }

 private:
  double& sum_ms_;
  Stopwatch watch_;
};

// Equal keys mean that passes are built from the same features.
std::string plan_key(const Plan& plan, const Scene& scene) {
  std::string key;
  for (const EffectPlan& effect : plan.effects) {
    key += fmt::format("|{} {}", effect.effect->name, effect.called_for);
    for (const FeaturePlan& feature : effect.features) key += fmt::format(" {}", feature.on);
    for (const size_t object : effect.objects) {
      key += fmt::format(" {}", object);
      for (const auto& [name, value] : feature_defines(*effect.effect, scene, &scene.objects[object])) key += "," + name;
    }
  }
  return key;
}

// Of these, the ones that belong to variants of the configuration.
Parameters own_parameters(const Configuration& configuration, const std::map<std::string, double>& params) {
  Parameters own;
  for (const VariantManifest* variant : configuration)
    for (const ParameterManifest& parameter : variant->parameters)
      if (const auto set = params.find(variant->name + "." + parameter.name); set != params.end()) own.insert(*set);
  return own;
}

// The passes done once, repeated: [pass][repetition].
std::vector<std::vector<double>> time_once(Frame& frame) {
  std::vector<std::vector<double>> once_ms(frame.once_names().size());
  for (size_t i = 0; i < once_repetitions; ++i) {
    const FrameTimes times = frame.run_once(Timing::bracketed);
    for (size_t pass = 0; pass < times.pass_ms.size(); ++pass) once_ms[pass].push_back(times.pass_ms[pass]);
  }
  return once_ms;
}

}  // namespace

EffectRun::EffectRun(Backend& backend, const EffectManifest& effect, ShaderCache& shaders, const CellOptions& options,
                     const std::string& images, const Tell& tell)
    : backend_(backend), effect_(effect), shaders_(shaders), options_(options), images_(images), tell_(tell) {
  for (const VariantManifest& manifest : effect.variants)
    if (is_compared(manifest, options)) variants_.emplace_back().manifest = &manifest;
}

void EffectRun::start(const SceneOnDevice& scene, const MeasuredPoint& point, const std::string& failure) {
  scene_ = scene;
  point_ = point;
  again_.clear();
  drawn_.clear();
  for (Variant& variant : variants_) {
    variant.failure = failure;
    variant.known.clear();
    blank_rows(variant);
  }
  if (!failure.empty()) return;
  const std::string key = plan_key(*scene.plan, *scene.scene);
  if (truth_ && key == plan_key_)
    truth_->forget();
  else
    truth_ = std::make_unique<TruthRun>(*scene.resources, *scene.plan, effect_, shaders_, *scene.bakes, options_);
  plan_key_ = key;
}

void EffectRun::take(const std::string& name, Known known) {
  for (Variant& variant : variants_) {
    if (variant.manifest->name != name || !variant.failure.empty() || known.rows.size() != variant.rows.size()) continue;
    for (size_t view = 0; view < variant.rows.size(); ++view) {
      CellRow& row = variant.rows[view];
      CellRow& there = known.rows[view];
      row.notes = std::move(there.notes);
      row.passes = std::move(there.passes);
      row.cold_ms = there.cold_ms;
      row.fetches = there.fetches, row.fetches_per_pixel = there.fetches_per_pixel;
      row.covered_pixels = there.covered_pixels, row.target_bytes = there.target_bytes;
      row.memory_bytes = there.memory_bytes, row.memory_bytes_alone = there.memory_bytes_alone;
      row.shader_hashes = std::move(there.shader_hashes);
    }
    variant.known = std::move(known.drawn);
  }
}

void EffectRun::blank_rows(Variant& variant) {
  variant.first_is_drawn = false;
  variant.rows.clear();
  for (const View& view : scene_.scene->views) {
    CellRow& row = variant.rows.emplace_back(blank_row(backend_.info().backend, backend_.info().device, *scene_.scene,
                                                       *scene_.plan->library, view, *variant.manifest, options_));
    for (const auto& [path, value] : point_.params) row.params[path] = value;
    for (const auto& [path, word] : point_.words) row.words[path] = word;
    row.timed = point_.timed;
    if (!variant.failure.empty()) fail(row, variant.failure);
  }
}

void EffectRun::start_again(const std::set<std::string>& variants) {
  again_ = variants;
  for (Variant& variant : variants_) {
    if (!is_at_work(variant)) continue;
    variant.prepared.clear();
    variant.failure.clear();
    blank_rows(variant);
  }
  truth_ = std::make_unique<TruthRun>(*scene_.resources, *scene_.plan, effect_, shaders_, *scene_.bakes, options_);
}

void EffectRun::release() {
  truth_.reset();
  for (Variant& variant : variants_) variant.prepared.clear();
}

void EffectRun::attempt(Variant& variant, const std::function<void()>& work) {
  if (!lamina::attempt(variant.failure, variant.rows, work)) variant.prepared.clear();
}

void EffectRun::each(const std::string& doing, void (EffectRun::*step)(Variant&)) {
  for (size_t i = 0; i < variants_.size(); ++i) {
    if (!is_at_work(variants_[i])) continue;
    tell_(static_cast<double>(i) / static_cast<double>(variants_.size()), doing + " " + variants_[i].manifest->name);
    attempt(variants_[i], [&] { (this->*step)(variants_[i]); });
  }
}

void EffectRun::prepare() { each("preparing", &EffectRun::prepare); }

void EffectRun::count() { each("counting", &EffectRun::count); }

void EffectRun::prepare(Variant& variant) {
  if (!variant.known.empty()) return;
  const Parameters parameters = own_parameters(configuration_with(*scene_.plan, *variant.manifest), point_.params);
  // Equal keys mean the same passes, on the same resources.
  std::string key = fmt::format("{} {}", plan_key_, scene_.scene->moves());
  for (const auto& [name, value] : parameters) key += fmt::format("|{}={}", name, value);
  const auto known = std::ranges::find_if(variant.prepared, [&](const Prepared& prepared) { return prepared.key == key; });
  if (known == variant.prepared.end()) {
    variant.prepared.resize(std::min(variant.prepared.size(), max_prepared - 1));
    double cold_ms = 0;
    {
      const Clock clock(cold_ms);
      auto ready =
          std::make_unique<ReadyFrame>(*scene_.resources, *scene_.plan, configuration_with(*scene_.plan, *variant.manifest),
                                       shaders_, parameters, point_.timed ? Timing::bracketed : Timing::off);
      variant.prepared.push_front({.key = key, .ready = std::move(ready)});
    }
    Prepared& made = variant.prepared.front();
    made.once = once_inputs(made.ready->graph, *scene_.scene);
    variant.first_is_drawn = true;
    spent_.device += made.ready->wall_ms;
    if (point_.params.empty())  // a sweep's points share frames
      for (CellRow& row : variant.rows) row.cold_ms = cold_ms;
  } else {
    variant.prepared.splice(variant.prepared.begin(), variant.prepared, known);
    known->ready->frame.set_background(scene_.scene->background);
    if (const std::string once = once_inputs(known->ready->graph, *scene_.scene); known->once != once) {
      const Clock clock(spent_.device);
      known->ready->frame.run_once(Timing::off);
      known->once = once;
    }
  }
  const std::set<std::string> hashes = variant.prepared.front().ready->graph.shader_hashes();
  for (CellRow& row : variant.rows) {
    row.shader_hashes.assign(hashes.begin(), hashes.end());
    const Frame& frame = variant.prepared.front().ready->frame;
    row.target_bytes = frame.target_bytes();
    row.memory_bytes = frame.memory_bytes();
    row.memory_bytes_alone = frame.memory_bytes_alone();
  }
}

void EffectRun::count(Variant& variant) {
  if (!variant.known.empty()) return;
  Prepared& prepared = variant.prepared.front();
  const Graph& graph = prepared.ready->graph;
  const auto coverage = [&] { return coverage_inputs(graph, *scene_.scene, prepared.early_tests); };
  const bool known = prepared.covered.size() == variant.rows.size() && prepared.coverage == coverage();
  if (known && !point_.counted) {
    for (size_t view = 0; view < variant.rows.size(); ++view)
      variant.rows[view].covered_pixels = count_on(prepared.covered[view]);
    return;
  }
  const Clock clock(spent_.device);
  if (!prepared.counting) prepared.counting = std::make_unique<Frame>(*scene_.resources, graph, Build::counting);
  prepared.counting->set_background(scene_.scene->background);
  if (const std::string once = once_inputs(graph, *scene_.scene); prepared.counted_once != once) {
    prepared.counting->run_once(Timing::off);
    prepared.once_counts = prepared.counting->once_counts();
    prepared.counted_once = once;
  }
  prepared.covered.clear();
  prepared.early_tests = true;
  for (CellRow& row : variant.rows) {
    CellRow counted;
    prepared.covered.push_back(
        count_cell(counted, *prepared.counting, prepared.once_counts, *variant.manifest, prepared.covered.size()));
    for (const PassRow& pass : counted.passes) prepared.early_tests = prepared.early_tests && pass.early_tests;
    row.covered_pixels = counted.covered_pixels;
    if (!point_.counted) continue;
    row.passes = counted.passes;
    row.fetches = counted.fetches;
    row.fetches_per_pixel = counted.fetches_per_pixel;
  }
  prepared.coverage = coverage();
  if (point_.params.empty()) prepared.counting.reset();  // no other point follows
}

// The time of an effect that covers no pixel is that of an empty frame: none is given. Returns whether it is so.
bool EffectRun::note_nothing_covered() {
  const auto covers = [](const CellRow& row) { return row.failed || row.covered_pixels.value_or(1) > 0; };
  for (const Variant& variant : variants_)
    if (!is_at_work(variant) || std::ranges::any_of(variant.rows, covers)) return false;
  const std::string note = fmt::format("{} covers no pixel in any view, so no time or ratio is given", effect_.name);
  for (Variant& variant : variants_)
    for (CellRow& row : variant.rows) row.timed = false, row.notes.push_back(note);
  fmt::print(stderr, "lamina: note: {}; check the views\n", note);
  return true;
}

// Ratios are to the baseline, where it has not failed.
RoundsResult EffectRun::time(const RoundOptions& rounds, const CostModel* model) {
  const bool said = point_.timed || point_.params.empty();  // and not again at each point of a sweep of errors
  if ((said && note_nothing_covered()) || !point_.timed) return {};
  const Clock clock(spent_.device);
  std::vector<Arm> arms;
  std::vector<std::pair<const Variant*, CellRow*>> cells;  // beside arms
  std::map<size_t, size_t> baseline_arms;                  // by view
  for (Variant& variant : variants_) {
    if (is_at_work(variant)) attempt(variant, [&] { variant.once_ms = time_once(variant.prepared.front().ready->frame); });
    if (!variant.failure.empty()) continue;
    variant.first_is_drawn = false;
    Frame& frame = variant.prepared.front().ready->frame;
    for (size_t view = 0; view < variant.rows.size(); ++view) {
      if (variant.rows[view].failed) continue;                            // what is not a picture has no time worth measuring
      if (variant.manifest->baseline) baseline_arms[view] = arms.size();  // it is the first variant
      Arm& arm = arms.emplace_back(Arm{[&frame, view] { return frame.run(view, Timing::bracketed); }, std::nullopt});
      if (model) arm.expected_ms = predicted_ms(*model, variant.rows[view].passes);
      if (const auto known = baseline_arms.find(view); known != baseline_arms.end()) arm.baseline = known->second;
      cells.emplace_back(&variant, &variant.rows[view]);
    }
  }
  if (arms.empty()) return {};
  RoundsResult result = run_rounds(arms, rounds, [&](double fraction) { tell_(fraction, "timing"); });

  for (size_t i = 0; i < arms.size(); ++i) {
    const ArmSamples& samples = result.arms[i];
    const auto [variant, row] = cells[i];
    if (!samples.failure.empty()) {
      fail(*row, samples.failure);
      continue;
    }
    if (result.rounds < rounds.min_rounds) {  // stopped: what was drawn and counted stays
      row->timed = false;
      row->notes.emplace_back(stopped_note);
      continue;
    }
    size_t once = 0, frame = 0;
    for (PassRow& pass : row->passes) pass.ms = pass.once ? variant->once_ms[once++] : samples.pass_ms[frame++];
    const bool has_baseline = arms[i].baseline && result.arms[*arms[i].baseline].failure.empty();
    if (has_baseline && !row->baseline)
      row->ratio_to_baseline = ratio_interval(samples.frame_ms, result.arms[*arms[i].baseline].frame_ms);
  }
  return result.rounds < rounds.min_rounds ? RoundsResult{} : result;
}

void EffectRun::forget_times() {
  for (Variant& variant : variants_)
    for (CellRow& row : variant.rows) {
      row.timed = false;
      row.ratio_to_baseline.reset();
      for (PassRow& pass : row.passes) pass.ms.clear();
    }
}

EffectRun::Drawn EffectRun::draw(Variant& variant, size_t view) {
  if (!variant.known.empty()) return variant.known[view];
  Prepared& prepared = variant.prepared.front();
  if (view > 0 || !variant.first_is_drawn) {
    const Clock clock(spent_.device);
    prepared.ready->frame.run(view, Timing::off);
    variant.first_is_drawn = false;
  }
  note_unfinished(variant.rows[view], prepared.ready->frame, view);
  const Clock clock(spent_.read_back);
  return {prepared.ready->frame.picture(), prepared.covered[view]};
}

// `baseline` may be null: then there is nothing to hold the frame against.
std::string EffectRun::why_no_picture_of(const CellRow& row, const JudgedFrame& frame, const Drawn* baseline) const {
  if (!point_.judged) return "";
  if (row.nonfinite_pixels > 0) return why_not_finite(frame.picture);
  if (!baseline || nonfinite_pixels(baseline->picture) > 0) return "";
  return why_no_picture(frame, {baseline->picture, baseline->covered}, scene_.scene->background);
}

void EffectRun::score(Variant& variant, size_t view, const Drawn* baseline, const Scoring& scoring) {
  CellRow& row = variant.rows[view];
  std::vector<std::pair<std::string, DisplayImage>> pictures;  // by path
  const auto write_pictures = [&] {
    const auto made = std::exchange(pictures, {});
    tbb::parallel_for_each(made,
                           [&](const auto& picture) { write_png((options_.out / picture.first).string(), picture.second); });
  };
  attempt(variant, [&] {
    if (row.failed) return;
    std::optional<Drawn> own;
    if (!variant.manifest->baseline) own = draw(variant, view);
    const auto& [picture, covered] = own ? *own : *baseline;
    KeepPicture keep;
    if (point_.pictured)
      keep = [&](const std::string& suffix, const DisplayImage& image) {
        return pictures.emplace_back(images_ + "/" + picture_name(row, point_.picture_suffix + suffix), image).first;
      };
    const Clock clock(spent_.metrics);
    const CellRow* known = scoring.known ? scoring.known({*variant.manifest, view, picture, covered}) : nullptr;
    fill_picture(row, picture, covered, keep);
    if (const std::string why = why_no_picture_of(row, {picture, covered}, own ? baseline : nullptr); !why.empty())
      return fail(row, std::string(no_picture) + why);
    if (row.nonfinite_pixels == 0)
      truth_->score(*variant.manifest, view, picture, row, keep,
                    [&](double fraction) { tell_(fraction, "casting rays for the truth of view " + row.view); });
    if (variant.manifest->baseline || !baseline) return;
    const Mask drawn = either(covered, baseline->covered);
    if (known)
      copy_errors(row, *known);
    else
      fill_errors(row, picture, baseline->picture, drawn, keep);
    if (row.error_covered && (options_.alpha || reads_frame_after(*scene_.plan, effect_)))
      row.max_alpha = max_alpha(picture, baseline->picture, &drawn);
  });
  // Whoever waits for cells makes this one again, where it stops. Else the cell fails and the others go on.
  if (scoring.done)
    write_pictures();
  else
    attempt(variant, write_pictures);
}

bool EffectRun::score(const Scoring& scoring) {
  Variant& first = variants_.front();
  const size_t views = first.rows.size();
  for (size_t view = 0; view < views; ++view) {
    const std::string name = first.rows[view].view;
    const auto is_wanted = [&](const Variant& variant) {
      return is_at_work(variant) && (!scoring.wanted || scoring.wanted(variant.manifest->name, name));
    };
    if (std::ranges::none_of(variants_, is_wanted)) continue;
    tell_(static_cast<double>(view) / static_cast<double>(views), "scoring view " + name);
    std::optional<Drawn> baseline;
    const auto known = drawn_.find(view);
    if (!is_at_work(first) && known != drawn_.end())
      baseline = known->second;
    else
      attempt(first, [&] { baseline = draw(first, view); });
    if (baseline && keeps_pictures_) drawn_.insert_or_assign(view, *baseline);
    for (Variant& variant : variants_) {
      if (!is_wanted(variant)) continue;
      score(variant, view, baseline ? &*baseline : nullptr, scoring);
      if (scoring.done && !scoring.done(variant.rows[view])) return false;
    }
  }
  return true;
}

std::vector<CellRow> EffectRun::rows() const {
  std::vector<CellRow> all;
  for (const Variant& variant : variants_) all.insert(all.end(), variant.rows.begin(), variant.rows.end());
  return all;
}

ReadyFrame* EffectRun::frame(std::string_view variant) {
  for (Variant& candidate : variants_)
    if (candidate.manifest->name == variant && !candidate.prepared.empty()) return candidate.prepared.front().ready.get();
  return nullptr;
}

}  // namespace lamina
