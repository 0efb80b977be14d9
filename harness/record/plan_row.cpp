// SPDX-License-Identifier: Apache-2.0
#include "harness/record/plan_row.h"

#include "harness/record/fields.h"

namespace lamina {

using lines::field;
using lines::left_out;
using lines::may_lack;

constexpr auto fields(const PlanRow::Pass*) {
  using Row = PlanRow::Pass;
  return std::tuple(may_lack("pass", &Row::pass), may_lack("effect", &Row::effect), may_lack("runs", &Row::runs),
                    may_lack("once", &Row::once), may_lack("reason", &Row::reason), may_lack("objects", &Row::objects),
                    may_lack("reads", &Row::reads), may_lack("writes", &Row::writes), left_out("variant", &Row::variant));
}

constexpr auto fields(const PlanRow::Variant*) {
  using Row = PlanRow::Variant;
  return std::tuple(may_lack("variant", &Row::variant), may_lack("baseline", &Row::baseline), left_out("passes", &Row::passes),
                    left_out("error", &Row::error));
}

constexpr auto fields(const PlanRow::Feature*) {
  using Row = PlanRow::Feature;
  return std::tuple(may_lack("feature", &Row::feature), may_lack("on", &Row::on), may_lack("reason", &Row::reason));
}

constexpr auto fields(const PlanRow::Effect*) {
  using Row = PlanRow::Effect;
  return std::tuple(field("effect", &Row::effect), field("called_for", &Row::called_for), field("reason", &Row::reason),
                    may_lack("objects", &Row::objects), may_lack("features", &Row::features),
                    may_lack("variants", &Row::variants));
}

constexpr auto fields(const PlanRow::Target*) {
  using Row = PlanRow::Target;
  return std::tuple(field("target", &Row::target), left_out("effect", &Row::effect), left_out("variant", &Row::variant),
                    field("shared", &Row::shared), field("copies", &Row::copies), field("writers", &Row::writers),
                    field("readers", &Row::readers), field("bytes", &Row::bytes));
}

constexpr auto fields(const PlanRow::Frame*) {
  using Row = PlanRow::Frame;
  return std::tuple(field("width", &Row::width), field("height", &Row::height), field("passes", &Row::passes),
                    field("left_out", &Row::left_out), field("targets", &Row::targets),
                    left_out("aliased_bytes", &Row::aliased_bytes), left_out("reused_bytes", &Row::reused_bytes));
}

constexpr auto fields(const PlanRow*) {
  return std::tuple(field("effects", &PlanRow::effects), left_out("frame", &PlanRow::frame),
                    left_out("frame_error", &PlanRow::frame_error));
}

// A reader of the record goes from targets to passes by these places.
void check(const PlanRow::Frame& frame, const lines::At& at) {
  for (const PlanRow::Target& target : frame.targets)
    for (const auto* places : {&target.writers, &target.readers})
      for (const uint64_t place : *places)
        if (place >= frame.passes.size())
          lines::refuse(at, fmt::format("the target '{}' names pass {} of {}", target.target, place, frame.passes.size()));
}

lines::Line to_json(const PlanRow& row) { return lines::line_of("plan", row, "plan"); }

template PlanRow row_of(const lines::Json& line, const std::string& where);
template nlohmann::ordered_json schema_of<PlanRow>();

}  // namespace lamina
