// SPDX-License-Identifier: Apache-2.0
// The record of a run: one JSON object a line, appended and flushed as each is known, so that a run that dies leaves all it had
// measured. Each kind of line is a row: its struct names the fields once, for writing, checking and reading. Field names are
// fixed by tests/record; schema 1.
#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "harness/record/cell_rows.h"
#include "harness/record/function_rows.h"
#include "harness/record/gate_rows.h"
#include "harness/record/plan_row.h"
#include "harness/record/row_of.h"
#include "harness/record/run_row.h"
#include "harness/record/saving_row.h"
#include "harness/record/sweep_rows.h"
#include "harness/record/timer_row.h"

namespace lamina {

// Opens a record, afresh or to go on behind its last line, and appends lines; its folder must exist. Throws Error(bad_input)
// where the folder cannot be written.
class RecordWriter {
 public:
  explicit RecordWriter(const std::filesystem::path& file, bool go_on = false);
  // Appends one line and flushes it. Throws Error(failed) when the disk is full, and at every call after that, so that a line
  // cut short is the last one. Bytes that are not UTF-8 become U+FFFD.
  void append(const nlohmann::ordered_json& line);

 private:
  std::filesystem::path file_;
  std::ofstream stream_;
};

// A record as read back: what reports are made of.
struct Record {
  nlohmann::json run;  // its settings are each command's own
  std::vector<PlanRow> plans;
  std::vector<TimerRow> timers;
  std::vector<CellRow> cells;
  std::vector<BakeRow> bakes;
  std::vector<PhaseRow> phases;
  std::vector<SavingRow> savings;
  std::vector<FunctionRow> functions;
  std::vector<FunctionTimeRow> function_times;
  std::vector<FunctionTimerRow> function_timers;
  std::vector<FunctionPictureRow> function_pictures;
  std::vector<PairsRow> pairs;
  std::vector<GateRow> gates;
  std::vector<SameArmRow> aas;
  std::vector<VerdictRow> verdicts;
  std::vector<SweepRow> sweeps;  // at most one
  std::vector<CrossoverRow> crossovers;
};
// Throws Error(bad_input, "record", "FILE:LINE", ...) for a line that is not JSON, another schema, no first line of kind "run",
// an unknown kind, or a field missing or of the wrong type. A last line cut short by a crash (it has no newline) is dropped,
// and said so in `run["truncated"]`, a sentence. `all_lines` gets all lines as they are, the run line first, for what copies
// them.
Record read_record(const std::filesystem::path& file, std::vector<nlohmann::json>* all_lines = nullptr);

// The JSON Schema of a line of a record, made of the rows' fields.
nlohmann::ordered_json record_line_schema();

// The value at a JSON pointer as text ("/machine/cpu"); "" where there is none. For the run line.
std::string text_at(const nlohmann::json& value, const char* pointer);
// An object's entries as "key value, key value"; "" for anything else.
std::string entries_of(const nlohmann::json& object);

// Whether the backend has a timer certificate and every one of it is good. Where not, no report shows its times.
bool times_shown(const Record& record, std::string_view backend);
// A cell's frame time of each round, or nothing where it failed or its backend's times are not shown.
std::vector<double> shown_samples_ms(const Record& record, const CellRow& cell);

}  // namespace lamina
