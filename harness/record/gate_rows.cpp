// SPDX-License-Identifier: Apache-2.0
#include "harness/record/gate_rows.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "harness/record/fields.h"

namespace lamina {
namespace {

using namespace lines;

constexpr std::array<std::string_view, 9> verdict_names = {"same",      "faster", "better", "not_compared", "time_open",
                                                           "ambiguous", "slower", "worse",  "failed"};
constexpr auto cause_names = std::to_array<std::string_view>({"figures",
                                                              "against_record",
                                                              "as_before",
                                                              "same_code",
                                                              "same_code_new_errors",
                                                              "new_variant",
                                                              "new_view",
                                                              "failed_before",
                                                              "gone",
                                                              "cannot_be_measured",
                                                              "cannot_be_run",
                                                              "not_measured",
                                                              "process_failed",
                                                              "api_message",
                                                              "certificate_holds",
                                                              "certificate_failed",
                                                              "error_lost",
                                                              "beyond_bound",
                                                              "not_counted",
                                                              "counted_once",
                                                              "not_finite",
                                                              "covers_nothing",
                                                              "covers_nothing_anywhere",
                                                              "one_colour",
                                                              "another_hash",
                                                              "baseline_changed",
                                                              "changed_for_nothing",
                                                              "one_picture",
                                                              "too_few_samples",
                                                              "ratio_of_zero",
                                                              "timed_once",
                                                              "another_machine",
                                                              "exact_failed",
                                                              "out_of_time",
                                                              "stopped",
                                                              "arm_differs"});
static_assert(cause_names.size() == static_cast<size_t>(Cause::arm_differs) + 1);
constexpr std::array verdicts_on_times = {Verdict::same, Verdict::faster, Verdict::slower, Verdict::ambiguous};
constexpr std::array verdicts_of_gates = {Verdict::same, Verdict::faster, Verdict::slower, Verdict::ambiguous, Verdict::failed};
constexpr std::array verdicts_on_figures = {Verdict::same,   Verdict::faster,       Verdict::slower,
                                            Verdict::better, Verdict::worse,        Verdict::ambiguous,
                                            Verdict::failed, Verdict::not_compared, Verdict::time_open};

[[noreturn]] void refuse_word(const At& at, const std::string& word, const std::vector<std::string_view>& known) {
  refuse(at, fmt::format("the field '{}' is '{}', which is none of {}", at.path(), word, fmt::join(known, ", ")));
}

template <const auto& known>
struct OneOf : Kind<std::string> {
  static Line schema() {
    Line names = Line::array();
    for (const Verdict verdict : known) names.push_back(name_of(verdict));
    return {{"enum", names}};
  }
  static Line write(Verdict verdict, const At&) { return name_of(verdict); }
  static Verdict read(const Json& value, const At& at) {
    std::vector<std::string_view> names;
    for (const Verdict verdict : known) {
      if (value == name_of(verdict)) return verdict;
      names.push_back(name_of(verdict));
    }
    refuse_word(at, value, names);
  }
};

struct ExitStatus : Kind<int> {
  static std::string words() { return "an exit status from 0 to 4"; }
  static bool fits(const Json& value) { return value.is_number_unsigned() && value.get<uint64_t>() <= 4; }
  static Line schema() { return {{"type", "integer"}, {"minimum", 0}, {"maximum", 4}}; }
};

struct FiniteOrNull : Kind<std::optional<double>> {
  static Line write(const std::optional<double>& value, const At&) {
    return value && std::isfinite(*value) ? Line(*value) : Line(nullptr);
  }
};

}  // namespace

template <>
struct lines::Kind<Cause> {
  static std::string words() { return "a string"; }
  static bool fits(const Json& value) { return value.is_string(); }
  static Line schema() { return {{"enum", cause_names}}; }
  static Line write(Cause cause, const At&) { return cause_names[static_cast<size_t>(cause)]; }
  static Cause read(const Json& value, const At& at) {
    const auto found = std::ranges::find(cause_names, value.get<std::string>());
    if (found == cause_names.end()) refuse_word(at, value, {cause_names.begin(), cause_names.end()});
    return static_cast<Cause>(found - cause_names.begin());
  }
};

constexpr auto fields(const OperationChange*) {
  using Row = OperationChange;
  return std::tuple(field("operation", &Row::operation), field("before", &Row::before), field("after", &Row::after));
}

// [before, after, whether after came first], ms.
template <>
struct lines::Kind<StripPair> {
  static std::string words() { return "a pair of times and their order"; }
  static bool fits(const Json& value) { return Kind<std::vector<double>>::fits(value) && value.size() == 3; }
  static Line schema() { return {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 3}, {"maxItems", 3}}; }
  static Line write(const StripPair& pair, const At&) {
    const auto rounded = [](double ms) { return std::round(ms * 1e6) / 1e6; };  // to the nanosecond
    return {rounded(pair.before), rounded(pair.after), pair.after_first ? 1 : 0};
  }
  static StripPair read(const Json& value, const At&) { return {value[0], value[1], value[2] == 1}; }
};

constexpr auto fields(const VerdictRow*) {
  using Row = VerdictRow;
  return std::tuple(field("backend", &Row::backend), field("effect", &Row::effect), field("variant", &Row::variant),
                    field("view", &Row::view), field("what", &Row::what), field("pass", &Row::pass),
                    field("texture", &Row::texture), field<OneOf<verdicts_on_figures>>("verdict", &Row::verdict),
                    field<FiniteOrNull>("before", &Row::before), field<FiniteOrNull>("after", &Row::after),
                    field("ratio", &Row::ratio), field<FiniteOrNull>("limit", &Row::limit),
                    lines::left_out("cause", &Row::cause), lines::left_out("details", &Row::details),
                    lines::left_out("operations", &Row::operations), lines::left_out("counts_hold", &Row::counts_hold),
                    field("sentence", &Row::sentence));
}

constexpr auto fields(const SameArmRow*) {
  using Row = SameArmRow;
  return std::tuple(field("backend", &Row::backend), field("effect", &Row::effect), field("variant", &Row::variant),
                    field("ratio", &Row::ratio), field<OneOf<verdicts_on_times>>("verdict", &Row::verdict));
}

constexpr auto fields(const GateRow*) {
  using Row = GateRow;
  return std::tuple(field("mode", &Row::mode), field("against", &Row::against),
                    field<OneOf<verdicts_of_gates>>("verdict", &Row::verdict), field<ExitStatus>("status", &Row::status),
                    field("processes", &Row::processes), field("rounds", &Row::rounds), field("wall_s", &Row::wall_s),
                    field("margin", &Row::margin), field("confidence", &Row::confidence),
                    field("comparisons", &Row::comparisons));
}

void check(const GateRow& row, const At& at) {
  if (row.mode != "against" && row.mode != "baseline") refuse_word(at.in("mode"), row.mode, {"against", "baseline"});
}

constexpr auto fields(const PairedPass*) {
  using Row = PairedPass;
  return std::tuple(field("name", &Row::name), field("cut", &Row::cut), field("same", &Row::same), field("ms", &Row::ms),
                    field("strips", &Row::strips));
}

constexpr auto fields(const PairsRow*) {
  using Row = PairsRow;
  return std::tuple(field("process", &Row::process), field("backend", &Row::backend), field("effect", &Row::effect),
                    field("variant", &Row::variant), field("view", &Row::view), field("frames", &Row::frames),
                    field("passes", &Row::passes));
}

void check(const PairsRow& row, const At& at) {
  for (const PairedPass& pass : row.passes) {
    const std::pair<const char*, size_t> sizes[] = {
        {"same", pass.same.size()}, {"ms", pass.ms.size()}, {"strips", pass.strips.size()}};
    for (const auto& [name, size] : sizes)
      if (size != row.frames.size())
        refuse(at, fmt::format("pass '{}' has '{}' of {} frames, the line names {}", pass.name, name, size, row.frames.size()));
  }
}

std::string_view name_of(Verdict verdict) { return verdict_names[static_cast<size_t>(verdict)]; }

Line to_json(const VerdictRow& row) { return line_of("verdict", row, row.variant); }
Line to_json(const SameArmRow& row) { return line_of("aa", row, row.variant); }
Line to_json(const GateRow& row) { return line_of("gate", row, "gate"); }
Line to_json(const PairsRow& row) { return line_of("pairs", row, row.variant); }

template VerdictRow row_of(const Json& line, const std::string& where);
template nlohmann::ordered_json schema_of<VerdictRow>();
template SameArmRow row_of(const Json& line, const std::string& where);
template nlohmann::ordered_json schema_of<SameArmRow>();
template GateRow row_of(const Json& line, const std::string& where);
template nlohmann::ordered_json schema_of<GateRow>();
template PairsRow row_of(const Json& line, const std::string& where);
template nlohmann::ordered_json schema_of<PairsRow>();

}  // namespace lamina
