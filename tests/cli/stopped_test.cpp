// SPDX-License-Identifier: Apache-2.0
// Ctrl-C in the middle of a comparison, and surroundings that lack what programs take for granted.

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
  static constexpr const char* small = " --variant vertex_normal --backend vulkan --size 32x32 --truth-rays 0";
  std::string compare_square(const std::string& more) {
    return std::string(LAMINA_PROGRAM) + " compare " + square_model() + small + " --out " + out().string() + " " + more;
  }
};

TEST_F(Surroundings, CtrlCLeavesTheReportOfWhatWasMeasured) {
  const Outcome outcome =
      shell(compare_square("--budget 300 --precision 0.000001") + " & pid=$!; until ls " + (out() / "images").string() +
            "/*.png >/dev/null 2>&1; do kill -0 $pid || exit 99; sleep 0.1; " + "done; sleep 2; kill -INT $pid; wait $pid");
  EXPECT_EQ(outcome.status, 130) << outcome.output;
  EXPECT_SAYS(outcome.output, "stopped; the record and the report hold what was measured until then");
  EXPECT_TRUE(std::filesystem::exists(out() / "index.html"));
  const Record record = this->record();
  EXPECT_EQ(record.timers.size(), 1u);
  EXPECT_FALSE(record.cells.empty()) << "a picture was there";
  for (const CellRow& cell : record.cells) EXPECT_FALSE(cell.failed) << cell.reason;
}

TEST_F(Surroundings, CtrlCEndsAGateWithItsReportAndKeepsItsBaseline) {
  const std::string gate = std::string(LAMINA_PROGRAM) + " gate " + square_model() + small + " --budget 300 --out " +
                           out().string() + " --baseline " + (folder_ / "stored").string();
  const std::string stop = " & pid=$!; until grep -qs '\"plan\"' " + (out() / "record.jsonl").string() +
                           "; do kill -0 $pid || exit 99; sleep 0.1; done; sleep 3; kill -INT $pid; wait $pid";
  const Outcome first = shell(gate + " --update" + stop);
  EXPECT_EQ(first.status, 130) << first.output;
  EXPECT_SAYS(first.output, "not written: stopped before everything was measured");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "stored"));

  EXPECT_EQ(shell(gate + " --update --no-time").status, 0);
  std::filesystem::remove_all(out());
  const Outcome second = shell(gate + stop);
  EXPECT_EQ(second.status, 130) << second.output;
  EXPECT_SAYS(second.output, "stopped before everything was measured, so nothing is judged");
  ASSERT_EQ(record().gates.size(), 1u);
  EXPECT_EQ(record().gates.front().verdict, Verdict::ambiguous);
  EXPECT_TRUE(std::filesystem::exists(out() / "index.html"));
}

TEST_F(Surroundings, NoHomeAndNoFolderForTemporaryFilesAreNoProblem) {
  const Outcome outcome = shell("env -u HOME -u XDG_CACHE_HOME TMPDIR=/nowhere/at/all " + compare_square("--no-time"));
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_TRUE(std::filesystem::exists(out() / "index.html"));
}

TEST_F(Surroundings, AHomeThatIsNoFolderCostsOnlyTheCache) {
  write("file", "");
  const Outcome outcome =
      shell("env -u XDG_CACHE_HOME HOME=" + (folder_ / "file").string() + " " + compare_square("--no-time"));
  EXPECT_NE(outcome.status, 2) << outcome.output;
  EXPECT_TRUE(std::filesystem::exists(out() / "index.html"));
}

// With file systems of its own, which go with the process.
class OwnMounts : public Surroundings {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    if (shell("unshare --mount mount -t tmpfs none " + folder_.string()).status != 0)
      GTEST_SKIP() << "this user may not mount file systems in a namespace of its own; run as root";
    std::filesystem::create_directories(folder_ / "own");
  }
  // A comparison of the square after `mount`, which may speak of $OWN, an empty folder.
  Outcome compare_after(const std::string& mount, const std::string& environment = "") {
    return shell("export OWN=" + (folder_ / "own").string() + "; unshare --mount sh -c '" + mount + " && exec env " +
                 environment + " " + compare_square("--no-time") + "'");
  }
};

TEST_F(OwnMounts, LittleSharedMemoryIsNoProblem) {
  const Outcome outcome = compare_after("mount -t tmpfs -o size=1m none /dev/shm");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
}

TEST_F(OwnMounts, AFullFolderForTemporaryFilesIsNoProblem) {
  const Outcome outcome = compare_after(
      "mount -t tmpfs -o size=4k none $OWN && (head -c 8192 /dev/zero > $OWN/fill; true) 2>/dev/null", "TMPDIR=$OWN");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
}

TEST_F(OwnMounts, AHomeThatCannotBeWrittenCostsOnlyTheCache) {
  const Outcome outcome = compare_after("mount -t tmpfs -o ro none $OWN", "-u XDG_CACHE_HOME -u LAMINA_CACHE HOME=$OWN");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
}

TEST_F(OwnMounts, AFullDiskIsOneMessage) {
  const Outcome outcome =
      shell("OWN=" + (folder_ / "own").string() + "; unshare --mount sh -c 'mount -t tmpfs -o size=16k none " +
            (folder_ / "own").string() + " && exec " + LAMINA_PROGRAM + " compare " + square_model() + small +
            " --no-time --out " + (folder_ / "own/out").string() + "'");
  EXPECT_EQ(outcome.status, 1) << outcome.output;
  EXPECT_SAYS(outcome.output, "No space left on device");
}

TEST_F(OwnMounts, AnyUserMayRunIt) {
  std::filesystem::permissions(folder_, std::filesystem::perms::all);
  const Outcome outcome =
      shell("setpriv --reuid=65534 --regid=65534 --clear-groups env HOME=/nonexistent " + compare_square("--no-time"));
  EXPECT_EQ(outcome.status, 0) << outcome.output;
}

}  // namespace
}  // namespace lamina
