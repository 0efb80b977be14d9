// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/graph.h"

#include <algorithm>

#include "harness/core/text.h"
#include "harness/graph/blocks.h"
#include "harness/graph/left_out.h"
#include "harness/scene/mesh/hull_check.h"

namespace lamina {
namespace {

// The definition that shaders of variants with views of lights get.
constexpr const char* casting_lights_define = "CASTING_LIGHTS";

bool is_per_object(const PassManifest& pass, const VariantManifest& variant) {
  if (pass.draw == DrawKind::objects || pass.draw == DrawKind::unwrapped) return true;
  return std::any_of(pass.writes.begin(), pass.writes.end(), [&](const std::string& name) {
    const TargetManifest* target = variant.target(name);
    return target && target->scope == Scope::object;
  });
}

bool has_light_views(const VariantManifest& variant) {
  return std::any_of(variant.passes.begin(), variant.passes.end(),
                     [](const PassManifest& pass) { return pass.view == PassView::light; });
}

std::string frequency_words(const PassManifest& pass, const Scene& scene, bool& once) {
  once = pass.when == Frequency::once;
  if (pass.when == Frequency::once) return "once for the scene";
  if (pass.when == Frequency::truth) return "for the truth alone";
  if (pass.when == Frequency::frame || pass.when == Frequency::frame_and_truth) return "every frame";
  once = !scene.moves();
  if (once) return "once: meshes and lights are still";
  return scene.mesh_moves || scene.objects_move ? "every frame: a mesh moves" : "every frame: a light moves";
}

// The effect's objects that the pass is of: those with and without the features that it names.
std::vector<size_t> chosen_objects(const Plan& plan, const EffectPlan& effect, const PassManifest& pass, const Scene& scene) {
  if (pass.with.empty() && pass.without.empty()) return effect.objects;
  std::vector<size_t> chosen;
  for (const size_t object : effect.objects) {
    const auto features = feature_defines(plan, *effect.effect, scene, &scene.objects[object]);
    if ((pass.with.empty() || features.contains(pass.with)) && !features.contains(pass.without)) chosen.push_back(object);
  }
  return chosen;
}

std::string chosen_words(const PassManifest& pass) {
  const std::string without = pass.without.empty() ? "" : "without " + pass.without;
  if (pass.with.empty()) return without;
  return "with " + pass.with + (without.empty() ? "" : " and " + without);
}

// Features that the effect does not have.
void check_features(const EffectManifest& effect, const PassManifest& pass) {
  std::vector<std::string> known;
  for (const FeatureManifest& feature : effect.features) known.push_back(feature.define);
  for (const std::string& name : {pass.with, pass.without})
    if (!name.empty() && std::find(known.begin(), known.end(), name) == known.end())
      throw Error(ErrorKind::bad_input, "variants", pass.where, unknown_name("feature", name, known));
}

void require_closed(const EffectPlan& effect, const VariantManifest& variant, const Scene& scene) {
  for (const size_t object : effect.objects)
    if (const auto problem = hull_problem(scene.objects[object].mesh))
      throw Error(ErrorKind::failed, "plan", fmt::format("object '{}'", scene.objects[object].name),
                  fmt::format("{} needs a closed hull, and its mesh {}", variant.name, *problem));
}

using Definitions = std::map<std::string, std::string>;
using Stages = std::vector<std::shared_ptr<const CompiledShader>>;

class Maker {
 public:
  Maker(const Plan& plan, const Scene& scene, ShaderCache& shaders, const Parameters& parameters)
      : plan_(plan), scene_(scene), shaders_(shaders), parameters_(parameters), casting_(casting_lights(scene)) {}

  GraphPass make_pass(const EffectPlan& effect, const VariantManifest& variant, const PassManifest& manifest) {
    GraphPass pass;
    pass.effect = effect.effect, pass.variant = &variant, pass.pass = &manifest;
    pass.reason = frequency_words(manifest, scene_, pass.once);
    std::vector<std::optional<size_t>> lights = {std::nullopt};
    if (manifest.view == PassView::light) {
      if (casting_.empty())
        throw Error(
            ErrorKind::bad_input, "variants", manifest.where,
            fmt::format("pass '{}' is drawn from each light that casts, and none does: say casts = true for a light of {}",
                        manifest.name, scene_.name));
      lights.assign(casting_.begin(), casting_.end());
    }
    for (const std::optional<size_t> light : lights) {
      if (!is_per_object(manifest, variant)) {
        pass.draws.push_back(make_draw(pass, std::nullopt, light));
        continue;
      }
      const std::vector<size_t> objects = objects_of(effect, manifest);
      for (const size_t object : objects) pass.draws.push_back(make_draw(pass, object, light));
      // A scene without any such object still has the targets that are cleared before them.
      if (objects.empty() && manifest.draw == DrawKind::objects) pass.draws.push_back({.light = light});
    }
    return pass;
  }

 private:
  std::vector<size_t> objects_of(const EffectPlan& effect, const PassManifest& pass) const {
    if (pass.of != DrawnObjects::own) return pass.of == DrawnObjects::all ? plan_.all : plan_.opaque;
    return chosen_objects(plan_, effect, pass, scene_);
  }

  Definitions definitions(const GraphPass& pass, const Object* object) {
    Definitions defines = features(*pass.effect, object);
    if (!pass.effect->baker.empty())
      for (const auto& [name, text] : plan_.library->code->bakers.at(pass.effect->baker)->defines(pass.variant->bake))
        defines[name] = text;
    if (has_light_views(*pass.variant)) defines[casting_lights_define] = fmt::format("{}", casting_.size());
    for (const auto& [name, text] : pass.pass->defines) {
      defines[name] = text;
      if (!text.starts_with('$')) continue;
      const ParameterManifest& parameter = *pass.variant->parameter(text.substr(1));
      defines[name] = parameter.text(pass.variant->value_of(parameter, parameters_));
    }
    return defines;
  }

  // Asked for each draw of an object, and the same for all.
  const Definitions& features(const EffectManifest& effect, const Object* object) {
    const auto [known, is_new] = features_.try_emplace({&effect, object});
    if (is_new) known->second = feature_defines(plan_, effect, scene_, object);
    return known->second;
  }

  GraphDraw make_draw(const GraphPass& pass, std::optional<size_t> index, std::optional<size_t> light) {
    const Object* object = index ? &scene_.objects[*index] : nullptr;
    if (pass.pass->draw == DrawKind::unwrapped && !object->unwrap_problem.empty())
      throw Error(ErrorKind::failed, "plan", fmt::format("object '{}'", object->name),
                  fmt::format("cannot be drawn unwrapped, as pass '{}' needs: {}", pass.pass->name, object->unwrap_problem));
    GraphDraw draw;
    draw.object = index, draw.light = light;
    draw.stages = compiled(pass, definitions(pass, object));
    resolve(pass, draw);
    check_names(pass, draw, object);
    return draw;
  }

  // The same for all objects with the same definitions.
  const Stages& compiled(const GraphPass& pass, Definitions defines) {
    const auto [known, is_new] = compiled_.try_emplace({pass.pass, std::move(defines)});
    if (is_new) known->second = compile(*pass.pass, known->first.second);
    return known->second;
  }

  Stages compile(const PassManifest& pass, const Definitions& defines) {
    Stages stages;
    if (pass.draw == DrawKind::mips) return stages;
    if (!pass.vertex.empty()) {
      stages.push_back(shaders_.get(pass.vertex, Stage::vertex, defines));
      stages.push_back(shaders_.get(pass.fragment, Stage::fragment, defines));
    }
    if (pass.draw == DrawKind::compute) stages.push_back(shaders_.get(pass.compute, Stage::compute, defines));
    if (stages.size() == 2) part_blocks(stages);
    return stages;
  }

  // Both stages may declare a block of one name, each with the members that it wants. Where these differ they are two buffers,
  // and need two bindings: the fragment stage's moves to one that is free.
  void part_blocks(Stages& stages) {
    const std::vector<ShaderResource> vertex = stages[0]->reflection.resources, fragment = stages[1]->reflection.resources;
    uint32_t free = 0;
    for (const auto* resources : {&vertex, &fragment})
      for (const ShaderResource& resource : *resources) free = std::max(free, resource.binding + 1);
    for (const ShaderResource& mine : fragment)
      for (const ShaderResource& other : vertex)
        if (mine.binding == other.binding && mine.kind == BindingKind::uniform_buffer && other.kind == mine.kind &&
            layout_key(mine) != layout_key(other))
          stages[1] = shaders_.rebound(stages[1], mine.binding, free++);
  }

  void resolve(const GraphPass& pass, GraphDraw& draw) {
    const SourceContext sources{plan_, scene_, *pass.effect, *pass.variant, *pass.pass, draw.object, draw.light};
    const BlockContext blocks{
        scene_, *plan_.library, *pass.effect, pass.pass->where, 0, pass.pass->view, draw.light, draw.object, 1, 1, {}};
    std::set<uint32_t> seen;
    for (const auto& stage : draw.stages)
      for (const ShaderResource& resource : stage->reflection.resources) {
        if (!seen.insert(resource.binding).second) continue;
        if (resource.kind == BindingKind::texture)
          draw.reads.push_back({resource.binding, resource.name, texture_source(sources, resource.name)});
        else if (resource.kind == BindingKind::storage_buffer)
          draw.buffers.push_back({resource.binding, buffer_source(sources, resource.name)});
      }
    for (const auto& stage : draw.stages)
      for (const ShaderResource& resource : stage->reflection.resources)
        if (resource.kind == BindingKind::uniform_buffer &&
            checked_.insert({stage.get(), resource.binding, pass.effect, draw.object.has_value(), pass.pass->view}).second)
          check_block(resource, block_values(resource, blocks), pass.pass->where);
    for (const ResolvedRead& read : draw.reads)
      if (read.source.kind == Source::Kind::frame && !pass.effect->reads_frame)
        throw Error(
            ErrorKind::bad_input, "variants", pass.pass->where,
            fmt::format("pass '{}' reads the frame: say reads_frame = true in {}, so that {} is drawn after what does not",
                        pass.pass->name, pass.effect->file.string(), pass.effect->name));
  }

  // Samplers and specialization constants that the manifest names and the shaders do not have.
  void check_names(const GraphPass& pass, const GraphDraw& draw, const Object* object) const {
    std::vector<std::string> samplers, constants;
    for (const ResolvedRead& read : draw.reads) samplers.push_back(read.sampler);
    for (const auto& stage : draw.stages)
      for (const SpecConstantInfo& constant : stage->reflection.constants) constants.push_back(constant.name);
    const auto expect = [&](const char* what, const std::string& name, const std::vector<std::string>& known) {
      if (std::find(known.begin(), known.end(), name) == known.end())
        throw Error(ErrorKind::bad_input, "variants", pass.pass->where, unknown_name(what, name, known));
    };
    // An object's features may have left a sampler out.
    for (const auto& [sampler, read] : pass.pass->reads)
      if (!object) expect("sampler", sampler, samplers);
    for (const auto& [name, text] : pass.pass->constants) expect("specialization constant", name, constants);
  }

  struct Checked {
    const CompiledShader* shader;
    uint32_t binding;
    const EffectManifest* effect;
    bool of_object;
    PassView view;
    auto operator<=>(const Checked&) const = default;
  };

  const Plan& plan_;
  const Scene& scene_;
  ShaderCache& shaders_;
  const Parameters& parameters_;
  const std::vector<size_t> casting_;
  std::set<Checked> checked_;
  std::map<std::pair<const PassManifest*, Definitions>, Stages> compiled_;
  std::map<std::pair<const EffectManifest*, const Object*>, Definitions> features_;
};

}  // namespace

std::set<std::string> Graph::shader_hashes() const {
  std::set<std::string> hashes;
  for (const GraphPass& pass : passes)
    for (const GraphDraw& draw : pass.draws)
      for (const auto& stage : draw.stages) hashes.insert(stage->hash);
  return hashes;
}

bool has_truth_passes(const VariantManifest& variant) {
  return std::any_of(variant.passes.begin(), variant.passes.end(),
                     [](const PassManifest& pass) { return pass.when == Frequency::truth; });
}

Resource target_of(const VariantManifest& variant, const std::string& name, const GraphDraw& draw,
                   std::optional<size_t> light_of_read) {
  const TargetManifest* target = variant.target(name);
  const Scope scope = target ? target->scope : Scope::frame;
  return {target && target->shared ? nullptr : &variant, name, scope == Scope::object ? draw.object : std::nullopt,
          scope != Scope::light ? std::nullopt
          : light_of_read       ? light_of_read
                                : draw.light};
}

Graph make_graph(const Plan& plan, const Configuration& configuration, const Scene& scene, ShaderCache& shaders,
                 const VariantManifest* told, const Parameters& parameters) {
  Graph graph;
  graph.library = plan.library;
  graph.parameters = parameters;
  Maker maker(plan, scene, shaders, graph.parameters);
  for (const VariantManifest* variant : configuration) {
    const EffectPlan& effect = *plan.of(variant->effect);
    const bool truth = variant == told && has_truth_passes(*variant);
    if (variant->closed) require_closed(effect, *variant, scene);
    for (const PassManifest& manifest : variant->passes) {
      if ((manifest.when == Frequency::truth) != truth && manifest.when != Frequency::frame_and_truth) continue;
      if (variant->value_of(manifest.repeat, parameters) < 1) continue;
      if (manifest.view == PassView::light && !manifest.needs_light && casting_lights(scene).empty()) {
        graph.dropped.push_back({.effect = effect.effect, .variant = variant, .pass = &manifest, .reason = "no light casts"});
        continue;
      }
      check_features(*effect.effect, manifest);
      if (!chosen_words(manifest).empty() && chosen_objects(plan, effect, manifest, scene).empty()) {
        graph.dropped.push_back({.effect = effect.effect,
                                 .variant = variant,
                                 .pass = &manifest,
                                 .reason = "left out: no object " + chosen_words(manifest)});
        continue;
      }
      graph.passes.push_back(maker.make_pass(effect, *variant, manifest));
    }
  }
  if (plan.culling == Culling::on) {
    leave_out_repeated(graph);
    leave_out_unread(graph);
  }
  check_written_before_read(graph);
  return graph;
}

}  // namespace lamina
