// SPDX-License-Identifier: Apache-2.0
// The graph of a plan made by hand, as text, and as Graphviz reads it where it is installed.
#include "harness/record/plan_dot.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/folder.h"
#include "tests/record/read_back.h"

namespace lamina {
namespace {

PlanRow two_passes() {
  PlanRow plan;
  plan.effects = {{.effect = "mist", .called_for = true, .reason = "a hull"},
                  {.effect = "water", .reason = "no object is \"water\"\nor \\ seen"}};
  PlanRow::Frame frame;
  frame.width = 8, frame.height = 4;
  frame.passes = {{.pass = "sum", .effect = "mist", .once = true, .reason = "once for the scene", .reads = {"noise"}},
                  {.pass = "show", .effect = "mist", .reason = "every frame", .reads = {"thickness"}}};
  for (PlanRow::Pass& pass : frame.passes) pass.variant = "full";
  frame.left_out = {{.pass = "blur", .effect = "mist", .runs = false, .reason = "left out: nothing reads what it writes"}};
  frame.targets = {{.target = "frame", .writers = {1}, .bytes = 256},
                   {.target = "thickness", .effect = "mist", .variant = "full", .shared = true, .writers = {0}, .readers = {1}},
                   {.target = "depth", .bytes = 128}};
  plan.frame = frame;
  return plan;
}

bool dot_has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(PlanDot, HoldsPassesInOrderTargetsOnceAndWhatIsLeftOut) {
  const std::string dot = plan_dot(two_passes(), "a \"scene\"");
  for (const char* part :
       {"digraph \"a \\\"scene\\\"\"",
        "pass_0 [label=\"1. sum\\nmist: full\\nonce for the scene\\nfrom noise\", style=\"rounded\"]",
        "pass_1 [label=\"2. show\\nmist: full\\nevery frame\"]", "pass_0 -> pass_1 [style=invis]",
        "target_1 [shape=ellipse, penwidth=2, label=\"thickness\\nshared, 0 B\"]", "pass_0 -> target_1;", "target_1 -> pass_1;",
        "pass_1 -> target_0;", "style=dashed, color=\"grey50\"",
        "label=\"water\\nnot called for: no object is \\\"water\\\" or \\\\ seen\"", "label=\"blur\\nmist: "})
    EXPECT_TRUE(dot_has(dot, part)) << part << "\n" << dot;
  EXPECT_FALSE(dot_has(dot, "depth")) << "nobody touches it";
  EXPECT_FALSE(dot_has(dot, "not called for: a hull"));
}

TEST(PlanDot, AFrameThatCannotRunIsSaid) {
  PlanRow plan = two_passes();
  plan.frame.reset();
  plan.frame_error = "the mesh is open";
  EXPECT_TRUE(dot_has(plan_dot(plan, "s"), "cannot run: the mesh is open"));
}

TEST(PlanDot, IsReadByGraphviz) {
  if (std::system("dot -V >/dev/null 2>&1") != 0) GTEST_SKIP() << "Graphviz is not installed";
  const Folder folder;
  const std::filesystem::path file = folder.write("plan.dot", plan_dot(two_passes(), "a \"scene\""));
  EXPECT_EQ(std::system(("dot -Tcanon " + file.string() + " >/dev/null").c_str()), 0);
}

TEST(PlannedFrame, ComesBackFromTheRecordAndNamesNoPassThatIsNotThere) {
  PlanRow plan = two_passes();
  EXPECT_EQ(to_json(read_back(plan)), to_json(plan));
  plan.frame->targets[1].readers = {2};
  EXPECT_THROW(read_back(plan), Error) << "there are two passes";
  EXPECT_FALSE(read_back(PlanRow{}).frame) << "a record of before";
}

}  // namespace
}  // namespace lamina
