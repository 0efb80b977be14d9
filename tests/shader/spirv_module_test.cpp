// SPDX-License-Identifier: Apache-2.0
#include "harness/shader/spirv_module.h"

#include <gtest/gtest.h>

namespace lamina {
namespace {

// Words by hand, from the SPIR-V specification 1.0, section 2.3: length << 16 | opcode, then the operands.
constexpr uint32_t instruction(uint32_t length, spv::Op op) { return length << 16 | op; }

// The header for `bound` ids, and then `body`.
std::vector<uint32_t> module_of(uint32_t bound, std::vector<uint32_t> body) {
  std::vector<uint32_t> words = {0x07230203, 0x00010000, 0, bound, 0};
  words.insert(words.end(), body.begin(), body.end());
  return words;
}

TEST(SpirvModule, FindsDefinitionsNamesAndDecorations) {
  const auto words =
      module_of(4, {instruction(4, spv::OpName), 2, 0x6e696b73, 0x00000065,  // "skin", "e"
                    instruction(4, spv::OpDecorate), 2, spv::DecorationBinding, 7, instruction(3, spv::OpDecorate), 2,
                    spv::DecorationNonWritable, instruction(3, spv::OpTypeFloat), 1, 32, instruction(4, spv::OpVariable), 1, 2,
                    spv::StorageClassUniformConstant});
  const SpirvModule module(words);
  EXPECT_EQ(module.instructions().size(), 5u);
  EXPECT_EQ(module.definition(1).op(), spv::OpTypeFloat);
  EXPECT_EQ(module.definition(1).type, 0u);
  EXPECT_EQ(module.definition(2).op(), spv::OpVariable);
  EXPECT_EQ(module.definition(2).type, 1u);
  EXPECT_EQ(module.name(2), "skine");
  EXPECT_EQ(module.name(1), "");
  EXPECT_EQ(module.decoration(2, spv::DecorationBinding), 7u);
  EXPECT_EQ(module.decoration(2, spv::DecorationNonWritable), 0u);
  EXPECT_EQ(module.decoration(2, spv::DecorationLocation), std::nullopt);
  EXPECT_EQ(module.decoration(1, spv::DecorationBinding), std::nullopt);
  EXPECT_THROW(module.definition(3), Error) << "nothing makes it";
  EXPECT_THROW(module.definition(4), Error) << "over the bound";
}

TEST(SpirvModule, RefusesBrokenWords) {
  const auto refused = [](const std::vector<uint32_t>& words) { EXPECT_THROW(SpirvModule{words}, Error); };
  refused({});
  refused({0x07230203, 0x00010000, 0, 1});
  refused({0x03022307, 0x00000100, 0, 1, 0});                        // the other byte order
  refused(module_of(2, {instruction(0, spv::OpNop)}));               // would never end
  refused(module_of(2, {instruction(3, spv::OpTypeFloat), 1}));      // longer than what is left
  refused(module_of(2, {instruction(1, spv::OpTypeFloat)}));         // no room for its result
  refused(module_of(2, {instruction(3, spv::OpTypeFloat), 2, 32}));  // over the bound
  EXPECT_NO_THROW(SpirvModule(module_of(2, {instruction(3, spv::OpTypeFloat), 1, 32})));
}

TEST(ValidateSpirv, SaysWhatIsWrongAboutWhat) {
  try {
    validate_spirv(module_of(2, {instruction(3, spv::OpTypeFloat), 1, 32}), Api::vulkan, ErrorKind::bad_input, "x.frag");
    FAIL() << "a module without a memory model is invalid";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_EQ(error.subject(), "x.frag");
    EXPECT_GT(error.message().size(), std::string("SPIRV-Tools finds the module invalid: ").size());
  }
}

}  // namespace
}  // namespace lamina
