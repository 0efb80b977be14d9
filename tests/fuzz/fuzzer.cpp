// SPDX-License-Identifier: Apache-2.0
// libFuzzer's entry for one target, LAMINA_FUZZ_TARGET. Readers take files, so each input becomes one, in memory.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string_view>

#include "tests/fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, size_t size) {
  using namespace lamina;
  static const FuzzTarget& target = [&]() -> const FuzzTarget& {
    for (const FuzzTarget& each : fuzz_targets())
      if (std::string_view(each.name) == LAMINA_FUZZ_TARGET) return each;
    std::abort();
  }();
  static const std::filesystem::path file = [&] {
    const auto folder = std::filesystem::path("/dev/shm") / ("lamina_fuzz_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    return folder / target.file;
  }();
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  run_target(target, file);
  return 0;
}
