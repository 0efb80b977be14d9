// SPDX-License-Identifier: Apache-2.0
// What was swept and where curves cross, in words: the same for the page and for Markdown.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "reports/words.h"

namespace lamina {

namespace {

using Json = nlohmann::json;

bool has_several_effects(const Record& record) {
  std::set<std::string> effects;
  for (const auto* lines : {&record.cells, &record.crossovers})
    for (const Json& line : *lines) effects.insert(text_at(line, "/effect"));
  return effects.size() > 1;
}

// A sentence before and after the words " on BACKEND", which stand at its end or before its "; ...". Without them, all is
// before.
std::pair<std::string, std::string> around_backend(const std::string& sentence, const std::string& backend) {
  const std::string words = " on " + backend;
  for (size_t at = sentence.rfind(words); at != std::string::npos && !backend.empty(); at = sentence.rfind(words, at - 1)) {
    const size_t end = at + words.size();
    if (end == sentence.size() || sentence[end] == ';') return {sentence.substr(0, at), sentence.substr(end)};
    if (at == 0) break;
  }
  return {sentence, ""};
}

// "vulkan", "vulkan and osmesa", "vulkan, osmesa and egl".
std::string joined_names(const std::vector<std::string>& names) {
  const size_t last = names.size() - 1;
  if (last == 0) return names[0];
  return fmt::format("{} and {}", fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(last), ", "),
                     names[last]);
}

}  // namespace

std::vector<Headline> crossover_headlines(const Record& record, Told told) {
  struct Answer {
    std::string effect, before, after;
    std::vector<std::string> backends;  // none where the sentence names none
  };
  std::vector<Answer> answers;
  std::map<std::array<std::string, 4>, size_t> places;
  for (const Json& line : record.crossovers) {
    const bool about_limit = line.contains("limit") && !line.at("limit").is_null();
    if (told != Told::all && about_limit != (told == Told::about_limits)) continue;
    const std::string effect = text_at(line, "/effect"), backend = text_at(line, "/backend"),
                      sentence = text_at(line, "/sentence");
    const auto [before, after] = around_backend(sentence, backend);
    const auto [place, added] = places.try_emplace({effect, text_at(line, "/parameter"), before, after}, answers.size());
    if (added) answers.push_back({effect, before, after, {}});
    std::vector<std::string>& backends = answers[place->second].backends;
    if (before != sentence && std::ranges::find(backends, backend) == backends.end()) backends.push_back(backend);
  }
  const bool several = has_several_effects(record);
  std::vector<Headline> all;
  for (const auto& [effect, before, after, backends] : answers)
    all.push_back({.variant = several ? effect : "",
                   .words = backends.empty() ? before : fmt::format("{} on {}{}", before, joined_names(backends), after)});
  return all;
}

std::vector<std::string> sweep_lines(const Record& record) {
  std::vector<std::string> lines;
  for (const Json& sweep : record.sweeps)
    for (const Json& parameter : sweep.at("parameters")) {
      const Json& values = parameter.at("values");
      std::string words = text_at(parameter, "/path");
      if (!values.empty())
        words += fmt::format(" from {} to {}{}{} in {} values", values.front().dump(), values.back().dump(),
                             text_at(parameter, "/unit").empty() ? "" : " ", text_at(parameter, "/unit"), values.size());
      lines.push_back(words);
    }
  return lines;
}

}  // namespace lamina
