// SPDX-License-Identifier: Apache-2.0
#include "harness/core/byte_words.h"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(ByteWords, HaveThreeDigitsAndTheNextPrefixFrom1024On) {
  EXPECT_EQ(byte_words(0), "0 B");
  EXPECT_EQ(byte_words(1023), "1023 B");
  EXPECT_EQ(byte_words(1024), "1.00 KiB");
  EXPECT_EQ(byte_words(48 * 1024), "48.0 KiB");
  EXPECT_EQ(byte_words(512 * 512 * 8), "2.00 MiB");
  EXPECT_EQ(byte_words(300ull << 20), "300 MiB");
  EXPECT_EQ(byte_words(5ull << 30), "5.00 GiB");
}

}  // namespace
}  // namespace lamina
