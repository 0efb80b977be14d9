// SPDX-License-Identifier: Apache-2.0
// What was swept and where curves cross, in words: the same for the page and for Markdown.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "harness/sweep/answers.h"
#include "reports/words.h"

namespace lamina {

namespace {

bool has_several_effects(const Record& record) {
  std::set<std::string> effects;
  for (const CellRow& cell : record.cells) effects.insert(cell.effect);
  for (const CrossoverRow& row : record.crossovers) effects.insert(row.effect);
  return effects.size() > 1;
}

// "vulkan", "vulkan and osmesa", "vulkan, osmesa and egl".
std::string joined_names(const std::vector<std::string>& names) {
  const size_t last = names.size() - 1;
  if (last == 0) return names[0];
  return fmt::format("{} and {}", fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(last), ", "),
                     names[last]);
}

}  // namespace

std::vector<Headline> crossover_headlines(const Record& record, Crossovers which) {
  struct Answer {
    std::string effect, claim, remark;
    std::vector<std::string> backends;  // none where the sentence names none
  };
  std::vector<Answer> answers;
  std::map<std::array<std::string, 4>, size_t> places;
  for (const CrossoverRow& row : crossovers_of(record)) {
    if (which != Crossovers::all && row.limit.has_value() != (which == Crossovers::about_limits)) continue;
    const std::string& claim = row.claim.empty() ? row.sentence : row.claim;
    const auto [place, added] = places.try_emplace({row.effect, row.parameter, claim, row.remark}, answers.size());
    if (added) answers.push_back({row.effect, claim, row.remark, {}});
    std::vector<std::string>& backends = answers[place->second].backends;
    if (!row.claim.empty() && std::ranges::find(backends, row.backend) == backends.end()) backends.push_back(row.backend);
  }
  const bool several = has_several_effects(record);
  std::vector<Headline> all;
  for (const auto& [effect, claim, remark, backends] : answers)
    all.push_back({.variant = several ? effect : "",
                   .words = backends.empty() ? claim : fmt::format("{} on {}{}", claim, joined_names(backends), remark)});
  return all;
}

std::vector<std::string> sweep_lines(const Record& record) {
  std::vector<std::string> lines;
  const auto words_of = [](double value) { return nlohmann::json(value).dump(); };
  for (const SweepRow& sweep : record.sweeps)
    for (const auto& [path, unit, values] : sweep.parameters) {
      std::string words = path;
      if (!values.empty())
        words += fmt::format(" from {} to {}{}{} in {} values", words_of(values.front()), words_of(values.back()),
                             unit.empty() ? "" : " ", unit, values.size());
      lines.push_back(words);
    }
  return lines;
}

}  // namespace lamina
