// SPDX-License-Identifier: Apache-2.0
// 3D textures: texels in and out, filtering by definition on every axis, the ends of each, and what is refused.
#include <gmock/gmock.h>

#include "tests/backend/rig.h"

namespace lamina {
namespace {

using ::testing::HasSubstr;

// 2 x 3 x 4 texels: no side is like another.
constexpr uint32_t width = 2, height = 3, depth = 4;
constexpr TextureDesc volume_desc(Format format) {
  TextureDesc desc;
  desc.width = width, desc.height = height, desc.depth = depth, desc.format = format;
  return desc;
}

// x, y and z weigh differently, and the corners of a cell are not on one plane.
float value_at(uint32_t x, uint32_t y, uint32_t z) {
  return static_cast<float>(x) + 10 * static_cast<float>(y * y) + 100 * static_cast<float>(z) +
         7 * static_cast<float>(x * y * z);
}

class BackendTexture3D : public BackendTest {
 protected:
  TextureId volume(Format format, const std::vector<std::byte>& texels) {
    TextureDesc desc = volume_desc(format);
    desc.name = "volume";
    return backend().create_texture(desc, std::vector<std::vector<std::byte>>{texels});
  }
  // value_at() in every texel.
  TextureId values() {
    std::vector<float> texels;
    for (uint32_t z = 0; z < depth; ++z)
      for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) texels.push_back(value_at(x, y, z));
    return volume(Format::r32_float, bytes_of(texels));
  }
  // `expression` of a texture `t`, and of a 2D texture `plane` where one is given.
  float sample(TextureId id, Sampler sampler, const std::string& expression, TextureId plane = {}) {
    Draw draw;
    draw.textures = {{.binding = 2, .texture = id, .sampler = sampler}};
    if (plane) draw.textures.push_back({.binding = 3, .texture = plane, .sampler = sampler});
    return draw_over(1, 1,
                     std::string("layout(binding = 2) uniform sampler3D t;\n") +
                         (plane ? "layout(binding = 3) uniform sampler2D plane;\n" : "") +
                         "layout(location = 0) out vec4 c; void main() { c = vec4(" + expression + "); }",
                     draw)
        .at(0, 0);
  }
};
LAMINA_ON_EVERY_BACKEND(BackendTexture3D);

// Odd row lengths, so that rows and slices end off any alignment.
TEST_P(BackendTexture3D, EveryFormatComesBackAsItWent) {
  for (const Format format :
       {Format::r8_unorm, Format::rg8_unorm, Format::rgba8_unorm, Format::rgba8_srgb, Format::r16_float, Format::rg16_float,
        Format::rgba16_float, Format::r32_float, Format::rg32_float, Format::rgba32_float}) {
    SCOPED_TRACE(name_of(format));
    std::vector<std::byte> texels(width * height * depth * bytes_per_texel(format));
    for (size_t i = 0; i < texels.size(); ++i)
      texels[i] = static_cast<std::byte>(i % 59);  // no half or float that is no number
    const std::vector<std::byte> reversed(texels.rbegin(), texels.rend());
    const TextureId first = volume(format, texels),
                    second = volume(format, reversed);  // what is on its way is not what arrived
    EXPECT_EQ(backend().read_texture(first), texels);
    EXPECT_EQ(backend().read_texture(second), reversed);
  }
}

TEST_P(BackendTexture3D, EveryTexelLiesWhereItWasPut) {
  Draw draw;
  draw.textures = {{.binding = 2, .texture = values(), .sampler = {.filter = Filter::nearest}}};
  const Floats seen = draw_over(width, height * depth, R"(
layout(binding = 2) uniform sampler3D t;
layout(location = 0) out vec4 c;
void main() {
  ivec3 at = ivec3(gl_FragCoord.x, int(gl_FragCoord.y) % 3, int(gl_FragCoord.y) / 3);
  c = vec4(texelFetch(t, at, 0).r, texture(t, (vec3(at) + 0.5) / vec3(2, 3, 4)).r, dot(vec3(textureSize(t, 0)), vec3(1, 10, 100)), 1);
})",
                                draw);
  for (uint32_t z = 0; z < depth; ++z)
    for (uint32_t y = 0; y < height; ++y)
      for (uint32_t x = 0; x < width; ++x) {
        EXPECT_EQ(seen.at(x, z * height + y, 0), value_at(x, y, z)) << "fetched " << x << " " << y << " " << z;
        EXPECT_EQ(seen.at(x, z * height + y, 1), value_at(x, y, z)) << "sampled " << x << " " << y << " " << z;
      }
  EXPECT_EQ(seen.at(0, 0, 2), 432);
}

// The eight texels about a point, weighed by the point's place between them: in texel units less a half.
TEST_P(BackendTexture3D, LinearMixesEightTexels) {
  const TextureId id = values();
  for (const Filter filter : {Filter::linear, Filter::trilinear})
    for (const auto& [x, y, z] :
         {std::tuple{0.5, 0.0, 0.0}, {0.0, 0.5, 0.0}, {0.0, 0.0, 0.5}, {0.25, 1.75, 2.25}, {0.75, 0.5, 1.125}}) {
      double expected = 0;
      for (uint32_t corner = 0; corner < 8; ++corner) {
        const uint32_t dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2;
        const auto weight = [](double at, uint32_t upper) { return upper ? at - std::floor(at) : 1 - (at - std::floor(at)); };
        const double of_corner = weight(x, dx) * weight(y, dy) * weight(z, dz);
        if (of_corner > 0)
          expected +=
              of_corner * value_at(static_cast<uint32_t>(x) + dx, static_cast<uint32_t>(y) + dy, static_cast<uint32_t>(z) + dz);
      }
      const double of_a_cell = 1 + 30 + 100 + 7 * 9;  // what neighbours differ by at most, all axes together
      EXPECT_NEAR(sample(id, {.filter = filter},
                         fmt::format("textureLod(t, (vec3({}, {}, {}) + 0.5) / vec3(2, 3, 4), 0.0).r", x, y, z)),
                  expected, of_a_cell * weight_step)
          << x << " " << y << " " << z;
    }
}

TEST_P(BackendTexture3D, ClampHoldsTheFirstAndTheLastSlice) {
  const TextureId id = values();
  for (const Filter filter : {Filter::nearest, Filter::linear}) {
    EXPECT_EQ(sample(id, {.filter = filter}, "texture(t, vec3(0.25, 0.5, -0.5)).r"), value_at(0, 1, 0));
    EXPECT_EQ(sample(id, {.filter = filter}, "texture(t, vec3(0.25, 0.5, 1.5)).r"), value_at(0, 1, 3));
    EXPECT_EQ(sample(id, {.filter = filter}, "texture(t, vec3(2.0, -1.0, 0.125)).r"), value_at(1, 0, 0));
  }
  EXPECT_EQ(sample(id, {.filter = Filter::nearest, .wrap = Wrap::repeat}, "texture(t, vec3(0.25, 0.5, 1.375)).r"),
            value_at(0, 1, 1));
}

TEST_P(BackendTexture3D, HalvesAreFiltered) {
  std::vector<uint16_t> texels;
  for (uint32_t i = 0; i < width * height * depth; ++i) texels.push_back(glm::packHalf1x16(i < width * height ? 0.25f : 0.75f));
  const TextureId id = volume(Format::r16_float, bytes_of(texels));
  EXPECT_NEAR(sample(id, {}, "texture(t, vec3(0.5, 0.5, 0.25)).r"), 0.5, weight_step);
}

// What one draw has bound must not reach the next: 2D after 3D at one place, and both in one shader.
TEST_P(BackendTexture3D, StandsBesideTexturesOfTwoDimensions) {
  const TextureId id = values(), plane = texture<float>(Format::r32_float, 1, 1, {1000});
  EXPECT_EQ(sample(id, {}, "texelFetch(t, ivec3(1, 2, 3), 0).r + texture(plane, vec2(0.5)).r", plane),
            1000 + value_at(1, 2, 3));
  Draw draw;
  draw.textures = {{.binding = 2, .texture = plane}};
  EXPECT_EQ(draw_over(1, 1,
                      "layout(binding = 2) uniform sampler2D t; layout(location = 0) out vec4 c;\n"
                      "void main() { c = texture(t, vec2(0.5)); }",
                      draw)
                .at(0, 0),
            1000);
}

TEST_P(BackendTexture3D, ASamplerOfOtherDimensionsIsRefused) {
  const TextureId id = values(), plane = texture<float>(Format::r32_float, 1, 1, {1});
  const Error flat = error_of([&] { sample(plane, {}, "texture(t, vec3(0.5)).r"); });
  EXPECT_EQ(flat.kind(), ErrorKind::bad_input);
  EXPECT_THAT(flat.message(), HasSubstr("binding 2 is a sampler3D, 'test texture' is a 2D texture"));
  const Error solid = error_of([&] { sample(id, {}, "texture(t, vec3(0.5)).r + texture(plane, vec2(0.5)).r", id); });
  EXPECT_EQ(solid.kind(), ErrorKind::bad_input);
  EXPECT_THAT(solid.message(), HasSubstr("binding 3 is a sampler2D, 'volume' is a 3D texture"));
}

TEST_P(BackendTexture3D, WhatOneCannotBeIsRefused) {
  const auto refused = [&](auto change, size_t bytes = 0) {
    TextureDesc desc = volume_desc(Format::r8_unorm);
    desc.name = "odd one";
    change(desc);
    const std::vector<std::vector<std::byte>> levels(bytes > 0 ? 1 : 0, std::vector<std::byte>(bytes));
    const Error error = error_of([&] { backend().create_texture(desc, levels); });
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_EQ(error.subject(), "odd one");
    return error.message();
  };
  EXPECT_THAT(refused([](TextureDesc& d) { d.levels = 2; }), HasSubstr("sampled only"));
  EXPECT_THAT(refused([](TextureDesc& d) { d.target = true; }), HasSubstr("sampled only"));
  EXPECT_THAT(refused([](TextureDesc& d) { d.storage = true; }), HasSubstr("sampled only"));
  EXPECT_THAT(refused([](TextureDesc& d) { d.format = Format::d32_float; }), HasSubstr("sampled only"));
  EXPECT_THAT(refused([](TextureDesc& d) { d.format = Format::r32_uint; }), HasSubstr("sampled only"));
  EXPECT_THAT(refused([](TextureDesc& d) { d.depth = 0; }), HasSubstr("2"));
  EXPECT_THAT(refused([](TextureDesc& d) { d.depth = 1u << 24; }), HasSubstr("16777216"));
  EXPECT_THAT(refused([](TextureDesc&) {}, width * height), HasSubstr("24 bytes")) << "texels of one slice";
}

}  // namespace
}  // namespace lamina
