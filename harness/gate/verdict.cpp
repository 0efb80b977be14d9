// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/verdict.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "harness/record/record.h"

namespace lamina {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 8> names = {"same",      "faster", "better", "not_compared",
                                                   "ambiguous", "slower", "worse",  "failed"};

// A PSNR of equal pictures is infinite, which JSON has no number for.
Json number(const std::optional<double>& value) { return value && std::isfinite(*value) ? Json(*value) : Json(nullptr); }

}  // namespace

std::string_view name_of(Verdict verdict) { return names[static_cast<size_t>(verdict)]; }

Json to_json(const VerdictRow& row) {
  return {{"kind", "verdict"},
          {"backend", row.backend},
          {"effect", row.effect},
          {"variant", row.variant},
          {"view", row.view},
          {"what", row.what},
          {"pass", row.pass},
          {"texture", row.texture},
          {"verdict", name_of(row.verdict)},
          {"before", number(row.before)},
          {"after", number(row.after)},
          {"ratio", interval_to_json(row.ratio, row.variant, "ratio")},
          {"limit", number(row.limit)},
          {"sentence", row.sentence}};
}

Json to_json(const SameArmRow& row) {
  return {{"kind", "aa"},
          {"backend", row.backend},
          {"effect", row.effect},
          {"variant", row.variant},
          {"ratio", interval_to_json(row.ratio, row.variant, "ratio")},
          {"verdict", name_of(row.verdict)}};
}

Json to_json(const GateRow& row) {
  return {{"kind", "gate"},
          {"mode", row.mode},
          {"against", row.against},
          {"verdict", name_of(row.verdict)},
          {"status", row.status},
          {"processes", row.processes},
          {"rounds", row.rounds},
          {"wall_s", row.wall_s},
          {"margin", row.margin},
          {"confidence", row.confidence},
          {"comparisons", row.comparisons}};
}

GateOutcome outcome_of(std::span<const VerdictRow> rows) {
  const auto any = [&](auto... verdicts) {
    return std::any_of(rows.begin(), rows.end(), [&](const VerdictRow& row) { return ((row.verdict == verdicts) || ...); });
  };
  if (any(Verdict::failed, Verdict::worse, Verdict::slower)) return {Verdict::failed, 1};
  if (any(Verdict::ambiguous) || !any(Verdict::same, Verdict::faster, Verdict::better)) return {Verdict::ambiguous, 3};
  return {any(Verdict::faster) ? Verdict::faster : Verdict::same, 0};
}

}  // namespace lamina
