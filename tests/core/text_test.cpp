// SPDX-License-Identifier: Apache-2.0
#include "harness/core/text.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "harness/core/error.h"
#include "harness/core/format.h"
#include "tests/folder.h"

namespace lamina {
namespace {

TEST(NearestName, FindsOneEditAway) {
  const std::vector<std::string> names = {"thickness", "scattering", "transparency"};
  EXPECT_EQ(nearest_name("tickness", names), "thickness");
  EXPECT_EQ(nearest_name("scatering", names), "scattering");
}

TEST(NearestName, SaysNothingWhenAllAreFar) {
  const std::vector<std::string> names = {"thickness", "scattering"};
  EXPECT_EQ(nearest_name("qqqq", names), "");
  EXPECT_EQ(unknown_name("key", "qqqq", names), "unknown key 'qqqq' (known: thickness, scattering)");
}

TEST(WriteFileAtomically, ReadsBackAndLeavesNoTemporary) {
  const Folder folder;
  write_file_atomically(folder / "a.txt", "one");
  write_file_atomically(folder / "a.txt", "two");
  EXPECT_EQ(read_file(folder / "a.txt", "test"), "two");
  EXPECT_EQ(folder.files(), 1u);
}

TEST(WriteFileAtomically, WhatCannotBePutInItsPlaceLeavesNoTemporary) {
  const Folder folder;
  std::filesystem::create_directories(folder / "a.txt" / "a folder of that name, which is not empty");
  EXPECT_THROW(write_file_atomically(folder / "a.txt", "x"), Error);
  EXPECT_EQ(folder.files(), 1u);
}

TEST(WriteFileAtomically, ThrowsWhereTheFolderIsMissing) {
  EXPECT_THROW(write_file_atomically("/no/such/folder/a.txt", "x"), Error);
}

TEST(ReadFile, RefusesAMissingFileAndAFolder) {
  EXPECT_THROW(read_file("/no/such/file", "test"), Error);
  EXPECT_THROW(read_file("/", "test"), Error);
}

TEST(Format, EveryNameFindsItsFormat) {
  for (int i = 0; i <= static_cast<int>(Format::d32_float); ++i) {
    const auto format = static_cast<Format>(i);
    EXPECT_EQ(format_named(name_of(format)), format);
  }
  EXPECT_EQ(format_named("rgba16"), std::nullopt);
  for (const auto& [format, channels, bytes] : {std::tuple{Format::r8_unorm, 1u, 1u},
                                                {Format::rg8_unorm, 2u, 1u},
                                                {Format::rgba8_unorm, 4u, 1u},
                                                {Format::rgba8_srgb, 4u, 1u},
                                                {Format::r16_float, 1u, 2u},
                                                {Format::rg16_float, 2u, 2u},
                                                {Format::rgba16_float, 4u, 2u},
                                                {Format::r32_float, 1u, 4u},
                                                {Format::rg32_float, 2u, 4u},
                                                {Format::rgba32_float, 4u, 4u},
                                                {Format::r32_uint, 1u, 4u},
                                                {Format::d32_float, 1u, 4u}}) {
    EXPECT_EQ(channels_of(format), channels) << name_of(format);
    EXPECT_EQ(bytes_per_texel(format), channels * bytes) << name_of(format);
  }
}

TEST(Format, MipLevelsOfOddSizes) {
  EXPECT_EQ(full_mip_levels(1, 1), 1u);
  EXPECT_EQ(full_mip_levels(1024, 512), 11u);
  EXPECT_EQ(full_mip_levels(1023, 5), 10u);
}

}  // namespace
}  // namespace lamina
