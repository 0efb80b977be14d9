// SPDX-License-Identifier: Apache-2.0
// Textures that are needed at different times: where they lie in one memory, which are one, and that each holds what was put
// there for as long as it is needed.
#include "harness/backend/common/shared_memory.h"

#include <map>
#include <random>
#include <set>

#include "tests/backend/rig.h"

namespace lamina {
namespace {

std::vector<uint32_t> places_of(const Lifetime& life) {
  std::vector<uint32_t> places;
  for (uint32_t at = life.first; at <= life.last; ++at) places.push_back(at);
  return places;
}

TEST(MemoryPlaces, AreWorkedOutByHandForAFew) {
  const auto bytes_of_all = [](std::vector<MemoryNeed> needs) { return place_in_memory(needs).bytes; };
  EXPECT_EQ(bytes_of_all({}), 0u);
  EXPECT_EQ(bytes_of_all({{100, 1, {0, 1}}, {60, 1, {2, 3}}, {70, 1, {4, 4}}}), 100u) << "one after the other";
  EXPECT_EQ(bytes_of_all({{100, 1, {0, 2}}, {60, 1, {2, 3}}, {70, 1, {1, 4}}}), 230u) << "all at place 2";
  EXPECT_EQ(bytes_of_all({{100, 1, {0, 1}}, {100, 1, {1, 2}}, {100, 1, {2, 3}}}), 200u) << "a chain of two at a time";
  EXPECT_EQ(bytes_of_all({{100, 1, {0, 3}}, {60, 1, {0, 1}}, {50, 1, {2, 3}}}), 160u) << "two behind one";
  EXPECT_EQ(bytes_of_all({{100, 64, {0, 1}}, {60, 64, {0, 1}}}), 188u) << "the second starts at 128";
}

// Three that follow each other leave a gap, in which a small one lies for as long as the two around it.
TEST(MemoryPlaces, AGapIsUsed) {
  const std::vector<MemoryNeed> needs = {{40, 1, {0, 0}}, {30, 1, {0, 4}}, {20, 1, {0, 4}}, {10, 1, {1, 4}}};
  const MemoryPlaces places = place_in_memory(needs);
  EXPECT_EQ(places.bytes, 90u);
  EXPECT_EQ(places.offsets[3], 0u) << "where the first was";
}

TEST(MemoryPlaces, WhatIsNeededAtOneTimeNeverOverlaps) {
  std::mt19937 bits(7);
  const auto below = [&](uint32_t count) { return static_cast<uint32_t>(bits() % count); };
  for (int trial = 0; trial < 400; ++trial) {
    std::vector<MemoryNeed> needs;
    for (uint32_t i = below(24); i-- > 0;) {
      const uint32_t first = below(12);
      needs.push_back({1 + below(500), uint64_t{1} << below(8), {first, first + below(6)}});
    }
    const MemoryPlaces places = place_in_memory(needs);
    uint64_t end = 0, at_most = 0, peak = 0;
    for (size_t i = 0; i < needs.size(); ++i) {
      EXPECT_EQ(places.offsets[i] % needs[i].alignment, 0u);
      end = std::max(end, places.offsets[i] + needs[i].bytes);
      at_most += needs[i].bytes + needs[i].alignment - 1;
      uint64_t alive = 0;
      for (size_t j = 0; j < needs.size(); ++j) {
        const Lifetime &a = needs[i].lifetime, &b = needs[j].lifetime;
        if (b.first <= a.first && a.first <= b.last) alive += needs[j].bytes;
        if (j <= i || a.last < b.first || b.last < a.first) continue;
        EXPECT_TRUE(places.offsets[i] + needs[i].bytes <= places.offsets[j] ||
                    places.offsets[j] + needs[j].bytes <= places.offsets[i])
            << "trial " << trial << ": " << i << " and " << j;
      }
      peak = std::max(peak, alive);
    }
    EXPECT_EQ(places.bytes, end);
    EXPECT_LE(places.bytes, at_most);
    EXPECT_GE(places.bytes, peak) << "what is needed at one time";
  }
}

// The fewest textures are as many as are needed at one time (the chromatic number of an interval graph is its largest clique).
TEST(ReusedTextures, AreAsFewAsAreNeededAtOneTime) {
  std::mt19937 bits(11);
  const auto below = [&](uint32_t count) { return static_cast<uint32_t>(bits() % count); };
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<TransientDesc> descs;
    for (uint32_t i = below(24); i-- > 0;) {
      const uint32_t first = below(12);
      descs.push_back({{.width = 1 + below(2), .format = below(2) ? Format::r32_float : Format::rgba8_unorm},
                       Lifetime{first, first + below(5)}});
      if (below(6) == 0) descs.back().lifetime.reset();
    }
    const std::vector<size_t> which = reused_textures(descs);
    const auto kind = [&](size_t i) { return std::pair(descs[i].texture.width, descs[i].texture.format); };
    std::map<std::pair<uint32_t, Format>, std::set<size_t>> made;
    std::map<std::pair<uint32_t, Format>, std::map<uint32_t, size_t>> needed;  // by place
    for (size_t i = 0; i < descs.size(); ++i) {
      EXPECT_EQ(which[which[i]], which[i]);
      EXPECT_EQ(kind(which[i]), kind(i));
      if (!descs[i].lifetime) {
        EXPECT_EQ(which[i], i) << "what is always needed is its own";
        continue;
      }
      made[kind(i)].insert(which[i]);
      for (const uint32_t place : places_of(*descs[i].lifetime)) ++needed[kind(i)][place];
      for (size_t j = 0; j < i; ++j)
        if (which[j] == which[i] && descs[j].lifetime) {
          EXPECT_FALSE(overlap(*descs[i].lifetime, *descs[j].lifetime));
        }
    }
    for (const auto& [of, textures] : made) {
      size_t most = 0;
      for (const auto& [place, count] : needed[of]) most = std::max(most, count);
      EXPECT_EQ(textures.size(), most) << "trial " << trial;
    }
  }
}

TEST(ReusedTextures, OnlyThoseThatAreAlikeAreOne) {
  const TextureDesc plain{.width = 8, .height = 8, .levels = 4, .format = Format::r32_float, .target = true};
  std::vector<TextureDesc> others(7, plain);
  others[1].width = 9, others[2].height = 9, others[3].levels = 3, others[4].format = Format::rgba8_unorm;
  others[5].storage = true, others[6].target = false;
  for (size_t i = 0; i < others.size(); ++i) {
    const std::vector<TransientDesc> pair = {{plain, Lifetime{0, 1}}, {others[i], Lifetime{2, 3}}};
    EXPECT_EQ(reused_textures(pair)[1], i == 0 ? 0u : 1u) << i;
  }
}

class BackendSharedMemory : public BackendTest {
 protected:
  static Pass fill(TextureId color, float value, Load load = Load::clear) {
    Pass pass = raster(color, {}, load);
    pass.colors[0].clear = {value, value, value, value};
    return pass;
  }
  static Pass copied(TextureId from, TextureId to) {
    return {.name = "test copy", .kind = PassKind::copy, .copy_from = from, .copy_to = to};
  }
  static TextureDesc desc(Format format = Format::r32_float, uint32_t levels = 1) {
    return {.name = "transient", .width = 64, .height = 32, .levels = levels, .format = format, .target = true};
  }
};
LAMINA_ON_EVERY_BACKEND(BackendSharedMemory);

// Frame after frame, and in any order: each brings what was put into it to where it is needed.
TEST_P(BackendSharedMemory, EachHoldsWhatWasPutThereForAsLongAsItIsNeeded) {
  const std::vector<TransientDesc> descs = {{desc(), Lifetime{0, 1}},
                                            {desc(), Lifetime{2, 3}},
                                            {desc(), Lifetime{1, 2}},
                                            {desc(), std::nullopt},
                                            {desc(), std::nullopt}};
  const PlacedTextures made = backend().create_textures(descs);
  ASSERT_EQ(made.textures.size(), 5u);
  const auto [first, second, between, kept, other] =
      std::tuple(made.textures[0], made.textures[1], made.textures[2], made.textures[3], made.textures[4]);
  EXPECT_GE(made.bytes_alone, 5 * 64 * 32 * 4u);
  EXPECT_EQ(made.bytes, made.bytes_alone / 5 * 4) << "two of three lie in one place";
  EXPECT_EQ(first == second, backend().info().api == Api::opengl);
  for (float frame = 1; frame < 4; ++frame) {
    run({fill(first, frame), copied(first, between), fill(second, 10 * frame), copied(second, kept)});
    run({fill(first, 100 * frame), copied(first, between), copied(between, other)});
    EXPECT_EQ(read<float>(kept), std::vector<float>(64 * 32, 10 * frame));
    EXPECT_EQ(read<float>(other), std::vector<float>(64 * 32, 100 * frame));
  }
  for (const TextureId id : std::set<TextureId>(made.textures.begin(), made.textures.end())) backend().destroy(id);
}

// Formats, sizes and levels that differ lie in one memory on Vulkan alone; a depth and a colour too.
TEST_P(BackendSharedMemory, WhatIsNotAlikeSharesMemoryWhereTheApiCan) {
  TextureDesc depth = desc(Format::d32_float);
  depth.width = 17;
  const std::vector<TransientDesc> descs = {{desc(Format::rgba8_unorm, 3), Lifetime{0, 0}}, {depth, Lifetime{1, 1}}};
  const PlacedTextures made = backend().create_textures(descs);
  EXPECT_NE(made.textures[0], made.textures[1]);
  if (backend().info().api == Api::opengl)
    EXPECT_EQ(made.bytes, made.bytes_alone);
  else
    EXPECT_LE(made.bytes, made.bytes_alone);
  Pass deep{.name = "deep"};
  deep.depth = Attachment{.texture = made.textures[1], .clear = {0.25f}};
  run({fill(made.textures[0], 1), deep});
  EXPECT_EQ(read<float>(made.textures[1]), std::vector<float>(17 * 32, 0.25f));
}

TEST_P(BackendSharedMemory, AloneNothingIsShared) {
  const std::vector<TransientDesc> descs(3, {desc(), std::nullopt});
  const PlacedTextures made = backend().create_textures(descs);
  EXPECT_EQ(made.bytes, made.bytes_alone);
  EXPECT_EQ(std::set<TextureId>(made.textures.begin(), made.textures.end()).size(), 3u);
}

// What another texture has had the memory of since is not read, kept, copied or drawn with: by name, and nothing is done.
TEST_P(BackendSharedMemory, WhatIsLostIsNotRead) {
  if (backend().info().api == Api::opengl) GTEST_SKIP() << "the two are one texture";
  const std::vector<TransientDesc> descs = {{desc(), Lifetime{0, 0}}, {desc(), Lifetime{1, 1}}, {desc(), std::nullopt}};
  const PlacedTextures made = backend().create_textures(descs);
  const auto [first, second, kept] = std::tuple(made.textures[0], made.textures[1], made.textures[2]);
  EXPECT_THROW(read<float>(first), Error) << "nothing is there yet";
  run({fill(first, 1), fill(second, 2)});
  const auto refused = [&](const std::vector<Pass>& passes) {
    const Error error = error_of([&] { run(passes); });
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_NE(std::string(error.what()).find("transient"), std::string::npos) << error.what();
  };
  EXPECT_THROW(read<float>(first), Error);
  refused({fill(first, 5, Load::keep)});
  refused({copied(first, kept)});
  refused({fill(kept, 0), fill(second, 3), copied(first, kept)});
  EXPECT_EQ(read<float>(second), std::vector<float>(64 * 32, 2)) << "what was refused was not begun";
  Pass both = fill(first, 1);
  both.colors.push_back(fill(second, 1).colors[0]);
  refused({both});
  run({fill(first, 4), copied(first, kept)});
  EXPECT_EQ(read<float>(kept), std::vector<float>(64 * 32, 4));
  EXPECT_THROW(read<float>(second), Error);
}

TEST_P(BackendSharedMemory, EachLevelIsFilledBeforeItIsRead) {
  if (backend().info().api == Api::opengl) GTEST_SKIP() << "OpenGL does not tell";
  const std::vector<TransientDesc> descs = {{desc(Format::r32_float, 2), Lifetime{0, 0}}, {desc(), Lifetime{1, 1}}};
  const PlacedTextures made = backend().create_textures(descs);
  const TextureId over = target(Format::rgba32_float, 2, 2);
  Draw look = triangles(pipeline(full_screen, R"(
layout(binding = 0) uniform sampler2D t;
layout(location = 0) out vec4 c;
void main() { c = vec4(textureLod(t, vec2(0.5), 1).r); })"));
  look.textures = {{.binding = 0, .texture = made.textures[0]}};
  const Pass mips{.name = "mips", .kind = PassKind::mips, .mips_of = made.textures[0]};
  EXPECT_THROW(run({fill(made.textures[0], 3), raster(over, {look})}), Error) << "level 1 holds nothing";
  run({fill(made.textures[0], 3), mips, raster(over, {look})});
  EXPECT_EQ(picture(over, 2).at(0, 0), 3);
  run({fill(made.textures[1], 1)});
  EXPECT_THROW(run({raster(over, {look})}), Error);
}

}  // namespace
}  // namespace lamina
