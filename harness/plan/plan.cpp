// SPDX-License-Identifier: Apache-2.0
#include "harness/plan/plan.h"

#include <algorithm>

#include "harness/plan/seen.h"
#include "harness/scene/declare.h"

namespace lamina {

bool reads_frame_after(const Plan& plan, const EffectManifest& effect) {
  const auto own = std::ranges::find(plan.effects, &effect, &EffectPlan::effect);
  return std::any_of(own, plan.effects.end(), [&](const EffectPlan& entry) {
    return entry.effect != &effect && entry.called_for && entry.effect->reads_frame;
  });
}

namespace {

// Whether all of `needs`, the effect's own or those of one of its features, are met.
bool are_met(const std::vector<NeedManifest>& needs, const EffectManifest& effect, const Scene& scene, const Object* object) {
  return std::all_of(needs.begin(), needs.end(), [&](const NeedManifest& need) {
    const double value = needed_value(effect, scene, object, need.name);
    return need.at_least ? value >= *need.at_least : value > 0;
  });
}

EffectPlan& of_effect(Plan& plan, const EffectManifest& effect) {
  return plan.effects[static_cast<size_t>(&effect - plan.library->effects.data())];
}

bool is_in_a_view(const Scene& scene, const Object& object, double aspect) {
  return std::any_of(scene.views.begin(), scene.views.end(),
                     [&](const View& view) { return may_be_seen(object, view, aspect); });
}

// Gives the object to the effects that draw it. One whose effects need what it has none of is drawn as what no effect draws,
// where it is a surface and does not vanish with that.
void add_object(Plan& plan, const Scene& scene, std::optional<double> aspect, size_t index) {
  const Object& object = scene.objects[index];
  const bool all_run = plan.culling == Culling::off;
  bool drawn = false, over_frame = false, vanishes = false;
  for (const EffectManifest* effect : effects_of(object, *plan.library)) {
    const bool met = are_met(effect->needs, *effect, scene, &object);
    if (aspect && !all_run && effect->only_where_seen && met && !is_in_a_view(scene, object, *aspect))
      ++of_effect(plan, *effect).unseen;
    else if (met || all_run)
      of_effect(plan, *effect).objects.push_back(index);
    drawn = drawn || met || all_run;
    over_frame = over_frame || (met && effect->reads_frame);
    vanishes = vanishes || (!met && effect->vanishes);
  }
  const EffectManifest* otherwise = plan.library->otherwise();
  if (!drawn && !vanishes && object.solid && otherwise) of_effect(plan, *otherwise).objects.push_back(index);
  if (!object.solid || vanishes) return;
  plan.all.push_back(index);
  if (!over_frame) plan.opaque.push_back(index);
}

// Whether some object says each word that the effect needs of one of them.
bool says_what_is_needed(const EffectPlan& entry, const Scene& scene) {
  return std::all_of(entry.effect->object.words.begin(), entry.effect->object.words.end(), [&](const WordManifest& word) {
    return word.needed.empty() || std::any_of(entry.objects.begin(), entry.objects.end(), [&](size_t object) {
             return scene.objects[object].effects.at(entry.effect->name).words.at(word.name) == word.needed;
           });
  });
}

std::string reason_of(const EffectPlan& entry) {
  if (entry.unseen == 0) return entry.called_for ? entry.effect->because : entry.effect->not_because;
  if (!entry.called_for) return "no view sees an object that calls for it";
  const size_t all = entry.objects.size() + entry.unseen;
  return fmt::format("{} ({} of {} objects; no view sees the others)", entry.effect->because, entry.objects.size(), all);
}

void settle_features(EffectPlan& entry, const Scene& scene) {
  for (const FeatureManifest& feature : entry.effect->features) {
    size_t on = 0;
    for (const size_t object : entry.objects) on += are_met(feature.needs, *entry.effect, scene, &scene.objects[object]);
    if (entry.objects.empty()) on = are_met(feature.needs, *entry.effect, scene, nullptr);
    std::string reason = on > 0 ? feature.because : feature.not_because;
    if (on > 0 && on < entry.objects.size()) reason += fmt::format(" (on {} of {} objects)", on, entry.objects.size());
    entry.features.push_back({feature.define, on > 0, reason});
  }
}

}  // namespace

const EffectPlan* Plan::of(std::string_view effect) const {
  for (const EffectPlan& candidate : effects)
    if (candidate.effect->name == effect) return &candidate;
  return nullptr;
}

double needed_value(const EffectManifest& effect, const Scene& scene, const Object* object, std::string_view name) {
  if (object)
    if (const auto values = object->effects.find(effect.name); values != object->effects.end())
      if (const double value = fact_or_number(values->second, name); value != 0) return value;
  const auto values = scene.effects.find(effect.name);
  return values == scene.effects.end() ? 0 : fact_or_number(values->second, name);
}

std::map<std::string, std::string> feature_defines(const EffectManifest& effect, const Scene& scene, const Object* object) {
  std::map<std::string, std::string> defines;
  for (const FeatureManifest& feature : effect.features)
    if (are_met(feature.needs, effect, scene, object)) defines[feature.define] = "1";
  return defines;
}

std::map<std::string, std::string> feature_defines(const Plan& plan, const EffectManifest& effect, const Scene& scene,
                                                   const Object* object) {
  std::map<std::string, std::string> defines = feature_defines(effect, scene, object);
  if (plan.culling == Culling::off)
    for (const FeatureManifest& feature : effect.features)
      if (feature.at_zero) defines[feature.define] = "1";
  return defines;
}

Plan make_plan(const Library& library, const Scene& scene, std::optional<double> aspect, Culling culling) {
  Plan plan;
  plan.library = &library;
  plan.culling = culling;
  for (const EffectManifest& effect : library.effects) plan.effects.emplace_back().effect = &effect;
  for (size_t i = 0; i < scene.objects.size(); ++i) add_object(plan, scene, aspect, i);
  for (EffectPlan& entry : plan.effects) {
    const EffectManifest& effect = *entry.effect;
    if (culling == Culling::off) {
      entry.called_for = scene.effects.contains(effect.name) || !entry.objects.empty();
    } else {
      if (!says_what_is_needed(entry, scene)) entry.objects.clear();
      entry.called_for = effect.of_objects()
                             ? !entry.objects.empty()
                             : scene.effects.contains(effect.name) && are_met(effect.needs, effect, scene, nullptr);
    }
    entry.reason = reason_of(entry);
    if (entry.called_for) settle_features(entry, scene);
  }
  return plan;
}

Configuration configuration_of(const Plan& plan, const std::map<std::string, const VariantManifest*, std::less<>>& variants) {
  Configuration configuration;
  for (const EffectPlan& entry : plan.effects) {
    if (!entry.called_for) continue;
    const VariantManifest* variant = &entry.effect->baseline();
    for (const auto* given : {&plan.chosen, &variants})
      if (const auto found = given->find(entry.effect->name); found != given->end()) variant = found->second;
    configuration.push_back(variant);
  }
  return configuration;
}

Configuration configuration_with(const Plan& plan, const VariantManifest& variant) {
  return configuration_of(plan, {{variant.effect, &variant}});
}

}  // namespace lamina
