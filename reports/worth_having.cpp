// SPDX-License-Identifier: Apache-2.0
// The answer first: of each effect the variants worth having and those that are dominated, and what a gate said.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/frontier.h"
#include "reports/words.h"

namespace lamina {
namespace {

// What a variant came to on each backend: who beats it, "" where none does, or why that is not known.
struct Standing {
  std::string variant;
  bool baseline = false;
  double ssim = 0;  // on the first backend where it is worth having
  std::vector<std::string> worth_on, unknown_on;
  std::vector<std::pair<std::string, std::string>> beaten_on;  // backend, by whom
};

const ErrorMetric& judging_metric = error_metrics[0];  // SSIM, which people who read headlines know

std::string listed(const std::vector<std::string>& names) {
  if (names.size() < 2) return fmt::format("{}", fmt::join(names, ""));
  return fmt::format("{} and {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

// " on vulkan", or nothing where it is so on all backends of the effect.
std::string on(const std::vector<std::string>& backends, size_t all) {
  return backends.size() == all ? "" : " on " + listed(backends);
}

std::vector<Standing> standings(const std::vector<SummaryRow>& rows, const std::string& effect, Reference reference, Cost cost,
                                std::vector<std::string>& backends) {
  std::vector<Standing> all;
  for (const SummaryRow& first : rows) {
    if (first.effect != effect || std::ranges::find(backends, first.backend) != backends.end()) continue;
    backends.push_back(first.backend);
    std::vector<const SummaryRow*> group;
    std::vector<Contender> contenders;
    for (const SummaryRow& row : rows)
      if (row.effect == effect && row.backend == first.backend) {
        group.push_back(&row);
        contenders.push_back(contender(figures_of(row), cost, judging_metric, reference));
      }
    const std::vector<size_t> by = beaten_by(contenders);
    for (size_t i = 0; i < group.size(); ++i) {
      auto known = std::ranges::find_if(all, [&](const Standing& s) { return s.variant == group[i]->variant; });
      if (known == all.end()) known = all.insert(known, {.variant = group[i]->variant, .baseline = group[i]->baseline});
      if (!contenders[i].cost || !contenders[i].error)
        known->unknown_on.push_back(first.backend);
      else if (by[i] == i) {
        const CostAndErrors figures = figures_of(*group[i]);
        if (known->worth_on.empty())
          known->ssim = (reference == Reference::baseline ? figures.to_baseline : figures.to_truth)->ssim;
        known->worth_on.push_back(first.backend);
      } else
        known->beaten_on.emplace_back(first.backend, group[by[i]]->variant);
    }
  }
  return all;
}

// " (SSIM 0.9942)", so that it is seen how little may part two that are both worth having; near 1 there are more digits to it.
std::string worth_words(const Standing& one, Reference reference) {
  if (one.baseline && reference == Reference::baseline) return " (the baseline)";
  return fmt::format(" ({}SSIM {:.{}f})", one.baseline ? "the baseline, " : "", one.ssim, one.ssim > 0.9995 ? 6 : 4);
}

// "by light_map", and where, unless there is one backend.
std::string beaten_words(const Standing& one, size_t backends) {
  std::vector<std::string> where, each;
  for (const auto& [backend, better] : one.beaten_on) {
    where.push_back(backend);
    each.push_back(fmt::format("by {} on {}", better, backend));
  }
  const std::string& first = one.beaten_on.front().second;
  if (std::ranges::any_of(one.beaten_on, [&](const auto& on_one) { return on_one.second != first; })) return listed(each);
  if (backends == 1) return "by " + first;
  return fmt::format("by {} on {}", first,
                     where.size() < backends ? listed(where)
                     : backends == 2         ? "both backends"
                                             : "every backend");
}

// "layered_material" and what is worth having of it; nothing where nothing can be weighed.
std::optional<Headline> answer(const std::vector<SummaryRow>& rows, const std::string& effect, Reference reference) {
  const bool timed = std::ranges::any_of(rows, [&](const SummaryRow& row) { return row.effect == effect && row.frame_ms; });
  std::vector<std::string> backends, worth, unknown;
  std::vector<std::pair<std::string, std::vector<std::string>>> dominated;  // by what and where; what is
  for (const Standing& one : standings(rows, effect, reference, timed ? Cost::time : Cost::fetches, backends)) {
    if (!one.worth_on.empty()) worth.push_back(one.variant + worth_words(one, reference) + on(one.worth_on, backends.size()));
    if (!one.beaten_on.empty()) {
      const std::string by = beaten_words(one, backends.size());
      auto known = std::ranges::find_if(dominated, [&](const auto& group) { return group.first == by; });
      if (known == dominated.end()) known = dominated.insert(known, {by, {}});
      known->second.push_back(one.variant);
    }
    if (!one.unknown_on.empty()) unknown.push_back(one.variant + on(one.unknown_on, backends.size()));
  }
  if (worth.size() < 2 && dominated.empty()) return std::nullopt;
  std::string words = fmt::format("worth having, by {} and SSIM to the {}: {}.", timed ? "time" : "fetches",
                                  reference == Reference::baseline ? "baseline" : "truth", listed(worth));
  std::vector<std::string> groups;
  for (const auto& [by, variants] : dominated) groups.push_back(fmt::format("{} ({})", listed(variants), by));
  if (!groups.empty())
    words += fmt::format(" Dominated, since another is closer and not measurably {}: {}.", timed ? "slower" : "more expensive",
                         fmt::join(groups, "; "));
  if (!unknown.empty()) words += fmt::format(" Not known (failed, not timed or without figures): {}.", listed(unknown));
  return Headline{.variant = effect, .words = words};
}

}  // namespace

CostAndErrors figures_of(const SummaryRow& row) {
  const bool whole = row.failed_views == 0;
  return {.frame_ms = row.frame_ms,
          .fetches_per_pixel = row.fetches_per_pixel,
          .to_baseline = row.baseline && whole && row.nonfinite_pixels == 0 ? no_error : row.mean,
          .to_truth = row.mean_to_truth};
}

std::vector<Headline> worth_having(const std::vector<SummaryRow>& rows) {
  std::vector<Headline> all;
  std::vector<std::string> done;
  for (const SummaryRow& row : rows) {
    if (std::ranges::find(done, row.effect) != done.end()) continue;
    done.push_back(row.effect);
    for (const Reference reference : {Reference::baseline, Reference::truth})
      if (auto words = answer(rows, row.effect, reference)) all.push_back(std::move(*words));
  }
  return all;
}

}  // namespace lamina
