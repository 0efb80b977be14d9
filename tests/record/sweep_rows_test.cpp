// SPDX-License-Identifier: Apache-2.0
// Lines of a sweep: written, read back, and refused where a field is missing or of another type.
#include "harness/record/sweep_rows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "harness/core/error.h"
#include "harness/record/record.h"
#include "tests/folder.h"

namespace lamina {
namespace {

using Json = nlohmann::ordered_json;

Json sweep_line() {
  SweepRow row;
  row.parameters = {{"objects.heart.thickness", "texels", {0, 1, 2.5}}};
  row.points = 3, row.shard_index = 1, row.shard_count = 4;
  row.limits = {{"ssim", 0.98}, {"flip", 0.05}};
  return to_json(row);
}

Json crossover_line() {
  CrossoverRow row{
      "objects.heart.thickness", "vulkan", "layered_material", "vertex_normal", "", "ssim", 0.98, 6.2, 0.1, "so it is"};
  return to_json(row);
}

class SweepRows : public InFolder<> {
 protected:
  Record read(const Json& line) {
    std::ofstream(file_) << R"({"kind":"run","schema":1})" << '\n' << line.dump() << '\n';
    return read_record(file_);
  }
  const std::filesystem::path file_ = folder_ / "record.jsonl";
};

TEST_F(SweepRows, FieldNamesAreFixed) {
  EXPECT_EQ(
      sweep_line().dump(),
      R"({"kind":"sweep","parameters":[{"path":"objects.heart.thickness","unit":"texels","values":[0.0,1.0,2.5]}],"zip":false,)"
      R"("points":3,"shard":{"index":1,"count":4},"limits":[{"metric":"ssim","limit":0.98},{"metric":"flip","limit":0.05}]})");
  EXPECT_EQ(
      crossover_line().dump(),
      R"({"kind":"crossover","parameter":"objects.heart.thickness","backend":"vulkan","effect":"layered_material",)"
      R"("variant":"vertex_normal","other":"","metric":"ssim","limit":0.98,"at":6.2,"tolerance":0.1,"sentence":"so it is"})");
}

TEST_F(SweepRows, WhatIsWrittenIsReadBack) {
  EXPECT_EQ(to_json(read(sweep_line()).sweeps.at(0)), sweep_line());
  EXPECT_EQ(to_json(read(crossover_line()).crossovers.at(0)), crossover_line());
  CrossoverRow none;
  EXPECT_TRUE(to_json(none).at("at").is_null());
  EXPECT_TRUE(to_json(none).at("limit").is_null());
}

TEST_F(SweepRows, AMissingOrMistypedFieldIsRefused) {
  for (const Json& line : {sweep_line(), crossover_line()})
    for (const auto& [name, value] : line.items()) {
      if (name == "kind") continue;
      Json without = line, mistyped = line;
      without.erase(name);
      mistyped[name] = Json::object({{"no", "such"}});
      EXPECT_THROW(read(without), Error) << name;
      EXPECT_THROW(read(mistyped), Error) << name;
    }
}

TEST_F(SweepRows, ANumberThatIsNoneIsRefused) {
  CrossoverRow row;
  row.at = std::nan("");
  EXPECT_THROW(to_json(row), Error);
  SweepRow sweep;
  sweep.parameters = {{"a", "", {std::nan("")}}};
  EXPECT_THROW(to_json(sweep), Error);
}

}  // namespace
}  // namespace lamina
