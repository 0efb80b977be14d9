// SPDX-License-Identifier: Apache-2.0
// Variants that leave no picture, and a baseline that cannot be drawn: no verdict is made of them.
#include <algorithm>

#include "tests/cli/program.h"

namespace lamina {
namespace {

class NotAPicture : public ProgramTest {
 protected:
  void add_variant(const std::string& name, const std::string& main) {
    std::filesystem::create_directories(folder_ / "mine");
    write("mine/" + name + ".toml",
          "[variant]\nname = \"" + name +
              "\"\neffect = \"layered_material\"\n[[pass]]\nname = \"composite\"\ndraw = \"objects\"\n"
              "vertex = \"common/object.vert\"\nfragment = \"" +
              name + ".frag\"\nwrite = [\"frame\"]\ndepth = \"read_write\"\n");
    write("mine/" + name + ".frag",
          "#include \"common/frame.glsl\"\n#include \"common/surface.glsl\"\n#include \"common/mesh_in.glsl\"\n"
          "layout(binding = 4) uniform sampler2D inner_albedo;\nlayout(location = 0) out vec4 color;\nvoid main() { " +
              main + " }\n");
  }
  Outcome compare(const std::string& scene) {
    return lamina_program("compare " + scene + " --backend vulkan --size 64x64 --no-time --truth-rays 0 --out " +
                          out().string());
  }
};

TEST_F(NotAPicture, FramesOfNoPictureFailAndAreNeverFast) {
  add_variant(
      "nan_pixel",
      "vec3 c = texture(inner_albedo, in_uv).rgb; float z = int(gl_FragCoord.x) == int(frame_size_px.x) / 2 ? c.x - c.x "
      ": 1.0; color = vec4(c / z, 1.0);");
  add_variant("discard_all", "if (texture(inner_albedo, in_uv).a >= -1.0) discard; color = vec4(1);");
  add_variant("one_colour", "color = vec4(0.2, 0.2, 0.2, 1.0);");
  const Outcome outcome = compare("heart --variant nan_pixel --variant discard_all --variant one_colour --variants-dir " +
                                  (folder_ / "mine").string());
  EXPECT_EQ(outcome.status, 1) << outcome.output;
  EXPECT_SAYS(outcome.output, "not a picture");
  size_t found = 0;
  for (const CellRow& cell : record().cells)
    for (const auto& [name, words] : {std::pair{"nan_pixel", "are not finite numbers, the first at (32, "},
                                      {"discard_all", "nothing is drawn where the baseline covers"},
                                      {"one_colour", "it is one colour all over the"}}) {
      if (cell.variant != name) continue;
      ++found;
      EXPECT_TRUE(cell.failed) << name;
      EXPECT_TRUE(cell.reason.starts_with("not a picture: ")) << cell.reason;
      EXPECT_SAYS(cell.reason, words);
      EXPECT_FALSE(cell.error_covered || cell.median_ms || cell.ratio_to_baseline);
      EXPECT_TRUE(std::filesystem::exists(out() / cell.image)) << "it can still be looked at";
    }
  EXPECT_EQ(found, 9u);
  std::ifstream summary(out() / "summary.md");
  const std::string text{std::istreambuf_iterator<char>(summary), {}};
  EXPECT_SAYS(text, "**one_colour** is not a picture on vulkan: it is one colour");
}

// Colours as the baseline's or not: alpha is a figure of its own, where it is asked for.
TEST_F(NotAPicture, AlphaIsComparedWhereItIsAskedFor) {
  add_variant("half_alpha", "color = vec4(in_uv, texture(inner_albedo, in_uv).b, 0.5);");
  const std::string scene = square_model() + " --variant half_alpha --variants-dir " + (folder_ / "mine").string();
  const auto alpha_of = [&](const std::string& more) {
    const Outcome outcome = compare(scene + more);
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_EQ(outcome.output.find("alpha differs from the baseline's by up to 0.5") != std::string::npos, !more.empty());
    std::optional<double> most;
    for (const CellRow& cell : record().cells)
      if (cell.variant == "half_alpha") most = cell.max_alpha;
    return most;
  };
  EXPECT_EQ(alpha_of(""), std::nullopt);
  EXPECT_NEAR(alpha_of(" --alpha").value_or(0), 0.5, 1e-6);
}

TEST_F(NotAPicture, ABaselineWithoutTexelsFailsByNameAndTheOthersGoOn) {
  // A square whose texture coordinates are one point, as a palette's are.
  const std::string model = square_model();
  std::fstream bytes(folder_ / "square.bin", std::ios::in | std::ios::out | std::ios::binary);
  const float point[2] = {0.25f, 0.5f};
  for (int vertex = 0; vertex < 4; ++vertex) {
    bytes.seekp(32 * vertex + 24);
    bytes.write(reinterpret_cast<const char*>(point), sizeof point);
  }
  bytes.close();
  const Outcome outcome = compare(model + few_variants);
  EXPECT_EQ(outcome.status, 1) << outcome.output;
  EXPECT_SAYS(outcome.output, "texture coordinates");
  const Record record = this->record();
  const auto baselines = std::ranges::count_if(record.cells, &CellRow::baseline);
  EXPECT_GT(baselines, 0);
  EXPECT_EQ(record.cells.size(), 3 * static_cast<size_t>(baselines));
  for (const CellRow& cell : record.cells) {
    EXPECT_EQ(cell.failed, cell.baseline) << cell.variant << " " << cell.reason;
    if (cell.baseline) {
      EXPECT_SAYS(cell.reason, "square");
    } else {
      EXPECT_FALSE(cell.error_covered || cell.ratio_to_baseline) << "there is nothing to hold it against";
      EXPECT_TRUE(cell.fetches);
    }
  }
}

TEST_F(NotAPicture, LimitsAreCheckedBeforeAnythingRuns) {
  for (const auto& [limit, words] : {std::pair{"sim=0.9", "ssim"}, {"truth.ssim=0.9", "limits the error to the baseline"}}) {
    const Outcome outcome = lamina_program(std::string("compare heart --limit ") + limit + " --out " + out().string());
    EXPECT_EQ(outcome.status, 2) << outcome.output;
    EXPECT_SAYS(outcome.output, words);
  }
  EXPECT_FALSE(std::filesystem::exists(out()));
}

}  // namespace
}  // namespace lamina
