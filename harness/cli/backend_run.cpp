// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/backend_run.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "harness/core/text.h"

namespace lamina {
namespace {

constexpr size_t once_repetitions = 6;  // enough for an interval

// The double that is written as shortly as this float: 10.24, not 10.239999771118164.
double decimal(float value) { return std::stod(fmt::format("{}", value)); }

CellRow blank_row(const std::string& backend, const std::string& device, const Scene& scene, const View& view,
                  const VariantManifest& variant, const CompareOptions& options) {
  CellRow row;
  row.scene = scene.name;
  row.effect = variant.effect;
  row.variant = variant.name;
  row.baseline = variant.baseline;
  row.backend = backend;
  row.device = device;
  row.view = view.name;
  row.width = static_cast<int>(options.width_px);
  row.height = static_cast<int>(options.height_px);
  row.params["scene.time"] = scene.time_s;
  for (const Object& object : scene.objects)
    if (object.layers) {
      row.params[fmt::format("objects.{}.thickness", object.name)] = decimal(object.layers->thickness_texels);
      row.params[fmt::format("objects.{}.scattering", object.name)] = decimal(object.layers->scattering);
    }
  for (const ParameterManifest& parameter : variant.parameters)
    row.params[fmt::format("{}.{}", variant.name, parameter.name)] = parameter.value;
  return row;
}

void fail(CellRow& row, const std::string& reason) {
  row.failed = true;
  row.reason = reason;
}

std::string linear_hash(const Image& image) {
  return hash_hex({reinterpret_cast<const char*>(image.rgba.data()), image.rgba.size() * sizeof(float)});
}

// Names of scenes' views and objects may hold anything; file names may not.
std::string file_name_of(std::string text) {
  for (char& c : text)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-') c = '_';
  return text;
}

std::vector<PassRow> count_rows(const Frame& counting, const std::vector<PassCounts>& once,
                                const std::vector<PassCounts>& frame) {
  std::vector<PassRow> rows;
  const auto add = [&](const std::vector<std::string>& names, const std::vector<PassCounts>& counts, bool is_once) {
    for (size_t i = 0; i < names.size(); ++i) {
      PassRow& row = rows.emplace_back();
      row.name = names[i];
      row.once = is_once;
      row.fragments = counts[i].fragments;
      row.vertices = counts[i].vertices;
      row.early_tests = counts[i].early_tests;
      row.fetches = counts[i].fetches();
      row.by_texture = counts[i].by_texture;
    }
  };
  add(counting.once_names(), once, true);
  add(counting.frame_names(), frame, false);
  return rows;
}

// A picture of a broken frame can be shown, but not scored: what is not finite becomes magenta.
Image with_marked_nonfinite(const Image& image) {
  constexpr std::array<float, 4> magenta = {1, 0, 1, 1};
  Image marked = image;
  for (size_t i = 0; i < marked.rgba.size(); i += 4)
    if (!std::all_of(&marked.rgba[i], &marked.rgba[i] + 4, [](float value) { return std::isfinite(value); }))
      std::copy(magenta.begin(), magenta.end(), &marked.rgba[i]);
  return marked;
}

Mask either(const Mask& a, const Mask& b) {
  Mask both = a;
  for (size_t i = 0; i < both.on.size(); ++i) both.on[i] = a.on[i] | b.on[i];
  return both;
}

}  // namespace

BackendRun::BackendRun(Backend& backend, SceneResources& resources, const Plan& plan, const EffectManifest& effect,
                       ShaderCache& shaders, Bakes& bakes, const CompareOptions& options, const std::filesystem::path& images)
    : resources_(resources),
      plan_(plan),
      shaders_(shaders),
      options_(options),
      images_(images),
      truth_(resources, plan, effect, shaders, bakes, options) {
  for (const VariantManifest& manifest : effect.variants) {
    if (!is_compared(manifest, options)) continue;
    Variant& variant = variants_.emplace_back();
    variant.manifest = &manifest;
    for (const View& view : resources.scene().views)
      variant.rows.push_back(
          blank_row(backend.info().backend, backend.info().device, resources.scene(), view, manifest, options));
    variant.covered.resize(variant.rows.size());
  }
}

// The one place where a variant's failure is caught.
template <class Work>
void BackendRun::attempt(Variant& variant, Work&& work) {
  if (!variant.failure.empty()) return;
  try {
    work();
  } catch (const std::exception& error) {
    variant.failure = error.what();
    variant.frame.reset();
    for (CellRow& row : variant.rows) fail(row, variant.failure);
  }
}

void BackendRun::prepare(Progress& progress) {
  for (size_t i = 0; i < variants_.size(); ++i) {
    Variant& variant = variants_[i];
    progress.show(static_cast<double>(i) / static_cast<double>(variants_.size()), "preparing " + variant.manifest->name);
    attempt(variant, [&] {
      const auto start = std::chrono::steady_clock::now();
      variant.graph = make_graph(plan_, configuration_with(plan_, *variant.manifest), resources_.scene(), shaders_);
      variant.frame = std::make_unique<Frame>(resources_, variant.graph, Build::timed);
      variant.frame->run_once(Timing::off);
      variant.frame->run(0, Timing::off);
      const double cold_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
      const std::set<std::string> hashes = variant.graph.shader_hashes();
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
      Frame counting(resources_, variant.graph, Build::counting);
      counting.run_once(Timing::off);
      const std::vector<PassCounts> once = counting.once_counts();
      for (size_t view = 0; view < variant.rows.size(); ++view) {
        counting.run(view, Timing::off);
        CellRow& row = variant.rows[view];
        row.passes = count_rows(counting, once, counting.frame_counts());
        for (const PassRow& pass : row.passes)
          if (!pass.once) row.fetches += pass.fetches;
        variant.covered[view] = counting.coverage(variant.manifest->effect);
        row.covered_pixels =
            static_cast<uint64_t>(std::count(variant.covered[view].on.begin(), variant.covered[view].on.end(), 1));
        if (row.covered_pixels > 0)
          row.fetches_per_pixel = static_cast<double>(row.fetches) / static_cast<double>(row.covered_pixels);
      }
    });
  }
}

Image BackendRun::render(Variant& variant, size_t view) {
  variant.frame->run(view, Timing::off);
  return variant.frame->picture();
}

std::string BackendRun::picture_path(const CellRow& row, std::string_view suffix) const {
  return file_name_of(fmt::format("{}-{}-{}-{}{}", row.effect, row.variant, row.backend, row.view, suffix)) + ".png";
}

void BackendRun::score(Progress& progress) {
  const size_t views = variants_.front().rows.size();
  for (size_t view = 0; view < views; ++view) {
    progress.show(static_cast<double>(view) / static_cast<double>(views),
                  "scoring view " + resources_.scene().views[view].name);
    std::optional<Image> baseline;
    for (Variant& variant : variants_) {
      attempt(variant, [&] {
        if (variant.manifest->baseline) baseline = render(variant, view);
        score_view(variant, view, baseline ? &*baseline : nullptr, progress);
      });
    }
  }
}

void BackendRun::score_view(Variant& variant, size_t view, const Image* baseline, Progress& progress) {
  CellRow& row = variant.rows[view];
  const bool is_baseline = variant.manifest->baseline;
  const Image picture = is_baseline ? *baseline : render(variant, view);
  const DisplayImage display = to_display(with_marked_nonfinite(picture));
  const auto write = [&](const std::string& suffix, const DisplayImage& image) {
    const std::string name = picture_path(row, suffix);
    write_png((images_ / name).string(), image);
    return "images/" + name;
  };
  row.image = write("", display);
  row.image_hash = linear_hash(picture);
  row.nonfinite_pixels = nonfinite_pixels(picture);
  if (row.nonfinite_pixels == 0)
    truth_.score(*variant.manifest, view, picture, row, write, [&](double fraction) {
      progress.show(fraction, "casting rays for the truth of view " + resources_.scene().views[view].name);
    });
  if (is_baseline || !baseline || row.nonfinite_pixels > 0 || nonfinite_pixels(*baseline) > 0) return;
  const Mask covered = either(variant.covered[view], variants_.front().covered[view]);
  if (std::count(covered.on.begin(), covered.on.end(), 1) == 0) return;  // nothing of the effect is in this view
  const ErrorReport report = measure_error(picture, *baseline, covered);
  row.error_covered = report.covered;
  row.error_frame = report.frame;
  row.difference = write("-difference", difference_picture(display, to_display(*baseline), difference_gain));
  row.flip = write("-flip", flip_picture(report.flip, picture.width, picture.height));
  row.worst_tile = worst_tile(report.flip, picture.width, picture.height);
}

RoundsResult BackendRun::time(Progress& progress, bool timer_ok) {
  for (Variant& variant : variants_)
    for (CellRow& row : variant.rows) row.timed = timer_ok;
  if (!timer_ok) return {};
  for (Variant& variant : variants_)
    attempt(variant, [&] {
      variant.once_ms.assign(variant.frame->once_names().size(), {});
      for (size_t i = 0; i < once_repetitions; ++i) {
        const FrameTimes times = variant.frame->run_once(Timing::bracketed);
        for (size_t pass = 0; pass < times.pass_ms.size(); ++pass) variant.once_ms[pass].push_back(times.pass_ms[pass]);
      }
    });

  std::vector<Arm> arms;
  std::vector<std::pair<Variant*, size_t>> cells;  // beside arms
  for (Variant& variant : variants_) {
    if (!variant.failure.empty()) continue;
    for (size_t view = 0; view < variant.rows.size(); ++view) {
      Arm arm;
      arm.run = [&variant, view] { return variant.frame->run(view, Timing::bracketed); };
      if (variants_.front().failure.empty()) arm.baseline = view;  // the baseline's arms come first, one a view
      arms.push_back(std::move(arm));
      cells.emplace_back(&variant, view);
    }
  }
  RoundOptions rounds;
  rounds.budget_s = options_.budget_s;
  rounds.precision = options_.precision;
  rounds.seed = options_.seed;
  RoundsResult result = run_rounds(arms, rounds, [&](double fraction) { progress.show(fraction, "timing"); });

  for (size_t i = 0; i < arms.size(); ++i) {
    const ArmSamples& samples = result.arms[i];
    CellRow& row = cells[i].first->rows[cells[i].second];
    if (!samples.failure.empty()) {
      fail(row, samples.failure);
      continue;
    }
    size_t once = 0, frame = 0;
    for (PassRow& pass : row.passes) pass.ms = pass.once ? cells[i].first->once_ms[once++] : samples.pass_ms[frame++];
    const bool has_baseline = arms[i].baseline && result.arms[*arms[i].baseline].failure.empty();
    if (has_baseline && !row.baseline)
      row.ratio_to_baseline = ratio_interval(samples.frame_ms, result.arms[*arms[i].baseline].frame_ms);
  }
  return result;
}

std::vector<CellRow> BackendRun::rows() const {
  std::vector<CellRow> all;
  for (const Variant& variant : variants_) all.insert(all.end(), variant.rows.begin(), variant.rows.end());
  return all;
}

std::vector<CellRow> failed_rows(const std::string& backend, const Scene& scene, const EffectManifest& effect,
                                 const CompareOptions& options, const std::string& reason) {
  std::vector<CellRow> rows;
  for (const VariantManifest& variant : effect.variants) {
    if (!is_compared(variant, options)) continue;
    for (const View& view : scene.views) fail(rows.emplace_back(blank_row(backend, "", scene, view, variant, options)), reason);
  }
  return rows;
}

}  // namespace lamina
