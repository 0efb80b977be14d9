// SPDX-License-Identifier: Apache-2.0
// The options that several commands have, each said once; a command's own are in its file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/cli/placeholders.h"
#include "harness/core/disk_cache.h"
#include "harness/measure/rounds.h"

namespace CLI {
class App;
}

namespace lamina {

struct FrameSize {
  uint32_t width_px = 512, height_px = 512;
  double aspect() const { return static_cast<double>(width_px) / height_px; }
};

// Of commands that look at a scene.
struct SceneOptions {
  std::string scene = "heart";
  std::optional<float> time_s;
  std::vector<std::filesystem::path> variants_dirs;
  std::filesystem::path configuration;  // a file of lamina choose; empty: effects stand at their baselines
};

// Of commands that run on devices.
struct DeviceOptions {
  std::vector<std::string> backends = {"vulkan", "osmesa"};
  std::string device;  // as BackendOptions has it
  bool validation = LAMINA_VALIDATION;
};

// Of commands that leave cells: which ones, and how exactly each is known.
struct CellOptions : DeviceOptions, FrameSize {
  SceneOptions scene;
  std::filesystem::path out = "lamina-out";
  std::vector<std::string> variants;                     // NAME or EFFECT/NAME; empty: all. Baselines are always there.
  size_t truth_rays = 256;                               // a pixel and light; 0: no truth
  std::filesystem::path cache = default_cache_folder();  // of bakes and truths; empty: none
  bool alpha = false;                                    // alpha counts, even where no later effect reads it
  std::string command;                                   // as the user typed it
};

// Each adds options to a command, in the order in which its help shows them; what they set must outlive the parsing. Texts that
// differ between commands are given.
void add_scene_name(CLI::App& command, SceneOptions& options,
                    const std::string& help = "Scene file (.toml), glTF model (.glb, .gltf) or built-in scene");
void add_variants_dir(CLI::App& command, SceneOptions& options,
                      const std::string& help = "Folder with variants of your own: manifests and shaders (may be given again)");
// The two above, and between them --time.
void add_scene(CLI::App& command, SceneOptions& options);
void add_configuration(CLI::App& command, SceneOptions& options);
void add_out(CLI::App& command, std::filesystem::path& out, const std::string& help = "Folder for record, report and pictures");
void add_backends(CLI::App& command, DeviceOptions& options);  // and --device
void add_variant(CLI::App& command, std::vector<std::string>& variants,
                 const std::string& help = "Only this variant and the baseline (may be given again)",
                 const char* value = placeholder::variant);
// Throws Error(bad_input) while it is parsed.
void add_size(CLI::App& command, FrameSize& size);
// --budget and --precision; `timed`: what has a budget of its own.
void add_rounds(CLI::App& command, RoundOptions& rounds, const std::string& timed);
void add_truth(CLI::App& command, CellOptions& options);  // --truth-rays and --cache
void add_cache(CLI::App& command, std::filesystem::path& cache);
void add_alpha(CLI::App& command, CellOptions& options);
void add_seed(CLI::App& command, uint64_t& seed, const std::string& help = "Seed of the order of rounds");
void add_validation(CLI::App& command, DeviceOptions& options);

}  // namespace lamina
