// SPDX-License-Identifier: Apache-2.0
#include "harness/plan/manifest.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "harness/core/text.h"
#include "harness/core/toml_table.h"

namespace lamina {
namespace {

namespace fs = std::filesystem;

constexpr double unlimited = std::numeric_limits<double>::max();
constexpr double largest_size = 65536;
// Names of targets that the harness makes itself.
constexpr std::string_view frame_target = "frame";

// The enumerator whose name stands under `key`, or `fallback` where the key is absent.
template <class Enum>
Enum choice(const TomlTable& table, std::string_view key, const std::vector<std::string>& names, Enum fallback) {
  const auto name = table.optional_string(key);
  if (!name) return fallback;
  const auto found = std::find(names.begin(), names.end(), *name);
  if (found == names.end()) throw table.error(key, unknown_name(key, *name, names));
  return static_cast<Enum>(found - names.begin());
}

const std::vector<std::string> filter_names = {"nearest", "linear", "trilinear"};
const std::vector<std::string> wrap_names = {"clamp", "repeat"};
const std::vector<std::string> scope_names = {"frame", "object"};

SizeRule read_size(const TomlTable& table) {
  SizeRule size;
  size.scale = table.optional_number("scale", 1.0 / 64, 16).value_or(1);
  if (!table.has("size")) return size;
  if (table.is_list("size")) {
    const auto fixed = table.optional_numbers("size");
    if (fixed->size() != 2 || (*fixed)[0] < 1 || (*fixed)[1] < 1 || (*fixed)[0] > largest_size || (*fixed)[1] > largest_size)
      throw table.error("size", "'size' must be \"frame\", a texture of the object, or [width, height] from 1 to 65536");
    size.kind = SizeRule::Kind::fixed;
    size.width = static_cast<uint32_t>((*fixed)[0]);
    size.height = static_cast<uint32_t>((*fixed)[1]);
    return size;
  }
  const std::string name = table.string("size");
  if (name != frame_target) size.kind = SizeRule::Kind::texture, size.texture = name;
  return size;
}

TargetManifest read_target(const std::string& name, const TomlTable& table) {
  TargetManifest target;
  target.name = name;
  if (name == frame_target || name == "depth")
    throw table.error({}, fmt::format("'{}' is the harness's own target: choose another name", name));
  target.scope = choice(table, "scope", scope_names, Scope::frame);
  target.size = read_size(table);
  if (target.scope == Scope::frame && target.size.kind == SizeRule::Kind::texture)
    throw table.error("size", "only a target with scope = \"object\" can be as large as an object's texture");
  const std::string format = table.string("format");
  if (const auto known = format_named(format))
    target.format = *known;
  else {
    std::vector<std::string> names;
    for (int i = 0; i <= static_cast<int>(Format::d32_float); ++i) names.emplace_back(name_of(static_cast<Format>(i)));
    throw table.error("format", unknown_name("format", format, names));
  }
  target.mips = table.optional_bool("mips").value_or(false);
  target.buffers = static_cast<uint32_t>(table.optional_number("buffers", 1, 2).value_or(1));
  target.sampler.filter = choice(table, "filter", filter_names, Filter::nearest);
  target.sampler.wrap = choice(table, "wrap", wrap_names, Wrap::clamp);
  table.refuse_unknown_keys();
  return target;
}

BufferManifest read_buffer(const std::string& name, const TomlTable& table) {
  BufferManifest buffer;
  buffer.name = name;
  buffer.scope = choice(table, "scope", scope_names, Scope::frame);
  buffer.bytes = static_cast<uint64_t>(table.optional_number("bytes", 0, 1e10).value_or(0));
  buffer.bytes_per_vertex = static_cast<uint64_t>(table.optional_number("bytes_per_vertex", 0, 1e4).value_or(0));
  buffer.bytes_per_pixel = static_cast<uint64_t>(table.optional_number("bytes_per_pixel", 0, 1e4).value_or(0));
  if (buffer.bytes + buffer.bytes_per_vertex + buffer.bytes_per_pixel == 0)
    throw table.error({}, "a buffer needs 'bytes', 'bytes_per_vertex' or 'bytes_per_pixel' above 0");
  if (buffer.bytes_per_vertex > 0 && buffer.scope != Scope::object)
    throw table.error("bytes_per_vertex", "only a buffer with scope = \"object\" has vertices");
  table.refuse_unknown_keys();
  return buffer;
}

ApertureKind read_apertures(const TomlTable& table) {
  ApertureKind kind;
  kind.count = static_cast<uint32_t>(table.optional_number("count", 1, most_apertures).value_or(1));
  kind.anti = table.optional_bool("anti").value_or(false);
  if (kind.anti && kind.count > 1) throw table.error("count", "an anti-aperture is one cap a point; leave out 'count'");
  table.refuse_unknown_keys();
  return kind;
}

ParameterManifest read_parameter(const std::string& name, const TomlTable& table) {
  ParameterManifest parameter;
  parameter.name = name;
  parameter.low = table.optional_number("min", -unlimited, unlimited).value_or(-unlimited);
  parameter.high = table.optional_number("max", parameter.low, unlimited).value_or(unlimited);
  if (!table.has("value")) throw table.error({}, "'value' is missing: the parameter's default");
  parameter.value = *table.optional_number("value", parameter.low, parameter.high);
  parameter.unit = table.optional_string("unit").value_or("");
  parameter.title = table.optional_string("title").value_or("");
  table.refuse_unknown_keys();
  return parameter;
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
  for (const auto& sampler : pass.has("read") ? table.keys() : std::vector<std::string>{}) {
    ReadManifest read;
    if (table.is_table(sampler)) {
      const TomlTable entry = table.table(sampler);
      read.source = entry.string("from");
      if (entry.has("filter")) read.filter = choice(entry, "filter", filter_names, Filter::linear);
      if (entry.has("wrap")) read.wrap = choice(entry, "wrap", wrap_names, Wrap::clamp);
      entry.refuse_unknown_keys();
    } else {
      read.source = table.string(sampler);
    }
    reads[sampler] = read;
  }
  return reads;
}

void read_repeat(const TomlTable& table, const VariantManifest& variant, PassManifest& pass) {
  if (!table.has("repeat")) return;
  if (!table.is_string("repeat")) {
    pass.repeat = static_cast<uint32_t>(*table.optional_number("repeat", 1, 1000));
    return;
  }
  const std::string text = table.string("repeat");
  if (!text.starts_with("log2(") || !text.ends_with(")"))
    throw table.error("repeat", "'repeat' must be a number or \"log2(TARGET)\"");
  pass.repeat_log2_of = text.substr(5, text.size() - 6);
  if (!variant.target(pass.repeat_log2_of))
    throw table.error("repeat", fmt::format("'{}' is not a target of this variant", pass.repeat_log2_of));
}

// What a pass must have and must not have, by the way it draws.
void check_pass(const TomlTable& table, const VariantManifest& variant, const PassManifest& pass) {
  const bool raster = pass.draw == DrawKind::objects || pass.draw == DrawKind::unwrapped || pass.draw == DrawKind::fullscreen;
  if (raster && (pass.vertex.empty() || pass.fragment.empty()))
    throw table.error({}, "a drawn pass needs 'vertex' and 'fragment' shaders");
  if (pass.draw == DrawKind::compute && pass.compute.empty()) throw table.error({}, "a compute pass needs a 'compute' shader");
  if (pass.writes.empty() && pass.draw != DrawKind::compute)
    throw table.error({}, "'write' is missing: the targets that the pass draws into");

  std::vector<std::string> known = {std::string(frame_target)};
  for (const TargetManifest& target : variant.targets) known.push_back(target.name);
  std::optional<Scope> scope;
  for (const std::string& name : pass.writes) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw table.error("write", unknown_name("target", name, known));
    const TargetManifest* target = variant.target(name);
    const Scope its = target ? target->scope : Scope::frame;
    if (scope && *scope != its) throw table.error("write", "a pass writes targets of one scope");
    scope = its;
    if (pass.draw == DrawKind::mips && (!target || !target->mips))
      throw table.error("write", fmt::format("'{}' has no mips", name));
  }
  if (pass.draw == DrawKind::unwrapped && scope != Scope::object)
    throw table.error("write",
                      "an unwrapped pass writes targets with scope = \"object\": every object has texture space of its own");
  if (pass.draw == DrawKind::objects && scope == Scope::object)
    throw table.error("write", "objects on screen are drawn into targets of the frame's scope");
  const bool depth_allowed = pass.draw == DrawKind::objects;
  if (pass.depth != Depth::none && !depth_allowed)
    throw table.error("depth", "only passes that draw objects on screen have depth");
}

PassManifest read_pass(const TomlTable& table, const VariantManifest& variant, const fs::path& shaders) {
  PassManifest pass;
  const fs::path folder = variant.file.parent_path();
  pass.name = table.string("name");
  pass.where = table.where();
  table.string("draw");
  pass.draw = choice(table, "draw", {"objects", "unwrapped", "fullscreen", "compute", "mips"}, DrawKind::objects);
  pass.when = choice(table, "when", {"frame", "mesh_or_lights_move", "once", "truth"}, Frequency::frame);
  read_repeat(table, variant, pass);
  pass.vertex = find_shader(table, "vertex", folder, shaders);
  if (pass.draw == DrawKind::fullscreen && pass.vertex.empty()) pass.vertex = shaders / "common/fullscreen.vert";
  pass.fragment = find_shader(table, "fragment", folder, shaders);
  pass.compute = find_shader(table, "compute", folder, shaders);
  for (auto& [name, text] : table.table("define").texts()) pass.defines[name] = text;
  for (auto& [name, text] : table.table("constants").texts()) pass.constants[name] = text;
  pass.reads = read_reads(table);
  pass.writes = table.optional_strings("write").value_or(std::vector<std::string>{});
  if (const auto clear = table.optional_numbers("clear")) {
    if (clear->size() != 4) throw table.error("clear", "'clear' must be a list of four numbers");
    pass.clear.emplace();
    std::transform(clear->begin(), clear->end(), pass.clear->begin(), [](double value) { return static_cast<float>(value); });
  }
  pass.blend = choice(table, "blend", {"none", "alpha", "premultiplied", "additive"}, Blend::none);
  pass.depth = choice(table, "depth", {"none", "read", "read_write"}, Depth::none);
  pass.cull = choice(table, "cull", {"none", "back", "front"}, Cull::none);
  if (const auto groups = table.optional_numbers("groups")) {
    if (groups->size() != 3) throw table.error("groups", "'groups' must be a list of three counts");
    for (size_t i = 0; i < 3; ++i) pass.groups[i] = static_cast<uint32_t>(std::clamp((*groups)[i], 1.0, 65535.0));
  }
  pass.threads_over = table.optional_string("threads_over").value_or("");
  if (!pass.threads_over.empty() && !variant.target(pass.threads_over))
    throw table.error("threads_over", fmt::format("'{}' is not a target of this variant", pass.threads_over));
  if (const auto local = table.optional_numbers("local_size")) {
    if (local->size() != 2) throw table.error("local_size", "'local_size' must be a list of two counts");
    for (size_t i = 0; i < 2; ++i) pass.local_size[i] = static_cast<uint32_t>(std::clamp((*local)[i], 1.0, 1024.0));
  }
  table.refuse_unknown_keys();
  check_pass(table, variant, pass);
  return pass;
}

VariantManifest read_variant(const fs::path& file, std::string effect, const fs::path& shaders) {
  const TomlTable root = TomlTable::parse(file, "variants");
  const TomlTable head = root.table("variant");
  VariantManifest variant;
  variant.file = file;
  variant.name = head.string("name");
  variant.effect = head.optional_string("effect").value_or(effect);
  if (variant.effect.empty()) throw head.error({}, "'effect' is missing: which effect is this a variant of?");
  variant.title = head.optional_string("title").value_or(variant.name);
  variant.baseline = head.optional_bool("baseline").value_or(false);
  head.refuse_unknown_keys();
  for (const auto& [name, table] : root.tables("targets")) variant.targets.push_back(read_target(name, table));
  for (const auto& [name, table] : root.tables("buffers")) variant.buffers.push_back(read_buffer(name, table));
  if (root.has("apertures")) variant.apertures = read_apertures(root.table("apertures"));
  for (const auto& [name, table] : root.tables("parameters")) variant.parameters.push_back(read_parameter(name, table));
  for (const TomlTable& table : root.array_of_tables("pass")) variant.passes.push_back(read_pass(table, variant, shaders));
  if (variant.passes.empty()) throw root.error({}, "a variant needs at least one [[pass]]");
  root.refuse_unknown_keys();
  return variant;
}

EffectManifest read_effect(const fs::path& file) {
  const TomlTable root = TomlTable::parse(file, "variants");
  const TomlTable head = root.table("effect");
  EffectManifest effect;
  effect.name = head.string("name");
  effect.title = head.string("title");
  effect.order = static_cast<int>(head.optional_number("order", -1000, 1000).value_or(100));
  effect.called_by = head.string("called_by");
  effect.because = head.string("because");
  effect.not_because = head.string("not_because");
  head.refuse_unknown_keys();
  for (const auto& [define, table] : root.tables("features")) {
    effect.features.push_back({define, table.string("fact"), table.string("because"), table.string("not_because")});
    table.refuse_unknown_keys();
  }
  root.refuse_unknown_keys();
  return effect;
}

std::vector<fs::path> sorted_entries(const fs::path& folder) {
  std::error_code failure;
  std::vector<fs::path> entries;
  for (const auto& entry : fs::directory_iterator(folder, failure)) entries.push_back(entry.path());
  if (failure) throw Error(ErrorKind::bad_input, "variants", folder.string(), "is not a folder that can be read");
  std::sort(entries.begin(), entries.end());
  return entries;
}

void add_variant(Library& library, VariantManifest variant) {
  std::vector<std::string> names;
  for (EffectManifest& effect : library.effects) {
    names.push_back(effect.name);
    if (effect.name != variant.effect) continue;
    for (const VariantManifest& other : effect.variants) {
      if (other.name == variant.name)
        throw Error(ErrorKind::bad_input, "variants", variant.file.string(),
                    fmt::format("variant '{}' of {} is already defined in {}: choose another name", variant.name, effect.name,
                                other.file.string()));
      if (other.baseline && variant.baseline)
        throw Error(ErrorKind::bad_input, "variants", variant.file.string(),
                    fmt::format("{} already has the baseline '{}': remove 'baseline = true'", effect.name, other.name));
    }
    effect.variants.push_back(std::move(variant));
    return;
  }
  throw Error(ErrorKind::bad_input, "variants", variant.file.string(), unknown_name("effect", variant.effect, names));
}

void add_effect_folder(Library& library, const fs::path& folder) {
  library.effects.push_back(read_effect(folder / "effect.toml"));
  const std::string name = library.effects.back().name;
  for (const fs::path& file : sorted_entries(folder))
    if (file.extension() == ".toml" && file.filename() != "effect.toml")
      add_variant(library, read_variant(file, name, library.shaders));
}

}  // namespace

const TargetManifest* VariantManifest::target(std::string_view target_name) const {
  for (const TargetManifest& candidate : targets)
    if (candidate.name == target_name) return &candidate;
  return nullptr;
}

const EffectManifest& Library::effect(std::string_view name) const {
  std::vector<std::string> names;
  for (const EffectManifest& candidate : effects) {
    if (candidate.name == name) return candidate;
    names.push_back(candidate.name);
  }
  throw Error(ErrorKind::bad_input, "variants", std::string(name), unknown_name("effect", name, names));
}

Library load_library(const fs::path& home, const std::vector<fs::path>& user_dirs) {
  Library library;
  library.shaders = fs::weakly_canonical(home / "shaders");
  for (const fs::path& folder : sorted_entries(home / "variants"))
    if (fs::is_regular_file(folder / "effect.toml")) add_effect_folder(library, folder);
  for (const fs::path& dir : user_dirs) {
    size_t found = 0;
    for (const fs::path& entry : sorted_entries(dir)) {
      if (fs::is_regular_file(entry / "effect.toml"))
        add_effect_folder(library, entry), ++found;
      else if (entry.extension() == ".toml")
        add_variant(library, read_variant(entry, "", library.shaders)), ++found;
    }
    if (found == 0)
      throw Error(ErrorKind::bad_input, "variants", dir.string(), "holds no variant manifest (*.toml) and no effect folder");
  }
  for (EffectManifest& effect : library.effects) {
    std::stable_partition(effect.variants.begin(), effect.variants.end(), [](const VariantManifest& v) { return v.baseline; });
    if (effect.variants.empty() || !effect.variants.front().baseline)
      throw Error(ErrorKind::bad_input, "variants", effect.name, "has no baseline: one variant must say 'baseline = true'");
  }
  std::stable_sort(library.effects.begin(), library.effects.end(),
                   [](const auto& a, const auto& b) { return a.order < b.order; });
  return library;
}

}  // namespace lamina
