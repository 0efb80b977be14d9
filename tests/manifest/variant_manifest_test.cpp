// SPDX-License-Identifier: Apache-2.0
// Manifests: what the built-in ones say, and that every mistake in a user's own is one message with file, line and what to do.
#include <gtest/gtest.h>

#include <algorithm>

#include "harness/manifest/library.h"
#include "tests/manifest/user_folder.h"

namespace lamina {
namespace {

namespace fs = std::filesystem;

class UserVariant : public UserFolder {
 protected:
  // What loading with this manifest says; "" when it loads.
  std::string refusal(const std::string& text) {
    write("mine.toml", text);
    return loading_says();
  }
};

const std::string head = "[variant]\nname = \"mine\"\neffect = \"layered_material\"\n";
const std::string pass =
    "[[pass]]\nname = \"composite\"\ndraw = \"objects\"\nvertex = \"common/object.vert\"\nfragment = "
    "\"surface/lambert.frag\"\nwrite = [\"frame\"]\n";

TEST(BuiltinVariants, BaselineComesFirst) {
  const Library library = load_library(LAMINA_SOURCE_DIR, effect_code());
  const EffectManifest& effect = library.effect("layered_material");
  ASSERT_GT(effect.variants.size(), 3u);
  EXPECT_EQ(effect.baseline().name, "light_map");
  const auto by_name = [](const VariantManifest& a, const VariantManifest& b) { return a.name < b.name; };
  EXPECT_TRUE(std::is_sorted(effect.variants.begin() + 1, effect.variants.end(), by_name))
      << "the others by their files' names";
  EXPECT_EQ(effect.variant("normal_map_tap"), nullptr);
  const VariantManifest* taps = effect.variant("normal_map_taps");
  ASSERT_NE(taps, nullptr);
  EXPECT_EQ(taps->targets.size(), 0u) << "the first optimization has no off-screen target";
}

TEST(BuiltinVariants, UnknownEffectNamesTheNearest) {
  try {
    load_library(LAMINA_SOURCE_DIR, effect_code()).effect("layered_materia");
    FAIL();
  } catch (const Error& error) {
    EXPECT_SAYS(std::string(error.what()), "did you mean 'layered_material'?");
  }
}

TEST_F(UserVariant, LoadsBesideTheBuiltInOnes) {
  write("mine.toml", head + pass);
  const Library library = load_library(LAMINA_SOURCE_DIR, effect_code(), {folder_});
  EXPECT_EQ(library.effect("layered_material").variants.back().name, "mine");
}

TEST_F(UserVariant, IsLikeAnotherButForWhatItSays) {
  const std::string base =
      "[variant]\nname = \"base\"\neffect = \"layered_material\"\n[parameters.taps]\nvalue = 3\nmin = 1\n"
      "[targets.a]\nformat = \"r8_unorm\"\n[targets.b]\nformat = \"r8_unorm\"\n";
  const std::string first =
                        "[[pass]]\nname = \"first\"\ndraw = \"fullscreen\"\nfragment = \"common/frame_as_it_is.frag\"\n"
                        "define = { X = \"1\", Y = \"2\" }\nwrite = [\"a\"]\n",
                    told =
                        "[[pass]]\nname = \"told\"\nwhen = \"truth\"\ndraw = \"fullscreen\"\nfragment = "
                        "\"common/frame_as_it_is.frag\"\nwrite = [\"b\"]\n";
  write("base.toml", base + first + told + pass);
  const std::string like = "[variant]\nname = \"mine\"\neffect = \"layered_material\"\nlike = \"base\"\n";
  const std::string own =
      "[parameters.taps]\nvalue = 5\n[targets.b]\nformat = \"r16_float\"\n"
      "[[pass]]\nname = \"first\"\ndefine = { X = \"7\" }\n"
      "[[pass]]\nname = \"second\"\nbefore = \"composite\"\ndraw = \"fullscreen\"\nfragment = "
      "\"common/frame_as_it_is.frag\"\nwrite = [\"b\"]\n";
  ASSERT_EQ(refusal(like + own), "");
  const Library library = load_library(LAMINA_SOURCE_DIR, effect_code(), {folder_});
  const VariantManifest& variant = library.effect("layered_material").variants.back();
  ASSERT_EQ(variant.name, "mine");
  ASSERT_EQ(variant.passes.size(), 3u) << "a pass for the truth alone stays with the other";
  EXPECT_EQ(variant.passes[0].name, "first");
  EXPECT_EQ(variant.passes[0].defines, (std::map<std::string, std::string>{{"X", "7"}, {"Y", "2"}}));
  EXPECT_EQ(variant.passes[1].name, "second");
  EXPECT_EQ(variant.passes[2].name, "composite");
  EXPECT_EQ(variant.target("a")->format, Format::r8_unorm);
  EXPECT_EQ(variant.target("b")->format, Format::r16_float);
  EXPECT_EQ(variant.parameter("taps")->value, 5);

  EXPECT_EQ(refusal("[variant]\nname = \"mine\"\neffect = \"layered_material\"\nlike = \"base\"\nleave_out = [\"first\"]\n"),
            "");
  EXPECT_SAYS(refusal(like + "leave_out = [\"third\"]\n"), "mine.toml:5: ");
  EXPECT_SAYS(refusal(like + "leave_out = [\"third\"]\n"), "base.toml has no such pass");
  EXPECT_SAYS(refusal("[variant]\nname = \"mine\"\neffect = \"layered_material\"\nlike = \"bass\"\n"), "there is no ");
  EXPECT_SAYS(refusal("[variant]\nname = \"mine\"\neffect = \"layered_material\"\nlike = \"mine\"\n"),
              "like one that is like it");
  EXPECT_SAYS(refusal(like + "[[pass]]\nname = \"x\"\nbefore = \"y\"\n"), "no pass before this one is named 'y'");
  EXPECT_SAYS(refusal(head + "leave_out = [\"first\"]\n" + pass), "'leave_out' needs 'like'");
  // A mistake in what is taken over is in the file that makes it.
  write("base.toml", base + first + "colour = 1\n" + pass);
  EXPECT_SAYS(refusal(like), "base.toml:17: unknown key 'colour'");
}

TEST_F(UserVariant, ShaderBesideTheManifestComesFirst) {
  fs::create_directories(folder_ / "surface");
  write("surface/lambert.frag", "void main() {}");
  write("mine.toml", head + pass);
  const Library library = load_library(LAMINA_SOURCE_DIR, effect_code(), {folder_});
  EXPECT_EQ(library.effect("layered_material").variants.back().passes[0].fragment,
            fs::weakly_canonical(folder_ / "surface/lambert.frag"));
}

TEST_F(UserVariant, MistakesAreNamedWithFileAndLine) {
  EXPECT_SAYS(refusal(head + "titel = \"x\"\n" + pass), "mine.toml:4: unknown key 'titel' (did you mean 'title'?)");
  EXPECT_SAYS(refusal(head + pass + "blend = \"aditive\"\n"),
              "mine.toml:10: unknown blend 'aditive' (did you mean 'additive'?)");
  EXPECT_SAYS(refusal(head + pass + "fetches = 3\n"), "mine.toml:10: unknown key 'fetches'");
  EXPECT_SAYS(refusal(head + "[targets.a]\nformat = \"rgba16_flot\"\n" + pass),
              "mine.toml:5: unknown format 'rgba16_flot' (did you mean 'rgba16_float'?)");
  EXPECT_SAYS(refusal("[variant]\nname = \"mine\"\n" + pass), "'effect' is missing");
  EXPECT_SAYS(refusal("[variant]\nname = \"mine\"\neffect = \"skinn\"\n" + pass), "unknown effect 'skinn'");
  EXPECT_SAYS(refusal(head), "at least one [[pass]]");
  EXPECT_SAYS(refusal(head + "[[pass]]\nname = 3\n"), "mine.toml:5: 'name' must be a string");
  EXPECT_SAYS(refusal(head + "[[pass]\n"), "mine.toml:4");
  EXPECT_SAYS(refusal("[variant]\nname = \"light_map\"\neffect = \"layered_material\"\n" + pass), "already defined");
  EXPECT_SAYS(refusal(head + "baseline = true\n" + pass), "already has the baseline 'light_map'");
}

TEST_F(UserVariant, PassesAreHeldToWhatTheyCanDo) {
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = head + pass;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_SAYS(refusal(with("surface/lambert.frag", "surface/lambrt.frag")),
              "mine.toml:8: shader 'surface/lambrt.frag' is neither in");
  EXPECT_SAYS(refusal(with("\"frame\"", "\"fram\"")), "unknown target 'fram' (did you mean 'frame'?)");
  EXPECT_SAYS(refusal(with("\"objects\"", "\"unwrapped\"")), "scope = \"object\"");
  EXPECT_SAYS(refusal(with("write = [\"frame\"]\n", "")), "'write' is missing");
  EXPECT_SAYS(refusal(with("fragment = \"surface/lambert.frag\"\n", "")), "needs 'vertex' and 'fragment'");
  EXPECT_SAYS(refusal(with("\"objects\"", "\"mips\"")), "'frame' has no mips");
}

TEST_F(UserVariant, PassesAreHeldToTheirTargetsAndViews) {
  const std::string targets =
      "[targets.flat]\nformat = \"rgba16_float\"\n[targets.near]\nformat = \"d32_float\"\n"
      "[targets.lit]\nscope = \"light\"\nformat = \"rgba16_float\"\n";
  const auto refused = [&](const std::string& draw, const std::string& rest) {
    const bool raster = draw == "objects" || draw == "unwrapped" || draw == "fullscreen";
    return refusal(head + targets + "[[pass]]\nname = \"p\"\ndraw = \"" + draw + "\"\n" +
                   (raster ? "vertex = \"common/object.vert\"\nfragment = \"surface/lambert.frag\"\n" : "") + rest);
  };
  EXPECT_SAYS(refused("mips", "write = [\"flat\"]\n"), "'flat' has no mips");
  EXPECT_SAYS(refused("fullscreen", "write = [\"flat\"]\nlevels = \"down\"\n"), "'flat' has no mips");
  EXPECT_SAYS(refused("fullscreen", "write = [\"near\"]\n"), "name it under 'depth_target'");
  EXPECT_SAYS(refused("objects", "write = [\"flat\", \"lit\"]\n"), "targets of one scope");
  EXPECT_SAYS(refused("objects", "write = [\"lit\"]\n"), "a view of a light, and nothing else");
  EXPECT_SAYS(refused("objects", "view = \"light\"\nwrite = [\"flat\"]\n"), "a view of a light, and nothing else");
  EXPECT_SAYS(refused("objects", "view = \"mirror\"\nwrite = [\"frame\"]\n"), "the frame is drawn from the eye");
  EXPECT_SAYS(refused("objects", "view = \"mirror\"\nwrite = [\"flat\"]\ndepth = \"read\"\n"),
              "name a 'depth_target' of this view");
  EXPECT_SAYS(refused("objects", "write = [\"flat\"]\ndepth = \"read\"\ndepth_target = \"flat\"\n"),
              "not of the format d32_float");
  EXPECT_SAYS(refused("objects", "write = [\"flat\"]\ndepth_target = \"near\"\n"), "depth is neither read nor written");
  EXPECT_SAYS(refused("objects", "write = [\"flat\"]\nblend = [\"none\", \"additive\"]\n"), "2 ways for 1 targets");
  EXPECT_SAYS(refused("fullscreen", "write = [\"flat\"]\ndepth = \"read\"\n"), "have depth");
  EXPECT_SAYS(refused("fullscreen", "write = [\"flat\"]\nof = \"all\"\n"), "choose them");
  EXPECT_SAYS(refused("objects", "write = [\"flat\"]\nof = \"all\"\nwith = \"A\"\n"), "among the effect's own objects");
  EXPECT_SAYS(refused("objects", "write = [\"flat\"]\ndepth = \"read\"\nclear_depth_again = true\n"),
              "the frame's depth is everyone's");
  EXPECT_SAYS(refused("fullscreen", "write = [\"flat\"]\nuntil_empty = true\n"), "count what they draw");
}

TEST_F(UserVariant, AnEmptyOrMissingFolderIsSaid) {
  EXPECT_THROW(load_library(LAMINA_SOURCE_DIR, effect_code(), {folder_}), Error);
  EXPECT_THROW(load_library(LAMINA_SOURCE_DIR, effect_code(), {folder_ / "no"}), Error);
}

TEST_F(UserVariant, WhatIsTriedIsWhatTheParameterTakes) {
  const std::string taps = head + "[parameters.taps]\nvalue = 3\nmin = 1\nmax = 8\nwhole = true\n";
  EXPECT_EQ(refusal(taps + "try = [1, 8]\n" + pass), "");
  EXPECT_SAYS(refusal(taps + "try = [1, 9]\n" + pass), "mine.toml:9: 'try' holds 9, which is no whole number from 1 to 8");
  EXPECT_SAYS(refusal(taps + "try = [1.5]\n" + pass), "'try' holds 1.5");
  const std::string words = head + "[parameters.kind]\nvalue = \"low\"\nof = [\"low\", \"high\"]\n";
  EXPECT_EQ(refusal(words + "try = [\"high\"]\n" + pass), "");
  EXPECT_SAYS(refusal(words + "try = [\"hig\"]\n" + pass), "unknown word 'hig' (did you mean 'high'?)");
}

}  // namespace
}  // namespace lamina
