// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/point_run.h"

#include <algorithm>
#include <chrono>

#include "harness/graph/inputs.h"
#include "harness/scene/digest.h"

namespace lamina {
namespace {

// Two, so that a grid that goes back and forth between layers apart and layers together builds nothing twice; few, so that a
// long sweep takes no more memory than a short one.
constexpr size_t max_prepared = 2;

class Clock {
 public:
  explicit Clock(double& sum_ms) : sum_ms_(sum_ms), start_(std::chrono::steady_clock::now()) {}
  ~Clock() { sum_ms_ += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  double& sum_ms_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace

PointRun::PointRun(Backend& backend, SweptScene& scenes, const Library& library, const EffectManifest& effect,
                   ShaderCache& shaders, const SweepOptions& options, bool timer_ok)
    : backend_(backend),
      scenes_(scenes),
      library_(library),
      effect_(effect),
      shaders_(shaders),
      options_(options),
      timer_ok_(timer_ok) {
  for (const VariantManifest& manifest : effect.variants)
    if (is_compared(manifest, options.compare)) variants_.emplace_back().manifest = &manifest;
}

PointRun::~PointRun() {
  truth_.reset();  // frames go before the resources they bind
  variants_.clear();
}

void PointRun::go_to(size_t point) {
  Scene next = scenes_.at(point);
  const std::string resources = device_digest(next, library_), meshes = meshes_digest(next);
  scene_ = std::move(next);
  point_ = point;
  if (resources != resources_key_ || !resources_) {
    truth_.reset();
    for (Variant& variant : variants_) variant.prepared.clear();
    resources_.reset();
    bakes_ = std::make_unique<Bakes>(scene_, *library_.code, DiskCache(options_.compare.cache));
    resources_ = std::make_unique<SceneResources>(backend_, scene_, library_, options_.compare.width_px,
                                                  options_.compare.height_px, bakes_.get());
  } else {
    resources_->update(meshes != meshes_);
  }
  resources_key_ = resources, meshes_ = meshes;

  plan_ = make_plan(library_, scene_);
  std::string plan_key;
  for (const EffectPlan& effect : plan_.effects) {
    plan_key += fmt::format("|{} {}", effect.effect->name, effect.called_for);
    for (const FeaturePlan& feature : effect.features) plan_key += fmt::format(" {}", feature.on);
    for (const size_t object : effect.objects) {
      plan_key += fmt::format(" {}", object);
      for (const auto& [name, value] : feature_defines(*effect.effect, scene_, &scene_.objects[object])) plan_key += "," + name;
    }
  }
  if (plan_key != plan_key_ || !truth_)
    truth_ = std::make_unique<TruthRun>(*resources_, plan_, effect_, shaders_, *bakes_, options_.compare);
  else
    truth_->forget();
  plan_key_ = plan_key;
}

// The cache key of what a variant's passes are built from, besides what is in resources_key().
std::string PointRun::key_of(const VariantManifest& variant, size_t point) const {
  std::string key = fmt::format("{} {}", plan_key_, scene_.mesh_moves || scene_.lights_move);
  for (const VariantManifest* used : configuration_with(plan_, variant))
    for (const auto& [name, value] : scenes_.parameters_of_variant(*used, point)) key += fmt::format("|{}={}", name, value);
  return key;
}

void PointRun::start_rows(Variant& variant, size_t point) {
  variant.failure.clear();
  variant.rows.clear();
  for (const View& view : scenes_.scene().views) {
    CellRow& row = variant.rows.emplace_back(blank_row(backend_.info().backend, backend_.info().device, scene_, library_, view,
                                                       *variant.manifest, options_.compare));
    for (const auto& [path, value] : scenes_.params(point)) row.params[path] = value;
    for (const auto& [path, word] : scenes_.words_at(point)) row.words[path] = word;
    row.timed = options_.time.has(point) && timer_ok_;
  }
}

void PointRun::prepare(Variant& variant, size_t point) {
  const std::string key = key_of(*variant.manifest, point);
  const auto known = std::find_if(variant.prepared.begin(), variant.prepared.end(),
                                  [&](const Prepared& prepared) { return prepared.key == key; });
  if (known != variant.prepared.end()) {
    variant.prepared.splice(variant.prepared.begin(), variant.prepared, known);
  } else {
    const Configuration configuration = configuration_with(plan_, *variant.manifest);
    variant.prepared.resize(std::min(variant.prepared.size(), max_prepared - 1));
    Prepared& made = variant.prepared.emplace_front();
    Parameters parameters;
    for (const VariantManifest* used : configuration) parameters.merge(scenes_.parameters_of_variant(*used, point));
    made.graph = make_graph(plan_, configuration, scene_, shaders_, Purpose::frame, parameters);
    made.frame = std::make_unique<Frame>(*resources_, made.graph, Build::timed);
    made.key = key;  // last: what could not be made is not found again
  }
  Prepared& prepared = variant.prepared.front();
  prepared.frame->set_background(scene_.background);
  const std::set<std::string> hashes = prepared.graph.shader_hashes();
  for (CellRow& row : variant.rows) row.shader_hashes.assign(hashes.begin(), hashes.end());
  const std::string once = once_inputs(prepared.graph, scene_);
  if (prepared.once == once) return;
  const Clock clock(spent_.device);
  prepared.frame->run_once(Timing::off);
  prepared.once = once;
}

// Runs the counting build, for the covered pixels where these may have changed, and for the counts where `fetches` is set.
void PointRun::count(Variant& variant, bool fetches) {
  Prepared& prepared = variant.prepared.front();
  const auto coverage = [&] { return coverage_inputs(prepared.graph, scene_, prepared.early_tests); };
  const bool known = prepared.covered.size() == variant.rows.size() && prepared.coverage == coverage();
  if (known && !fetches) {
    for (size_t view = 0; view < variant.rows.size(); ++view)
      variant.rows[view].covered_pixels =
          static_cast<uint64_t>(std::count(prepared.covered[view].on.begin(), prepared.covered[view].on.end(), 1));
    return;
  }
  const Clock clock(spent_.device);
  if (!prepared.counting) prepared.counting = std::make_unique<Frame>(*resources_, prepared.graph, Build::counting);
  prepared.counting->set_background(scene_.background);
  if (const std::string once = once_inputs(prepared.graph, scene_); prepared.counted_once != once) {
    prepared.counting->run_once(Timing::off);
    prepared.once_counts = prepared.counting->once_counts();
    prepared.counted_once = once;
  }
  prepared.covered.clear();
  prepared.early_tests = true;
  for (size_t view = 0; view < variant.rows.size(); ++view) {
    CellRow row;
    prepared.covered.push_back(count_cell(row, *prepared.counting, prepared.once_counts, *variant.manifest, view));
    for (const PassRow& pass : row.passes) prepared.early_tests = prepared.early_tests && pass.early_tests;
    variant.rows[view].covered_pixels = row.covered_pixels;
    if (!fetches) continue;
    variant.rows[view].passes = row.passes;
    variant.rows[view].fetches = row.fetches;
    variant.rows[view].fetches_per_pixel = row.fetches_per_pixel;
  }
  prepared.coverage = coverage();
}

void PointRun::time(Progress& progress) {
  const Clock clock(spent_.device);
  std::vector<TimedCell> cells;
  for (Variant& variant : variants_) {
    attempt(variant.failure, variant.rows, [&] { variant.once_ms = time_once(*variant.prepared.front().frame); });
    if (!variant.failure.empty()) continue;
    for (size_t view = 0; view < variant.rows.size(); ++view) {
      TimedCell& cell =
          cells.emplace_back(TimedCell{variant.prepared.front().frame.get(), view, &variant.rows[view], &variant.once_ms, {}});
      if (variants_.front().failure.empty()) cell.baseline = view;  // the baseline's come first, one a view
    }
  }
  if (!cells.empty()) time_cells(cells, options_.compare, progress);
}

Image PointRun::render(Variant& variant, size_t view) {
  Frame& frame = *variant.prepared.front().frame;
  {
    const Clock clock(spent_.device);
    frame.run(view, Timing::off);
  }
  const Clock clock(spent_.read_back);
  return frame.picture();
}

CellRow PointRun::score(Variant& variant, size_t view, const Image* baseline, bool keep_pictures,
                        std::vector<Picture>& pictures, Progress& progress) {
  CellRow& row = variant.rows[view];
  attempt(variant.failure, variant.rows, [&] {
    if (row.failed) return;
    const Image picture = variant.manifest->baseline ? *baseline : render(variant, view);
    KeepPicture keep;
    if (keep_pictures)
      keep = [&](const std::string& suffix, const DisplayImage& image) {
        pictures.push_back({picture_name(row, fmt::format("-{}{}", point_, suffix)), image});
        return "images/" + pictures.back().name;
      };
    const Clock clock(spent_.metrics);
    fill_picture(row, picture, variant.prepared.front().covered[view], keep);
    if (row.nonfinite_pixels == 0)
      truth_->score(
          *variant.manifest, view, picture, row, keep ? keep : [](const auto&, const auto&) { return std::string(); },
          [&](double fraction) { progress.show(fraction, "casting rays for the truth"); });
    if (variant.manifest->baseline || !baseline) return;
    fill_errors(row, picture, *baseline,
                either(variant.prepared.front().covered[view], variants_.front().prepared.front().covered[view]), keep);
  });
  return row;
}

bool PointRun::run(size_t point, const std::function<bool(const std::string&, const std::string&)>& wanted, Progress& progress,
                   const Done& done) {
  std::string failure;  // of the point: all its cells fail, the next points go on
  try {
    go_to(point);
  } catch (const std::exception& error) {
    failure = error.what();
    resources_key_.clear();  // nothing may be left as it was
  }
  for (Variant& variant : variants_) {
    start_rows(variant, point);
    attempt(variant.failure, variant.rows, [&] {
      if (!failure.empty()) throw std::runtime_error(failure);
      prepare(variant, point);
      count(variant, options_.fetches.has(point) || options_.time.has(point));
    });
  }
  if (options_.time.has(point) && timer_ok_) time(progress);
  Variant& first = variants_.front();
  for (size_t view = 0; view < scenes_.scene().views.size(); ++view) {
    const std::string& name = scenes_.scene().views[view].name;
    const auto is_wanted = [&](const Variant& variant) { return wanted(variant.manifest->name, name); };
    if (std::none_of(variants_.begin(), variants_.end(), is_wanted)) continue;
    std::optional<Image> baseline;
    attempt(first.failure, first.rows, [&] { baseline = render(first, view); });
    for (Variant& variant : variants_) {
      if (!is_wanted(variant)) continue;
      std::vector<Picture> pictures;
      const CellRow row =
          score(variant, view, baseline ? &*baseline : nullptr, options_.pictures.has(point), pictures, progress);
      if (!done(row, pictures)) return false;
    }
  }
  return true;
}

}  // namespace lamina
