// SPDX-License-Identifier: Apache-2.0
// What failed, a sentence a variant: it comes before every table.
#include <fmt/format.h>

#include <algorithm>

#include "harness/quality/judged_picture.h"
#include "reports/words.h"

namespace lamina {
namespace {

std::string clause(const SummaryRow& row) {
  const bool no_frame = row.reason.starts_with(no_picture);
  if (row.failed_views == row.views)
    return fmt::format("{} on {}: {}", no_frame ? "is not a picture" : "failed", row.backend,
                       no_frame ? row.reason.substr(no_picture.size()) : row.reason);
  return fmt::format("{} in {} of {} views on {}: {}", no_frame ? "is not a picture" : "failed", row.failed_views, row.views,
                     row.backend, no_frame ? row.reason.substr(no_picture.size()) : row.reason);
}

}  // namespace

std::vector<Headline> failure_headlines(const std::vector<SummaryRow>& rows) {
  std::vector<std::string> effects;
  std::vector<Headline> all;
  for (const SummaryRow& row : rows) {
    if (row.failed_views == 0) continue;
    size_t known = 0;
    while (known < all.size() && (effects[known] != row.effect || all[known].variant != row.variant)) ++known;
    if (known < all.size()) {
      all[known].words += "; it " + clause(row);
      continue;
    }
    effects.push_back(row.effect);
    all.push_back({.variant = row.variant, .words = clause(row)});
  }
  for (Headline& each : all) each.words += '.';
  return all;
}

}  // namespace lamina
