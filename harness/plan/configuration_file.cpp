// SPDX-License-Identifier: Apache-2.0
#include "harness/plan/configuration_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "harness/core/text.h"
#include "harness/core/toml_table.h"
#include "harness/manifest/parameter_value.h"

namespace lamina {
namespace {

double value_in(const TomlTable& table, const std::string& path, const ParameterManifest& parameter) {
  return parameter.words.empty() ? checked_number(parameter, table.optional_number(path).value_or(std::nan("")), table, path)
                                 : checked_word(parameter, table.string(path), table, path);
}

// [parameters]: of the variants that are chosen.
void apply_parameters(Plan& plan, const TomlTable& table) {
  std::map<std::string, std::map<std::string, double>> values;  // by effect and parameter
  for (const std::string& path : table.keys()) {
    const std::string name = path.substr(0, path.find('.'));
    const auto chosen = std::ranges::find(plan.chosen, name, [](const auto& entry) { return entry.second->name; });
    if (chosen == plan.chosen.end() || name == path)
      throw table.error(path,
                        fmt::format("'{}' is no parameter of a variant under [variants]; write \"VARIANT.PARAMETER\"", path));
    const std::string parameter = path.substr(name.size() + 1);
    std::vector<std::string> known;
    for (const ParameterManifest& each : chosen->second->parameters) known.push_back(each.name);
    const ParameterManifest* found = chosen->second->parameter(parameter);
    if (!found) throw table.error(path, unknown_name("parameter", parameter, known));
    values[chosen->first][parameter] = value_in(table, path, *found);
  }
  for (const auto& [effect, of_effect] : values) {
    plan.own.push_back(std::make_shared<const VariantManifest>(plan.chosen[effect]->with_defaults(of_effect)));
    plan.chosen[effect] = plan.own.back().get();
  }
}

}  // namespace

TomlFormPtr configuration_form() {
  const TomlKey variant{"EFFECT", "the variant at which this effect stands", {form::text()}};
  const TomlKey parameter{"VARIANT.PARAMETER", "a number, or a word", {form::number(-1e300, 1e300), form::text()}};
  return form::make(
      {{"configuration",
        "what was chosen, and for what",
        {form::table(form::make({{"scene", "the scene that it was chosen for", {form::text()}}}))},
        true},
       {"variants", "the variant of each effect", {form::table(form::make({}, variant))}, true},
       {"parameters", "of these variants, where they are not at their defaults", {form::table(form::make({}, parameter))}}});
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
    for (const VariantManifest& variant : entry->effect->variants) known.push_back(variant.name);
    const VariantManifest* found = entry->effect->variant(wanted);
    if (!found)
      throw variants.error(name, unknown_name("variant", wanted, known) + "; choose again, or give it with --variants-dir");
    plan.chosen[name] = found;
  }
  apply_parameters(plan, table.table("parameters"));
}

std::string configuration_text(const std::string& scene, const Library& library, const Configuration& configuration) {
  toml::table variants, parameters;
  for (const VariantManifest* variant : configuration) {
    variants.insert(variant->effect, variant->name);
    const VariantManifest& declared = *library.effect(variant->effect).variant(variant->name);
    for (const ParameterManifest& parameter : variant->parameters) {
      if (parameter.value == declared.parameter(parameter.name)->value) continue;
      const std::string path = variant->name + "." + parameter.name;
      if (parameter.words.empty())
        parameters.insert(path, parameter.value);
      else
        parameters.insert(path, parameter.text(parameter.value));
    }
  }
  toml::table all{{"configuration", toml::table{{"scene", scene}}}, {"variants", std::move(variants)}};
  if (!parameters.empty()) all.insert("parameters", std::move(parameters));
  std::ostringstream text;
  text << "# Of lamina choose; compare, sweep, gate and plan take it with --configuration.\n" << all << "\n";
  return text.str();
}

}  // namespace lamina
