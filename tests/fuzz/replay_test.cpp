// SPDX-License-Identifier: Apache-2.0
// Every input of tests/fuzz/corpus through its target: what the fuzzers began with, and each that they found.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/folder.h"
#include "tests/fuzz/targets.h"

namespace lamina {
namespace {

namespace fs = std::filesystem;

class Replay : public testing::TestWithParam<FuzzTarget> {};

TEST_P(Replay, ReadsOrRefusesInWordsAboutTheFile) {
  const Folder folder;
  size_t inputs = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(LAMINA_SOURCE_DIR) / "tests/fuzz/corpus" / GetParam().name)) {
    const fs::path file = folder / GetParam().file;
    fs::copy_file(entry.path(), file, fs::copy_options::overwrite_existing);
    EXPECT_NO_THROW(run_target(GetParam(), file)) << entry.path();
    ++inputs;
  }
  EXPECT_GT(inputs, 0u) << "no corpus for " << GetParam().name;
}

INSTANTIATE_TEST_SUITE_P(Each, Replay, testing::ValuesIn(fuzz_targets().begin(), fuzz_targets().end()),
                         [](const testing::TestParamInfo<FuzzTarget>& target) { return std::string(target.param.name); });

}  // namespace
}  // namespace lamina
