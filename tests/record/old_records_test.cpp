// SPDX-License-Identifier: Apache-2.0
// Records that earlier versions wrote, as they wrote them, are read; CHANGELOG.md promises it of every version with this
// schema.
#include <gtest/gtest.h>

#include "harness/record/record.h"

namespace lamina {
namespace {

Record old_record(const char* name) {
  return read_record(std::filesystem::path(LAMINA_SOURCE_DIR) / "tests/data/records" / name);
}

TEST(OldRecords, OfCompare) {
  const Record record = old_record("compare_0.1.0.jsonl");
  EXPECT_EQ(record.cells.size(), 9u);
  EXPECT_EQ(record.timers.size(), 2u);
  EXPECT_TRUE(times_shown(record, "vulkan"));
  for (const CellRow& cell : record.cells) EXPECT_FALSE(cell.failed) << cell.reason;
}

TEST(OldRecords, OfStress) {
  const Record record = old_record("stress_0.1.0.jsonl");
  EXPECT_EQ(record.functions.size(), 25u);
  EXPECT_EQ(record.function_times.size(), 5u);
}

TEST(OldRecords, OfSweepAndGate) {
  const Record sweep = old_record("sweep_0.1.0.jsonl");
  ASSERT_EQ(sweep.sweeps.size(), 1u);
  EXPECT_EQ(sweep.cells.size(), 3u);
  const Record gate = old_record("gate_0.1.0.jsonl");
  ASSERT_EQ(gate.gates.size(), 1u);
  EXPECT_EQ(gate.verdicts.size(), 8u);
}

// What asked and what ran is of records since 1.0.0; the line before them had devices alone.
TEST(OldRecords, RunLine) {
  nlohmann::json line = {{"kind", "run"}, {"schema", unsigned{record_schema}}, {"devices", {{{"backend", "vulkan"}}}}};
  const RunRow row = row_of<RunRow>(line, "here");
  EXPECT_TRUE(row.backends.empty());
  EXPECT_EQ(row.devices.at(0).timestamp_bits, 0u);
  line["backends"] = {{{"asked", "egl"}, {"ran", false}, {"reason", "no device"}}};
  EXPECT_EQ(row_of<RunRow>(line, "here").backends.at(0).asked, "egl");
  line["backends"] = {{{"asked", "egl"}}};
  EXPECT_THROW(row_of<RunRow>(line, "here"), Error);
}

}  // namespace
}  // namespace lamina
