// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/graph.h"

#include <algorithm>

#include "harness/core/text.h"

namespace lamina {
namespace {

const std::vector<std::string> object_textures = {"outer_albedo", "outer_normal", "inner_albedo", "albedo"};
// Textures of objects repeat, as glTF's default sampler does.
constexpr Sampler object_sampler = {Filter::trilinear, Wrap::repeat};

// Maps are of the unit tile, and radii must not be mixed with what lies across its border.
constexpr Sampler aperture_sampler = {Filter::linear, Wrap::clamp};

// The samplers of a variant's aperture maps are aperture_0, aperture_1, ...
std::optional<uint32_t> aperture_named(const VariantManifest& variant, std::string_view sampler) {
  for (uint32_t i = 0; variant.apertures && i < variant.apertures->count; ++i)
    if (sampler == fmt::format("aperture_{}", i)) return i;
  return std::nullopt;
}

bool is_per_object(const PassManifest& pass, const VariantManifest& variant) {
  if (pass.draw == DrawKind::objects || pass.draw == DrawKind::unwrapped) return true;
  for (const std::string& name : pass.writes)
    if (const TargetManifest* target = variant.target(name)) return target->scope == Scope::object;
  return false;
}

Source resolve_source(const VariantManifest& variant, const PassManifest& pass, const std::string& sampler,
                      const Object* object) {
  const auto declared = pass.reads.find(sampler);
  const ReadManifest read = declared != pass.reads.end() ? declared->second : ReadManifest{sampler, {}, {}};
  Source source;
  source.name = read.source;
  source.variant = &variant;
  if (const TargetManifest* target = variant.target(read.source)) {
    source.kind = Source::Kind::target;
    source.sampler = target->sampler;
  } else if (read.source == "frame") {
    source.kind = Source::Kind::frame;
    source.sampler = {Filter::nearest, Wrap::clamp};
  } else if (read.source == "depth") {
    source.kind = Source::Kind::depth;
    source.sampler = {Filter::nearest, Wrap::clamp};
    if (pass.depth != Depth::none)
      throw Error(ErrorKind::bad_input, "variants", pass.where,
                  "a pass cannot read 'depth' while it tests against it: set depth = \"none\"");
  } else if (object && object_texture(*object, read.source)) {
    source.sampler = object_sampler;
  } else if (const auto aperture = aperture_named(variant, read.source)) {
    source.kind = Source::Kind::aperture_map;
    source.aperture = *aperture;
    source.sampler = aperture_sampler;
  } else if (read.source == "cap_table") {
    source.kind = Source::Kind::cap_table;
    source.sampler = {Filter::linear, Wrap::clamp};
  } else {
    std::vector<std::string> names = {"frame", "depth"};
    for (const TargetManifest& known : variant.targets) names.push_back(known.name);
    names.emplace_back("cap_table");
    if (object) names.insert(names.end(), object_textures.begin(), object_textures.end());
    throw Error(ErrorKind::bad_input, "variants", pass.where,
                fmt::format("pass '{}' samples '{}': {}", pass.name, sampler, unknown_name("texture", read.source, names)));
  }
  if (read.filter) source.sampler.filter = *read.filter;
  if (read.wrap) source.sampler.wrap = *read.wrap;
  return source;
}

void check_constants(const GraphPass& pass, const GraphDraw& draw) {
  std::vector<std::string> known;
  for (const auto& stage : draw.stages)
    for (const SpecConstantInfo& constant : stage->reflection.constants) known.push_back(constant.name);
  for (const auto& [name, text] : pass.pass->constants)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw Error(ErrorKind::bad_input, "variants", pass.pass->where, unknown_name("specialization constant", name, known));
}

GraphDraw make_draw(const GraphPass& pass, const EffectManifest& effect, const Object* object, std::optional<size_t> index,
                    ShaderCache& shaders) {
  GraphDraw draw;
  draw.object = index;
  std::map<std::string, std::string> defines = object ? feature_defines(effect, *object) : std::map<std::string, std::string>{};
  if (pass.variant->apertures) {
    defines["APERTURES"] = fmt::format("{}", pass.variant->apertures->count);
    if (pass.variant->apertures->anti) defines["ANTI_APERTURE"] = "1";
  }
  for (const auto& [name, text] : pass.pass->defines) defines[name] = text;
  if (!pass.pass->vertex.empty() && pass.pass->draw != DrawKind::mips) {
    draw.stages.push_back(shaders.get(pass.pass->vertex, Stage::vertex, defines));
    draw.stages.push_back(shaders.get(pass.pass->fragment, Stage::fragment, defines));
  }
  if (pass.pass->draw == DrawKind::compute) draw.stages.push_back(shaders.get(pass.pass->compute, Stage::compute, defines));
  std::set<uint32_t> seen;
  for (const auto& stage : draw.stages)
    for (const ShaderResource& resource : stage->reflection.resources)
      if (resource.kind == BindingKind::texture && seen.insert(resource.binding).second)
        draw.reads.push_back(
            {resource.binding, resource.name, resolve_source(*pass.variant, *pass.pass, resource.name, object)});
  for (const auto& [sampler, read] : pass.pass->reads) {
    std::vector<std::string> samplers;
    for (const ResolvedRead& resolved : draw.reads) samplers.push_back(resolved.sampler);
    if (!object && std::find(samplers.begin(), samplers.end(), sampler) == samplers.end())
      throw Error(ErrorKind::bad_input, "variants", pass.pass->where, unknown_name("sampler", sampler, samplers));
  }
  check_constants(pass, draw);
  return draw;
}

std::string frequency_words(const PassManifest& pass, const Scene& scene, bool& once) {
  once = pass.when == Frequency::once;
  if (pass.when == Frequency::once) return "once for the scene";
  if (pass.when == Frequency::truth) return "for the truth alone";
  if (pass.when == Frequency::frame) return "every frame";
  once = !scene.mesh_moves && !scene.lights_move;
  if (once) return "once: meshes and lights are still";
  return scene.mesh_moves ? "every frame: a mesh moves" : "every frame: a light moves";
}

// A target, or buffer, of a variant; for one object or for the frame.
struct Resource {
  const VariantManifest* variant;
  std::string name;
  std::optional<size_t> object;
  auto operator<=>(const Resource&) const = default;
};

// Storage buffers and images that the draw's shaders touch are read and written alike.
std::vector<Resource> touched_storage(const GraphPass& pass, const GraphDraw& draw) {
  std::vector<Resource> touched;
  for (const auto& stage : draw.stages)
    for (const ShaderResource& resource : stage->reflection.resources) {
      if (resource.kind != BindingKind::storage_buffer) continue;
      for (const BufferManifest& buffer : pass.variant->buffers)
        if (buffer.name == resource.name)
          touched.push_back({pass.variant, buffer.name, buffer.scope == Scope::object ? draw.object : std::nullopt});
    }
  return touched;
}

Resource written(const GraphPass& pass, const GraphDraw& draw, const std::string& name) {
  const TargetManifest* target = pass.variant->target(name);
  return {pass.variant, name, target && target->scope == Scope::object ? draw.object : std::nullopt};
}

// Backwards from the frame: a draw is needed when it draws into the frame or into something that a needed draw reads.
void drop_unread(Graph& graph) {
  std::set<Resource> needed;
  std::vector<GraphPass> kept;
  for (auto pass = graph.passes.rbegin(); pass != graph.passes.rend(); ++pass) {
    std::vector<GraphDraw> draws;
    for (const GraphDraw& draw : pass->draws) {
      const std::vector<Resource> storage = touched_storage(*pass, draw);
      bool wanted = pass->pass->when == Frequency::truth ||
                    std::any_of(storage.begin(), storage.end(), [&](const Resource& r) { return needed.contains(r); });
      for (const std::string& name : pass->pass->writes)
        wanted = wanted || name == "frame" || needed.contains(written(*pass, draw, name));
      if (!wanted) continue;
      draws.push_back(draw);
      needed.insert(storage.begin(), storage.end());
      for (const ResolvedRead& read : draw.reads)
        if (read.source.kind == Source::Kind::target) {
          const TargetManifest* target = pass->variant->target(read.source.name);
          // An object-scoped target is read for the object that is drawn; by a pass of the whole frame it cannot be.
          needed.insert({pass->variant, read.source.name, target->scope == Scope::object ? draw.object : std::nullopt});
        }
    }
    if (draws.empty()) {
      pass->draws.clear();
      pass->reason = "left out: nothing reads what it writes";
      graph.dropped.insert(graph.dropped.begin(), *pass);
    } else {
      pass->draws = std::move(draws);
      kept.insert(kept.begin(), *pass);
    }
  }
  graph.passes = std::move(kept);
}

}  // namespace

std::shared_ptr<const CompiledShader> ShaderCache::get(const std::filesystem::path& file, Stage stage,
                                                       const std::map<std::string, std::string>& defines) {
  std::string key = fmt::format("{}|{}", file.string(), static_cast<int>(stage));
  for (const auto& [name, text] : defines) key += fmt::format("|{}={}", name, text);
  auto& entry = compiled_[key];
  if (!entry)
    entry =
        std::make_shared<const CompiledShader>(compile_shader({file, stage, api_, defines, {shaders_, file.parent_path()}}));
  return entry;
}

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

std::shared_ptr<const TextureImage> object_texture(const Object& object, std::string_view name) {
  if (name == "albedo") return object.albedo;
  if (!object.layers) return nullptr;
  if (name == "outer_albedo") return object.layers->outer_albedo;
  if (name == "outer_normal") return object.layers->outer_normal;
  if (name == "inner_albedo") return object.layers->inner_albedo;
  return nullptr;
}

Graph make_graph(const Plan& plan, const Configuration& configuration, const Scene& scene, ShaderCache& shaders,
                 Purpose purpose) {
  Graph graph;
  for (const VariantManifest* variant : configuration) {
    const EffectPlan& effect = *plan.of(variant->effect);
    const bool truth = purpose == Purpose::truth && has_truth_passes(*variant);
    for (const PassManifest& manifest : variant->passes) {
      if ((manifest.when == Frequency::truth) != truth) continue;
      GraphPass pass;
      pass.variant = variant;
      pass.pass = &manifest;
      pass.reason = frequency_words(manifest, scene, pass.once);
      if (!is_per_object(manifest, *variant)) {
        pass.draws.push_back(make_draw(pass, *effect.effect, nullptr, std::nullopt, shaders));
      } else {
        for (const size_t index : effect.objects) {
          const Object& object = scene.objects[index];
          if (manifest.draw == DrawKind::unwrapped && !object.unwrap_problem.empty())
            throw Error(ErrorKind::failed, "plan", fmt::format("object '{}'", object.name),
                        fmt::format("cannot be drawn unwrapped, as pass '{}' needs: {}", manifest.name, object.unwrap_problem));
          pass.draws.push_back(make_draw(pass, *effect.effect, &object, index, shaders));
        }
      }
      graph.passes.push_back(std::move(pass));
    }
  }
  drop_unread(graph);
  return graph;
}

}  // namespace lamina
