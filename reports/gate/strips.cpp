// SPDX-License-Identifier: Apache-2.0
#include "reports/gate/strips.h"

#include <fmt/format.h>

#include "harness/core/error.h"

namespace lamina {
namespace {

bool is_on(const VerdictRow& row, const GateStrips& strips) {
  return row.what == "time" && row.effect == strips.effect && row.variant == strips.variant && row.backend == strips.backend &&
         row.view == strips.view && row.pass == strips.pass;
}

GateStrips& comparison_of(std::vector<GateStrips>& all, const PairsRow& pairs, const std::string& pass, bool same_arm) {
  for (GateStrips& known : all)
    if (known.effect == pairs.effect && known.variant == pairs.variant && known.backend == pairs.backend &&
        known.view == pairs.view && known.pass == pass && known.same_arm == same_arm)
      return known;
  return all.emplace_back(GateStrips{pairs.effect, pairs.variant, pairs.backend, pairs.view, pass, same_arm, nullptr, {}});
}

}  // namespace

std::vector<GateStrips> gate_strips(const Record& record) {
  std::vector<GateStrips> all;
  for (const PairsRow& pairs : record.pairs)
    for (const PairedPass& pass : pairs.passes)
      for (size_t frame = 1; frame < pairs.frames.size(); ++frame) {
        GateStrips::Process process{pairs.process, {}, pass.strips[frame]};
        try {
          process.estimate = estimate_ratio(process.strips);
        } catch (const Error&) {
          continue;
        }
        comparison_of(all, pairs, pass.name, pairs.frames[frame] == frame_again).processes.push_back(std::move(process));
      }
  for (GateStrips& strips : all)
    for (const VerdictRow& row : record.verdicts)
      if (!strips.same_arm && is_on(row, strips)) strips.verdict = &row;
  return all;
}

std::string words_for_comparison(const GateStrips& strips) {
  return fmt::format("{}{} on {}, view {}, pass {}", strips.same_arm ? "A/A " : "", strips.variant, strips.backend, strips.view,
                     strips.pass);
}

}  // namespace lamina
