// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/targets.h"

#include <stdexcept>

#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/gate/limits.h"
#include "harness/record/record.h"
#include "harness/scene/gltf/gltf.h"
#include "harness/scene/scene_file.h"
#include "harness/scene/textures.h"
#include "harness/stress/family.h"
#include "harness/stress/point_sets.h"
#include "tests/builtin_library.h"

namespace lamina {
namespace {

namespace fs = std::filesystem;

const Family& caps() {
  static const Family family = load_family(fs::path(LAMINA_SOURCE_DIR) / "shaders/cap_intersection/family.toml", effect_code());
  return family;
}

const GateNames gate_names{{"layered_material", "skin"}, {"light_map", "vertex_normal", "face"}, {"vulkan", "osmesa", "egl"}};

constexpr FuzzTarget targets[] = {
    {"scene", "scene.toml", [](const fs::path& file) { read_scene_file(file, builtin_library(), std::nullopt); }},
    {"manifest", "variant.toml", [](const fs::path& file) { read_variant(file, "", fs::path(LAMINA_SOURCE_DIR) / "shaders"); }},
    {"effect", "effect.toml", [](const fs::path& file) { read_effect(file, effect_code()); }},
    {"family", "family.toml", [](const fs::path& file) { load_family(file, effect_code()); }},
    {"gate", "gate.toml", [](const fs::path& file) { LimitsFile(file, gate_names); }},
    {"points", "points.txt", [](const fs::path& file) { read_points(caps(), file); }},
    {"record", "record.jsonl", [](const fs::path& file) { read_record(file); }},
    {"gltf", "model.gltf", [](const fs::path& file) { load_gltf(file); }},
    {"glb", "model.glb", [](const fs::path& file) { load_gltf(file); }},
    {"picture", "picture.png", [](const fs::path& file) { load_texels(file, true); }},
    {"encoded_picture", "picture.bin",
     [](const fs::path& file) {
       const std::string bytes = read_file(file, "fuzz");
       decode_texels(std::as_bytes(std::span(bytes)), "picture", false);
     }},
};

}  // namespace

std::span<const FuzzTarget> fuzz_targets() { return targets; }

void run_target(const FuzzTarget& target, const fs::path& file) {
  try {
    target.read(file);
  } catch (const Error& error) {
    // What the file itself says may be quoted: the fuzzer finds these words here and puts them into files.
    for (const char* word : {"std::", "json.exception", "bad_alloc", "basic_string", "vector::"})
      if (error.message().find(word) != std::string::npos && read_file(file, "fuzz").find(word) == std::string::npos)
        throw std::logic_error(fmt::format("{}: words of the parser: {}", target.name, error.what()));
  }
}

}  // namespace lamina
