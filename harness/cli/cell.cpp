// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/cell.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "harness/core/text.h"
#include "harness/record/dearness.h"
#include "harness/scene/declare.h"

namespace lamina {
namespace {

std::string linear_hash(const Image& image) {
  return hash_hex({reinterpret_cast<const char*>(image.rgba.data()), image.rgba.size() * sizeof(float)});
}

// Names of scenes' views and objects may hold anything; file names may not.
std::string file_name_of(std::string text) {
  for (char& c : text)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-') c = '_';
  return text;
}

std::vector<LineRow> dearest_lines(const PassCounts& counts) {
  LineWork all;
  for (const auto& [line, work] : counts.lines) all.add(work);
  std::vector<LineRow> rows;
  for (const auto& [line, work] : counts.lines) rows.push_back({line.file, line.line, work.fetches, work.operations});
  std::ranges::stable_sort(rows, std::greater{}, [&](const LineRow& row) {
    return dearness(static_cast<double>(row.fetches), static_cast<double>(row.operations), static_cast<double>(all.fetches),
                    static_cast<double>(all.operations));
  });
  rows.resize(std::min(rows.size(), max_line_rows));
  return rows;
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
      row.operations = counts[i].operations;
      row.issued = counts[i].issued;
      row.lines = dearest_lines(counts[i]);
      row.vertex_issued = counts[i].vertex_issued;
      row.runs = counts[i].runs;
      row.triangles = counts[i].triangles;
      row.issued_fragments = counts[i].issued_fragments;
      row.written = counts[i].written;
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

}  // namespace

CellRow blank_row(const std::string& backend, const std::string& device, const Scene& scene, const Library& library,
                  const View& view, const VariantManifest& variant, const CellOptions& options) {
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
  for (const auto& [path, value] : declared_numbers(scene, library)) row.params[path] = value;
  row.words = declared_words(scene, library);
  for (const ParameterManifest& parameter : variant.parameters) {
    const std::string path = fmt::format("{}.{}", variant.name, parameter.name);
    row.params[path] = parameter.value;
    if (!parameter.words.empty()) row.words[path] = parameter.text(parameter.value);
  }
  return row;
}

void fail(CellRow& row, const std::string& reason) {
  row.failed = true;
  row.reason = reason;
}

bool attempt(std::string& failure, std::vector<CellRow>& rows, const std::function<void()>& work) {
  if (!failure.empty()) return false;
  try {
    work();
  } catch (const std::exception& error) {
    failure = error.what();
    for (CellRow& row : rows) fail(row, failure);
  }
  return failure.empty();
}

void append_row(RecordWriter& record, const CellRow& row) {
  nlohmann::ordered_json line;
  try {
    line = to_json(row);
  } catch (const Error& error) {
    CellRow failed;
    failed.scene = row.scene, failed.effect = row.effect, failed.variant = row.variant, failed.baseline = row.baseline;
    failed.backend = row.backend, failed.device = row.device, failed.view = row.view;
    failed.width = row.width, failed.height = row.height, failed.params = row.params, failed.words = row.words;
    failed.failed = true, failed.reason = error.what();
    line = to_json(failed);
  }
  record.append(line);
}

Mask count_cell(CellRow& row, Frame& counting, const std::vector<PassCounts>& once, const VariantManifest& variant,
                size_t view) {
  counting.run(view, Timing::off);
  row.passes = count_rows(counting, once, counting.frame_counts());
  uint64_t fetches = 0;
  for (const PassRow& pass : row.passes)
    if (!pass.once) fetches += *pass.fetches;
  row.fetches = fetches;
  Mask covered = counting.coverage(variant.effect);
  row.covered_pixels = count_on(covered);
  if (row.covered_pixels > 0) row.fetches_per_pixel = static_cast<double>(fetches) / static_cast<double>(*row.covered_pixels);
  return covered;
}

std::string picture_name(const CellRow& row, const std::string& suffix) {
  return file_name_of(fmt::format("{}-{}-{}-{}{}", row.effect, row.variant, row.backend, row.view, suffix)) + ".png";
}

void fill_picture(CellRow& row, const Image& picture, const Mask& covered, const KeepPicture& keep) {
  if (keep) row.image = keep("", to_display(with_marked_nonfinite(picture)));
  row.image_hash = linear_hash(picture);
  row.nonfinite_pixels = nonfinite_pixels(picture);
  if (row.nonfinite_pixels == 0 && row.covered_pixels > 0) row.range_linear = range_linear(picture, &covered);
}

void fill_errors(CellRow& row, const Image& picture, const Image& baseline, const Mask& covered, const KeepPicture& keep) {
  if (row.nonfinite_pixels > 0 || nonfinite_pixels(baseline) > 0) return;
  if (count_on(covered) == 0) return;  // nothing of the effect is in this view
  fill_errors(row, measure_error(picture, baseline, covered), picture, baseline, keep);
}

void fill_errors(CellRow& row, const ErrorReport& report, const Image& picture, const Image& baseline,
                 const KeepPicture& keep) {
  row.error_covered = report.covered;
  row.error_frame = report.frame;
  if (!keep) return;
  row.difference = keep("-difference", difference_picture(to_display(picture), to_display(baseline), difference_gain));
  row.flip = keep("-flip", flip_picture(report.flip, picture.width, picture.height));
  row.worst_tile = worst_tile(report.flip, picture.width, picture.height);
}

void copy_errors(CellRow& row, const CellRow& same) {
  row.error_covered = same.error_covered, row.error_frame = same.error_frame;
  row.difference = same.difference, row.flip = same.flip, row.worst_tile = same.worst_tile;
}

Mask either(const Mask& a, const Mask& b) {
  Mask both = a;
  for (size_t i = 0; i < both.on.size(); ++i) both.on[i] = a.on[i] | b.on[i];
  return both;
}

uint64_t count_on(const Mask& mask) { return static_cast<uint64_t>(std::count(mask.on.begin(), mask.on.end(), 1)); }

void note_unfinished(CellRow& row, const Frame& frame, size_t view) {
  for (const GraphPass* pass : frame.unfinished(view)) {
    std::string note =
        fmt::format("pass '{}' still drew something in the last of its repetitions: the rest is not drawn", pass->pass->name);
    if (!pass->pass->repeat.parameter.empty())
      note += fmt::format("; raise {}.{}", pass->variant->name, pass->pass->repeat.parameter);
    fmt::print(stderr, "lamina: note: {}, view {}: {}\n", row.variant, row.view, note);
    row.notes.push_back(std::move(note));
  }
}

}  // namespace lamina
