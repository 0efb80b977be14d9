// SPDX-License-Identifier: Apache-2.0
// What each pass of a variant costs, over the views: time, shaded fragments, and fetches by texture, format and filter.
#include <fmt/format.h>

#include <algorithm>

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
  return pass.shares.emplace_back(
      PassSummary::Share{.texture = fetched.texture, .format = fetched.format, .filter = fetched.filter});
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
      for (const TextureFetches& fetched : row.by_texture) share_of(pass, fetched).fetches += fetched.fetches;
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
    if (sum.covered_pixels == 0) continue;
    pass.fetches_per_pixel = sum.fetches / sum.covered_pixels;
    for (PassSummary::Share& share : pass.shares) share.per_pixel = static_cast<double>(share.fetches) / sum.covered_pixels;
  }
  return passes;
}

std::string words_for_fragments(const PassSummary& pass) {
  return fmt::format("{:.0f}{}", pass.fragments, pass.early_tests ? "" : ", hidden ones too");
}

std::string words_for_share(const PassSummary::Share& share) {
  return fmt::format("{} ({}, {}) {:.1f}/px", share.texture, share.format, share.filter, share.per_pixel);
}

Table passes_table(const std::vector<PassSummary>& passes) {
  Table table = {
      .caption =
          "Means over views; fetches per pixel that the effect covers; ns per fetch: the pass's whole time over its fetches",
      .columns = {words_column("variant"), words_column("backend"), words_column("pass"), words_column("done"),
                  figures_column("ms"), figures_column("fragments"), figures_column("fetches/px"), figures_column("ns/fetch"),
                  words_column("by texture, format and filter")},
      .html_class = "wide"};
  const auto figure = [](const std::optional<double>& value, int digits) {
    return value ? fmt::format("{:.{}f}", *value, digits) : std::string("-");
  };
  for (const PassSummary& pass : passes) {
    Row& row = table.rows.emplace_back(row_of({pass.variant, pass.backend, pass.name, pass.once ? "once" : "each frame",
                                               pass.ms ? words_for_ms(*pass.ms) : "-", words_for_fragments(pass),
                                               figure(pass.fetches_per_pixel, 1), figure(pass.ns_per_fetch, 2), ""}));
    for (const PassSummary::Share& share : pass.shares) row.cells.back().items.push_back(words_for_share(share));
  }
  return table;
}

}  // namespace lamina
