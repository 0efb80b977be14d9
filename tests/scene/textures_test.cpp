// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/textures.h"

#include <gtest/gtest.h>
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

#include <cmath>
#include <random>

#include "tests/scene/made_files.h"

namespace lamina {
namespace {

// OpenImageIO 2.4's PNG reader leaves by longjmp over a std::string where a file ends early, and so leaks it.
struct LeaksAllowed {
#ifdef __SANITIZE_ADDRESS__
  LeaksAllowed() { __lsan_disable(); }
  ~LeaksAllowed() { __lsan_enable(); }
#endif
};

uint8_t code(const TextureImage& texture, size_t level, size_t texel, size_t channel) {
  return std::to_integer<uint8_t>(texture.levels.at(level).at(texel * 4 + channel));
}

Texels random_texels(uint32_t width, uint32_t height) {
  std::mt19937 random(7);
  Texels texels{width, height, {}};
  const auto number = [&] { return float(random() % 65536) / 65535; };
  for (size_t i = 0; i < size_t{width} * height; ++i) texels.rgba.emplace_back(number(), number(), number(), number());
  return texels;
}

// IEC 61966-2-1: code 10 is the last on the linear segment (10 / 255 = 0.0392 <= 0.04045), 255 * 0.735357 = 187.5 is half
// light.
TEST(LoadTexels, DecodesKnownSrgbCodesToLinear) {
  const Folder folder;
  write_png(folder / "codes.png", 4, 1, 4, {0, 10, 128, 255, 188, 255, 1, 128, 64, 64, 64, 0, 255, 255, 255, 255});
  const Texels texels = load_texels(folder / "codes.png", true);
  ASSERT_EQ(texels.width, 4u);
  EXPECT_EQ(texels.rgba[0].r, 0.0f);
  EXPECT_NEAR(texels.rgba[0].g, 10.0 / 255 / 12.92, 1e-7);
  EXPECT_NEAR(texels.rgba[0].b, 0.2158605, 1e-6);
  EXPECT_NEAR(texels.rgba[1].r, 0.5028865, 1e-6);
  EXPECT_NEAR(texels.rgba[1].a, 128.0 / 255, 1e-6) << "alpha is linear";
  EXPECT_NEAR(texels.rgba[2].r, 0.05126946, 1e-6) << "colours under alpha 0 stay";
  EXPECT_EQ(texels.rgba[3], glm::vec4(1));
}

TEST(LoadTexels, TakesDataAsItIsAndFillsInChannels) {
  const Folder folder;
  write_png(folder / "grey.png", 2, 1, 1, {51, 255});
  const Texels texels = load_texels(folder / "grey.png", false);
  EXPECT_LT(glm::distance(texels.rgba[0], glm::vec4(0.2f, 0.2f, 0.2f, 1)), 1e-6f);
}

TEST(LoadTexels, FloatFilesAreLinearAlready) {
  const Folder folder;
  const std::vector<float> values = {0.25f, 0.5f, 4.0f};
  auto output = OIIO::ImageOutput::create((folder / "light.exr").string());
  ASSERT_TRUE(output->open((folder / "light.exr").string(), OIIO::ImageSpec(1, 1, 3, OIIO::TypeDesc::FLOAT)));
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
  output->close();
  EXPECT_EQ(load_texels(folder / "light.exr", true).rgba[0], glm::vec4(0.25f, 0.5f, 4.0f, 1.0f));
}

TEST(LoadTexels, RefusesMissingDamagedAndNonFiniteFiles) {
  const Folder folder;
  expect_refused([&] { load_texels(folder / "none.png", true); }, {"none.png"});
  folder.write("text.png", "this is no picture");
  expect_refused([&] { load_texels(folder / "text.png", true); }, {"text.png", "cannot be"});
  write_png(folder / "whole.png", 64, 64, 3, std::vector<uint8_t>(64 * 64 * 3, 77));
  const std::string whole = bytes_of(folder / "whole.png");
  folder.write("cut.png", whole.substr(0, whole.size() / 2));
  {
    [[maybe_unused]] const LeaksAllowed in_openimageio;
    expect_refused([&] { load_texels(folder / "cut.png", true); }, {"cut.png", "cannot be"});
  }
  const std::vector<float> values = {0, std::nanf(""), 0};
  auto output = OIIO::ImageOutput::create((folder / "nan.exr").string());
  ASSERT_TRUE(output->open((folder / "nan.exr").string(), OIIO::ImageSpec(1, 1, 3, OIIO::TypeDesc::FLOAT)));
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
  output->close();
  expect_refused([&] { load_texels(folder / "nan.exr", true); }, {"nan.exr", "(0, 0)", "not finite"});
}

// Exporters write JPEG files that end in .png.
TEST(LoadTexels, AnEndingMayBeAnotherFormats) {
  const Folder folder;
  write_png(folder / "a.png", 1, 2, 3, {255, 0, 0, 0, 255, 0});
  std::filesystem::rename(folder / "a.png", folder / "a.jpg");
  EXPECT_EQ(load_texels(folder / "a.jpg", true).rgba[1], glm::vec4(0, 1, 0, 1));
}

// Targa has no magic number: its reader would take a damaged file of another format for one of its own.
TEST(LoadTexels, TargaIsReadByItsEndingAlone) {
  const Folder folder;
  write_png(folder / "a.tga", 1, 2, 3, {255, 0, 0, 0, 255, 0});
  EXPECT_EQ(load_texels(folder / "a.tga", true).rgba.size(), 2u);
  std::filesystem::rename(folder / "a.tga", folder / "a.png");
  expect_refused([&] { load_texels(folder / "a.png", true); }, {"a.png", "cannot be read as a picture"});
}

TEST(DecodeTexels, AFewBytesHoldNoHugePicture) {
  const std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16384 +X 16384\n" + std::string(64, '\x02');
  expect_refused([&] { decode_texels(std::as_bytes(std::span(bytes)), "picture", false); },
                 {"16384 x 16384 texels are more than its", "bytes can hold"});
}

TEST(DecodeTexels, ReadsAnEncodedFileInMemoryWhateverItsName) {
  const Folder folder;
  write_png(folder / "a.png", 1, 2, 3, {255, 0, 0, 0, 255, 0});
  const std::string bytes = bytes_of(folder / "a.png");
  const Texels texels = decode_texels(std::as_bytes(std::span(bytes)), "material 'skin'", true);
  EXPECT_EQ(texels.rgba[0], glm::vec4(1, 0, 0, 1)) << "row 0 is the top row";
  EXPECT_EQ(texels.rgba[1], glm::vec4(0, 1, 0, 1));
  [[maybe_unused]] const LeaksAllowed in_openimageio;
  expect_refused([&] { decode_texels(std::as_bytes(std::span(bytes)).first(40), "material 'skin'", true); },
                 {"material 'skin'"});
}

TEST(DecodeTexels, ReadsJpeg) {
  const Folder folder;
  auto output = OIIO::ImageOutput::create((folder / "a.jpg").string());
  ASSERT_TRUE(output->open((folder / "a.jpg").string(), OIIO::ImageSpec(8, 8, 3, OIIO::TypeDesc::UINT8)));
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::UINT8, std::vector<uint8_t>(8 * 8 * 3, 188).data()));
  output->close();
  const std::string bytes = bytes_of(folder / "a.jpg");
  EXPECT_NEAR(decode_texels(std::as_bytes(std::span(bytes)), "grey", true).rgba.at(63).g, 0.503f, 0.02f);
}

TEST(DecodeTexels, ReadsWebp) {
  const std::string bytes = webp_bytes();
  const Texels texels = decode_texels(std::as_bytes(std::span(bytes)), "picture", true);
  ASSERT_EQ(texels.rgba.size(), 2u);
  EXPECT_EQ(texels.rgba[0], glm::vec4(1, 0, 0, 1));
  EXPECT_LT(glm::distance(texels.rgba[1], glm::vec4(0, 0, 1, 0.2f)), 1e-3f) << "transparency darkens no colour";
}

TEST(MakeTexture, LevelZeroKeepsEveryCode) {
  Texels all{256, 1, {}};
  for (int k = 0; k < 256; ++k) {
    const double encoded = k / 255.0;
    const auto linear = float(encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4));
    all.rgba.emplace_back(linear, linear, linear, float(encoded));
  }
  const auto texture = make_texture("all", all, TexelMeaning::colour);
  EXPECT_EQ(texture->format, Format::rgba8_srgb);
  const Texels back = base_texels(*texture);
  for (size_t k = 0; k < 256; ++k) {
    EXPECT_EQ(code(*texture, 0, k, 0), k);
    EXPECT_EQ(code(*texture, 0, k, 3), k);
    EXPECT_NEAR(back.rgba[k].r, all.rgba[k].r, 1e-6);
    EXPECT_NEAR(back.rgba[k].a, all.rgba[k].a, 1e-6);
  }
}

TEST(MakeTexture, HalfBlackHalfWhiteIsHalfLight) {
  const auto texture = make_texture("half", {2, 1, {glm::vec4(0), glm::vec4(1)}}, TexelMeaning::colour);
  ASSERT_EQ(texture->levels.size(), 2u);
  EXPECT_EQ(code(*texture, 1, 0, 0), 188) << "sRGB of 0.5 is 0.7354";
  EXPECT_EQ(code(*texture, 1, 0, 3), 128) << "alpha is linear";
}

// Sizes halve rounded down, and every texel of the base weighs the same in every level: so the mean stays. Rounding to codes
// moves a mean by half a code at most.
TEST(MakeTexture, MeanOfOddSizesStaysDownToOneTexel) {
  for (const auto& [width, height] : {std::pair{13u, 7u}, {1u, 5u}, {31u, 3u}, {9u, 1u}, {8u, 8u}}) {
    const Texels base = random_texels(width, height);
    glm::dvec4 mean(0);
    for (const glm::vec4 texel : base.rgba) mean += glm::dvec4(texel) / double(base.rgba.size());
    const auto texture = make_texture("odd", base, TexelMeaning::data);
    ASSERT_EQ(texture->levels.size(), full_mip_levels(width, height));
    for (size_t level = 0; level < texture->levels.size(); ++level) {
      const size_t texels = size_t{std::max(1u, width >> level)} * std::max(1u, height >> level);
      ASSERT_EQ(texture->levels[level].size(), texels * 4);
      for (size_t channel = 0; channel < 4; ++channel) {
        double level_mean = 0;
        for (size_t i = 0; i < texels; ++i) level_mean += code(*texture, level, i, channel) / 255.0 / double(texels);
        EXPECT_NEAR(level_mean, mean[int(channel)], 0.51 / 255) << width << " x " << height << ", level " << level;
      }
    }
  }
}

// Three texels in one: a third each; five in two: two and a half each.
TEST(MakeTexture, OddSizesWeighByArea) {
  const auto gray = [](float v) { return glm::vec4(v, v, v, 1); };
  const auto three = make_texture("three", {3, 1, {gray(0), gray(0), gray(0.9f)}}, TexelMeaning::data);
  EXPECT_EQ(code(*three, 1, 0, 0), std::lround(255 * 0.3));
  const auto five = make_texture("five", {5, 1, {gray(0), gray(0), gray(1), gray(0), gray(0)}}, TexelMeaning::data);
  EXPECT_EQ(code(*five, 1, 0, 0), std::lround(255 * 0.5 / 2.5));
  EXPECT_EQ(code(*five, 1, 1, 0), std::lround(255 * 0.5 / 2.5));
}

TEST(MakeTexture, NormalsAreUnitInEveryLevel) {
  const auto texture = make_texture("normals", random_texels(37, 21), TexelMeaning::normal);
  EXPECT_EQ(texture->format, Format::rgba8_unorm);
  EXPECT_EQ(texture->levels.size(), 6u) << "37, 18, 9, 4, 2, 1";
  for (const auto& level : texture->levels)
    for (size_t i = 0; i < level.size() / 4; ++i) {
      glm::vec3 n;
      for (size_t c = 0; c < 3; ++c) n[int(c)] = float(std::to_integer<uint8_t>(level[i * 4 + c])) / 255 * 2 - 1;
      EXPECT_NEAR(glm::length(n), 1.0f, 0.0075f) << "half a code on each of three axes is sqrt(3) / 255";
    }
}

// (1,0,0) and (0,0,1) average to their bisector; opposite normals cancel, and then the flat one is as good as any.
TEST(MakeTexture, NormalsAverageAsVectors) {
  const auto texel = [](glm::vec3 n) { return glm::vec4(n * 0.5f + 0.5f, 1); };
  const auto bent = make_texture("bent", {2, 1, {texel({1, 0, 0}), texel({0, 0, 1})}}, TexelMeaning::normal);
  EXPECT_EQ(code(*bent, 1, 0, 0), std::lround(255 * (0.5 + 0.5 * std::sqrt(0.5))));
  EXPECT_EQ(code(*bent, 1, 0, 1), 128);
  EXPECT_EQ(code(*bent, 1, 0, 2), std::lround(255 * (0.5 + 0.5 * std::sqrt(0.5))));
  const auto opposite = make_texture("opposite", {2, 1, {texel({1, 0, 0}), texel({-1, 0, 0})}}, TexelMeaning::normal);
  EXPECT_EQ(code(*opposite, 1, 0, 0), 128);
  EXPECT_EQ(code(*opposite, 1, 0, 2), 255);
}

TEST(MakeTexture, RefusesTexelsThatDoNotFillIt) {
  expect_refused([] { make_texture("short", {2, 2, {glm::vec4(0)}}, TexelMeaning::data); }, {"short", "2 x 2"});
  expect_refused([] { make_texture("empty", {}, TexelMeaning::data); }, {"empty"});
}

TEST(Resized, InterpolatesBetweenCentresAndHoldsEdges) {
  const Texels two{2, 1, {glm::vec4(0), glm::vec4(1)}};
  const Texels four = resized(two, 4, 2);
  ASSERT_EQ(four.rgba.size(), 8u);
  for (size_t row = 0; row < 2; ++row) {
    EXPECT_FLOAT_EQ(four.rgba[row * 4 + 0].r, 0.0f);
    EXPECT_FLOAT_EQ(four.rgba[row * 4 + 1].r, 0.25f);
    EXPECT_FLOAT_EQ(four.rgba[row * 4 + 2].r, 0.75f);
    EXPECT_FLOAT_EQ(four.rgba[row * 4 + 3].r, 1.0f);
  }
}

TEST(ConstantTexture, IsOneTexelWithOneLevel) {
  const auto texture = constant_texture("grey", {0.5f, 0.5f, 0.5f, 0.25f}, TexelMeaning::colour);
  ASSERT_EQ(texture->levels.size(), 1u);
  EXPECT_EQ(code(*texture, 0, 0, 0), 188);
  EXPECT_EQ(code(*texture, 0, 0, 3), 64);
}

// Codes that nobody wrote to give the same texture as the floats that they stand for, at odd sizes too.
TEST(Textures, CodesAndTheirFloatsMakeTheSameTexture) {
  std::mt19937 random(7);
  for (const auto& [width, height] : {std::pair{1u, 1u}, {7u, 5u}, {16u, 8u}, {1u, 9u}})
    for (const bool srgb : {false, true}) {
      std::vector<uint8_t> codes(size_t{4} * width * height);
      for (uint8_t& code : codes) code = static_cast<uint8_t>(random() >> 24);
      const Texels coded{width, height, TexelArray::of_codes(codes, srgb)};
      Texels floats = coded;
      floats.rgba.begin();  // whoever may write gets floats
      ASSERT_TRUE(floats.rgba.codes().empty());
      ASSERT_FALSE(coded.rgba.codes().empty());
      EXPECT_EQ(floats.rgba, coded.rgba);
      for (const TexelMeaning meaning :
           {TexelMeaning::colour, TexelMeaning::normal, TexelMeaning::data, TexelMeaning::normal_mean})
        EXPECT_EQ(make_texture("a", coded, meaning)->levels, make_texture("b", floats, meaning)->levels)
            << width << "x" << height << (srgb ? " sRGB " : " ") << static_cast<int>(meaning);
    }
}

// The nearest code of the sRGB curve: between codes k and k + 1 the line is at k + 1/2, decoded.
TEST(Textures, EveryValueGetsTheNearestCode) {
  std::vector<float> lines;
  for (int k = 0; k < 255; ++k) {
    const double encoded = (k + 0.5) / 255;
    lines.push_back(static_cast<float>(encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4)));
  }
  std::vector<float> values = {-1, -0.0f, 0, 1e-30f, 1, std::nextafter(1.0f, 0.0f), 1.5f, 1e30f};
  for (const float line : lines)
    for (const float value : {line, std::nextafter(line, 0.0f), std::nextafter(line, 1.0f)}) values.push_back(value);
  for (int i = 0; i <= 4096; ++i) values.push_back(static_cast<float>(i) / 4096);
  std::mt19937 random(11);
  for (int i = 0; i < 20000; ++i) values.push_back(static_cast<float>(random()) * 0x1p-32f);
  Texels row{static_cast<uint32_t>(values.size()), 1, {}};
  for (const float value : values) row.rgba.emplace_back(value, value, value, 1);
  const auto texture = make_texture("row", row, TexelMeaning::colour);
  for (size_t i = 0; i < values.size(); ++i) {
    const auto code = std::upper_bound(lines.begin(), lines.end(), values[i]) - lines.begin();
    ASSERT_EQ(std::to_integer<int>(texture->levels[0][4 * i]), code) << values[i];
  }
}

}  // namespace
}  // namespace lamina
