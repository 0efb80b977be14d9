// SPDX-License-Identifier: Apache-2.0
#include "harness/plan/configuration_file.h"

#include <sstream>

#include "harness/core/text.h"
#include "harness/core/toml_table.h"

namespace lamina {

TomlFormPtr configuration_form() {
  const TomlKey variant{"EFFECT", "the variant at which this effect stands", {form::text()}};
  return form::make({{"configuration",
                      "what was chosen, and for what",
                      {form::table(form::make({{"scene", "the scene that it was chosen for", {form::text()}}}))},
                      true},
                     {"variants", "the variant of each effect", {form::table(form::make({}, variant))}, true}});
}

void apply_configuration(Plan& plan, const std::filesystem::path& file) {
  const TomlTable table = TomlTable::parse(file, "configuration", configuration_form());
  table.check_keys();
  table.table("configuration").check_keys();
  const TomlTable variants = table.table("variants");
  std::vector<std::string> effects;
  for (const EffectManifest& effect : plan.library->effects) effects.push_back(effect.name);
  for (const std::string& name : variants.keys()) {
    const EffectPlan* entry = plan.of(name);
    if (!entry) throw variants.error(name, unknown_name("effect", name, effects));
    const std::string wanted = variants.string(name);
    std::vector<std::string> known;
    const VariantManifest* found = nullptr;
    for (const VariantManifest& variant : entry->effect->variants) {
      known.push_back(variant.name);
      if (variant.name == wanted) found = &variant;
    }
    if (!found)
      throw variants.error(name, unknown_name("variant", wanted, known) + "; choose again, or give it with --variants-dir");
    plan.chosen[name] = found;
  }
}

std::string configuration_text(const std::string& scene, const std::map<std::string, std::string>& variants) {
  toml::table of_effects;
  for (const auto& [effect, variant] : variants) of_effects.insert(effect, variant);
  std::ostringstream text;
  text << "# Of lamina choose; compare, sweep, gate and plan take it with --configuration.\n"
       << toml::table{{"configuration", toml::table{{"scene", scene}}}, {"variants", std::move(of_effects)}} << "\n";
  return text.str();
}

}  // namespace lamina
