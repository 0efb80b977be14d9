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
      else if (by[i] == i)
        known->worth_on.push_back(first.backend);
      else
        known->beaten_on.emplace_back(first.backend, group[by[i]]->variant);
    }
  }
  return all;
}

// "layered_material" and what is worth having of it; nothing where nothing can be weighed.
std::optional<Headline> answer(const std::vector<SummaryRow>& rows, const std::string& effect, Reference reference) {
  const bool timed = std::ranges::any_of(rows, [&](const SummaryRow& row) { return row.effect == effect && row.frame_ms; });
  std::vector<std::string> backends, worth, dominated, unknown;
  for (const Standing& one : standings(rows, effect, reference, timed ? Cost::time : Cost::fetches, backends)) {
    if (!one.worth_on.empty())
      worth.push_back(one.variant + (one.baseline ? " (the baseline)" : "") + on(one.worth_on, backends.size()));
    std::vector<std::string> by;
    for (const auto& [backend, better] : one.beaten_on) by.push_back(better);
    std::vector<std::string> where;
    for (const auto& [backend, better] : one.beaten_on) where.push_back(backend);
    if (!by.empty() && std::ranges::all_of(by, [&](const std::string& name) { return name == by[0]; }))
      dominated.push_back(fmt::format("{} (by {}{})", one.variant, by[0],
                                      backends.size() == 1             ? ""
                                      : where.size() < backends.size() ? " on " + listed(where)
                                      : backends.size() == 2           ? " on both backends"
                                                                       : " on every backend"));
    else if (!by.empty()) {
      std::vector<std::string> each;
      for (const auto& [backend, better] : one.beaten_on) each.push_back(fmt::format("by {} on {}", better, backend));
      dominated.push_back(fmt::format("{} ({})", one.variant, listed(each)));
    }
    if (!one.unknown_on.empty()) unknown.push_back(one.variant + on(one.unknown_on, backends.size()));
  }
  if (worth.size() + dominated.size() < 2) return std::nullopt;
  std::string words = fmt::format("worth having, by {} and SSIM to the {}: {}.", timed ? "time" : "fetches",
                                  reference == Reference::baseline ? "baseline" : "truth", listed(worth));
  if (!dominated.empty())
    words += fmt::format(" Dominated, since another is closer and not measurably {}: {}.", timed ? "slower" : "dearer",
                         listed(dominated));
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

std::vector<Headline> answers(const std::vector<SummaryRow>& rows) {
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
