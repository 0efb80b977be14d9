// SPDX-License-Identifier: Apache-2.0
// How long planning takes: a scene of many objects, a library of ten effects. Prints milliseconds for 1,000 objects, and how
// the time grows with their number.
#include <fmt/format.h>
#include <unistd.h>

#include <fstream>

#include "harness/core/stopwatch.h"
#include "harness/plan/plan.h"

namespace fs = std::filesystem;

namespace {

// Seven effects more than the built-in three, each with a feature.
fs::path more_effects() {
  const fs::path folder = fs::temp_directory_path() / fmt::format("lamina_planning_{}", ::getpid());
  for (int i = 0; i < 7; ++i) {
    const fs::path effect = folder / fmt::format("more_{}", i);
    fs::create_directories(effect);
    std::ofstream(effect / "effect.toml") << fmt::format(
        "[effect]\nname = \"more_{0}\"\ntitle = \"t\"\nkey = \"more_{0}\"\nbecause = \"b\"\nnot_because = \"n\"\n"
        "[numbers.amount_{0}]\nvalue = 1\n[features.AMOUNT]\nneeds = [\"amount_{0}\"]\nbecause = \"b\"\nnot_because = \"n\"\n",
        i);
    std::ofstream(effect / "full.toml") << fmt::format(
        "[variant]\nname = \"full_{}\"\nbaseline = true\n[[pass]]\nname = \"draw\"\ndraw = \"objects\"\nvertex = "
        "\"common/object.vert\"\nfragment = \"surface/lambert.frag\"\nwrite = [\"frame\"]\n",
        i);
  }
  return folder;
}

double planning_ms(const lamina::Library& library, size_t objects) {
  lamina::Scene scene;
  for (size_t i = 0; i < objects; ++i) {
    lamina::Object& object = scene.objects.emplace_back();
    object.name = fmt::format("object {}", i);
    const lamina::EffectManifest& effect = library.effects[i % library.effects.size()];
    object.effects[effect.name].numbers = {{fmt::format("amount_{}", i % 7), double(i % 2)}};
  }
  constexpr int times = 20;
  const lamina::Stopwatch watch;
  for (int i = 0; i < times; ++i) lamina::make_plan(library, scene);
  return watch.elapsed_s() * 1000 / times;
}

}  // namespace

int main() {
  const fs::path folder = more_effects();
  const lamina::Library library = lamina::load_library(LAMINA_SOURCE_DIR, lamina::effect_code(), {folder});
  const double thousand = planning_ms(library, 1000), ten_thousand = planning_ms(library, 10000);
  fmt::print("planning 1,000 objects with {} effects: {:.3f} ms; ten times the objects take {:.1f} times as long\n",
             library.effects.size(), thousand, ten_thousand / thousand);
  fs::remove_all(folder);
}
