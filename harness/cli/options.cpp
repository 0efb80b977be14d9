// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/options.h"

#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "harness/backend/backend.h"
#include "harness/cli/placeholders.h"
#include "harness/core/error.h"

namespace lamina {
namespace {

constexpr uint32_t largest_px = 65536;

std::pair<uint32_t, uint32_t> parse_size(const std::string& text) {
  unsigned long width = 0, height = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%lux%lu%c", &width, &height, &rest) != 2 || text.starts_with('-') || width < 1 || height < 1 ||
      width > largest_px || height > largest_px)
    throw Error(ErrorKind::bad_input, "options", "--size",
                fmt::format("'{}' must be WIDTHxHEIGHT, each from 1 to {}", text, largest_px));
  return {static_cast<uint32_t>(width), static_cast<uint32_t>(height)};
}

}  // namespace

void add_scene_name(CLI::App& command, SceneOptions& options, const std::string& help) {
  command.add_option("scene", options.scene, help)->capture_default_str()->type_name(placeholder::scene);
}

void add_variants_dir(CLI::App& command, SceneOptions& options, const std::string& help) {
  command.add_option("--variants-dir", options.variants_dirs, help)->type_name(placeholder::directory);
}

void add_scene(CLI::App& command, SceneOptions& options) {
  add_scene_name(command, options);
  command.add_option("--time", options.time_s, "Moment of the scene")->type_name("SECONDS");
  add_variants_dir(command, options);
}

void add_configuration(CLI::App& command, SceneOptions& options) {
  command
      .add_option("--configuration", options.configuration,
                  "File of lamina choose: at which variant each effect stands while another is compared (default: baselines)")
      ->type_name(placeholder::file);
}

void add_out(CLI::App& command, std::filesystem::path& out, const std::string& help) {
  command.add_option("--out", out, help)->capture_default_str()->type_name(placeholder::directory);
}

void add_backends(CLI::App& command, DeviceOptions& options) {
  command.add_option("--backend", options.backends, fmt::format("{} (may be given again)", fmt::join(backend_names(), ", ")))
      ->capture_default_str()
      ->type_name(placeholder::backend);
  command.add_option("--device", options.device, "Part of a device's name, or its number in 'lamina list'")
      ->type_name(placeholder::device);
}

void add_variant(CLI::App& command, std::vector<std::string>& variants, const std::string& help, const char* value) {
  command.add_option("--variant", variants, help)->type_name(value);
}

void add_size(CLI::App& command, FrameSize& size) {
  command
      .add_option_function<std::string>(
          "--size", [&size](const std::string& text) { std::tie(size.width_px, size.height_px) = parse_size(text); },
          "Size of the frame in pixels")
      ->type_name(placeholder::size)
      ->default_str(fmt::format("{}x{}", size.width_px, size.height_px));
}

void add_rounds(CLI::App& command, RoundOptions& rounds, const std::string& timed) {
  command.add_option("--budget", rounds.budget_s, "Seconds of timed rounds " + timed)
      ->capture_default_str()
      ->type_name("SECONDS")
      ->check(CLI::Range(0.0, 86400.0));
  command.add_option("--precision", rounds.precision, "Stop where each ratio's 95% interval has this half width, relative")
      ->capture_default_str()
      ->check(CLI::Range(1e-6, 1.0));
}

void add_truth(CLI::App& command, CellOptions& options) {
  command.add_option("--truth-rays", options.truth_rays, "Rays a pixel and light for the truth; 0: no truth")
      ->capture_default_str()
      ->check(CLI::Range(0, 65536));
  add_cache(command, options.cache);
}

void add_cache(CLI::App& command, std::filesystem::path& cache) {
  command.add_option("--cache", cache, "Folder that keeps bakes, truths, cost models and timers' certificates; \"\": none")
      ->capture_default_str()
      ->type_name(placeholder::directory);
}

void add_alpha(CLI::App& command, CellOptions& options) {
  command.add_flag("--alpha", options.alpha, "Compare the frame's alpha too; without it, where a later effect reads the frame");
}

void add_seed(CLI::App& command, uint64_t& seed, const std::string& help) {
  command.add_option("--seed", seed, help)->capture_default_str();
}

void add_validation(CLI::App& command, DeviceOptions& options) {
  command.add_flag("--validation,!--no-validation", options.validation,
                   "Check API use: Vulkan's validation layers, OpenGL's debug output");
}

}  // namespace lamina
