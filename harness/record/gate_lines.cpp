// SPDX-License-Identifier: Apache-2.0
#include "harness/record/gate_lines.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "harness/record/line_checks.h"

namespace lamina {
namespace {

using Json = nlohmann::json;
using namespace line_checks;

constexpr std::array<std::string_view, 2> modes = {"against", "baseline"};
constexpr std::array<std::string_view, 4> time_verdicts = {"same", "faster", "slower", "ambiguous"};
constexpr std::array<std::string_view, 5> gate_verdicts = {"same", "faster", "slower", "ambiguous", "failed"};
constexpr std::array<std::string_view, 8> figure_verdicts = {"same",  "faster",    "slower", "better",
                                                             "worse", "ambiguous", "failed", "not_compared"};

void check_word(const Json& line, const char* field, const auto& known, const std::string& where) {
  const std::string word = line[field];
  if (std::ranges::find(known, word) == known.end())
    refuse(where, fmt::format("the field '{}' is '{}', which is none of {}", field, word, fmt::join(known, ", ")));
}

constexpr Type exit_status = {[](const Json& v) { return v.is_number_unsigned() && v.get<uint64_t>() <= 4; },
                              "an exit status from 0 to 4"};

}  // namespace

void check_gate(const Json& line, const std::string& where) {
  check(line,
        {{"mode", text},
         {"against", text},
         {"verdict", text},
         {"status", exit_status},
         {"processes", count},
         {"rounds", count},
         {"wall_s", number},
         {"margin", number},
         {"confidence", number},
         {"comparisons", count}},
        where);
  check_word(line, "mode", modes, where);
  check_word(line, "verdict", gate_verdicts, where);
}

void check_aa(const Json& line, const std::string& where) {
  check(line, {{"backend", text}, {"effect", text}, {"variant", text}, {"ratio", object}, {"verdict", text}}, where);
  check_interval(line["ratio"], where, "ratio.");
  check_word(line, "verdict", time_verdicts, where);
}

void check_verdict(const Json& line, const std::string& where) {
  check(line,
        {{"backend", text},
         {"effect", text},
         {"variant", text},
         {"view", text},
         {"what", text},
         {"pass", text},
         {"texture", text},
         {"verdict", text},
         {"before", number_or_null},
         {"after", number_or_null},
         {"ratio", object_or_null},
         {"limit", number_or_null},
         {"sentence", text}},
        where);
  check_interval(line["ratio"], where, "ratio.");
  check_word(line, "verdict", figure_verdicts, where);
}

void check_pairs(const Json& line, const std::string& where) {
  check(line,
        {{"process", count},
         {"backend", text},
         {"effect", text},
         {"variant", text},
         {"view", text},
         {"frames", texts},
         {"passes", array}},
        where);
  for (const Json& pass : line["passes"]) {
    check(pass, {{"name", text}, {"cut", boolean}, {"same", booleans}, {"ms", array}, {"strips", array}}, where, "passes.");
    for (const char* field : {"same", "ms", "strips"}) {
      if (pass[field].size() != line["frames"].size())
        refuse(where, fmt::format("pass '{}' has '{}' of {} frames, the line names {}", pass["name"].get<std::string>(), field,
                                  pass[field].size(), line["frames"].size()));
    }
    for (const Json& samples : pass["ms"])
      if (!numbers.fits(samples)) refuse(where, fmt::format("the field 'passes.ms' holds what is not {}", numbers.words));
    for (const Json& pairs : pass["strips"])
      for (const Json& pair : pairs)
        if (!numbers.fits(pair) || pair.size() != 3)
          refuse(where, "the field 'passes.strips' holds what is not a pair of times and their order");
  }
}

}  // namespace lamina
