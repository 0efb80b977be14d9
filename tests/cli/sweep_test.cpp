// SPDX-License-Identifier: Apache-2.0
// lamina sweep and lamina merge as a user runs them, on a square whose variant is darker than the baseline by a parameter: its
// errors are known in closed form, and a cell takes no time.
#include <fcntl.h>
#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <map>
#include <random>
#include <thread>

#include "harness/core/text.h"
#include "harness/record/record.h"
#include "tests/cli/program.h"

namespace lamina {
namespace {

using Json = nlohmann::json;

class SweepTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    square_model();
    std::filesystem::create_directories(folder_ / "mine");
    write("square.toml", "[scene]\nmodel = \"square.gltf\"\n[objects.\"*\"]\nlayers = false\nalbedo = [0.5, 0.4, 0.3]\n");
    write("mine/darker.toml",
          "[variant]\nname = \"darker\"\neffect = \"surface\"\n[parameters.amount]\nvalue = 0.1\nmin = 0\nmax = 1\n"
          "[[pass]]\nname = \"surface\"\ndraw = \"objects\"\nvertex = \"common/object.vert\"\nfragment = \"darker.frag\"\n"
          "write = [\"frame\"]\ndepth = \"read_write\"\ncull = \"back\"\n");
    write("mine/darker.frag",
          "#include \"common/frame.glsl\"\n#include \"common/surface.glsl\"\n#include \"common/mesh_in.glsl\"\n"
          "layout(constant_id = 0) const float amount = 0.1;\nlayout(binding = 4) uniform sampler2D albedo;\n"
          "layout(location = 0) out vec4 color;\nvoid main() {\n"
          "  vec3 light = diffuse_light(normalize(in_normal), in_position);\n"
          "  color = vec4((1.0 - amount) * texture(albedo, in_uv).rgb * light, 1.0);\n}\n");
  }
  std::string command(const std::string& out, const std::string& set, const std::string& more = "") const {
    return "sweep " + (folder_ / "square.toml").string() + " --variants-dir " + (folder_ / "mine").string() + " --size 32x32 " +
           "--backend vulkan " + set + " --out " + (folder_ / out).string() + " " + more;
  }
  Outcome sweep(const std::string& out, const std::string& set, const std::string& more = "") const {
    return lamina_program(command(out, set, more));
  }
  std::filesystem::path file(const std::string& out) const { return folder_ / out / "record.jsonl"; }

  // All but what the command's words, its moment and the machines' list may differ in.
  std::vector<Json> lines(const std::string& out) const {
    std::vector<Json> all;
    std::istringstream stream(read_file(file(out), "test"));
    for (std::string line; std::getline(stream, line);) all.push_back(Json::parse(line));
    for (const char* name : {"command", "date", "machines"}) all.at(0).erase(name);
    return all;
  }
  // Starts the program and leaves it running.
  pid_t start(const std::string& arguments) const {
    const pid_t child = ::fork();
    if (child != 0) return child;
    const int nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, 1), ::dup2(nowhere, 2);
    ::execl("/bin/sh", "sh", "-c", ("exec " + std::string(LAMINA_PROGRAM) + " " + arguments).c_str(), nullptr);
    ::_exit(127);
  }
  static int wait_for(pid_t child) {
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  const std::string amounts_ = "--set darker.amount=0:0.9:0.1 --fetches every:4 --pictures every:4";
  // Touches uniforms alone, so that cells follow each other quickly.
  const std::string lights_ = "--set lights.key.intensity=0:4.5:0.5 --fetches every:4 --pictures every:4";
};

// The picture is (1 - amount) times the baseline's, so its greatest difference is amount times the baseline's greatest value.
TEST_F(SweepTest, ErrorsFollowTheParameter) {
  const Outcome outcome = sweep("out", amounts_, "--backend osmesa --limit rmse_linear=0.05");
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  const Record record = read_record(file("out"));
  ASSERT_EQ(record.cells.size(), 2u * 10 * 3 * 2) << "backends, points, views, variants";
  ASSERT_EQ(record.sweeps.size(), 1u);
  std::map<std::string, double> greatest;  // by backend and view, at amount 0.5
  const auto shot = [](const CellRow& cell) { return cell.backend + cell.view; };
  for (const CellRow& cell : record.cells)
    if (cell.params.at("darker.amount") == 0.5 && !cell.baseline) greatest[shot(cell)] = 2 * cell.error_covered->max_linear;
  for (const CellRow& cell : record.cells) {
    EXPECT_FALSE(cell.failed) << cell.reason;
    const double amount = cell.params.at("darker.amount");
    const bool fourth = amount == 0 || amount == 0.4 || amount == 0.8;
    EXPECT_EQ(!cell.fetches, !fourth);
    EXPECT_EQ(cell.image.empty(), !fourth);
    EXPECT_TRUE(std::filesystem::exists(folder_ / "out" / cell.image));
    if (cell.baseline) continue;
    const ErrorFigures& error = *cell.error_covered;
    EXPECT_NEAR(error.max_linear, amount * greatest.at(shot(cell)), 1e-3) << amount;
    EXPECT_EQ(std::isinf(error.psnr_db), amount == 0);
  }
  EXPECT_FALSE(record.crossovers.empty());
  EXPECT_SAYS(outcome.output, "darker keeps RMSE at most 0.05 up to amount");
  EXPECT_SAYS(read_file(folder_ / "out" / "summary.md", "test"), "## Answers");
  EXPECT_SAYS(sweep("out", amounts_, "--backend osmesa --limit rmse_linear=0.05").output, "120 cells are there, 0 to go");
}

// A flat surface under lights that are the same all over it: the light is one colour, in whatever way it is looked up and
// blurred, so all variants agree with the baseline at every thickness, up to the light map's half floats (2^-11) in light of
// about 1.
TEST_F(SweepTest, UnderEvenLightNoThicknessTellsVariantsApart) {
  write(
      "flat.toml",
      "[scene]\nmodel = \"square.gltf\"\n[lights.key]\nkind = \"directional\"\ndirection = [-0.3, -0.4, -1]\nintensity = 1\n");
  const Outcome outcome =
      lamina_program("sweep " + (folder_ / "flat.toml").string() + " --set objects.square.thickness=0,4,16" + few_variants +
                     " --size 64x64 --view front --out " + (folder_ / "flat").string());
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  const Record record = read_record(file("flat"));
  ASSERT_EQ(record.cells.size(), 3u * 3 * 2);
  for (const CellRow& cell : record.cells) {
    if (cell.baseline) continue;
    EXPECT_LE(cell.error_covered->max_linear, 2e-3) << cell.variant << " at " << cell.params.at("objects.square.thickness");
  }
  // Thicker layers are another picture all the same.
  EXPECT_NE(record.cells[0].image_hash, record.cells[3].image_hash);
}

// A moving light, mesh place and camera: what a point touches, and nothing else, changes its pictures.
TEST_F(SweepTest, EveryPointIsThePictureThatItWouldBeAlone) {
  const std::string grid = "--set lights.key.intensity=0,2 --set objects.square.position.x=0,0.5 --fetches all --pictures none";
  ASSERT_EQ(sweep("grid", grid).status, 0);
  const Record record = read_record(file("grid"));
  ASSERT_EQ(record.cells.size(), 4u * 3 * 2);
  std::map<std::pair<double, double>, std::vector<CellRow>> of_point;  // by the light and the place
  for (const CellRow& cell : record.cells)
    of_point[{cell.params.at("lights.key.intensity"), cell.params.at("objects.square.position.x")}].push_back(cell);
  ASSERT_EQ(of_point.size(), 4u);
  for (const auto& [point, cells] : of_point) {
    const auto& [light, place] = point;
    const std::string out = fmt::format("alone-{}-{}", light, place);
    ASSERT_EQ(
        sweep(out, fmt::format("--set lights.key.intensity={} --set objects.square.position.x={} --fetches all", light, place),
              "--pictures none")
            .status,
        0);
    const Record alone = read_record(file(out));
    ASSERT_EQ(alone.cells.size(), cells.size()) << out;
    for (size_t i = 0; i < cells.size(); ++i) EXPECT_EQ(to_json(alone.cells[i]), to_json(cells[i])) << out;
  }
}

TEST_F(SweepTest, BadInputStopsBeforeAnythingRuns) {
  const std::pair<std::string, std::string> cases[] = {
      {"--set objects.square.positon.x=0:1:1", "did you mean 'objects.square.position.x'"},
      {"--set darker.amount=0:2:1", "2 is out of range: it takes 0 to 1"},
      {"--set darker.amount=0:1:0", "do not lead from"},
      {"--set darker.amount=0,1 --shard 3/2", "K from 1 to N"},
      {"--set darker.amount=0,1 --time sometimes", "takes none, all or every:N"},
      {"--set darker.amount=0,1 --view fron", "did you mean 'front'"},
      {"--set darker.amount=0,1 --limit sim=1", "did you mean 'ssim'"}};
  for (const auto& [set, words] : cases) {
    const Outcome outcome = sweep("out", set);
    EXPECT_EQ(outcome.status, 2) << outcome.output;
    EXPECT_SAYS(outcome.output, words);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
  }
}

TEST_F(SweepTest, ARecordOfOtherInputsIsRefused) {
  ASSERT_EQ(sweep("out", "--set darker.amount=0,1").status, 0);
  const std::string before = read_file(file("out"), "test");
  for (const char* other : {"--set darker.amount=0,0.5", "--set darker.amount=0,1 --seed 2"}) {
    const Outcome outcome = sweep("out", other);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_SAYS(outcome.output, "choose another folder with --out");
  }
  write("mine/darker.frag", read_file(folder_ / "mine/darker.frag", "test") + "// changed\n");
  EXPECT_SAYS(sweep("out", "--set darker.amount=0,1").output, "'inputs' is");
  EXPECT_EQ(read_file(file("out"), "test"), before);
}

// Kills at random moments, each run going on where the last was killed, until the record is whole; then anew.
TEST_F(SweepTest, KilledAtAnyMomentNoCellIsLostOrDoubled) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  ASSERT_EQ(sweep("whole", lights_).status, 0);
  const std::vector<Json> whole = lines("whole");
  const double run_ms = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  std::mt19937_64 random(7);
  int kills = 0, finished = 0;
  for (int round = 0; kills < 20; ++round) {
    ASSERT_LT(round, 50);
    const std::string out = fmt::format("killed-{}", round);
    for (bool done = false; !done;) {
      const pid_t child = start(command(out, lights_));
      const auto after = std::chrono::microseconds(static_cast<int64_t>(run_ms * double(random() % 800)));
      const auto until = Clock::now() + after;
      int status = 0;
      pid_t ended = 0;
      while ((ended = ::waitpid(child, &status, WNOHANG)) == 0 && Clock::now() < until)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      if (ended == 0) {
        ::kill(child, SIGKILL);
        wait_for(child);
        ++kills;
        continue;
      }
      ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
      done = true;
    }
    ++finished;
    ASSERT_EQ(lines(out), whole) << out;
  }
  RecordProperty("kills", kills);
  RecordProperty("finished", finished);
}

TEST_F(SweepTest, ACutRecordGoesOn) {
  ASSERT_EQ(sweep("whole", lights_).status, 0);
  const std::string text = read_file(file("whole"), "test");
  for (const double share : {0.0, 0.001, 0.2, 0.5, 0.77, 0.995}) {
    std::filesystem::create_directories(folder_ / "cut");
    write("cut/record.jsonl", text.substr(0, static_cast<size_t>(share * double(text.size()))));
    const Outcome outcome = sweep("cut", lights_);
    ASSERT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_EQ(lines("cut"), lines("whole")) << share;
    std::filesystem::remove_all(folder_ / "cut");
  }
}

TEST_F(SweepTest, InterruptedItFinishesTheCellAndSaysHowToGoOn) {
  const std::string many = "--set lights.key.intensity=0:1:0.002 --fetches none --pictures none";
  const std::filesystem::path said = folder_ / "said";
  const pid_t child = start(command("out", many) + " >" + said.string() + " 2>&1");
  for (int i = 0; i < 30000; ++i) {
    std::error_code not_there;
    if (std::filesystem::file_size(file("out"), not_there) > 20000 && !not_there) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ::kill(child, SIGINT);
  EXPECT_EQ(wait_for(child), 128 + SIGINT);
  EXPECT_SAYS(read_file(said, "test"), "finishing the cell; a second Ctrl-C stops at once");
  EXPECT_SAYS(read_file(said, "test"), "Go on with the same command");
  const std::string stopped = read_file(file("out"), "test");
  EXPECT_TRUE(stopped.ends_with('\n'));
  const size_t cells = lines("out").size();
  EXPECT_LT(cells, 3000u);
  EXPECT_SAYS(sweep("out", many).output, "resuming");
  EXPECT_TRUE(read_file(file("out"), "test").starts_with(stopped)) << "what was there stays byte for byte";
  EXPECT_EQ(read_record(file("out")).cells.size(), 501u * 3 * 2);
}

TEST_F(SweepTest, AFullDiskStopsClearlyAndCanBeResumed) {
  ASSERT_EQ(sweep("whole", lights_).status, 0);
  const auto blocks = std::filesystem::file_size(file("whole")) / 1024 / 2;
  const std::string limited = fmt::format("ulimit -f {}; {} {} 2>&1", blocks, LAMINA_PROGRAM, command("full", lights_));
  FILE* pipe = ::popen(("bash -c '" + limited + "'").c_str(), "r");
  std::string output;
  for (int c; (c = std::fgetc(pipe)) != EOF;) output += static_cast<char>(c);
  const int status = ::pclose(pipe);
  EXPECT_EQ(WEXITSTATUS(status), 1) << output;
  EXPECT_SAYS(output, "cannot be written");
  EXPECT_SAYS(output, "free some space and run again");
  EXPECT_EQ(sweep("full", lights_).status, 0);
  EXPECT_EQ(lines("full"), lines("whole"));
}

TEST_F(SweepTest, ShardsMergeToTheRecordOfOneRun) {
  ASSERT_EQ(sweep("whole", lights_).status, 0);
  std::string folders;
  for (int k = 1; k <= 3; ++k) {
    ASSERT_EQ(sweep(fmt::format("part-{}", k), lights_, fmt::format("--shard {}/3", k)).status, 0);
    folders += (folder_ / fmt::format("part-{}", k)).string() + " ";
  }
  const Outcome merged = lamina_program("merge " + folders + "--out " + (folder_ / "merged").string());
  EXPECT_EQ(merged.status, 0) << merged.output;
  EXPECT_EQ(lines("merged"), lines("whole"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "merged" / lines("merged").at(3).at("image").get<std::string>()));

  const Outcome short_of = lamina_program("merge " + (folder_ / "part-1").string() + " " + (folder_ / "part-3").string() +
                                          " --out " + (folder_ / "short").string());
  EXPECT_EQ(short_of.status, 1);
  EXPECT_SAYS(short_of.output,
              "surface/darker on vulkan: 3 of 10 points are missing: lights.key.intensity 0.5; lights.key.intensity 2;");

  // What is there is not written over by what holds less, or something else.
  const std::string before = read_file(file("merged"), "test");
  const std::string part = (folder_ / "part-1").string();
  const Outcome less = lamina_program("merge " + part + " --out " + (folder_ / "merged").string());
  EXPECT_EQ(less.status, 2);
  EXPECT_SAYS(less.output, "holds 36 cells that these records lack");
  EXPECT_EQ(read_file(file("merged"), "test"), before);
  ASSERT_EQ(sweep("other", "--set darker.amount=0,1").status, 0);
  const std::string others = read_file(file("other"), "test");
  const Outcome other = lamina_program("merge " + part + " --out " + (folder_ / "other").string());
  EXPECT_EQ(other.status, 2);
  EXPECT_SAYS(other.output, "holds a record that these do not continue");
  EXPECT_EQ(read_file(file("other"), "test"), others);
  EXPECT_EQ(lamina_program("merge " + folders + "--out " + (folder_ / "merged").string()).status, 0) << "the same again";
  const Outcome nowhere = lamina_program("merge " + part + "-x --out " + (folder_ / "nowhere").string());
  EXPECT_EQ(nowhere.status, 2);
  EXPECT_SAYS(nowhere.output, "part-1-x: is not there");
}

TEST_F(SweepTest, TwoAtOnceInOneFolderAreRefused) {
  const pid_t first = start(command("out", "--set lights.key.intensity=0:1:0.01 --fetches none --pictures none"));
  for (int i = 0; i < 30000 && !std::filesystem::exists(file("out")); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const Outcome second = sweep("out", "--set lights.key.intensity=0:1:0.01 --fetches none --pictures none");
  EXPECT_EQ(second.status, 2) << second.output;
  EXPECT_SAYS(second.output, "is writing here");
  EXPECT_EQ(wait_for(first), 0);
  EXPECT_EQ(read_record(file("out")).cells.size(), 101u * 3 * 2);
}

TEST_F(SweepTest, OtherLimitsNeedNoCellAgain) {
  ASSERT_EQ(sweep("out", "--set darker.amount=0:1:0.5").status, 0);
  const Outcome outcome = sweep("out", "--set darker.amount=0:1:0.5", "--limit max_linear=0.0625");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_SAYS(outcome.output, "18 cells are there, 0 to go");
  EXPECT_SAYS(read_file(folder_ / "out" / "summary.md", "test"), "the greatest difference at most 0.0625");
}

// What the record says of how it came about can be given to a shell as it stands.
TEST_F(SweepTest, ItsCommandMakesItAgain) {
  const std::string out = (folder_ / "it's a folder").string();
  const std::string quoted = "'" + (folder_ / "it").string() + "'\\''s a folder'";
  const std::string arguments = "sweep " + (folder_ / "square.toml").string() + " --variants-dir " +
                                (folder_ / "mine").string() + " --size 32x32 --backend vulkan --set darker.amount=0,1 --out ";
  ASSERT_EQ(lamina_program(arguments + quoted).status, 0);
  const std::filesystem::path made = std::filesystem::path(out) / "record.jsonl";
  const std::string command = read_record(made).run.at("command");
  EXPECT_EQ(command, "lamina " + arguments + quoted) << "what needs no quotes has none";
  std::filesystem::remove_all(out);
  ASSERT_EQ(lamina_program(command.substr(std::string("lamina ").size())).status, 0);
  EXPECT_EQ(read_record(made).run.at("command"), command);
}

TEST_F(SweepTest, TimedPointsHaveRatiosAndOthersHaveNone) {
  const Outcome outcome = sweep("out", "--set darker.amount=0:0.3:0.1", "--time every:2 --budget 0.05 --fetches none");
  const Record record = read_record(file("out"));
  ASSERT_EQ(record.timers.size(), 1u);
  const bool certified = record.timers[0].ok;
  EXPECT_EQ(outcome.status, certified ? 0 : 1) << outcome.output;
  ASSERT_EQ(record.cells.size(), 4u * 3 * 2) << "points, views, variants";
  for (const CellRow& cell : record.cells) {
    const double amount = cell.params.at("darker.amount");
    const bool scheduled = amount == 0 || amount == 0.2;
    EXPECT_EQ(cell.timed, scheduled && certified);
    EXPECT_EQ(!cell.fetches, !scheduled) << "what is timed is counted";
    EXPECT_EQ(!cell.ratio_to_baseline, !scheduled || !certified || cell.baseline);
  }
}

}  // namespace
}  // namespace lamina
