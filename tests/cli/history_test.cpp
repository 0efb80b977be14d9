// SPDX-License-Identifier: Apache-2.0
// lamina history as a user runs it, over records made by hand.
#include "tests/cli/program.h"

namespace lamina {
namespace {

class HistoryCommand : public ProgramTest {
 protected:
  // A run's folder whose one cell fetches this much.
  std::string run_folder(const std::string& name, int fetches, const std::string& scene = "heart",
                         const std::string& end = "\n") {
    std::filesystem::create_directories(folder_ / name);
    write(
        name + "/record.jsonl",
        R"({"kind":"run","schema":1,"commit":"of_)" + name + R"(","build":"release"})" + "\n" + R"({"kind":"cell","scene":")" +
            scene +
            R"(","effect":"e","variant":"v","baseline":true,"backend":"vulkan","device":"d","width":8,"height":8,"view":"front",)"
            R"("params":{"scene.time":0},"status":"ok","reason":"","timed":false,"passes":[],"median_ms":null,"once_ms":null,)"
            R"("cold_ms":1,"ratio_to_baseline":null,"fetches":)" +
            std::to_string(fetches) +
            R"(,"fetches_per_pixel":null,"error":{"baseline":null,"frame":null,"truth":null},"nonfinite_pixels":0,)"
            R"("covered_pixels":0,"image":"","difference":"","flip":"","image_hash":"","shader_hashes":[]})" +
            end);
    return (folder_ / name).string();
  }
};

TEST_F(HistoryCommand, ShowsStepsAndWritesATable) {
  const std::string csv = (folder_ / "trend.csv").string();
  const Outcome outcome = lamina_program("history " + run_folder("a", 10) + " " + run_folder("b", 10) + " " +
                                         run_folder("c", 12) + "/record.jsonl --csv " + csv);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_SAYS(outcome.output, "history of 3 records, of_a to of_c");
  EXPECT_SAYS(outcome.output, "v on vulkan, view front: fetches 10 -> 12 (+20.0%) at commit of_c");
  EXPECT_SAYS(outcome.output, "in the order given");
  EXPECT_TRUE(std::filesystem::exists(csv));
}

TEST_F(HistoryCommand, ARecordCutShortIsUsedAndSaidSo) {
  const Outcome outcome =
      lamina_program("history " + run_folder("a", 10) + " " + run_folder("b", 11, "heart", "\n{\"kind\":\"ce"));
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_SAYS(outcome.output, "is used as far as it goes: line 3 is cut short");
  EXPECT_SAYS(outcome.output, "fetches 10 -> 11");
}

TEST_F(HistoryCommand, BadInputIsSaidWithStatus2) {
  const std::string a = run_folder("a", 10);
  const auto refused = [](const std::string& arguments, const std::string& words) {
    const Outcome outcome = lamina_program("history " + arguments);
    EXPECT_EQ(outcome.status, 2) << outcome.output;
    EXPECT_SAYS(outcome.output, words);
  };
  refused("", "record");
  refused(a, "two records or more");
  refused(a + " " + a + "/record.jsonl", "given twice");
  refused(a + " " + run_folder("other", 10, "terrain"), "no cell in common");
  refused(a + " " + (folder_ / "none").string(), "none");
  write("damaged.jsonl", "{\"kind\":\"run\",\"schema\":1}\nnot json\n");
  refused(a + " " + (folder_ / "damaged.jsonl").string(), "damaged.jsonl:2");
  write("future.jsonl", "{\"kind\":\"run\",\"schema\":2}\n");
  refused(a + " " + (folder_ / "future.jsonl").string(), "schema is 2");
}

}  // namespace
}  // namespace lamina
