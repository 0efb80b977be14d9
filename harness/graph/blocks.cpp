// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/blocks.h"

#include <algorithm>
#include <array>

#include "harness/core/text.h"
#include "harness/graph/views.h"

namespace lamina {
namespace {

[[noreturn]] void refuse(const BlockContext& context, const std::string& message) {
  throw Error(ErrorKind::bad_input, "variants", context.where, message);
}

ViewMatrices view_of_light(const BlockContext& context, size_t light) {
  const auto view = light_view(context.scene.lights[light], bounding_sphere(context.scene.objects));
  if (!view)
    refuse(context, fmt::format("light '{}' stands among the objects, and no one view shows all that it lights; move it out of "
                                "them, or set casts = false",
                                context.scene.lights[light].name));
  return *view;
}

ViewMatrices view_in_mirror(const BlockContext& context) {
  const MirrorManifest& mirror = *context.effect.mirror;
  double height = mirror.height;
  if (!mirror.height_number.empty()) {
    const auto values = context.scene.effects.find(context.effect.name);
    if (values != context.scene.effects.end()) height = fact_or_number(values->second, mirror.height_number);
  }
  return mirror_view(context.scene.views[context.view], context.width_px, context.height_px,
                     {mirror.normal, static_cast<float>(height)});
}

BlockValues frame_values(const ShaderResource& block, const BlockContext& context) {
  const Scene& scene = context.scene;
  const ViewMatrices eye = eye_view(scene.views[context.view], context.width_px, context.height_px);
  const ViewMatrices drawn = context.from == PassView::light    ? view_of_light(context, *context.light)
                             : context.from == PassView::mirror ? view_in_mirror(context)
                                                                : eye;
  BlockValues values;
  const float width = static_cast<float>(context.width_px), height = static_cast<float>(context.height_px);
  values.set("clip_from_world", drawn.clip_from_world());
  values.set("world_from_clip", glm::inverse(drawn.clip_from_world()));
  values.set("view_from_world", drawn.view_from_world);
  values.set("clip_from_view", drawn.clip_from_view);
  values.set("eye_world", glm::vec4(drawn.eye, scene.time_s));
  values.set("ambient", glm::vec4(scene.ambient, 0));
  values.set("background", glm::vec4(scene.background, 0));
  values.set("frame_size_px", glm::vec4(width, height, 1 / width, 1 / height));
  if (context.effect.mirror) values.set("mirror_clip_from_world", view_in_mirror(context).clip_from_world());

  std::array<glm::vec4, max_lights> position{}, radiance{};
  std::array<glm::mat4, max_lights> clip_from_world{};
  const std::vector<size_t> casting = casting_lights(scene);
  std::array<glm::ivec4, max_lights> casts{};
  const size_t count = std::min(scene.lights.size(), max_lights);
  for (size_t i = 0; i < count; ++i) {
    const Light& light = scene.lights[i];
    const bool point = light.kind == Light::Kind::point;
    position[i] = point ? glm::vec4(light.position, 1) : glm::vec4(-light.direction, 0);
    radiance[i] = glm::vec4(light.radiance, point ? light.radius_m : light.angular_radius);
    casts[i].x = static_cast<int>(std::find(casting.begin(), casting.end(), i) - casting.begin());
    if (casts[i].x == static_cast<int>(casting.size())) casts[i].x = -1;
  }
  const bool maps_are_read = std::any_of(block.members.begin(), block.members.end(),
                                         [](const BlockMember& member) { return member.name == "casting_clip_from_world"; });
  for (size_t k = 0; k < casting.size() && maps_are_read; ++k)
    if (const auto view = light_view(scene.lights[casting[k]], bounding_sphere(scene.objects)))
      clip_from_world[k] = view->clip_from_world();
  values.set("light_count", glm::ivec4(static_cast<int>(count), static_cast<int>(casting.size()), 0, 0));
  values.set("light_position", std::span<const glm::vec4>(position));
  values.set("light_radiance", std::span<const glm::vec4>(radiance));
  values.set("light_casts", std::span<const glm::ivec4>(casts));
  values.set("casting_clip_from_world", std::span<const glm::mat4>(clip_from_world));
  return values;
}

BlockValues object_values(const Scene& scene, size_t place) {
  const Object& object = scene.objects[place];
  BlockValues values;
  values.set("object_place", glm::ivec4(static_cast<int>(place), static_cast<int>(scene.objects.size()), 0, 0));
  values.set("world_from_object", object.world_from_object);
  values.set("world_from_object_normal", glm::mat4(glm::transpose(glm::inverse(glm::mat3(object.world_from_object)))));
  return values;
}

// Numbers as they are, words as their places among the declared ones.
void add_declared(BlockValues& values, const Declarations& declared, const EffectValues* known) {
  for (const NumberManifest& number : declared.numbers) {
    std::optional<double> value = number.value;
    if (known && known->numbers.contains(number.name)) value = known->numbers.find(number.name)->second;
    if (value) values.set(number.name, static_cast<float>(*value));
  }
  for (const WordManifest& word : declared.words) {
    const std::string& value = known ? known->words.at(word.name) : word.value;
    values.set(word.name, static_cast<int>(std::find(word.of.begin(), word.of.end(), value) - word.of.begin()));
  }
}

template <class Map>
const EffectValues* values_in(const Map& effects, const std::string& name) {
  const auto found = effects.find(name);
  return found == effects.end() ? nullptr : &found->second;
}

BlockValues effect_values(const BlockContext& context) {
  BlockValues values;
  const EffectManifest* otherwise = context.library.otherwise();
  if (context.object) {
    const Object& object = context.scene.objects[*context.object];
    if (otherwise) add_declared(values, otherwise->object, values_in(object.effects, otherwise->name));
    add_declared(values, context.effect.object, values_in(object.effects, context.effect.name));
  }
  add_declared(values, context.effect.scene, values_in(context.scene.effects, context.effect.name));
  return values;
}

}  // namespace

std::vector<size_t> casting_lights(const Scene& scene) {
  std::vector<size_t> casting;
  for (size_t i = 0; i < std::min(scene.lights.size(), max_lights); ++i)
    if (scene.lights[i].casts) casting.push_back(i);
  return casting;
}

BlockValues block_values(const ShaderResource& block, const BlockContext& context) {
  if (block.name == "Frame") return frame_values(block, context);
  if (block.name == "Effect") return effect_values(context);
  if (block.name == "Pass") {
    BlockValues values;
    values.set("iteration", context.iteration);
    return values;
  }
  if (block.name != "Object") {
    const std::vector<std::string> blocks = {"Frame", "Object", "Effect", "Pass"};
    refuse(context, unknown_name("uniform block", block.name, blocks));
  }
  if (!context.object) refuse(context, "block 'Object' is only there where a pass draws objects");
  return object_values(context.scene, *context.object);
}

}  // namespace lamina
