// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/sources.h"

#include <algorithm>
#include <charconv>

#include "harness/core/text.h"
#include "harness/graph/blocks.h"

namespace lamina {
namespace {

constexpr Sampler picture_sampler = {Filter::nearest, Wrap::clamp};
constexpr Sampler table_sampler = {Filter::linear, Wrap::clamp};

[[noreturn]] void refuse(const SourceContext& context, const std::string& message) {
  throw Error(ErrorKind::bad_input, "variants", context.pass.where, message);
}

// What a name asks for, and every name that could have been asked for, for messages.
class Chain {
 public:
  Chain(const SourceContext& context, const std::string& name) : context_(context), name_(name) {}

  std::optional<Source> texture() {
    if (auto found = target()) return found;
    if (auto found = frame_or_depth()) return found;
    if (context_.object) {
      const Object& object = context_.scene.objects[*context_.object];
      if (auto found = declared(context_.effect, context_.effect.object, object.effects, Source::Kind::object_texture))
        return found;
      if (const EffectManifest* otherwise = context_.plan.library->otherwise())
        if (auto found = declared(*otherwise, otherwise->object, object.effects, Source::Kind::object_texture)) return found;
      if (auto found = baked(false)) return found;
    }
    if (auto found = declared(context_.effect, context_.effect.scene, context_.scene.effects, Source::Kind::scene_texture))
      return found;
    for (const auto& [table, make] : context_.plan.library->code->tables)
      if (is(table)) return source(Source::Kind::table, table_sampler);
    return std::nullopt;
  }

  std::optional<Source> buffer() {
    for (const BufferManifest& buffer : context_.variant.buffers)
      if (is(buffer.name)) return source(Source::Kind::buffer, {});
    return context_.object ? baked(true) : std::nullopt;
  }

  const std::vector<std::string>& names() const { return names_; }

 private:
  bool is(const std::string& candidate) {
    names_.push_back(candidate);
    return candidate == name_;
  }

  Source source(Source::Kind kind, Sampler sampler) const {
    return {kind, name_, &context_.effect, &context_.variant, std::nullopt, sampler};
  }

  std::optional<Source> target() {
    for (const TargetManifest& target : context_.variant.targets) {
      if (target.scope == Scope::light) {
        if (auto found = of_light(target)) return found;
        continue;
      }
      if (!is(target.name)) continue;
      if (target.scope == Scope::object && !context_.object)
        refuse(context_, fmt::format("pass '{}' is of the whole frame and cannot read '{}', which every object has its own of",
                                     context_.pass.name, name_));
      return source(Source::Kind::target, target.sampler);
    }
    return std::nullopt;
  }

  // NAME in a pass that is drawn for a light; NAME_0, NAME_1, ... for the lights that cast, in others.
  std::optional<Source> of_light(const TargetManifest& target) {
    Source found = source(Source::Kind::target, target.sampler);
    found.name = target.name;
    if (context_.light) {
      found.light = context_.light;
      return is(target.name) ? std::optional(found) : std::nullopt;
    }
    const std::vector<size_t> casting = casting_lights(context_.scene);
    for (size_t k = 0; k < casting.size(); ++k) {
      found.light = casting[k];
      if (is(fmt::format("{}_{}", target.name, k))) return found;
    }
    return std::nullopt;
  }

  std::optional<Source> frame_or_depth() {
    if (is("frame")) return source(Source::Kind::frame, picture_sampler);
    if (!is("depth")) return std::nullopt;
    if (context_.pass.depth != Depth::none && context_.pass.depth_target.empty())
      refuse(context_, "a pass cannot read 'depth' while it tests against it: set depth = \"none\"");
    return source(Source::Kind::depth, picture_sampler);
  }

  template <class Map>
  std::optional<Source> declared(const EffectManifest& effect, const Declarations& of, const Map& values, Source::Kind kind) {
    const auto known = values.find(effect.name);
    if (known == values.end()) return std::nullopt;
    for (const TextureManifest& texture : of.textures)
      if (known->second.textures.contains(texture.name) && is(texture.name)) {
        Source found = source(kind, texture.sampler);
        found.effect = &effect;
        return found;
      }
    return std::nullopt;
  }

  std::optional<Source> baked(bool buffer) {
    if (context_.effect.baker.empty()) return std::nullopt;
    for (const BakedName& baked : context_.plan.library->code->bakers.at(context_.effect.baker)->names(context_.variant.bake))
      if (baked.buffer == buffer && is(baked.name)) return source(Source::Kind::baked, baked.sampler);
    return std::nullopt;
  }

  const SourceContext& context_;
  const std::string name_;
  std::vector<std::string> names_;
};

}  // namespace

Source texture_source(const SourceContext& context, const std::string& sampler) {
  const ReadManifest read = context.pass.read_of(sampler);
  Chain chain(context, read.source);
  std::optional<Source> source = chain.texture();
  if (!source)
    refuse(context, fmt::format("pass '{}' samples '{}': {}", context.pass.name, sampler,
                                unknown_name("texture", read.source, chain.names())));
  if (read.filter) source->sampler.filter = *read.filter;
  if (read.wrap) source->sampler.wrap = source->sampler.wrap_v = *read.wrap;
  return *source;
}

Source buffer_source(const SourceContext& context, const std::string& block) {
  Chain chain(context, block);
  std::optional<Source> source = chain.buffer();
  if (!source) refuse(context, unknown_name("storage buffer", block, chain.names()));
  return *source;
}

}  // namespace lamina
