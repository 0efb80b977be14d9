// SPDX-License-Identifier: Apache-2.0
// What was swept and where curves cross, in words: the same for the page and for Markdown.
#include <fmt/format.h>

#include "reports/words.h"

namespace lamina {

using Json = nlohmann::json;

std::vector<Headline> crossover_headlines(const Record& record) {
  std::vector<Headline> all;
  for (const Json& line : record.crossovers)
    all.push_back({.variant = text_at(line, "/effect"), .words = text_at(line, "/sentence")});
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
