// SPDX-License-Identifier: Apache-2.0
// Effects as data: that every mistake in an effect.toml is one message with file and line, that the built-in ones declare what
// they do, and that nothing else of the engine knows them.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>

#include "harness/core/text.h"
#include "harness/manifest/library.h"
#include "tests/manifest/user_folder.h"

namespace lamina {
namespace {

namespace fs = std::filesystem;

class UserEffect : public UserFolder {
 protected:
  void SetUp() override {
    write("wax/full.toml",
          "[variant]\nname = \"full\"\nbaseline = true\n[[pass]]\nname = \"draw\"\ndraw = \"objects\"\nvertex = "
          "\"common/object.vert\"\nfragment = \"surface/lambert.frag\"\nwrite = [\"frame\"]\n");
  }
  // What loading with this effect.toml says; "" when it loads.
  std::string refusal(const std::string& head, const std::string& rest = "") {
    write("wax/effect.toml",
          "[effect]\nname = \"wax\"\ntitle = \"t\"\nbecause = \"b\"\nnot_because = \"n\"\n" + head + "\n" + rest);
    return loading_says();
  }
};

TEST_F(UserEffect, LoadsWithAllThatItDeclares) {
  EXPECT_EQ(
      refusal("key = \"wax\"\nneeds = [\"density\"]",
              "[numbers.density]\nvalue = 1\nrange = [0, 10]\n[words.kind]\nof = [\"a\", \"b\"]\n[textures.cover]\n"
              "value = [1, 1, 1]\nalpha = \"wax.mask\"\n[facts.masked]\nseen_alpha = \"cover\"\n[features.MASK]\nneeds = "
              "[\"masked\", \"density\"]\nbecause = \"x\"\nnot_because = \"y\"\n[scene.numbers.level]\nvalue = 0\n[mirror]\n"
              "height = \"level\"\n"),
      "");
}

TEST_F(UserEffect, MistakesAreNamedWithFileAndLine) {
  EXPECT_SAYS(refusal("key = \"wax\"\nmodls = true"), "effect.toml:7: unknown key 'modls' (did you mean 'models'?)");
  EXPECT_SAYS(refusal("key = \"wax\"", "[numbers.a]\nvalue = 3\nrange = [0, 2]\n"),
              "effect.toml:8: 'value' must lie in the range, 0 to 2");
  EXPECT_SAYS(refusal("key = \"wax\"", "[numbers.a]\nrange = [2, 0]\n"), "effect.toml:8: 'range' must be [least, greatest]");
  EXPECT_SAYS(refusal("key = \"wax\"", "[textures.a]\notherwise = \"marbl\"\n"),
              "effect.toml:8: unknown otherwise 'marbl' (did you mean 'marble'?)");
  EXPECT_SAYS(refusal("key = \"wax\"", "[textures.a]\nvalue = [1]\n[facts.f]\nseen_alfa = \"a\"\n"),
              "effect.toml:10: unknown seen_alfa 'seen_alfa' (did you mean 'seen_alpha'?)");
  EXPECT_SAYS(refusal("key = \"wax\"\nbake = \"aperturs\""),
              "effect.toml:7: unknown bake 'aperturs' (did you mean 'apertures'?)");
  EXPECT_SAYS(refusal("key = \"wax\"\ntruth = \"direct_ligt\""),
              "effect.toml:7: unknown truth 'direct_ligt' (did you mean 'direct_light'?)");
  EXPECT_SAYS(
      refusal("key = \"wax\"", "[numbers.a]\nvalue = 1\n[features.F]\nneeds = [\"b\"]\nbecause = \"x\"\nnot_because = \"y\"\n"),
      "unknown fact or number 'b'");
  for (const std::string need : {"a >= much", "a >= "})
    EXPECT_SAYS(refusal("key = \"wax\"", "[numbers.a]\nvalue = 1\n[features.F]\nneeds = [\"" + need +
                                             "\"]\nbecause = \"x\"\nnot_because = \"y\"\n"),
                "'" + need + "' must be a name, or NAME >= NUMBER");
  EXPECT_SAYS(refusal("", "[numbers.a]\nvalue = 1\n"), "'key' is missing");
  EXPECT_SAYS(refusal("key = \"wax\"\ninstead_of = [\"layers\"]"), "unknown effect 'layers'");
  EXPECT_SAYS(refusal("key = \"wax\"", "[mirror]\nheight = \"level\"\n"), "unknown height 'level'");
}

TEST_F(UserEffect, AKeyMeansOneThing) {
  EXPECT_SAYS(refusal("key = \"layers\""), "the key 'layers' of objects is claimed by layered_material already");
  EXPECT_SAYS(refusal("key = \"wax\"", "[numbers.thickness]\nvalue = 1\n"), "the key 'thickness' of objects is claimed by");
  EXPECT_SAYS(refusal("key = \"wax\"", "[numbers.a]\nkey = \"outer.gloss\"\nvalue = 1\n"), "the key 'outer.gloss' of objects");
  EXPECT_SAYS(refusal("key = \"wax\"", "[numbers.position]\nvalue = 1\n"), "says where an object is");
  EXPECT_SAYS(refusal("otherwise = true"), "draws what no other effect does already");
}

TEST_F(UserEffect, WhatExcludesAnotherIsExcludedByIt) {
  ASSERT_EQ(refusal("key = \"wax\"\ninstead_of = [\"layered_material\"]"), "");
  const Library library = load_library(LAMINA_SOURCE_DIR, effect_code(), {folder_});
  const auto excludes = [&](const char* effect, const char* other) {
    const std::vector<std::string>& names = library.effect(effect).instead_of;
    return std::find(names.begin(), names.end(), other) != names.end();
  };
  EXPECT_TRUE(excludes("wax", "layered_material"));
  EXPECT_TRUE(excludes("layered_material", "wax"));
  EXPECT_FALSE(excludes("aperture_lighting", "wax"));
}

TEST_F(UserEffect, AMirrorNeedsAPlane) {
  write("wax/mirrored.toml",
        "[variant]\nname = \"mirrored\"\n[targets.seen]\nformat = \"rgba16_float\"\n[[pass]]\nname = \"look\"\ndraw = "
        "\"objects\"\n"
        "view = \"mirror\"\nvertex = \"common/object.vert\"\nfragment = \"surface/lambert.frag\"\nwrite = [\"seen\"]\n");
  EXPECT_SAYS(refusal("key = \"wax\""), "mirrored.toml:5: a view of kind mirror needs a plane");
  EXPECT_EQ(refusal("key = \"wax\"", "[mirror]\n"), "");
}

// Its own objects are drawn from the eye alone; others may be drawn from a mirror.
TEST_F(UserEffect, WhatIsLeftOutUnseenIsDrawnFromTheEye) {
  const auto mirrored = [&](const std::string& of) {
    write("wax/mirrored.toml",
          "[variant]\nname = \"mirrored\"\n[targets.seen]\nformat = \"rgba16_float\"\n[[pass]]\nname = \"look\"\ndraw = "
          "\"objects\"\n" +
              of +
              "view = \"mirror\"\nvertex = \"common/object.vert\"\nfragment = \"surface/lambert.frag\"\nwrite = [\"seen\"]\n");
    return refusal("key = \"wax\"\nonly_where_seen = true", "[mirror]\n");
  };
  EXPECT_SAYS(mirrored(""),
              "mirrored.toml:5: pass 'look' draws the effect's objects not from the eye: remove 'only_where_seen");
  EXPECT_EQ(mirrored("of = \"opaque\"\n"), "");
}

// Whether the word stands in the line, and not as a part of a longer one.
bool holds_word(const std::string& line, const std::string& word) {
  const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  for (size_t at = 0; (at = line.find(word, at)) != std::string::npos; ++at) {
    const size_t end = at + word.size();
    if ((at == 0 || !is_part(line[at - 1]) || word[0] == '"') && (end == line.size() || !is_part(line[end]) || word[0] == '"'))
      return true;
  }
  return false;
}

// No file of the engine outside harness/effects/ names an effect, its keys or its textures; scenes made by code are content and
// may.
TEST(Engine, KnowsNoEffectByName) {
  const Library library = load_library(LAMINA_SOURCE_DIR, effect_code());
  std::vector<std::string> anywhere, quoted;  // whole words; words between quotation marks
  const auto add = [&](const std::string& key) {
    if (key.empty()) return;
    (key.find_first_of("._") == std::string::npos ? quoted : anywhere).push_back(key);
  };
  for (const EffectManifest& effect : library.effects) {
    add(effect.key);
    (effect.name.find('_') == std::string::npos ? quoted : anywhere).push_back(effect.name);
    for (const NumberManifest& number : effect.object.numbers) add(number.key);
    for (const WordManifest& word : effect.object.words) add(word.key);
    for (const TextureManifest& texture : effect.object.textures) add(texture.name), add(texture.rgb), add(texture.alpha);
    add(effect.baker), add(effect.truth);
  }
  ASSERT_GT(anywhere.size(), 5u);
  for (const std::string& word : quoted) anywhere.push_back('"' + word + '"');
  size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(LAMINA_SOURCE_DIR) / "harness")) {
    const std::string path = entry.path().string();
    if (!entry.is_regular_file() || path.find("/harness/effects/") != std::string::npos ||
        path.find("/harness/scene/made/") != std::string::npos)
      continue;
    ++files;
    const bool reads_gltf = path.find("/harness/scene/gltf/") != std::string::npos;
    std::istringstream text(read_file(entry.path(), "test"));
    size_t number = 0;
    for (std::string line; std::getline(text, line);) {
      ++number;
      for (const std::string& word : anywhere) {
        if (reads_gltf && word == "\"skin\"") continue;  // glTF's own name for the joints of a mesh
        EXPECT_FALSE(holds_word(line, word)) << path << ":" << number << ": " << line;
      }
    }
  }
  EXPECT_GT(files, 100u);
}

// The linker joins types of one name without a word, however they differ.
TEST(Engine, GivesEveryTypeOfItsHeadersANameOfItsOwn) {
  std::map<std::string, std::string> header_of;  // by namespace and name
  for (const char* folder : {"harness", "reports"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(LAMINA_SOURCE_DIR) / folder)) {
      if (entry.path().extension() != ".h") continue;
      std::istringstream text(read_file(entry.path(), "test"));
      std::string within;
      bool is_template = false;  // whose types are told apart by their arguments
      for (std::string line; std::getline(text, line); is_template = line.starts_with("template ")) {
        if (line.starts_with("namespace ")) within = line;
        for (const std::string begin : {"struct ", "class ", "enum class "}) {
          if (is_template || !line.starts_with(begin) || line.ends_with(";")) continue;
          const std::string name = line.substr(begin.size(), line.find_first_of(" {", begin.size()) - begin.size());
          const auto [other, is_new] = header_of.emplace(within + name, entry.path().string());
          EXPECT_TRUE(is_new) << entry.path() << " and " << other->second << " have a " << name;
        }
      }
    }
  EXPECT_GT(header_of.size(), 150u);
}

TEST(BuiltinEffects, WhatAQuickComparisonLooksAtIsThere) {
  size_t named = 0;
  for (const EffectManifest& effect : load_library(LAMINA_SOURCE_DIR, effect_code()).effects)
    for (const std::string& name : effect.quick) {
      ++named;
      EXPECT_NE(effect.variant(name), nullptr) << effect.name << ": " << name;
    }
  EXPECT_GT(named, 8u);
}

}  // namespace
}  // namespace lamina
