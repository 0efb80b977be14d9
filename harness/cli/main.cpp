// SPDX-License-Identifier: Apache-2.0
// Finds the command that is called, and turns errors into exit statuses: 0 well; 1 a cell or gate failed; 2 bad input or usage;
// 3 ambiguous; 4 no usable device.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "commit.h"
#include "harness/cli/commands.h"
#include "harness/cli/exit_status.h"
#include "harness/cli/run_line.h"
#include "harness/core/error.h"
#include "harness/core/steady_heap.h"
#include "harness/core/usable_threads.h"

namespace {

namespace fs = std::filesystem;
using namespace lamina;

// A shader cache of this process alone, so that the first frame's cost is the same in every run; gone with the process. Where
// there is no place for one there is none at all: Mesa maps the file of its index, and on a full disk a write to it would end
// the process.
class PrivateShaderCache {
 public:
  PrivateShaderCache() {
    constexpr uintmax_t min_bytes = 64 << 20;
    std::error_code none;  // TMPDIR may name what is no folder, be full or be read-only
    const fs::path folder = fs::temp_directory_path(none);
    std::string pattern = (folder / "lamina-shaders-XXXXXX").string();
    if (none || fs::space(folder, none).available < min_bytes || none || !::mkdtemp(pattern.data())) {
      ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
      return;
    }
    folder_ = pattern;
    ::setenv("MESA_SHADER_CACHE_DIR", folder_.c_str(), 1);
  }
  ~PrivateShaderCache() {
    std::error_code ignored;
    if (!folder_.empty()) fs::remove_all(folder_, ignored);
  }
  PrivateShaderCache(const PrivateShaderCache&) = delete;
  PrivateShaderCache& operator=(const PrivateShaderCache&) = delete;

 private:
  std::string folder_;
};

int run(int argc, char** argv) {
  CLI::App app(
      "Lamina: what accuracy costs. Measures real-time translucency techniques: time, texture fetches and errors of every "
      "variant.",
      "lamina");
  app.set_version_flag("--version",
                       fmt::format("lamina {} (commit {}, build {})", LAMINA_VERSION, LAMINA_COMMIT, LAMINA_BUILD_NAME));
  app.require_subcommand(1);
  const Command commands[] = {add_compare(app), add_gate(app),    add_sweep(app),     add_merge(app), add_stress(app),
                              add_choose(app),  add_diff(app),    add_calibrate(app), add_plan(app),  add_list(app),
                              add_report(app),  add_history(app), add_schema(app),    add_man(app),   add_complete(app)};
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : usage_status;
  }
  const auto* called = std::ranges::find_if(commands, [](const Command& command) { return command.options->parsed(); });
  return called->run(command_line({argv + 1, static_cast<size_t>(argc - 1)}));
}

}  // namespace

int main(int argc, char** argv) {
  use_steady_heap();
  const PrivateShaderCache cache;
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, usable_threads());
  try {
    return run(argc, argv);
  } catch (const Error& error) {
    fmt::print(stderr, "lamina: {}\n", error.what());
    return static_cast<int>(error.kind());
  } catch (const std::exception& error) {
    fmt::print(stderr, "lamina: {}\n", error.what());
    return static_cast<int>(ErrorKind::failed);
  }
}
