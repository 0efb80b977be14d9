// SPDX-License-Identifier: Apache-2.0
// lamina compare from end to end, as a user runs it, in a small frame.
#include <algorithm>
#include <set>

#include "harness/quality/quality.h"
#include "harness/scene/textures.h"
#include "tests/cli/program.h"

namespace lamina {
namespace {

class Compare : public ProgramTest {
 protected:
  // Without times: a timer's certificate takes longer than all else.
  Outcome compare(const std::string& arguments, const std::string& times = "--no-time") {
    return lamina_program("compare " + arguments + " --size 96x96 " + times + " --out " + out().string());
  }
  static std::vector<CellRow> cells(const Record& record, const std::string& variant) {
    std::vector<CellRow> found;
    std::copy_if(record.cells.begin(), record.cells.end(), std::back_inserter(found),
                 [&](const CellRow& cell) { return cell.variant == variant; });
    return found;
  }
};

// Without --variant, --quick looks at what the effect names for it; without --quick, at all.
TEST_F(Compare, QuickLooksAtWhatTheEffectNames) {
  const auto variants = [&](const std::string& arguments) {
    const Outcome outcome = compare("open_plane --truth-rays 0 --backend vulkan " + arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    std::set<std::string> names;
    for (const CellRow& cell : record().cells) names.insert(cell.variant);
    return std::pair(names, outcome.output);
  };
  const auto [quick, said] = variants("--quick");
  EXPECT_EQ(quick, (std::set<std::string>{"exact_cap", "smoothstep_cap", "fitted_cap", "naive_cap", "lens_cosine"}));
  EXPECT_SAYS(said, "--quick looks at 5 of ");
  const auto [named, nothing] = variants("--quick --variant linear_cap");
  EXPECT_EQ(named, (std::set<std::string>{"exact_cap", "linear_cap"}));
  EXPECT_EQ(nothing.find("--quick looks at"), std::string::npos);
}

TEST_F(Compare, QuickLooksAtTheFirstBackendUnlessOneIsNamed) {
  const auto backends = [&](const std::string& arguments) {
    compare("open_plane --quick --truth-rays 0 --variant naive_cap " + arguments);
    std::set<std::string> names;
    for (const CellRow& cell : record().cells) names.insert(cell.backend);
    return names;
  };
  EXPECT_EQ(backends(""), (std::set<std::string>{"vulkan"}));
  EXPECT_EQ(backends("--backend osmesa --backend vulkan"), (std::set<std::string>{"osmesa", "vulkan"}));
}

// Two effects have variants of the same names: what one names for --quick is not meant of the other.
TEST_F(Compare, QuickNamesAreOfTheirOwnEffect) {
  for (const auto& [effect, quick] : {std::pair<std::string, std::string>("wax", "cheap"), {"clay", "odd"}}) {
    write("mine/" + effect + "/effect.toml",
          "[effect]\nname = \"" + effect + "\"\ntitle = \"t\"\nkey = \"" + effect + "\"\nquick = [\"" + quick +
              "\"]\ninstead_of = [\"aperture_lighting\"]\nbecause = \"b\"\nnot_because = \"n\"\n");
    for (const std::string variant : {"full", "cheap", "odd"})
      write("mine/" + effect + "/" + variant + ".toml",
            "[variant]\nname = \"" + variant + "\"\nbaseline = " + (variant == "full" ? "true" : "false") +
                "\n[[pass]]\nname = \"draw\"\ndraw = \"objects\"\nvertex = \"common/object.vert\"\n"
                "fragment = \"surface/lambert.frag\"\nwrite = [\"frame\"]\ndepth = \"read_write\"\n");
  }
  const std::string scene = write("two.toml",
                                  "[scene]\nbuiltin = \"sphere_over_plane\"\n[objects.plane]\nwax = true\n"
                                  "[objects.sphere]\nclay = true\n");
  const Outcome outcome = compare(scene + " --quick --backend vulkan --variants-dir " + (folder_ / "mine").string());
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  std::set<std::string> measured;
  for (const CellRow& cell : record().cells) measured.insert(cell.effect + "/" + cell.variant);
  EXPECT_EQ(measured, (std::set<std::string>{"wax/full", "wax/cheap", "clay/full", "clay/odd"})) << outcome.output;
}

TEST_F(Compare, HeartOnEveryDefaultBackend) {
  const Outcome outcome = compare("heart", std::string("--budget 0.1 --precision 0.05 --truth-rays 64") + few_variants);
  const Record record = this->record();
  // A machine that is busy with other tests can fail the timer's certificate; then times are refused and the status says so.
  EXPECT_EQ(outcome.status, std::ranges::all_of(record.timers, &TimerRow::ok) ? 0 : 1) << outcome.output;
  EXPECT_EQ(record.timers.size(), 2u);
  ASSERT_EQ(record.cells.size() % 6, 0u) << "three variants on two backends, in every view";
  ASSERT_GE(record.cells.size(), 12u);
  const std::map<std::string, double> composite_fetches = {{"light_map", 29}, {"normal_map_taps", 28}, {"vertex_normal", 15}};
  for (const CellRow& cell : record.cells) {
    SCOPED_TRACE(cell.variant + " " + cell.backend + " " + cell.view);
    EXPECT_FALSE(cell.failed) << cell.reason;
    EXPECT_EQ(cell.nonfinite_pixels, 0u);
    EXPECT_GT(*cell.covered_pixels, 500u);
    EXPECT_TRUE(std::filesystem::exists(out() / cell.image));
    const PassRow& composite = cell.passes.back();
    EXPECT_EQ(composite.name, "composite");
    EXPECT_EQ(static_cast<double>(*composite.fetches),
              composite_fetches.at(cell.variant) * static_cast<double>(*composite.fragments));
    EXPECT_GE(composite.fragments, cell.covered_pixels);
    if (cell.baseline) continue;
    EXPECT_LT(cell.error_covered->ssim, 1);
    EXPECT_GT(cell.error_covered->ssim, 0.3);
  }
  size_t pairs = 0;
  for (const CellRow& vulkan : record.cells)
    for (const CellRow& opengl : record.cells) {
      if (vulkan.backend != "vulkan" || opengl.backend != "osmesa" || vulkan.variant != opengl.variant ||
          vulkan.view != opengl.view)
        continue;
      ++pairs;
      EXPECT_GE(psnr_db(picture(opengl), picture(vulkan)), 45) << vulkan.image;
      EXPECT_EQ(opengl.fetches, vulkan.fetches) << vulkan.image;
    }
  EXPECT_EQ(2 * pairs, record.cells.size()) << "each cell of one backend is compared with the other's";
  for (const char* file : {"summary.md", "cells.csv", "index.html"}) EXPECT_TRUE(std::filesystem::exists(out() / file)) << file;
}

TEST_F(Compare, VariantOfAUserIsMeasuredLikeTheBuiltInOnes) {
  const std::filesystem::path mine = folder_ / "mine";
  std::filesystem::create_directories(mine);
  write("mine/one_tap.toml", R"([variant]
name = "one_tap"
effect = "layered_material"
[[pass]]
name = "composite"
draw = "objects"
vertex = "common/object.vert"
fragment = "one_tap.frag"
write = ["frame"]
depth = "read_write"
)");
  write("mine/one_tap.frag", R"(
#include "common/frame.glsl"
#include "common/surface.glsl"
#include "common/mesh_in.glsl"
layout(binding = 4) uniform sampler2D inner_albedo;
layout(location = 0) out vec4 color;
void main() { color = vec4(texture(inner_albedo, in_uv).rgb * diffuse_light(normalize(in_normal), in_position), 1.0); }
)");
  const Outcome outcome = compare(square_model() + " --backend vulkan --variant one_tap --variants-dir " + mine.string());
  const Record record = this->record();
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  ASSERT_FALSE(cells(record, "one_tap").empty());
  for (const CellRow& cell : cells(record, "one_tap")) {
    EXPECT_FALSE(cell.failed) << cell.reason;
    EXPECT_EQ(cell.passes.at(0).fetches, cell.passes.at(0).fragments);
    EXPECT_TRUE(cell.error_covered);
  }
  EXPECT_TRUE(cells(record, "vertex_normal").empty()) << "only the baseline stands beside it";
}

TEST_F(Compare, ShaderThatDoesNotCompileFailsItsCellsAndNoOther) {
  const std::filesystem::path mine = folder_ / "mine";
  std::filesystem::create_directories(mine);
  write("mine/broken.toml", R"([variant]
name = "broken"
effect = "layered_material"
[[pass]]
name = "composite"
draw = "objects"
vertex = "common/object.vert"
fragment = "broken.frag"
write = ["frame"]
)");
  write("mine/broken.frag", "layout(location = 0) out vec4 color;\nvoid main() {\n  color = nothing;\n}\n");
  const Outcome outcome =
      compare(square_model() + " --backend vulkan --variant broken --variant vertex_normal --variants-dir " + mine.string());
  const Record record = this->record();
  EXPECT_EQ(outcome.status, 1);
  EXPECT_SAYS(outcome.output, "broken.frag:3");
  ASSERT_EQ(cells(record, "broken").size(), 3u) << "views";
  for (const CellRow& cell : cells(record, "broken")) {
    EXPECT_TRUE(cell.failed);
    EXPECT_SAYS(cell.reason, "broken.frag:3");
    EXPECT_FALSE(cell.median_ms);
  }
  ASSERT_EQ(cells(record, "vertex_normal").size(), 3u);
  for (const CellRow& cell : cells(record, "vertex_normal")) EXPECT_FALSE(cell.failed) << cell.reason;
}

TEST_F(Compare, SceneWithoutLayersCostsNoLayeredMaterial) {
  square_model();
  const auto scene = write("plain.toml", "[scene]\nmodel = \"square.gltf\"\n[objects.\"*\"]\nlayers = false\n");
  const Outcome plan = lamina_program("plan " + scene.string());
  EXPECT_EQ(plan.status, 0);
  EXPECT_SAYS(plan.output, "layered_material: not called for: no object has layers");
  const Outcome outcome = compare(scene.string() + " --backend vulkan");
  const Record record = this->record();
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  ASSERT_EQ(record.cells.size(), 3u) << "one variant in three views";
  EXPECT_TRUE(record.timers.empty()) << "no times are wanted, so no timer is certified";
  for (const CellRow& cell : record.cells) {
    EXPECT_EQ(cell.effect, "surface");
    EXPECT_FALSE(cell.median_ms);
    EXPECT_EQ(cell.passes.size(), 1u);
    EXPECT_EQ(cell.passes.at(0).fetches, cell.passes.at(0).fragments);
  }
}

// What an effect that covers nothing takes is the time of an empty frame.
TEST_F(Compare, AnEffectThatIsInNoViewGetsNoTimeAndNoRatio) {
  square_model();
  const std::string scene =
      write("away.toml", "[scene]\nmodel = \"square.gltf\"\n[views.away]\neye = [0, 0, 5]\ntarget = [0, 0, 10]\n").string();
  const Outcome outcome =
      lamina_program("compare " + scene + few_variants + " --no-time --backend vulkan --size 64x64 --out " + out().string());
  EXPECT_SAYS(outcome.output, "layered_material covers no pixel in any view, so no time or ratio is given; check the views");
  const Record run = record();
  ASSERT_FALSE(run.cells.empty());
  for (const CellRow& cell : run.cells) {
    EXPECT_FALSE(cell.failed) << cell.reason;
    EXPECT_EQ(cell.covered_pixels, 0u);
    EXPECT_FALSE(cell.median_ms || cell.ratio_to_baseline || cell.error_covered) << cell.variant;
    EXPECT_NE(
        std::ranges::find_if(cell.notes, [](const std::string& note) { return note.find("covers no pixel") != note.npos; }),
        cell.notes.end());
  }
  for (const char* file : {"summary.md", "index.html"}) {
    std::ifstream stream(out() / file);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    EXPECT_SAYS(text, "covers no pixel in any view, so no time or ratio is given") << file;
    EXPECT_EQ(text.find("worth having\n"), std::string::npos) << file;
  }
}

TEST_F(Compare, HelmetRendersWhereItIsThere) {
  const std::filesystem::path helmet = std::filesystem::path(LAMINA_DATA_DIR) / "models/DamagedHelmet.glb";
  if (!std::filesystem::exists(helmet)) GTEST_SKIP() << helmet << " is absent: the real model is not part of the product";
  const Outcome outcome = compare(helmet.string() + " --backend vulkan" + few_variants);
  const Record record = this->record();
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  ASSERT_FALSE(record.cells.empty());
  for (const CellRow& cell : record.cells) EXPECT_FALSE(cell.failed) << cell.reason;
  ASSERT_FALSE(cells(record, "light_map").empty());
  for (const CellRow& cell : cells(record, "light_map"))
    for (const PassRow& pass : cell.passes) EXPECT_EQ(pass.once, pass.name != "composite") << "nothing moves: one light map";
}

// On an open plane the aperture is right and so is its intersection; what costs is the cosine at the middle: the sun stands 50
// degrees from the zenith, and the middle 25.
TEST_F(Compare, OpenPlaneIsHeldToItsTruth) {
  const std::string arguments =
      "open_plane --backend vulkan --variant smoothstep_cap --truth-rays 64 --cache " + (folder_ / "cache").string();
  compare(arguments);
  const Record first = record();
  ASSERT_EQ(first.bakes.size(), 1u);
  EXPECT_FALSE(first.bakes[0].from_cache);
  ASSERT_FALSE(first.cells.empty());
  for (const CellRow& cell : first.cells) {
    ASSERT_FALSE(cell.failed) << cell.reason;
    ASSERT_EQ(cell.assumptions.size(), 3u);
    std::map<std::string, double> psnr_db;
    for (const AssumptionRow& entry : cell.assumptions) psnr_db[entry.name] = entry.error.psnr_db;
    EXPECT_GE(psnr_db.at("aperture"), 40);
    EXPECT_GE(psnr_db.at("intersection"), 55);
    EXPECT_LE(psnr_db.at("cosine"), 30);
    EXPECT_NEAR(cell.error_truth->psnr_db, psnr_db.at("cosine"), 2);
    EXPECT_TRUE(std::filesystem::exists(out() / cell.truth_image));
  }
  // A second run casts no ray and says the same.
  compare(arguments);
  const Record second = record();
  EXPECT_TRUE(second.bakes.at(0).from_cache);
  ASSERT_EQ(second.cells.size(), first.cells.size());
  for (size_t i = 0; i < first.cells.size(); ++i) {
    EXPECT_EQ(second.cells[i].image_hash, first.cells[i].image_hash);
    EXPECT_EQ(to_json(second.cells[i])["error"], to_json(first.cells[i])["error"]);
  }
}

}  // namespace
}  // namespace lamina
