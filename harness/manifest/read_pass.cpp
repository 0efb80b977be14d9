// SPDX-License-Identifier: Apache-2.0
#include "harness/manifest/read_pass.h"

#include <algorithm>

#include "harness/manifest/choices.h"

namespace lamina {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> blend_names = {"none", "alpha", "premultiplied", "additive", "multiplied"};

Setting setting_of(const TomlTable& table, std::string_view key, const VariantManifest& variant, const std::string& reference,
                   double min, double max) {
  const ParameterManifest& parameter = parameter_named(table, key, variant, reference);
  if (!parameter.words.empty()) throw table.error(key, fmt::format("'{}' is a word; '{}' takes a number", reference, key));
  if (!(parameter.min >= min && parameter.max <= max))
    throw table.error(
        key, fmt::format("'{}' may be {} to {}; '{}' takes {} to {}", reference, parameter.min, parameter.max, key, min, max));
  return {parameter.value, parameter.name};
}

// A shader is looked for beside the manifest, then among the built-in ones.
fs::path find_shader(const TomlTable& table, std::string_view key, const fs::path& folder, const fs::path& shaders) {
  const auto name = table.optional_string(key);
  if (!name) return {};
  for (const fs::path& base : {folder, shaders})
    if (fs::is_regular_file(base / *name)) return fs::weakly_canonical(base / *name);
  throw table.error(key, fmt::format("shader '{}' is neither in {} nor in {}", *name, folder.string(), shaders.string()));
}

std::map<std::string, ReadManifest> read_reads(const TomlTable& pass) {
  std::map<std::string, ReadManifest> reads;
  const TomlTable table = pass.table("read");
  for (const auto& sampler : table.keys()) {
    ReadManifest read;
    if (table.is_table(sampler)) {
      const TomlTable entry = table.table(sampler);
      read.source = entry.optional_string("from").value_or(sampler);
      if (entry.has("filter")) read.filter = choice(entry, "filter", Filter::linear);
      if (entry.has("wrap")) read.wrap = choice(entry, "wrap", Wrap::clamp);
      entry.check_keys();
    } else {
      read.source = table.string(sampler);
    }
    reads[sampler] = read;
  }
  return reads;
}

void read_repeat(const TomlTable& table, const VariantManifest& variant, PassManifest& pass) {
  pass.levels = choice(table, "levels", LevelWalk::none);
  pass.needs_light = table.optional_bool("needs_light").value_or(true);
  pass.until_empty = table.optional_bool("until_empty").value_or(false);
  if (!table.has("repeat")) return;
  if (pass.levels != LevelWalk::none)
    throw table.error("repeat", "'levels' says how often the pass is repeated; leave out 'repeat'");
  if (table.is_string("repeat") && table.string("repeat").starts_with("log2(")) {
    const std::string text = table.string("repeat");
    pass.repeat_log2_of = text.substr(5, text.size() - 6);
    if (!text.ends_with(")") || !variant.target(pass.repeat_log2_of))
      throw table.error("repeat", fmt::format("'{}' is not a target of this variant", pass.repeat_log2_of));
    return;
  }
  if (table.is_string("repeat") && !table.string("repeat").starts_with("$"))
    throw table.error("repeat", "'repeat' must be a number, \"$PARAMETER\" or \"log2(TARGET)\"");
  pass.repeat = *read_setting(table, "repeat", variant);
}

void read_blend(const TomlTable& table, PassManifest& pass) {
  if (!table.is_list("blend")) {
    pass.blend.assign(pass.writes.size(), choice(table, "blend", Blend::none));
    return;
  }
  const std::vector<std::string> names = *table.optional_strings("blend");
  if (names.size() != pass.writes.size())
    throw table.error("blend", fmt::format("'blend' lists {} ways for {} targets", names.size(), pass.writes.size()));
  for (const std::string& name : names)
    pass.blend.push_back(static_cast<Blend>(std::find(blend_names.begin(), blend_names.end(), name) - blend_names.begin()));
}

void read_depth(const TomlTable& table, const VariantManifest& variant, PassManifest& pass) {
  pass.depth = choice(table, "depth", Depth::none);
  pass.depth_test = choice(table, "depth_test", DepthTest::less_equal);
  pass.clear_depth = static_cast<float>(table.optional_number("clear_depth").value_or(1));
  pass.clear_depth_again = table.optional_bool("clear_depth_again").value_or(false);
  pass.depth_target = table.optional_string("depth_target").value_or("");
  if (pass.depth_target.empty()) return;
  const TargetManifest* target = variant.target(pass.depth_target);
  if (!target) throw table.error("depth_target", fmt::format("'{}' is not a target of this variant", pass.depth_target));
  if (target->format != Format::d32_float)
    throw table.error("depth_target", fmt::format("'{}' is not of the format d32_float", pass.depth_target));
  if (pass.depth == Depth::none)
    throw table.error("depth_target", "depth is neither read nor written: say depth = \"read_write\"");
}

void check_clear_depth_again(const TomlTable& table, const PassManifest& pass) {
  if (pass.clear_depth_again && pass.depth_target.empty())
    throw table.error("clear_depth_again", "the frame's depth is everyone's: name a 'depth_target' of the variant");
}

void read_compute(const TomlTable& table, const VariantManifest& variant, PassManifest& pass) {
  if (const auto groups = table.optional_numbers("groups")) {
    for (size_t i = 0; i < 3; ++i) pass.groups[i] = static_cast<uint32_t>((*groups)[i]);
  }
  pass.threads_over = table.optional_string("threads_over").value_or("");
  if (!pass.threads_over.empty() && !variant.target(pass.threads_over))
    throw table.error("threads_over", fmt::format("'{}' is not a target of this variant", pass.threads_over));
  if (const auto local = table.optional_numbers("local_size")) {
    for (size_t i = 0; i < 2; ++i) pass.local_size[i] = static_cast<uint32_t>((*local)[i]);
  }
}

void check_shaders(const TomlTable& table, const PassManifest& pass) {
  const bool raster = pass.draw == DrawKind::objects || pass.draw == DrawKind::unwrapped || pass.draw == DrawKind::fullscreen;
  if (raster && (pass.vertex.empty() || pass.fragment.empty()))
    throw table.error({}, "a drawn pass needs 'vertex' and 'fragment' shaders");
  if (pass.draw == DrawKind::compute && pass.compute.empty()) throw table.error({}, "a compute pass needs a 'compute' shader");
  if (pass.writes.empty() && pass.depth_target.empty() && pass.draw != DrawKind::compute)
    throw table.error({}, "'write' is missing: the targets that the pass draws into");
}

// What is written is one thing's: the frame's, an object's or a light's.
void check_writes(const TomlTable& table, const VariantManifest& variant, const PassManifest& pass) {
  std::vector<std::string> known = {std::string(frame_target)};
  for (const TargetManifest& target : variant.targets) known.push_back(target.name);
  std::optional<Scope> scope;
  for (const std::string& name : pass.written()) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw table.error("write", unknown_name("target", name, known));
    const TargetManifest* target = variant.target(name);
    const Scope its = target ? target->scope : Scope::frame;
    if (scope && *scope != its) throw table.error("write", "a pass writes targets of one scope");
    scope = its;
    if ((pass.draw == DrawKind::mips || pass.levels != LevelWalk::none) && (!target || !target->mips))
      throw table.error("write", fmt::format("'{}' has no mips", name));
  }
  for (const std::string& name : pass.writes)
    if (variant.target(name) && variant.target(name)->format == Format::d32_float)
      throw table.error("write", fmt::format("'{}' is a depth target: name it under 'depth_target'", name));
  if (pass.draw == DrawKind::unwrapped && scope != Scope::object)
    throw table.error("write",
                      "an unwrapped pass writes targets with scope = \"object\": every object has texture space of its own");
  if (pass.draw == DrawKind::objects && scope == Scope::object)
    throw table.error("write", "objects on screen are drawn into targets of the frame's or a light's scope");
  if (scope && (pass.view == PassView::light) != (*scope == Scope::light) &&
      (pass.view == PassView::light || pass.draw == DrawKind::objects))
    throw table.error("write", "a view of a light, and nothing else, draws objects into targets with scope = \"light\"");
}

void check_view(const TomlTable& table, const PassManifest& pass) {
  const bool objects = pass.draw == DrawKind::objects;
  if (pass.depth != Depth::none && !objects) throw table.error("depth", "only passes that draw objects on screen have depth");
  if (pass.of != DrawnObjects::own && !objects) throw table.error("of", "only passes that draw objects on screen choose them");
  if (pass.of != DrawnObjects::own && !(pass.with.empty() && pass.without.empty()))
    throw table.error("of", "'with' and 'without' choose among the effect's own objects, which have its features");
  if (pass.view != PassView::eye && pass.draw == DrawKind::unwrapped)
    throw table.error("view", "an unwrapped pass has no view");
  if (pass.view != PassView::eye && pass.depth != Depth::none && pass.depth_target.empty())
    throw table.error("depth", "the frame's depth is the eye's: name a 'depth_target' of this view");
  if (pass.view != PassView::eye && std::find(pass.writes.begin(), pass.writes.end(), frame_target) != pass.writes.end() &&
      objects)
    throw table.error("write", "the frame is drawn from the eye");
  if (pass.until_empty && !objects) throw table.error("until_empty", "only passes that draw objects count what they draw");
}

}  // namespace

std::string_view name_of(Blend blend) { return blend_names.at(static_cast<size_t>(blend)); }

const ParameterManifest& parameter_named(const TomlTable& table, std::string_view key, const VariantManifest& variant,
                                         const std::string& reference) {
  const std::string name = reference.substr(1);
  if (const ParameterManifest* parameter = variant.parameter(name)) return *parameter;
  std::vector<std::string> names;
  for (const ParameterManifest& known : variant.parameters) names.push_back(known.name);
  throw table.error(key, unknown_name("parameter", name, names));
}

std::optional<Setting> read_setting(const TomlTable& table, std::string_view key, const VariantManifest& variant) {
  const TomlValue& range = table.form_of(key, TomlValue::Kind::number);
  if (table.is_string(key)) {
    const std::string text = table.string(key);
    if (!text.starts_with('$')) throw table.error(key, fmt::format("'{}' must be a number or \"$PARAMETER\"", key));
    return setting_of(table, key, variant, text, range.min, range.max);
  }
  const auto number = table.optional_number(key);
  return number ? std::optional(Setting{*number, {}}) : std::nullopt;
}

std::vector<Setting> read_settings(const TomlTable& table, std::string_view key, const VariantManifest& variant) {
  const TomlValue& range = table.form_of(key, TomlValue::Kind::numbers);
  std::vector<Setting> settings;
  if (table.is_list_of_strings(key)) {
    const std::vector<std::string> texts = table.optional_strings(key).value();
    for (const std::string& text : texts) settings.push_back(setting_of(table, key, variant, text, range.min, range.max));
    return settings;
  }
  for (const double number : table.optional_numbers(key).value_or(std::vector<double>{})) settings.push_back({number, {}});
  return settings;
}

std::vector<std::string> PassManifest::written() const {
  std::vector<std::string> names = writes;
  if (!depth_target.empty()) names.push_back(depth_target);
  return names;
}

ReadManifest PassManifest::read_of(const std::string& sampler) const {
  const auto declared = reads.find(sampler);
  return declared != reads.end() ? declared->second : ReadManifest{sampler, {}, {}};
}

TomlFormPtr pass_form(bool whole) {
  const TomlFormPtr read =
      form::make({{"from", "the target or texture that the sampler reads", {form::text()}}, filter_key, wrap_key});
  const std::vector<TomlValue> scalars = {form::text(), form::number(), form::flag()};
  const double most = largest_number;
  return form::make(
      {{"name", "the pass's name in records and reports", {form::text()}, true},
       {"draw", "what is drawn", {form::word({"objects", "unwrapped", "fullscreen", "compute", "mips"})}, whole},
       {"before", "with `like`: the pass that comes behind this one", {form::text()}},
       {"of", "which objects", {form::word({"own", "all", "opaque"})}},
       {"with", "only objects that have this feature", {form::text()}},
       {"without", "only objects that lack this feature", {form::text()}},
       {"view", "from where", {form::word({"eye", "light", "mirror"})}},
       {"when", "how often", {form::word({"frame", "mesh_or_lights_move", "once", "truth", "frame_and_truth"})}},
       {"levels", "one repetition for each mip level", {form::word({"none", "down", "up"})}},
       {"repeat", "how often, or \"log2(TARGET)\"", {form::number(0, 1000), form::text("^(\\$.+|log2\\(.+\\))$")}},
       {"until_empty", "leaves out the first repetition that draws nothing, and all after it", {form::flag()}},
       {"needs_light", "false: left out where no light casts", {form::flag()}},
       {"vertex", "shader", {form::text()}},
       {"fragment", "shader", {form::text()}},
       {"compute", "shader", {form::text()}},
       {"define", "definitions", {form::table(form::make({}, TomlKey{"NAME", "its text, or \"$PARAMETER\"", scalars}))}},
       {"constants", "specialization constants", {form::table(form::make({}, TomlKey{"NAME", "its value", scalars}))}},
       {"read",
        "other sources of samplers",
        {form::table(form::make({}, TomlKey{"SAMPLER", "what it reads", {form::text(), form::table(read)}}))}},
       {"groups", "work groups", {form::numbers(1, 65535, {3})}},
       {"threads_over", "one thread for each texel of this target", {form::text()}},
       {"local_size", "the group's size as the shader declares it", {form::numbers(1, 1024, {2})}},
       {"write", "targets, in the order of the shader's outputs", {form::texts()}},
       {"clear", "[r, g, b, a] before the pass", {form::numbers(-most, most, {4})}},
       {"blend", "how what is drawn meets what is there", {form::word(blend_names), form::texts(blend_names)}},
       {"cull", "the faces that are left out", {form::word({"none", "back", "front"})}},
       {"depth", "whether it is tested and written", {form::word({"none", "read", "read_write"})}},
       {"depth_test", "what is drawn against what is there", {form::word({"less_equal", "equal", "greater"})}},
       {"depth_target", "a target of format d32_float in place of the frame's depth", {form::text()}},
       {"clear_depth", "what the depth is cleared to", {form::number(0, 1)}},
       {"clear_depth_again", "before every repetition", {form::flag()}}});
}

PassManifest read_pass(const TomlTable& table, const VariantManifest& variant, const fs::path& shaders) {
  PassManifest pass;
  const fs::path folder = variant.file.parent_path();
  pass.name = table.string("name");
  pass.where = table.where();
  table.string("draw");
  pass.draw = choice(table, "draw", DrawKind::objects);
  pass.of = choice(table, "of", DrawnObjects::own);
  pass.view = choice(table, "view", PassView::eye);
  pass.when = choice(table, "when", Frequency::frame);
  read_repeat(table, variant, pass);
  pass.vertex = find_shader(table, "vertex", folder, shaders);
  if (pass.draw == DrawKind::fullscreen && pass.vertex.empty()) pass.vertex = shaders / "common/fullscreen.vert";
  pass.fragment = find_shader(table, "fragment", folder, shaders);
  pass.compute = find_shader(table, "compute", folder, shaders);
  for (auto& [name, text] : table.table("define").texts()) {
    if (text.starts_with('$')) parameter_named(table, "define", variant, text);
    pass.defines[name] = text;
  }
  for (auto& [name, text] : table.table("constants").texts()) pass.constants[name] = text;
  pass.reads = read_reads(table);
  pass.writes = table.optional_strings("write").value_or(std::vector<std::string>{});
  if (const auto clear = table.optional_numbers("clear")) {
    pass.clear.emplace();
    std::transform(clear->begin(), clear->end(), pass.clear->begin(), [](double value) { return static_cast<float>(value); });
  }
  read_blend(table, pass);
  read_depth(table, variant, pass);
  check_clear_depth_again(table, pass);
  pass.with = table.optional_string("with").value_or("");
  pass.without = table.optional_string("without").value_or("");
  pass.cull = choice(table, "cull", Cull::none);
  read_compute(table, variant, pass);
  table.check_keys();
  check_shaders(table, pass);
  check_writes(table, variant, pass);
  check_view(table, pass);
  return pass;
}

}  // namespace lamina
