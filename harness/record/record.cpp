// SPDX-License-Identifier: Apache-2.0
#include "harness/record/record.h"

#include <fmt/format.h>

namespace lamina {
namespace {

std::string words_of_value(const nlohmann::json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

}  // namespace

std::string text_at(const nlohmann::json& value, const char* pointer) {
  const nlohmann::json::json_pointer path(pointer);
  return value.contains(path) ? words_of_value(value.at(path)) : std::string();
}

std::string entries_of(const nlohmann::json& object) {
  if (!object.is_object()) return {};
  std::string words;
  for (const auto& [key, value] : object.items())
    words += fmt::format("{}{} {}", words.empty() ? "" : ", ", key, words_of_value(value));
  return words;
}

bool times_shown(const Record& record, std::string_view backend) {
  bool certified = false;
  for (const TimerRow& timer : record.timers) {
    if (timer.backend != backend) continue;
    if (!timer.ok) return false;
    certified = true;
  }
  return certified;
}

std::vector<double> shown_samples_ms(const Record& record, const CellRow& cell) {
  if (cell.failed || !cell.timed || !times_shown(record, cell.backend)) return {};
  return frame_samples_ms(cell.passes);
}

}  // namespace lamina
