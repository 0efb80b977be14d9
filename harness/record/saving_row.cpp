// SPDX-License-Identifier: Apache-2.0
#include "harness/record/saving_row.h"

#include <algorithm>

#include "harness/record/fields.h"

namespace lamina {

using lines::field;
using lines::left_out;

constexpr auto fields(const SavingRow::Cost*) {
  using Row = SavingRow::Cost;
  return std::tuple(left_out("ms", &Row::ms), field("fetches", &Row::fetches), field("operations", &Row::operations),
                    field("once_operations", &Row::once_operations), field("target_bytes", &Row::target_bytes));
}

constexpr auto fields(const SavingRow::Effect*) {
  using Row = SavingRow::Effect;
  return std::tuple(field("effect", &Row::effect), field("called_for", &Row::called_for), field("reason", &Row::reason),
                    left_out("cannot", &Row::cannot), field("culled", &Row::culled), field("all", &Row::all));
}

constexpr auto fields(const SavingRow*) {
  using Row = SavingRow;
  return std::tuple(field("scene", &Row::scene), field("backend", &Row::backend), field("device", &Row::device),
                    field("view", &Row::view), field("width", &Row::width), field("height", &Row::height),
                    field("effects", &Row::effects), left_out("ratio", &Row::ratio),
                    field("culled_texture_bytes", &Row::culled_texture_bytes),
                    field("all_texture_bytes", &Row::all_texture_bytes), field("culled_frame_bytes", &Row::culled_frame_bytes),
                    field("all_frame_bytes", &Row::all_frame_bytes), left_out("culled_memory_bytes", &Row::culled_memory_bytes),
                    left_out("all_memory_bytes", &Row::all_memory_bytes), field("different_pixels", &Row::different_pixels),
                    field("largest_difference", &Row::largest_difference), left_out("where", &Row::where),
                    left_out("failure", &Row::failure));
}

// Reports pair samples by round.
void check(const SavingRow& row, const lines::At& at) {
  const auto rounds = [&](const SavingRow::Cost& cost) { return cost.ms.size(); };
  size_t least = SIZE_MAX, most = 0;
  for (const SavingRow::Effect& effect : row.effects)
    for (const SavingRow::Cost* cost : {&effect.culled, &effect.all})
      if (rounds(*cost) > 0) least = std::min(least, rounds(*cost)), most = std::max(most, rounds(*cost));
  if (most > 0 && least != most) lines::refuse(at, "the effects were timed in different numbers of rounds");
}

lines::Line to_json(const SavingRow& row) { return lines::line_of("saving", row, "view " + row.view + " on " + row.backend); }

std::vector<double> saving_frame_ms(const std::vector<SavingRow::Effect>& effects, SavingRow::Cost SavingRow::Effect::*side) {
  std::vector<double> sums;
  for (const SavingRow::Effect& effect : effects) {
    const std::vector<double>& ms = (effect.*side).ms;
    if (sums.empty()) sums.assign(ms.size(), 0);
    for (size_t round = 0; round < ms.size(); ++round) sums[round] += ms[round];
  }
  return sums;
}

template SavingRow row_of(const lines::Json& line, const std::string& where);
template nlohmann::ordered_json schema_of<SavingRow>();

}  // namespace lamina
