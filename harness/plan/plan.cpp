// SPDX-License-Identifier: Apache-2.0
#include "harness/plan/plan.h"

#include "harness/core/text.h"

namespace lamina {
namespace {

double fact(const Object& object, const std::string& name, const EffectManifest& effect) {
  const auto facts = facts_of(object);
  if (const auto found = facts.find(name); found != facts.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [known, value] : facts) names.push_back(known);
  throw Error(ErrorKind::bad_input, "variants", effect.name + "/effect.toml", unknown_name("fact", name, names));
}

}  // namespace

const EffectPlan* Plan::of(std::string_view effect) const {
  for (const EffectPlan& candidate : effects)
    if (candidate.effect->name == effect) return &candidate;
  return nullptr;
}

std::map<std::string, double> facts_of(const Object& object) {
  const bool layers = object.layers.has_value(), apertures = object.apertures.has_value();
  return {{"layers", layers},
          {"apertures", apertures},
          {"aperture_texels", apertures ? object.apertures->map_texels : 0},
          {"plain", !layers && !apertures},
          {"seen_thickness", layers && object.layers->max_transparency > 0 ? object.layers->thickness_texels : 0},
          {"transparency", layers ? object.layers->max_transparency : 0}};
}

std::map<std::string, std::string> feature_defines(const EffectManifest& effect, const Object& object) {
  std::map<std::string, std::string> defines;
  for (const FeatureManifest& feature : effect.features)
    if (fact(object, feature.fact, effect) > 0) defines[feature.define] = "1";
  return defines;
}

Plan make_plan(const Library& library, const Scene& scene) {
  Plan plan;
  for (const EffectManifest& effect : library.effects) {
    EffectPlan entry;
    entry.effect = &effect;
    for (size_t i = 0; i < scene.objects.size(); ++i)
      if (fact(scene.objects[i], effect.called_by, effect) > 0) entry.objects.push_back(i);
    entry.called_for = !entry.objects.empty();
    entry.reason = entry.called_for ? effect.because : effect.not_because;
    for (const FeatureManifest& feature : effect.features) {
      size_t on = 0;
      for (const size_t object : entry.objects) on += fact(scene.objects[object], feature.fact, effect) > 0;
      if (!entry.called_for) continue;
      std::string reason = on > 0 ? feature.because : feature.not_because;
      if (on > 0 && on < entry.objects.size()) reason += fmt::format(" (on {} of {} objects)", on, entry.objects.size());
      entry.features.push_back({feature.define, on > 0, reason});
    }
    plan.effects.push_back(std::move(entry));
  }
  return plan;
}

Configuration configuration_with(const Plan& plan, const VariantManifest& variant) {
  Configuration configuration;
  for (const EffectPlan& entry : plan.effects) {
    if (!entry.called_for) continue;
    configuration.push_back(entry.effect->name == variant.effect ? &variant : &entry.effect->baseline());
  }
  return configuration;
}

}  // namespace lamina
