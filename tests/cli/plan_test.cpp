// SPDX-License-Identifier: Apache-2.0
// lamina plan --dot and compare --against-all-effects from end to end.
#include <sstream>

#include "tests/cli/program.h"

namespace lamina {
namespace {

class PlanShown : public ProgramTest {};

// Every pass that the frame of the baselines has is a box, and an effect that is not called for is there as left out.
TEST_F(PlanShown, AsAGraphOfTheFrame) {
  const Outcome plan = lamina_program("plan leaf_pair"), dot = lamina_program("plan leaf_pair --dot");
  ASSERT_EQ(plan.status, 0) << plan.output;
  ASSERT_EQ(dot.status, 0) << dot.output;
  for (const char* part : {"the frame, 512x512:", "its targets, ", "written by "}) EXPECT_SAYS(plan.output, part);
  size_t passes = 0;
  for (size_t at = plan.output.find("the frame, 512x512:");
       (at = plan.output.find(". translucency: ", at)) != std::string::npos; ++at) {
    const size_t name = at + 16;
    EXPECT_SAYS(dot.output, ". " + plan.output.substr(name, plan.output.find(' ', name) - name));
    ++passes;
  }
  EXPECT_GE(passes, 3u);
  EXPECT_SAYS(dot.output, "digraph \"leaf_pair\"");
  EXPECT_SAYS(dot.output, "water\\nnot called for: no object is water");
  EXPECT_SAYS(dot.output, "style=dashed");
  if (std::system("dot -V >/dev/null 2>&1") != 0) GTEST_SKIP() << "Graphviz is not installed, so the graph was not read by it";
  EXPECT_EQ(std::system(("dot -Tcanon " + write("plan.dot", dot.output).string() + " >/dev/null").c_str()), 0);
}

// Alone, and where targets that are needed at different times share memory; the record and the report have both, and what the
// device gave.
TEST_F(PlanShown, WhatTargetsTake) {
  const Outcome plan = lamina_program("plan pool");
  ASSERT_EQ(plan.status, 0) << plan.output;
  EXPECT_SAYS(plan.output, "where those needed at different times share memory: ");
  const Outcome outcome =
      lamina_program("compare leaf_pair --quick --no-time --size 48x48 --cache \"\" --out " + out().string());
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  const Record written = record();
  const PlanRow::Frame& frame = written.plans.at(0).frame.value();
  uint64_t alone = 0;
  for (const PlanRow::Target& target : frame.targets) alone += target.bytes;
  EXPECT_LT(frame.aliased_bytes.value(), alone);
  EXPECT_LE(frame.aliased_bytes.value(), frame.reused_bytes.value());
  EXPECT_LE(frame.reused_bytes.value(), alone);
  for (const CellRow& cell : written.cells) {
    ASSERT_TRUE(cell.memory_bytes && cell.memory_bytes_alone && cell.target_bytes) << cell.variant;
    EXPECT_LE(*cell.memory_bytes, *cell.memory_bytes_alone);
    EXPECT_GE(*cell.memory_bytes_alone, *cell.target_bytes) << "a driver may pad them";
    if (cell.baseline) {
      EXPECT_EQ(*cell.target_bytes, alone);
    }
    if (cell.baseline && cell.backend == "osmesa") {
      EXPECT_EQ(*cell.memory_bytes, *frame.reused_bytes);
    }
  }
  std::stringstream page;
  page << std::ifstream(out() / "index.html").rdbuf();
  EXPECT_NE(page.str().find("What targets take"), std::string::npos);
}

TEST_F(PlanShown, AFrameAgainstEverything) {
  const Outcome outcome =
      lamina_program("compare leaf_pair --against-all-effects --no-time --size 48x48 --cache \"\" --out " + out().string());
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_SAYS(outcome.output, "the pictures of both frames are the same to the bit in every view");
  const Record written = record();
  ASSERT_EQ(written.savings.size(), 4u) << "two views on two backends";
  for (const SavingRow& row : written.savings) {
    uint64_t culled = 0, all = 0, ran = 0;
    for (const SavingRow::Effect& effect : row.effects) {
      culled += effect.culled.operations, all += effect.all.operations, ran += effect.cannot.empty() ? 1 : 0;
      if (!effect.called_for) {
        EXPECT_EQ(effect.culled.operations + effect.culled.fetches + effect.culled.target_bytes, 0u);
      }
      EXPECT_TRUE(effect.culled.ms.empty());
    }
    EXPECT_GT(all, culled);
    EXPECT_GT(ran, 5u);
    EXPECT_GE(row.all_texture_bytes, row.culled_texture_bytes);
    EXPECT_GE(row.all_memory_bytes.value(), row.culled_memory_bytes.value());
  }
  EXPECT_TRUE(std::filesystem::exists(out() / "index.html"));
  EXPECT_EQ(lamina_program("compare leaf_pair --against-all-effects --watch").status, 2);
}

}  // namespace
}  // namespace lamina
