// SPDX-License-Identifier: Apache-2.0
// An effect that the product does not have, given by --variants-dir, is as good as a built-in one: tests/data/effects/lantern
// has numbers, words, textures of objects and scene, a fact, a feature, a table computed once, a shadow map, a mirror view and
// three variants, and no C++.
#include <algorithm>
#include <map>
#include <set>

#include "tests/cli/program.h"

namespace lamina {
namespace {

const std::string data = LAMINA_SOURCE_DIR "/tests/data/effects";
const std::string with_effect = " --variants-dir " + data;
const std::string small = with_effect + " --size 96x96 --cache \"\" --no-time";

class DeclaredEffect : public ProgramTest {
 protected:
  // The lantern's scene, with these lines changed.
  std::string scene(const std::vector<std::pair<std::string, std::string>>& changes = {}) {
    std::ifstream in(LAMINA_SOURCE_DIR "/tests/data/scenes/lantern.toml");
    std::string text((std::istreambuf_iterator<char>(in)), {});
    for (const auto& [from, to] : changes) {
      const size_t at = text.find(from);
      EXPECT_NE(at, std::string::npos) << from;
      text.replace(at, from.size(), to);
    }
    return write("lantern.toml", text).string();
  }
  Outcome sweep(const std::string& set, const std::string& folder = "out") {
    return lamina_program("sweep " + scene() + with_effect + " --size 64x64 --time none --cache \"\" --backend vulkan --out " +
                          (folder_ / folder).string() + " --set " + set);
  }
  std::vector<CellRow> cells(const std::string& variant) const {
    std::vector<CellRow> found;
    for (const CellRow& cell : record().cells)
      if (cell.variant == variant) found.push_back(cell);
    return found;
  }
};

TEST_F(DeclaredEffect, IsListedWithItsVariantsAndNumbers) {
  const Outcome listed = lamina_program("list" + with_effect);
  EXPECT_SAYS(listed.output, "effect lantern: A lamp shade, its shadow and its mirror image");
  for (const char* variant : {"lantern_full", "lantern_sky", "lantern_plain"}) EXPECT_SAYS(listed.output, variant);
  EXPECT_SAYS(listed.output, "parameter shadow_texels");
  const Outcome parameters = lamina_program("list --parameters " + scene() + with_effect);
  ASSERT_EQ(parameters.status, 0) << parameters.output;
  for (const char* path : {"objects.sphere.lantern.glow", "objects.*.lantern.glow", "objects.sphere.lantern.holes",
                           "objects.sphere.lantern.tint", "effects.lantern.level", "lantern_full.shadow_texels"})
    EXPECT_SAYS(parameters.output, path);
}

TEST_F(DeclaredEffect, IsPlannedWithReasons) {
  const Outcome plan = lamina_program("plan " + scene() + with_effect);
  ASSERT_EQ(plan.status, 0) << plan.output;
  EXPECT_SAYS(plan.output, "lantern: called for: an object is a lamp shade");
  EXPECT_SAYS(plan.output, "with HOLES: the shade has holes, and light inside");
  EXPECT_SAYS(plan.output, "aperture_lighting: not called for");
  EXPECT_SAYS(plan.output, "once for the scene");
}

// Both backends draw the same, the cheaper variants err, and what each reads is counted.
TEST_F(DeclaredEffect, IsCompared) {
  const Outcome outcome = lamina_program("compare " + scene() + small + " --out " + out().string());
  std::map<std::string, std::set<std::string>> read;
  for (const CellRow& cell : record().cells) {
    ASSERT_FALSE(cell.failed) << cell.reason;
    EXPECT_EQ(cell.effect, "lantern");
    EXPECT_EQ(cell.params.at("objects.sphere.lantern.glow"), 0.5);
    EXPECT_EQ(cell.params.at("effects.lantern.level"), 0);
    EXPECT_EQ(cell.words.at("objects.sphere.lantern.tint"), "warm");
    EXPECT_GT(*cell.covered_pixels, 100u);
    for (const PassRow& pass : cell.passes)
      if (pass.name == "light")
        for (const TextureFetches& fetched : pass.by_texture) read[cell.variant].insert(fetched.texture);
    if (cell.variant != "lantern_full") {
      EXPECT_LT(cell.error_covered->ssim, 0.9999);
    }
  }
  size_t pairs = 0;
  const Record record = this->record();
  for (const CellRow& vulkan : record.cells)
    for (const CellRow& opengl : record.cells) {
      if (vulkan.backend != "vulkan" || opengl.backend != "osmesa" || vulkan.variant != opengl.variant) continue;
      ++pairs;
      EXPECT_GE(psnr_db(picture(opengl), picture(vulkan)), 45) << vulkan.image;
      EXPECT_EQ(opengl.fetches, vulkan.fetches) << vulkan.image;
    }
  EXPECT_EQ(pairs, 3u) << "variants, in the one view";
  EXPECT_EQ(read.at("lantern_full"), (std::set<std::string>{"shade", "grain", "falloff", "shadow_0", "mirrored"}));
  EXPECT_EQ(read.at("lantern_sky"), (std::set<std::string>{"shade", "grain", "falloff", "shadow_0", "sky"}));
  EXPECT_EQ(read.at("lantern_plain"), (std::set<std::string>{"shade", "grain", "falloff", "sky"}));
}

// Without holes, or without light inside, the feature goes, and with it the code: the plan says why.
TEST_F(DeclaredEffect, IsCulled) {
  for (const char* change : {"holes = 0", "holes = 0.3\nglow = 0"}) {
    const Outcome plan = lamina_program("plan " + scene({{"holes = 0.3", change}}) + with_effect);
    ASSERT_EQ(plan.status, 0) << plan.output;
    EXPECT_SAYS(plan.output, "without HOLES: the shade is whole, or dark");
  }
  const Outcome plan = lamina_program("plan sphere_over_plane" + with_effect);
  EXPECT_SAYS(plan.output, "lantern: not called for: no object is a lamp shade");
}

// Another picture with every step of the number; a word, a scene's number and a variant's parameter are swept alike.
TEST_F(DeclaredEffect, IsSwept) {
  ASSERT_EQ(sweep("objects.sphere.lantern.glow=0:2:1").status, 0);
  std::set<std::string> of_glow;
  for (const CellRow& cell : cells("lantern_plain")) of_glow.insert(cell.image_hash);
  EXPECT_EQ(of_glow.size(), 3u);
  const Outcome word = sweep("objects.sphere.lantern.tint=warm,cold", "word");
  ASSERT_EQ(word.status, 0) << word.output;
  std::map<std::string, std::string> picture;
  for (const CellRow& cell : read_record(folder_ / "word/record.jsonl").cells)
    if (cell.variant == "lantern_plain") picture[cell.words.at("objects.sphere.lantern.tint")] = cell.image_hash;
  EXPECT_EQ(picture.size(), 2u);
  EXPECT_NE(picture["warm"], picture["cold"]);
  const Outcome own = sweep("lantern_full.shadow_texels=16,256", "own");
  ASSERT_EQ(own.status, 0) << own.output;
  std::set<std::string> pictures;
  for (const CellRow& cell : read_record(folder_ / "own/record.jsonl").cells)
    if (cell.variant == "lantern_full") pictures.insert(cell.image_hash);
  EXPECT_EQ(pictures.size(), 2u) << "a coarse shadow is another picture";
}

// The same command has nothing left to do; another number in the scene is another sweep.
TEST_F(DeclaredEffect, IsResumed) {
  ASSERT_EQ(sweep("effects.lantern.level=-1,0").status, 0);
  const Outcome again = sweep("effects.lantern.level=-1,0");
  EXPECT_EQ(again.status, 0);
  EXPECT_SAYS(again.output, "6 cells are there, 0 to go");
  scene({{"holes = 0.3", "holes = 0.4"}});
  const Outcome other = lamina_program("sweep " + (folder_ / "lantern.toml").string() + with_effect +
                                       " --size 64x64 --time none --cache \"\" --backend vulkan --out " + out().string() +
                                       " --set effects.lantern.level=-1,0");
  EXPECT_EQ(other.status, 2) << other.output;
}

TEST_F(DeclaredEffect, IsGated) {
  std::filesystem::create_directories(folder_ / "mine");
  std::filesystem::copy(data + "/lantern", folder_ / "mine/lantern", std::filesystem::copy_options::recursive);
  const std::string against = "gate " + scene() + " --variants-dir " + (folder_ / "mine").string() +
                              " --size 64x64 --no-time --cache \"\" --backend osmesa --baseline " +
                              (folder_ / "base.jsonl").string() + " --out " + out().string();
  const Outcome stored = lamina_program(against + " --update");
  ASSERT_EQ(stored.status, 0) << stored.output;
  EXPECT_EQ(lamina_program(against).status, 0);
  std::ifstream in(folder_ / "mine/lantern/lantern.frag");
  std::string text((std::istreambuf_iterator<char>(in)), {});
  text.replace(text.find("0.4 * foot"), 10, "0.5 * foot");
  write("mine/lantern/lantern.frag", text);
  EXPECT_EQ(lamina_program(against).status, 1) << "a darker picture";
}

// One message each, file and line, status 2.
TEST_F(DeclaredEffect, MistakesOfSceneFilesAreNamed) {
  const auto refused = [&](const std::vector<std::pair<std::string, std::string>>& changes, const std::string& words) {
    const Outcome outcome = lamina_program("plan " + scene(changes) + with_effect);
    EXPECT_EQ(outcome.status, 2) << outcome.output;
    EXPECT_SAYS(outcome.output, words);
  };
  refused({{"holes = 0.3", "hole = 0.3"}}, "lantern.toml:12: unknown key 'hole' (did you mean 'holes'?)");
  refused({{"holes = 0.3", "glow = 5"}}, "lantern.toml:12: 'glow' must be a number from 0 to 4");
  refused({{"holes = 0.3", "tint = \"wam\""}}, "lantern.toml:12: unknown tint 'wam' (did you mean 'warm'?)");
  refused({{"[objects.sphere]\nlit = true", "[objects.sphere]\nlit = false"}},
          "'lit = false' takes the object out of lantern; leave out lantern");
  refused({{"[objects.sphere]\nlit = true", "[objects.sphere]\nthickness = 3"}},
          "an object has layered_material or lantern; leave out thickness, or lantern");
  refused({{"[effects.lantern]", "[effects.lantrn]"}}, "did you mean 'lantern'?");
  refused({{"casts = true", "casts = false"}}, "full.toml:");
}

// No one view shows what a light among the objects lights.
TEST_F(DeclaredEffect, ALightAmongTheObjectsHasNoView) {
  const Outcome outcome = lamina_program(
      "compare " +
      scene({{"kind = \"directional\"\ndirection = [0.8, -1.0, -0.6]", "kind = \"point\"\nposition = [0, 1.5, 0]"}}) + small +
      " --backend osmesa --out " + out().string());
  EXPECT_EQ(outcome.status, 2) << outcome.output;
  EXPECT_SAYS(outcome.output, "light 'sun' stands among the objects");
}

// An effect of hulls refuses a mesh with an edge that is open, and says where it is.
TEST_F(DeclaredEffect, OpenHullsAreRefusedWithTheirEdge) {
  std::filesystem::create_directories(folder_ / "hulls/glass");
  write("hulls/glass/effect.toml", R"([effect]
name = "glass"
title = "Glass"
key = "glass"
closed = true
solid = false
instead_of = ["layered_material", "aperture_lighting"]
because = "an object is of glass"
not_because = "no object is of glass"
)");
  write("hulls/glass/clear.toml", R"([variant]
name = "clear"
baseline = true
[[pass]]
name = "front"
draw = "objects"
vertex = "common/object.vert"
fragment = "clear.frag"
write = ["frame"]
)");
  write("hulls/glass/clear.frag", "layout(location = 0) out vec4 color;\nvoid main() { color = vec4(1.0); }\n");
  write("glass.toml", "[scene]\nbuiltin = \"sphere_over_plane\"\n[objects.plane]\nglass = true\n");
  const Outcome open =
      lamina_program("plan " + (folder_ / "glass.toml").string() + " --variants-dir " + (folder_ / "hulls").string());
  EXPECT_EQ(open.status, 2) << open.output;
  EXPECT_SAYS(open.output, "object 'plane': glass needs a closed hull, and its mesh is open: the edge from (");
}

}  // namespace
}  // namespace lamina
