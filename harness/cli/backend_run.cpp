// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/backend_run.h"

#include <algorithm>
#include <chrono>

namespace lamina {

BackendRun::BackendRun(Backend& backend, SceneResources& resources, const Plan& plan, const EffectManifest& effect,
                       ShaderCache& shaders, Bakes& bakes, const CellOptions& options, const std::string& images)
    : resources_(resources),
      plan_(plan),
      shaders_(shaders),
      options_(options),
      images_(images),
      truth_(resources, plan, effect, shaders, bakes, options_) {
  for (const VariantManifest& manifest : effect.variants) {
    if (!is_compared(manifest, options)) continue;
    Variant& variant = variants_.emplace_back();
    variant.manifest = &manifest;
    for (const View& view : resources.scene().views)
      variant.rows.push_back(
          blank_row(backend.info().backend, backend.info().device, resources.scene(), *plan.library, view, manifest, options));
    variant.covered.resize(variant.rows.size());
  }
}

void BackendRun::attempt(Variant& variant, const std::function<void()>& work) {
  if (!lamina::attempt(variant.failure, variant.rows, work)) variant.ready.reset();
}

void BackendRun::prepare(Progress& progress) {
  for (size_t i = 0; i < variants_.size(); ++i) {
    Variant& variant = variants_[i];
    progress.show(static_cast<double>(i) / static_cast<double>(variants_.size()), "preparing " + variant.manifest->name);
    attempt(variant, [&] {
      const auto start = std::chrono::steady_clock::now();
      variant.ready = std::make_unique<ReadyFrame>(resources_, plan_, *variant.manifest, shaders_);
      const double cold_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
      const std::set<std::string> hashes = variant.ready->graph.shader_hashes();
      for (CellRow& row : variant.rows) {
        row.cold_ms = cold_ms;
        row.shader_hashes.assign(hashes.begin(), hashes.end());
      }
    });
  }
}

void BackendRun::count(Progress& progress) {
  for (size_t i = 0; i < variants_.size(); ++i) {
    Variant& variant = variants_[i];
    progress.show(static_cast<double>(i) / static_cast<double>(variants_.size()), "counting " + variant.manifest->name);
    attempt(variant, [&] {
      Frame counting(resources_, variant.ready->graph, Build::counting);
      counting.run_once(Timing::off);
      const std::vector<PassCounts> once = counting.once_counts();
      for (size_t view = 0; view < variant.rows.size(); ++view) {
        variant.covered[view] = count_cell(variant.rows[view], counting, once, *variant.manifest, view);
      }
    });
  }
}

ReadyFrame* BackendRun::frame(std::string_view variant) {
  for (Variant& candidate : variants_)
    if (candidate.manifest->name == variant && candidate.ready) return candidate.ready.get();
  return nullptr;
}

void BackendRun::score(Progress& progress, const Known& known) {
  const size_t views = variants_.front().rows.size();
  for (size_t view = 0; view < views; ++view) {
    progress.show(static_cast<double>(view) / static_cast<double>(views),
                  "scoring view " + resources_.scene().views[view].name);
    std::optional<Image> baseline;
    for (Variant& variant : variants_) {
      attempt(variant, [&] {
        if (view > 0) variant.ready->frame.run(view, Timing::off);  // the first view is what prepare() has drawn
        const Image picture = variant.ready->frame.picture();
        const CellRow* same = known ? known({*variant.manifest, view, picture, variant.covered[view]}) : nullptr;
        if (variant.manifest->baseline) baseline = picture;
        score_view(variant, view, picture, baseline ? &*baseline : nullptr, same, progress);
      });
    }
  }
}

void BackendRun::score_view(Variant& variant, size_t view, const Image& picture, const Image* baseline, const CellRow* known,
                            Progress& progress) {
  CellRow& row = variant.rows[view];
  const auto write = [&](const std::string& suffix, const DisplayImage& image) {
    const std::string path = images_ + "/" + picture_name(row, suffix);
    write_png((options_.out / path).string(), image);
    return path;
  };
  fill_picture(row, picture, variant.covered[view], write);
  if (row.nonfinite_pixels == 0)
    truth_.score(*variant.manifest, view, picture, row, write, [&](double fraction) {
      progress.show(fraction, "casting rays for the truth of view " + resources_.scene().views[view].name);
    });
  if (variant.manifest->baseline || !baseline) return;
  if (known)
    copy_errors(row, *known);
  else
    fill_errors(row, picture, *baseline, either(variant.covered[view], variants_.front().covered[view]), write);
}

RoundsResult BackendRun::time(const RoundOptions& rounds, Progress& progress, bool timer_ok) {
  for (Variant& variant : variants_)
    for (CellRow& row : variant.rows) row.timed = timer_ok;
  if (!timer_ok) return {};
  for (Variant& variant : variants_) attempt(variant, [&] { variant.once_ms = time_once(variant.ready->frame); });

  std::vector<TimedCell> cells;
  for (Variant& variant : variants_) {
    if (!variant.failure.empty()) continue;
    for (size_t view = 0; view < variant.rows.size(); ++view) {
      TimedCell& cell = cells.emplace_back(TimedCell{&variant.ready->frame, view, &variant.rows[view], &variant.once_ms, {}});
      if (variants_.front().failure.empty()) cell.baseline = view;  // the baseline's come first, one a view
    }
  }
  return time_cells(cells, rounds, progress);
}

std::vector<CellRow> BackendRun::rows() const {
  std::vector<CellRow> all;
  for (const Variant& variant : variants_) all.insert(all.end(), variant.rows.begin(), variant.rows.end());
  return all;
}

std::vector<CellRow> failed_rows(const std::string& backend, const Scene& scene, const Library& library,
                                 const EffectManifest& effect, const CellOptions& options, const std::string& reason) {
  std::vector<CellRow> rows;
  for (const VariantManifest& variant : effect.variants) {
    if (!is_compared(variant, options)) continue;
    for (const View& view : scene.views)
      fail(rows.emplace_back(blank_row(backend, "", scene, library, view, variant, options)), reason);
  }
  return rows;
}

}  // namespace lamina
