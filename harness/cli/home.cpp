// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/home.h"

#include <cstdlib>

#include "harness/core/error.h"

namespace lamina {
namespace {

namespace fs = std::filesystem;

bool holds_data(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_directory(folder / "variants", ignored) && fs::is_directory(folder / "shaders", ignored);
}

}  // namespace

fs::path home_folder(const fs::path& beside, const char* lamina_home) {
  if (lamina_home && *lamina_home) {
    if (holds_data(lamina_home)) return lamina_home;
    throw Error(ErrorKind::bad_input, "data", lamina_home,
                "LAMINA_HOME names this folder, which lacks variants/ or shaders/; name one that has both, or unset it");
  }
  const fs::path installed = (beside / "../share/lamina").lexically_normal();
  for (const fs::path& folder : {beside, installed})
    if (holds_data(folder)) return fs::weakly_canonical(folder / "variants").parent_path();  // past the links of a build tree
  throw Error(ErrorKind::bad_input, "data", beside.string(),
              fmt::format("neither this folder nor {} holds variants/ and shaders/; install the program again, or set "
                          "LAMINA_HOME to a folder that holds both",
                          installed.string()));
}

fs::path home_folder() { return home_folder(fs::read_symlink("/proc/self/exe").parent_path(), std::getenv("LAMINA_HOME")); }

}  // namespace lamina
