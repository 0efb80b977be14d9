// SPDX-License-Identifier: Apache-2.0
// Values of specialization constants: who sets them, and how they are written into 32 bits.
#include "harness/graph/spec_constants.h"

#include <gtest/gtest.h>

#include <bit>

#include "harness/core/error.h"

namespace lamina {
namespace {

using Type = SpecConstantInfo::Type;

// A pass with one draw of one shader that has these constants.
struct Example {
  explicit Example(std::vector<SpecConstantInfo> constants) {
    auto shader = std::make_shared<CompiledShader>();
    shader->reflection.constants = std::move(constants);
    draw.stages.push_back(shader);
    manifest.where = "example.toml:7";
    pass.variant = &variant, pass.pass = &manifest;
  }
  std::vector<SpecConstant> values(const Parameters& parameters = {}) const { return spec_constants(pass, draw, parameters); }

  VariantManifest variant;
  PassManifest manifest;
  GraphPass pass;
  GraphDraw draw;
};

TEST(SpecConstants, LaterOnesComeOverEarlierOnes) {
  Example example({{"taps", 3, Type::integer}});
  EXPECT_TRUE(example.values().empty()) << "the shader's own value";
  example.manifest.constants["taps"] = "5";
  EXPECT_EQ(example.values().at(0).id, 3u);
  EXPECT_EQ(example.values().at(0).bits, 5u);
  example.variant.name = "mine";
  example.variant.parameters.push_back({"taps", "", "", 7, 0, 100});
  EXPECT_EQ(example.values().at(0).bits, 7u);
  EXPECT_EQ(example.values({{"mine.taps", 11}}).at(0).bits, 11u);
  EXPECT_EQ(example.values({{"other.taps", 11}}).at(0).bits, 7u);
}

TEST(SpecConstants, AreWrittenAsTheirTypes) {
  Example example({{"on", 0, Type::boolean},
                   {"off", 1, Type::boolean},
                   {"below", 2, Type::integer},
                   {"most", 3, Type::unsigned_integer},
                   {"share", 4, Type::real}});
  example.manifest.constants = {{"on", "true"}, {"off", "false"}, {"below", "-2"}, {"most", "4294967295"}, {"share", "0.25"}};
  const std::vector<SpecConstant> values = example.values();
  ASSERT_EQ(values.size(), 5u);
  EXPECT_EQ(values[0].bits, 1u);
  EXPECT_EQ(values[1].bits, 0u);
  EXPECT_EQ(values[2].bits, 0xfffffffeu);
  EXPECT_EQ(values[3].bits, 0xffffffffu);
  EXPECT_EQ(values[4].bits, std::bit_cast<uint32_t>(0.25f));
}

TEST(SpecConstants, WhatIsNoSuchNumberIsRefusedWithItsPlace) {
  const auto expect_refused = [](Type type, const char* text, const std::string& words) {
    Example example({{"taps", 0, type}});
    example.manifest.constants["taps"] = text;
    try {
      example.values();
      ADD_FAILURE() << "took '" << text << "'";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_NE(std::string(error.what()).find("example.toml:7"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("'taps' must be " + words), std::string::npos) << error.what();
    }
  };
  for (const Type type : {Type::boolean, Type::integer, Type::unsigned_integer, Type::real})
    for (const char* text : {"", "many", "1.5x", "nan", "inf"}) expect_refused(type, text, "a number");
  for (const char* text : {"2.5", "2147483648", "-2147483649"}) expect_refused(Type::integer, text, "a whole number");
  for (const char* text : {"2.5", "-1", "4294967296"}) expect_refused(Type::unsigned_integer, text, "a whole number");
}

}  // namespace
}  // namespace lamina
