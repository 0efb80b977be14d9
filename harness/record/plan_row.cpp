// SPDX-License-Identifier: Apache-2.0
#include "harness/record/plan_row.h"

#include "harness/record/fields.h"

namespace lamina {

using lines::field;
using lines::left_out;
using lines::may_lack;

constexpr auto fields(const PlanRow::Pass*) {
  return std::tuple(may_lack("pass", &PlanRow::Pass::pass), may_lack("effect", &PlanRow::Pass::effect),
                    may_lack("runs", &PlanRow::Pass::runs), may_lack("once", &PlanRow::Pass::once),
                    may_lack("reason", &PlanRow::Pass::reason), may_lack("objects", &PlanRow::Pass::objects),
                    may_lack("reads", &PlanRow::Pass::reads), may_lack("writes", &PlanRow::Pass::writes));
}

constexpr auto fields(const PlanRow::Variant*) {
  return std::tuple(may_lack("variant", &PlanRow::Variant::variant), may_lack("baseline", &PlanRow::Variant::baseline),
                    left_out("passes", &PlanRow::Variant::passes), left_out("error", &PlanRow::Variant::error));
}

constexpr auto fields(const PlanRow::Feature*) {
  return std::tuple(may_lack("feature", &PlanRow::Feature::feature), may_lack("on", &PlanRow::Feature::on),
                    may_lack("reason", &PlanRow::Feature::reason));
}

constexpr auto fields(const PlanRow::Effect*) {
  return std::tuple(field("effect", &PlanRow::Effect::effect), field("called_for", &PlanRow::Effect::called_for),
                    field("reason", &PlanRow::Effect::reason), may_lack("objects", &PlanRow::Effect::objects),
                    may_lack("features", &PlanRow::Effect::features), may_lack("variants", &PlanRow::Effect::variants));
}

constexpr auto fields(const PlanRow*) { return std::tuple(field("effects", &PlanRow::effects)); }

lines::Line to_json(const PlanRow& row) { return lines::line_of("plan", row, "plan"); }

template PlanRow row_of(const lines::Json& line, const std::string& where);

}  // namespace lamina
