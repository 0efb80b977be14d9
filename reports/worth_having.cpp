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
struct Outcomes {
  std::string variant;
  bool baseline = false;
  double ssim = 0;           // on the first backend where it is worth having
  std::string beyond_limit;  // likewise, of where it is beyond a limit
  std::vector<std::string> worth_on, unknown_on, beyond_on;
  std::vector<std::pair<std::string, std::string>> beaten_on, not_told_on;  // backend, by or from whom
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

std::vector<Outcomes> outcomes(const std::vector<SummaryRow>& rows, const std::string& effect, Reference reference, Cost cost,
                               std::vector<std::string>& backends) {
  std::vector<Outcomes> all;
  for (const SummaryRow& first : rows) {
    if (first.effect != effect || std::ranges::find(backends, first.backend) != backends.end()) continue;
    backends.push_back(first.backend);
    std::vector<const SummaryRow*> group;
    std::vector<CostAndErrors> figures;
    for (const SummaryRow& row : rows)
      if (row.effect == effect && row.backend == first.backend) {
        group.push_back(&row);
        figures.push_back(figures_of(row));
      }
    const std::vector<Place> places = places_of(figures, cost, judging_metric, reference);
    for (size_t i = 0; i < group.size(); ++i) {
      auto known = std::ranges::find_if(all, [&](const Outcomes& one) { return one.variant == group[i]->variant; });
      if (known == all.end()) known = all.insert(known, {.variant = group[i]->variant, .baseline = group[i]->baseline});
      switch (places[i].standing) {
        case Standing::unknown:
          known->unknown_on.push_back(first.backend);
          break;
        case Standing::on_frontier:
          if (known->worth_on.empty())
            known->ssim = (reference == Reference::baseline ? figures[i].to_baseline : figures[i].to_truth)->ssim;
          known->worth_on.push_back(first.backend);
          break;
        case Standing::dominated:
          known->beaten_on.emplace_back(first.backend, group[places[i].by]->variant);
          break;
        case Standing::not_told_apart:
          known->not_told_on.emplace_back(first.backend, group[places[i].by]->variant);
          break;
        case Standing::beyond_limit:
          if (known->beyond_on.empty()) known->beyond_limit = group[i]->beyond_limit;
          known->beyond_on.push_back(first.backend);
          break;
      }
    }
  }
  return all;
}

// " (SSIM 0.9942)", so that it is seen how little may part two that are both worth having; near 1 there are more digits to it.
std::string worth_words(const Outcomes& one, Reference reference) {
  if (one.baseline && reference == Reference::baseline) return " (the baseline)";
  return fmt::format(" ({}SSIM {:.{}f})", one.baseline ? "the baseline, " : "", one.ssim, one.ssim > 0.9995 ? 6 : 4);
}

using OnBackends = std::vector<std::pair<std::string, std::string>>;

// "by light_map", and where, unless there is one backend. `how`: "by" or "from".
std::string beaten_words(const char* how, const OnBackends& all, size_t backends) {
  std::vector<std::string> where, each;
  for (const auto& [backend, other] : all) {
    where.push_back(backend);
    each.push_back(fmt::format("{} {} on {}", how, other, backend));
  }
  const std::string& first = all.front().second;
  if (std::ranges::any_of(all, [&](const auto& on_one) { return on_one.second != first; })) return listed(each);
  if (backends == 1) return fmt::format("{} {}", how, first);
  return fmt::format("{} {} on {}", how, first,
                     where.size() < backends ? listed(where)
                     : backends == 2         ? "both backends"
                                             : "every backend");
}

// "a and b (by c); d (by e on vulkan)": variants that have the same words share them.
class GroupedByWords {
 public:
  void add(const std::string& variant, const std::string& words) {
    auto known = std::ranges::find_if(groups_, [&](const auto& group) { return group.first == words; });
    if (known == groups_.end()) known = groups_.insert(known, {words, {}});
    known->second.push_back(variant);
  }
  bool empty() const { return groups_.empty(); }
  std::string text() const {
    std::vector<std::string> all;
    for (const auto& [words, variants] : groups_) all.push_back(fmt::format("{} ({})", listed(variants), words));
    return fmt::format("{}", fmt::join(all, "; "));
  }

 private:
  std::vector<std::pair<std::string, std::vector<std::string>>> groups_;
};

// "layered_material" and what is worth having of it; nothing where nothing can be weighed.
std::optional<Headline> answer(const std::vector<SummaryRow>& rows, const std::string& effect, Reference reference) {
  const bool timed = std::ranges::any_of(rows, [&](const SummaryRow& row) { return row.effect == effect && row.frame_ms; });
  std::vector<std::string> backends, worth, unknown;
  GroupedByWords dominated, not_told, beyond;
  for (const Outcomes& one : outcomes(rows, effect, reference, timed ? Cost::time : Cost::fetches, backends)) {
    if (!one.worth_on.empty()) worth.push_back(one.variant + worth_words(one, reference) + on(one.worth_on, backends.size()));
    if (!one.beaten_on.empty()) dominated.add(one.variant, beaten_words("by", one.beaten_on, backends.size()));
    if (!one.not_told_on.empty()) not_told.add(one.variant, beaten_words("from", one.not_told_on, backends.size()));
    if (!one.beyond_on.empty()) beyond.add(one.variant, one.beyond_limit + on(one.beyond_on, backends.size()));
    if (!one.unknown_on.empty()) unknown.push_back(one.variant + on(one.unknown_on, backends.size()));
  }
  if (worth.size() < 2 && dominated.empty() && not_told.empty() && beyond.empty()) return std::nullopt;
  std::string words =
      fmt::format("worth having, by {} and SSIM to the {}: {}.", timed ? "time" : "fetches",
                  reference == Reference::baseline ? "baseline" : "truth", worth.empty() ? "none" : listed(worth));
  if (!dominated.empty())
    words +=
        fmt::format(" Dominated, since another is closer and {}: {}.",
                    timed ? fmt::format("at most {:.2g}% slower", 100 * (as_fast - 1)) : "no more expensive", dominated.text());
  if (!not_told.empty())
    words += fmt::format(" Not told apart in {}, so that more rounds are needed (--precision, --budget): {}.",
                         timed ? "time" : "fetches", not_told.text());
  if (!beyond.empty()) words += fmt::format(" Beyond the limit of error, and not recommended: {}.", beyond.text());
  if (!unknown.empty()) words += fmt::format(" Not known (failed, not timed or without figures): {}.", listed(unknown));
  return Headline{.variant = effect, .words = words};
}

}  // namespace

CostAndErrors figures_of(const SummaryRow& row) {
  CostAndErrors figures{.frame_ms = row.frame_ms,
                        .fetches_per_pixel = row.fetches_per_pixel,
                        .to_baseline = row.mean,
                        .to_truth = row.mean_to_truth,
                        .rounds_ms = row.rounds_ms,
                        .baseline = row.baseline,
                        .beyond_limit = !row.beyond_limit.empty()};
  if (row.failed_views > 0)
    figures.to_baseline.reset(), figures.to_truth.reset();  // of fewer pictures than the others' are
  else if (row.baseline && row.nonfinite_pixels == 0)
    figures.to_baseline = no_error;
  return figures;
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
