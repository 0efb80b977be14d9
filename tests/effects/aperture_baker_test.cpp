// SPDX-License-Identifier: Apache-2.0
// What variants may ask of the baker of apertures, and that it gives what it promises.
#include "harness/effects/aperture_lighting/aperture_baker.h"

#include <gtest/gtest.h>

#include "tests/effects/made_scenes.h"

namespace lamina {
namespace {

std::string problem(const BakeOptions& options) { return aperture_baker.problem(options); }

TEST(ApertureBaker, TakesOneToFourOrAnAntiAperture) {
  for (const BakeOptions& good :
       {BakeOptions{}, {{"count", 1}}, {{"count", 4}}, {{"anti", 1}}, {{"count", 1}, {"anti", 1}}, {{"count", 3}, {"anti", 0}}})
    EXPECT_EQ(problem(good), "");
  for (const double count : {0.0, 5.0, 1.5, -1.0}) EXPECT_NE(problem({{"count", count}}).find("'count'"), std::string::npos);
  for (const double anti : {2.0, -1.0, 0.5}) EXPECT_NE(problem({{"anti", anti}}).find("'anti'"), std::string::npos);
  EXPECT_NE(problem({{"count", 2}, {"anti", 1}}).find("leave out 'count'"), std::string::npos);
  EXPECT_EQ(problem({{"soft", 1}, {"choice", 0}}), "");
  EXPECT_EQ(problem({{"choice", 1}}), "");
  for (const std::string name : {"soft", "choice"}) {
    EXPECT_NE(problem({{name, 2}}).find("'" + name + "'"), std::string::npos);
    EXPECT_NE(problem({{name, 1}, {"count", 2}}).find("leave out 'count'"), std::string::npos);
    EXPECT_NE(problem({{name, 1}, {"anti", 1}}).find("leave out all but one"), std::string::npos);
  }
  EXPECT_NE(problem({{"cuont", 2}}).find("did you mean 'count'"), std::string::npos);
}

TEST(ApertureBaker, DefinesTellShadersTheKind) {
  using Defines = std::map<std::string, std::string>;
  EXPECT_EQ(aperture_baker.defines({}), (Defines{{"APERTURES", "1"}}));
  EXPECT_EQ(aperture_baker.defines({{"count", 3}}), (Defines{{"APERTURES", "3"}}));
  EXPECT_EQ(aperture_baker.defines({{"anti", 1}}), (Defines{{"APERTURES", "1"}, {"ANTI_APERTURE", "1"}}));
  EXPECT_EQ(aperture_baker.defines({{"soft", 1}}), (Defines{{"APERTURES", "1"}, {"SOFT_APERTURE", "1"}}));
  EXPECT_EQ(aperture_baker.defines({{"choice", 1}}), (Defines{{"APERTURES", "2"}, {"APERTURE_CHOICE", "1"}}));
}

// Of open sky the first aperture is the hemisphere and the others are nothing; so is what is blocked of it.
double radius_under_open_sky(ApertureKind kind, size_t i) { return !kind.anti && i == 0 ? std::numbers::pi / 2 : 0; }

// Every object has the buffer, or all of the maps, and nothing else; each aperture stands in its own place.
TEST(ApertureBaker, GivesWhatItPromises) {
  Object floor = quad("floor", {-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1});
  apertures_of(floor).numbers["rays"] = 64;
  for (const ApertureKind kind : {ApertureKind{1, false}, ApertureKind{4, false}, ApertureKind{1, true}}) {
    const BakeOptions options = {{"count", kind.count}, {"anti", kind.anti}};
    std::set<std::string> buffers, maps;
    for (const BakedName& name : aperture_baker.names(options)) {
      (name.buffer ? buffers : maps).insert(name.name);
      if (!name.buffer) {
        EXPECT_EQ(name.sampler, (Sampler{Filter::linear, Wrap::clamp}));
      }
    }
    EXPECT_EQ(maps.size(), kind.count);
    for (const uint32_t side : {0u, 8u}) {
      apertures_of(floor).numbers["map_texels"] = side;
      const Scene scene = scene_of({floor});
      Bakes bakes(scene, effect_code(), DiskCache(""));
      const Baked& baked = baked_apertures(bakes, 0, kind);
      std::set<std::string> given_buffers, given_maps;
      for (const auto& [name, bytes] : baked.buffers) {
        given_buffers.insert(name);
        ASSERT_EQ(bytes.size(), 4 * kind.count * sizeof(Aperture));
        std::vector<Aperture> apertures(4 * kind.count);
        std::memcpy(apertures.data(), bytes.data(), bytes.size());
        for (size_t i = 0; i < apertures.size(); ++i)
          EXPECT_NEAR(apertures[i].w, radius_under_open_sky(kind, i % kind.count), 1e-3) << i;
      }
      for (const auto& [name, map] : baked.textures) {
        given_maps.insert(name);
        EXPECT_EQ(map->format, Format::rgba16_float);
        EXPECT_EQ(map->width, side);
        EXPECT_EQ(map->height, side);
        ASSERT_EQ(map->levels.size(), 1u);
        ASSERT_EQ(map->levels[0].size(), size_t{8} * side * side);
        uint64_t halves = 0;
        std::memcpy(&halves, map->levels[0].data(), sizeof halves);
        EXPECT_NEAR(glm::unpackHalf4x16(halves).w, radius_under_open_sky(kind, std::stoul(name.substr(name.find('_') + 1))),
                    1e-3)
            << name;
      }
      EXPECT_EQ(given_buffers, side == 0 ? buffers : std::set<std::string>{});
      EXPECT_EQ(given_maps, side == 0 ? std::set<std::string>{} : maps);
    }
  }
}

TEST(ApertureBaker, RaysAreCastOnceForEveryKind) {
  const Scene scene = scene_of({receiver()});
  Bakes bakes(scene, effect_code(), DiskCache(""));
  for (const ApertureKind kind : {ApertureKind{1, false}, ApertureKind{2, false}, ApertureKind{1, true}})
    vertex_apertures(bakes, 0, kind);
  ASSERT_EQ(bakes.stats().size(), 1u);
  EXPECT_EQ(bakes.stats()[0].effect, "aperture_lighting");
  EXPECT_EQ(bakes.stats()[0].object, 0u);
  EXPECT_EQ(bakes.stats()[0].points, 3u);
  EXPECT_EQ(bakes.stats()[0].rays, 1024u);
}

}  // namespace
}  // namespace lamina
