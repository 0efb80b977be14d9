// SPDX-License-Identifier: Apache-2.0
// What each pass of a variant costs, over the views: time, shaded fragments, fetches by texture, format and filter, operations
// by class, and the lines of source that cost the most.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "harness/record/dearness.h"
#include "reports/words.h"

namespace lamina {
namespace {

struct Sums {
  double covered_pixels = 0, fetches = 0, ms = 0, timed_fetches = 0;
  size_t timed_views = 0;
};

PassSummary::Share& share_of(PassSummary& pass, const TextureFetches& fetched) {
  const auto known = std::find_if(pass.shares.begin(), pass.shares.end(), [&](const PassSummary::Share& share) {
    return share.texture == fetched.texture && share.format == fetched.format && share.filter == fetched.filter;
  });
  if (known != pass.shares.end()) return *known;
  return pass.shares.emplace_back(PassSummary::Share{
      .texture = fetched.texture, .format = fetched.format, .filter = fetched.filter, .is_3d = fetched.dimensions == 3});
}

void add_fetched(PassSummary::Share& share, const TextureFetches& fetched) {
  const bool known = share.fetches == 0 || !share.levels.empty();  // so far
  share.fetches += fetched.fetches;
  if (!known || (fetched.levels.empty() && fetched.fetches > 0)) return share.levels.clear();
  share.levels.resize(std::max(share.levels.size(), fetched.levels.size()));
  for (size_t level = 0; level < fetched.levels.size(); ++level) share.levels[level] += fetched.levels[level];
}

PassSummary::Line& line_of(PassSummary& pass, const LineRow& row) {
  const auto known = std::ranges::find_if(
      pass.lines, [&](const PassSummary::Line& line) { return line.line == row.line && line.file == row.file; });
  return known != pass.lines.end() ? *known : pass.lines.emplace_back(PassSummary::Line{row.file, row.line, 0, 0});
}

// Of lines whose work is a sum over views, as that of the pass is.
void keep_dearest_lines(PassSummary& pass, double fetches) {
  constexpr size_t max_lines = 5;
  const double operations = pass.operations_per_pixel();
  std::ranges::stable_sort(pass.lines, std::greater{}, [&](const PassSummary::Line& line) {
    return dearness(line.fetches, line.operations, fetches, operations);
  });
  pass.lines.resize(std::min(pass.lines.size(), max_lines));
}

}  // namespace

std::vector<PassSummary> summarize_passes(const Record& record) {
  std::vector<PassSummary> passes;
  std::vector<Sums> sums;  // of the pass at the same index
  for (const CellRow& cell : record.cells) {
    if (cell.failed) continue;
    for (const PassRow& row : cell.passes) {
      const auto known = std::find_if(passes.begin(), passes.end(), [&](const PassSummary& p) {
        return p.name == row.name && p.backend == cell.backend && p.once == row.once && p.variant == cell.variant &&
               p.effect == cell.effect;
      });
      const size_t index = static_cast<size_t>(known - passes.begin());
      if (known == passes.end()) {
        PassSummary& added = passes.emplace_back();
        added.effect = cell.effect;
        added.variant = cell.variant;
        added.backend = cell.backend;
        added.name = row.name;
        added.once = row.once;
        sums.emplace_back();
      }
      PassSummary& pass = passes[index];
      Sums& sum = sums[index];
      ++pass.views;
      pass.early_tests = pass.early_tests && row.early_tests;
      const double fetches = static_cast<double>(row.fetches.value_or(0));
      pass.fragments += static_cast<double>(row.fragments.value_or(0));
      sum.fetches += fetches;
      sum.covered_pixels += static_cast<double>(cell.covered_pixels.value_or(0));
      for (const TextureFetches& fetched : row.by_texture) add_fetched(share_of(pass, fetched), fetched);
      for (const auto& [operation, times] : row.operations) pass.operations[operation] += static_cast<double>(times);
      for (const LineRow& line : row.lines) {
        PassSummary::Line& of = line_of(pass, line);
        of.fetches += static_cast<double>(line.fetches);
        of.operations += static_cast<double>(line.operations);
      }
      if (!row.ms.empty() && cell.timed && times_shown(record, cell.backend)) {
        sum.ms += median(row.ms);
        sum.timed_fetches += fetches;
        ++sum.timed_views;
      }
    }
  }
  for (size_t i = 0; i < passes.size(); ++i) {
    PassSummary& pass = passes[i];
    const Sums& sum = sums[i];
    pass.fragments /= static_cast<double>(pass.views);
    if (sum.timed_views > 0) pass.ms = sum.ms / static_cast<double>(sum.timed_views);
    if (sum.timed_fetches > 0) pass.ns_per_fetch = 1e6 * sum.ms / sum.timed_fetches;
    if (sum.covered_pixels == 0) {
      pass.operations.clear();
      pass.lines.clear();
      continue;
    }
    keep_dearest_lines(pass, sum.fetches);
    for (PassSummary::Line& line : pass.lines) line.fetches /= sum.covered_pixels, line.operations /= sum.covered_pixels;
    for (auto& [operation, times] : pass.operations) times /= sum.covered_pixels;
    pass.fetches_per_pixel = sum.fetches / sum.covered_pixels;
    for (PassSummary::Share& share : pass.shares) share.per_pixel = static_cast<double>(share.fetches) / sum.covered_pixels;
  }
  return passes;
}

double PassSummary::operations_per_pixel() const {
  return std::accumulate(operations.begin(), operations.end(), 0.0,
                         [](double sum, const auto& one) { return sum + one.second; });
}

std::string_view operation_group(std::string_view operation) {
  struct Group {
    std::string_view name;
    std::vector<std::string_view> of;
  };
  static const std::vector<Group> groups = {
      {"add, multiply", {"add", "multiply", "fma"}},
      {"divide, root", {"divide", "root"}},
      {"transcendental", {"sin", "cos", "tan", "asin", "acos", "atan", "hyperbolic", "exp", "log", "pow"}},
      {"integer", {"integer"}},
      {"compare, select, branch", {"compare", "select", "branch"}},
      {"convert", {"convert"}},
      {"inputs, derivatives", {"derivative", "interpolation", "input"}},
      {"memory", {"uniform", "storage", "image", "query"}}};
  for (const Group& group : groups)
    if (std::ranges::find(group.of, operation) != group.of.end()) return group.name;
  return "other";
}

std::string words_for_fragments(const PassSummary& pass) {
  return fmt::format("{:.0f}{}", pass.fragments, pass.early_tests ? "" : ", hidden ones too");
}

std::string words_for_share(const PassSummary::Share& share) {
  const std::optional<double> level = mean_level(share.levels);
  return fmt::format("{} ({}, {}{}) {:.1f}/px{}", share.texture, share.format, share.filter, share.is_3d ? ", 3D" : "",
                     share.per_pixel, level ? fmt::format(", level {:.1f}", *level) : "");
}

std::string words_for_line(const PassSummary::Line& line) {
  std::vector<std::string> words;
  if (line.operations >= 0.05) words.push_back(fmt::format("{:.1f} operations/px", line.operations));
  if (line.fetches >= 0.05) words.push_back(fmt::format("{:.1f} fetches/px", line.fetches));
  return fmt::format("{}:{} {}", line.file, line.line, fmt::join(words, ", "));
}

Table passes_table(const std::vector<PassSummary>& passes) {
  Table table = {
      .caption =
          "Means over views; fetches and operations per pixel that the effect covers; ns per fetch: the pass's whole time over "
          "its fetches; level: the mean of the mip levels that fetches read; dearest lines: by the sum of their shares of the "
          "pass's operations and fetches",
      .columns = {words_column("variant"), words_column("backend"), words_column("pass"), words_column("done"),
                  figures_column("ms"), figures_column("fragments"), figures_column("fetches/px"), figures_column("ns/fetch"),
                  words_column("by texture, format and filter"), figures_column("operations/px"), words_column("by class"),
                  words_column("dearest lines")},
      .html_class = "wide"};
  constexpr size_t by_texture = 8, by_class = 10;  // columns
  const auto figure = [](const std::optional<double>& value, int digits) {
    return value ? fmt::format("{:.{}f}", *value, digits) : std::string("-");
  };
  for (const PassSummary& pass : passes) {
    Row& row = table.rows.emplace_back(row_of(
        {pass.variant, pass.backend, pass.name, pass.once ? "once" : "each frame", pass.ms ? words_for_ms(*pass.ms) : "-",
         words_for_fragments(pass), figure(pass.fetches_per_pixel, 1), figure(pass.ns_per_fetch, 2), "",
         pass.operations.empty() ? "-" : figure(pass.operations_per_pixel(), 1), "", ""}));
    for (const PassSummary::Share& share : pass.shares) row.cells[by_texture].items.push_back(words_for_share(share));
    for (const auto& [operation, per_pixel] : pass.operations)
      if (per_pixel >= 0.05) row.cells[by_class].items.push_back(fmt::format("{} {:.1f}", operation, per_pixel));
    for (const PassSummary::Line& line : pass.lines) row.cells.back().items.push_back(words_for_line(line));
  }
  return table;
}

}  // namespace lamina
