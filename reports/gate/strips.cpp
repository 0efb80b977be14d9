// SPDX-License-Identifier: Apache-2.0
#include "reports/gate/strips.h"

#include <fmt/format.h>

#include "harness/core/error.h"

namespace lamina {
namespace {

using Json = nlohmann::json;

bool is_on(const Json& verdict, const GateStrips& strips) {
  return verdict.at("what") == "time" && verdict.at("effect") == strips.effect && verdict.at("variant") == strips.variant &&
         verdict.at("backend") == strips.backend && verdict.at("view") == strips.view && verdict.at("pass") == strips.pass;
}

GateStrips& comparison_of(std::vector<GateStrips>& all, const Json& pairs, const std::string& pass, bool same_arm) {
  for (GateStrips& known : all)
    if (known.effect == pairs.at("effect") && known.variant == pairs.at("variant") && known.backend == pairs.at("backend") &&
        known.view == pairs.at("view") && known.pass == pass && known.same_arm == same_arm)
      return known;
  return all.emplace_back(
      GateStrips{pairs.at("effect"), pairs.at("variant"), pairs.at("backend"), pairs.at("view"), pass, same_arm, nullptr, {}});
}

}  // namespace

std::vector<GateStrips> gate_strips(const Record& record) {
  std::vector<GateStrips> all;
  for (const Json& pairs : record.pairs)
    for (const Json& pass : pairs.at("passes"))
      for (size_t frame = 1; frame < pairs.at("frames").size(); ++frame) {
        GateStrips::Process process{pairs.at("process"), {}, {}};
        for (const Json& strip : pass.at("strips").at(frame)) process.strips.push_back({strip[0], strip[1], strip[2] == 1});
        try {
          process.estimate = estimate_ratio(process.strips);
        } catch (const Error&) {
          continue;
        }
        comparison_of(all, pairs, pass.at("name"), pairs.at("frames")[frame] == "again")
            .processes.push_back(std::move(process));
      }
  for (GateStrips& strips : all)
    for (const Json& verdict : record.verdicts)
      if (!strips.same_arm && is_on(verdict, strips)) strips.verdict = &verdict;
  return all;
}

std::string words_for_comparison(const GateStrips& strips) {
  return fmt::format("{}{} on {}, view {}, pass {}", strips.same_arm ? "A/A " : "", strips.variant, strips.backend, strips.view,
                     strips.pass);
}

}  // namespace lamina
