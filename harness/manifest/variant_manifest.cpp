// SPDX-License-Identifier: Apache-2.0
#include "harness/manifest/variant_manifest.h"

#include <algorithm>
#include <cmath>

#include "harness/manifest/choices.h"
#include "harness/manifest/read_pass.h"

namespace lamina {
namespace {

constexpr double largest_size = 65536;

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (int i = 0; i <= static_cast<int>(Format::d32_float); ++i) names.emplace_back(name_of(static_cast<Format>(i)));
  return names;
}

SizeRule read_size(const TomlTable& table, const VariantManifest& variant) {
  SizeRule size;
  size.scale = read_setting(table, "scale", variant, 1.0 / 64, 16).value_or(size.scale);
  if (!table.has("size")) return size;
  if (table.is_list("size")) {
    const auto sides = read_settings(table, "size", variant, 1, largest_size);
    if (sides.size() != 2) throw table.error("size", "'size' must be \"frame\", a texture of the object, or [width, height]");
    size.kind = SizeRule::Kind::fixed;
    size.width = sides[0], size.height = sides[1];
    return size;
  }
  const std::string name = table.string("size");
  if (name != frame_target) size.kind = SizeRule::Kind::texture, size.texture = name;
  return size;
}

void read_format(const TomlTable& table, const VariantManifest& variant, TargetManifest& target) {
  const std::string format = table.string("format");
  if (format.starts_with('$')) {
    const ParameterManifest& parameter = parameter_named(table, "format", variant, format);
    if (parameter.words.empty()) throw table.error("format", fmt::format("'{}' is a number; a format is a word", format));
    for (const std::string& word : parameter.words)
      if (!format_named(word)) throw table.error("format", unknown_name("format", word, format_names()));
    target.format_parameter = parameter.name;
    target.format = *format_named(parameter.words.at(static_cast<size_t>(parameter.value)));
  } else if (const auto known = format_named(format)) {
    target.format = *known;
  } else {
    throw table.error("format", unknown_name("format", format, format_names()));
  }
}

TargetManifest read_target(const std::string& name, const TomlTable& table, const VariantManifest& variant) {
  TargetManifest target;
  target.name = name;
  if (name == frame_target || name == depth_name)
    throw table.error({}, fmt::format("'{}' is the harness's own target: choose another name", name));
  target.scope = choice(table, "scope", {"frame", "object", "light"}, Scope::frame);
  target.size = read_size(table, variant);
  if (target.scope != Scope::object && target.size.kind == SizeRule::Kind::texture)
    throw table.error("size", "only a target with scope = \"object\" can be as large as an object's texture");
  read_format(table, variant, target);
  target.mips = table.optional_bool("mips").value_or(false);
  target.buffers = static_cast<uint32_t>(table.optional_number("buffers", 1, 2).value_or(1));
  target.sampler = read_sampler(table, {Filter::nearest, Wrap::clamp});
  target.shared = table.optional_bool("shared").value_or(false);
  if (target.shared && target.scope == Scope::object)
    throw table.error("shared", "only targets of the frame or of a light are shared between effects");
  table.refuse_unknown_keys();
  return target;
}

BufferManifest read_buffer(const std::string& name, const TomlTable& table) {
  BufferManifest buffer;
  buffer.name = name;
  buffer.scope = choice(table, "scope", {"frame", "object"}, Scope::frame);
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

ParameterManifest read_parameter(const std::string& name, const TomlTable& table) {
  ParameterManifest parameter;
  parameter.name = name;
  parameter.unit = table.optional_string("unit").value_or("");
  parameter.title = table.optional_string("title").value_or("");
  if (!table.has("value")) throw table.error({}, "'value' is missing: the parameter's default");
  if (table.has("of")) {
    const auto [words, value] = read_words(table);
    parameter.words = words;
    parameter.max = static_cast<double>(words.size() - 1);
    parameter.whole = true;
    parameter.value = static_cast<double>(value);
  } else {
    parameter.min = table.optional_number("min", -largest_number, largest_number).value_or(-largest_number);
    parameter.max = table.optional_number("max", parameter.min, largest_number).value_or(largest_number);
    parameter.value = *table.optional_number("value", parameter.min, parameter.max);
    parameter.whole = table.optional_bool("whole").value_or(false);
  }
  table.refuse_unknown_keys();
  return parameter;
}

}  // namespace

std::string ParameterManifest::text(double of) const {
  if (!words.empty()) return words.at(static_cast<size_t>(of));
  return whole ? fmt::format("{}", static_cast<int64_t>(of)) : fmt::format("{:#}", of);
}

const TargetManifest* VariantManifest::target(std::string_view target_name) const {
  for (const TargetManifest& candidate : targets)
    if (candidate.name == target_name) return &candidate;
  return nullptr;
}

const ParameterManifest* VariantManifest::parameter(std::string_view parameter_name) const {
  for (const ParameterManifest& candidate : parameters)
    if (candidate.name == parameter_name) return &candidate;
  return nullptr;
}

double VariantManifest::value_of(const ParameterManifest& parameter, const Parameters& set) const {
  const auto found = set.find(name + "." + parameter.name);
  return found == set.end() ? parameter.value : found->second;
}

double VariantManifest::value_of(const Setting& setting, const Parameters& set) const {
  return setting.parameter.empty() ? setting.value : value_of(*parameter(setting.parameter), set);
}

Format VariantManifest::format_of(const TargetManifest& of, const Parameters& set) const {
  if (of.format_parameter.empty()) return of.format;
  const ParameterManifest& word = *parameter(of.format_parameter);
  return *format_named(word.words.at(static_cast<size_t>(value_of(word, set))));
}

VariantManifest read_variant(const std::filesystem::path& file, const std::string& effect,
                             const std::filesystem::path& shaders) {
  const TomlTable root = TomlTable::parse(file, "variants");
  const TomlTable head = root.table("variant");
  VariantManifest variant;
  variant.file = file;
  variant.name = head.string("name");
  variant.effect = head.optional_string("effect").value_or(effect);
  if (variant.effect.empty()) throw head.error({}, "'effect' is missing: which effect is this a variant of?");
  variant.title = head.optional_string("title").value_or(variant.name);
  variant.baseline = head.optional_bool("baseline").value_or(false);
  variant.closed = head.optional_bool("closed").value_or(false);
  head.refuse_unknown_keys();
  for (const auto& [name, table] : root.tables("parameters")) variant.parameters.push_back(read_parameter(name, table));
  for (const auto& [name, table] : root.tables("targets")) variant.targets.push_back(read_target(name, table, variant));
  for (const auto& [name, table] : root.tables("buffers")) variant.buffers.push_back(read_buffer(name, table));
  const TomlTable bake = root.table("bake");
  for (const std::string& option : bake.keys())
    variant.bake[option] = bake.optional_number(option, -largest_number, largest_number).value_or(0);
  for (const TomlTable& table : root.array_of_tables("pass")) variant.passes.push_back(read_pass(table, variant, shaders));
  if (variant.passes.empty()) throw root.error({}, "a variant needs at least one [[pass]]");
  root.refuse_unknown_keys();
  return variant;
}

}  // namespace lamina
