// SPDX-License-Identifier: Apache-2.0
// Ctrl-C in the middle of a comparison, and surroundings that lack what programs take for granted.
#include <algorithm>

#include "tests/cli/program.h"

namespace lamina {
namespace {

class Surroundings : public ProgramTest {
 protected:
  static Outcome shell(const std::string& script) {
    Outcome outcome;
    FILE* pipe = ::popen(("exec 2>&1; " + script).c_str(), "r");
    std::array<char, 4096> buffer;
    while (const size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) outcome.output.append(buffer.data(), count);
    const int status = ::pclose(pipe);
    outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return outcome;
  }
  std::string compare_square(const std::string& more) {
    return std::string(LAMINA_PROGRAM) + " compare " + square_model() + " --backend vulkan --size 32x32 --truth-rays 0 --out " +
           out().string() + " " + more;
  }
};

TEST_F(Surroundings, CtrlCLeavesTheReportOfWhatWasMeasured) {
  const std::string record_file = (out() / "record.jsonl").string();
  const Outcome outcome =
      shell(compare_square("--budget 300 --precision 0.000001") + " & pid=$!; until grep -qs '\"timer\"' " + record_file +
            "; do kill -0 $pid || exit 99; sleep 0.1; done; sleep 2; kill -INT $pid; wait $pid");
  EXPECT_EQ(outcome.status, 130) << outcome.output;
  EXPECT_SAYS(outcome.output, "stopped; the record and the report hold what was measured until then");
  EXPECT_TRUE(std::filesystem::exists(out() / "index.html"));
  for (const CellRow& cell : record().cells) EXPECT_FALSE(cell.failed) << cell.reason;
}

TEST_F(Surroundings, NoHomeAndNoFolderForTemporaryFilesAreNoProblem) {
  const Outcome outcome =
      shell("env -u HOME -u XDG_CACHE_HOME TMPDIR=/nowhere/at/all " + compare_square("--quick --budget 0.1"));
  const bool certified = std::ranges::all_of(record().timers, &TimerRow::ok);
  EXPECT_EQ(outcome.status, certified ? 0 : 1) << outcome.output;
  EXPECT_TRUE(std::filesystem::exists(out() / "index.html"));
}

TEST_F(Surroundings, AHomeThatIsNoFolderCostsOnlyTheCache) {
  write("file", "");
  const Outcome outcome =
      shell("env -u XDG_CACHE_HOME HOME=" + (folder_ / "file").string() + " " + compare_square("--quick --budget 0.1"));
  EXPECT_NE(outcome.status, 2) << outcome.output;
  EXPECT_TRUE(std::filesystem::exists(out() / "index.html"));
}

}  // namespace
}  // namespace lamina
