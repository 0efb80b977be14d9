// SPDX-License-Identifier: Apache-2.0
#include "harness/record/run_row.h"

#include "harness/core/error.h"
#include "harness/record/fields.h"

namespace lamina {
namespace {

using lines::Json;
using lines::Line;
using lines::may_lack;
using lines::refuse;

bool is_moment(const Json& value) {
  if (!value.is_string()) return false;
  constexpr std::string_view pattern = "dddd-dd-ddTdd:dd:ddZ";
  const auto& words = value.get_ref<const std::string&>();
  if (words.size() != pattern.size()) return false;
  for (size_t i = 0; i < words.size(); ++i)
    if (pattern[i] == 'd' ? words[i] < '0' || words[i] > '9' : words[i] != pattern[i]) return false;
  return true;
}

// UTC, in the order of its characters.
struct Moment : lines::Kind<std::string> {
  static std::string words() { return "a moment in UTC like \"2026-01-31T23:59:59Z\""; }
  static bool fits(const Json& value) { return is_moment(value); }
  static Line schema() { return {{"type", "string"}, {"pattern", "^[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}Z$"}}; }
};
struct MomentOrNull : lines::Kind<std::optional<std::string>> {
  static std::string words() { return Moment::words() + " or null"; }
  static bool fits(const Json& value) { return value.is_null() || is_moment(value); }
  static Line schema() { return lines::or_null(Moment::schema()); }
};

struct ThisSchema : lines::Kind<int> {
  static Line schema() { return {{"const", record_schema}}; }
  static int read(const Json& value, const lines::At& at) {
    if (value != record_schema)
      refuse({at.subject}, fmt::format("the record's schema is {}, this program reads schema {}; use the program that wrote it",
                                       value.dump(), record_schema));
    return record_schema;
  }
};

}  // namespace

constexpr auto fields(const BackendRow*) {
  using Row = BackendRow;
  return std::tuple(lines::field("asked", &Row::asked), lines::field("ran", &Row::ran), may_lack("device", &Row::device),
                    may_lack("reason", &Row::reason));
}

constexpr auto fields(const DeviceInfo*) {
  using Row = DeviceInfo;
  return std::tuple(lines::field("backend", &Row::backend), may_lack("device", &Row::device), may_lack("driver", &Row::driver),
                    may_lack("api_version", &Row::api_version), may_lack("software", &Row::software),
                    may_lack("max_texture_size", &Row::max_texture_size), may_lack("vertex_storage", &Row::vertex_storage),
                    may_lack("fragment_storage", &Row::fragment_storage), may_lack("half_floats", &Row::half_floats),
                    may_lack("doubles", &Row::doubles), may_lack("exact_sample_counts", &Row::exact_sample_counts),
                    may_lack("issued_fragment_counts", &Row::issued_fragment_counts),
                    may_lack("timestamp_bits", &Row::timestamp_bits));
}

constexpr auto fields(const RunRow::Machine*) {
  using Row = RunRow::Machine;
  return std::tuple(may_lack("cpu", &Row::cpu), may_lack("threads", &Row::threads),
                    may_lack("lp_num_threads", &Row::lp_num_threads));
}

constexpr auto fields(const RunRow*) {
  using Row = RunRow;
  return std::tuple(lines::field<ThisSchema>("schema", &Row::schema), may_lack("lamina", &Row::lamina),
                    may_lack("commit", &Row::commit), may_lack<MomentOrNull>("commit_date", &Row::commit_date),
                    may_lack<Moment>("date", &Row::date), may_lack("build", &Row::build), may_lack("command", &Row::command),
                    may_lack("machine", &Row::machine), may_lack("backends", &Row::backends),
                    may_lack("devices", &Row::devices));
}

Line to_json(const RunRow& row) { return lines::line_of("run", row, "run"); }
Line to_json(const DeviceInfo& device) { return lines::Kind<DeviceInfo>::write(device, {device.device}); }

template RunRow row_of(const Json& line, const std::string& where);
template DeviceInfo row_of(const Json& line, const std::string& where);
template nlohmann::ordered_json schema_of<RunRow>();

}  // namespace lamina
