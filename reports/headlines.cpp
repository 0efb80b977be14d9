// SPDX-License-Identifier: Apache-2.0
// One plain sentence for each variant: what it saves on each backend, and what it loses.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/quality/judged_picture.h"
#include "reports/words.h"

namespace lamina {
namespace {

// From here on "times faster" reads better than a percentage; an editorial choice.
constexpr double ratio_for_times = 1.5;
// Nearer to 1 than this in every view, differences in SSIM are in digits that nobody reads; PSNR parts such variants. Likewise.
constexpr double almost_one = 0.9985;

std::string speed_words(const Interval& ratio, const std::string& baseline) {
  const double r = ratio.median;
  std::string words;
  if (ratio.low <= 1 && ratio.high >= 1)
    words = fmt::format("is neither faster nor slower than {} beyond the noise (ratio {:.3f} to {:.3f})", baseline, ratio.low,
                        ratio.high);
  else if (r < 1)
    words = r * ratio_for_times <= 1 ? fmt::format("is {:.1f} times faster than {}", 1 / r, baseline)
                                     : fmt::format("takes {:.2g}% less time than {}", 100 * (1 - r), baseline);
  else
    words = r >= ratio_for_times ? fmt::format("is {:.1f} times slower than {}", r, baseline)
                                 : fmt::format("takes {:.2g}% more time than {}", 100 * (r - 1), baseline);
  return words;
}

std::string loss_words(const SummaryRow& row) {
  if (!row.mean || !row.worst) return "";
  if (std::isinf(row.worst->psnr_db)) return row.ratio ? " with the same picture" : ", where its picture is the same";
  if (row.worst->ssim > almost_one)  // SSIM no longer differs there, and few digits would make the picture look perfect
    return fmt::format("{} above {:.3f} and {}PSNR {:.1f} dB (worst view {:.1f})",
                       row.ratio ? " at SSIM" : ", where its SSIM is",
                       std::min(0.999, std::floor(1000 * row.worst->ssim) / 1000), row.ratio ? "" : "its ", row.mean->psnr_db,
                       row.worst->psnr_db);
  return fmt::format("{} {:.3f} (worst view {:.3f})", row.ratio ? " at SSIM" : ", where its SSIM is", row.mean->ssim,
                     row.worst->ssim);
}

// What is known of the cost where no time is.
std::string untimed_words(const SummaryRow& row, const SummaryRow* baseline) {
  if (!baseline) return "was not timed against the baseline";
  if (!row.fetches_per_pixel || !baseline->fetches_per_pixel) return "was not timed against " + baseline->variant;
  return fmt::format("was not timed; it makes {:.1f} fetches a pixel, {} {:.1f},", *row.fetches_per_pixel, baseline->variant,
                     *baseline->fetches_per_pixel);
}

std::string clause(const SummaryRow& row, const SummaryRow* baseline, const std::string& loss) {
  if (row.failed_views == row.views) {
    if (row.reason.starts_with(no_picture))
      return fmt::format("is not a picture on {}: {}", row.backend, row.reason.substr(no_picture.size()));
    return fmt::format("failed on {}: {}", row.backend, row.reason);
  }
  std::string words =
      row.ratio ? speed_words(*row.ratio, baseline ? baseline->variant : "the baseline") : untimed_words(row, baseline);
  words += fmt::format(" on {}", row.backend) + loss;
  if (row.ratio && row.ratio->coverage < report_confidence)
    words += fmt::format(", by {} round{} only", row.ratio->rounds, row.ratio->rounds == 1 ? "" : "s");
  if (row.failed_views > 0)
    words += row.reason.starts_with(no_picture)
                 ? fmt::format("; in {} of {} views it is not a picture there", row.failed_views, row.views)
                 : fmt::format("; {} of {} views failed there", row.failed_views, row.views);
  return words;
}

}  // namespace

std::vector<Headline> headlines(const std::vector<SummaryRow>& rows) {
  struct OfVariant {
    std::string effect, loss;  // loss: on the first backend
    Headline headline;
  };
  std::vector<OfVariant> told;
  for (const SummaryRow& row : rows) {
    if (row.baseline) continue;
    const auto baseline = std::ranges::find_if(
        rows, [&](const SummaryRow& r) { return r.baseline && r.effect == row.effect && r.backend == row.backend; });
    const auto known = std::ranges::find_if(
        told, [&](const OfVariant& t) { return t.effect == row.effect && t.headline.variant == row.variant; });
    const std::string loss = loss_words(row);
    const bool again = known != told.end() && loss == known->loss && row.worst && !std::isinf(row.worst->psnr_db);
    const char* same = row.ratio ? " at the same loss" : ", where its loss is the same";
    const std::string words = clause(row, baseline == rows.end() ? nullptr : &*baseline, again ? same : loss);
    if (known == told.end())
      told.push_back({row.effect, loss, {.variant = row.variant, .words = words}});
    else
      known->headline.words += "; it " + words;
  }
  std::vector<Headline> all;
  for (OfVariant& each : told) {
    each.headline.words += '.';
    all.push_back(std::move(each.headline));
  }
  return all;
}

}  // namespace lamina
