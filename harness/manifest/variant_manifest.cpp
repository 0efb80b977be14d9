// SPDX-License-Identifier: Apache-2.0
#include "harness/manifest/variant_manifest.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "harness/manifest/choices.h"
#include "harness/manifest/like.h"
#include "harness/manifest/parameter_value.h"
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
  size.scale = read_setting(table, "scale", variant).value_or(size.scale);
  if (!table.has("size")) return size;
  if (table.is_list("size")) {
    const auto sides = read_settings(table, "size", variant);
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
  target.scope = choice(table, "scope", Scope::frame);
  target.size = read_size(table, variant);
  if (target.scope != Scope::object && target.size.kind == SizeRule::Kind::texture)
    throw table.error("size", "only a target with scope = \"object\" can be as large as an object's texture");
  read_format(table, variant, target);
  target.mips = table.optional_bool("mips").value_or(false);
  target.buffers = static_cast<uint32_t>(table.optional_number("buffers").value_or(1));
  target.sampler = read_sampler(table, {Filter::nearest, Wrap::clamp});
  target.shared = table.optional_bool("shared").value_or(false);
  if (target.shared && target.scope == Scope::object)
    throw table.error("shared", "only targets of the frame or of a light are shared between effects");
  table.check_keys();
  return target;
}

BufferManifest read_buffer(const std::string& name, const TomlTable& table) {
  BufferManifest buffer;
  buffer.name = name;
  buffer.scope = choice(table, "scope", Scope::frame);
  buffer.bytes = static_cast<uint64_t>(table.optional_number("bytes").value_or(0));
  buffer.bytes_per_vertex = static_cast<uint64_t>(table.optional_number("bytes_per_vertex").value_or(0));
  buffer.bytes_per_pixel = static_cast<uint64_t>(table.optional_number("bytes_per_pixel").value_or(0));
  if (buffer.bytes + buffer.bytes_per_vertex + buffer.bytes_per_pixel == 0)
    throw table.error({}, "a buffer needs 'bytes', 'bytes_per_vertex' or 'bytes_per_pixel' above 0");
  if (buffer.bytes_per_vertex > 0 && buffer.scope != Scope::object)
    throw table.error("bytes_per_vertex", "only a buffer with scope = \"object\" has vertices");
  table.check_keys();
  return buffer;
}

// What lamina choose tries beside the default.
void read_tries(const TomlTable& table, ParameterManifest& parameter) {
  if (!table.has("try")) return;
  if (parameter.words.empty())
    for (const std::vector<double> tries = table.optional_numbers("try").value(); const double value : tries)
      parameter.tries.push_back(checked_number(parameter, value, table, "try"));
  else
    for (const std::vector<std::string> tries = table.optional_strings("try").value(); const std::string& word : tries)
      parameter.tries.push_back(checked_word(parameter, word, table, "try"));
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
    parameter.min = table.optional_number("min").value_or(-largest_number);
    parameter.max = table.optional_number("max").value_or(largest_number);
    if (parameter.max < parameter.min)
      throw table.error("max", fmt::format("'max' must be a number from {} to {}", parameter.min, largest_number));
    parameter.value = *table.optional_number("value");
    if (parameter.value < parameter.min || parameter.value > parameter.max)
      throw table.error("value", fmt::format("'value' must be a number from {} to {}", parameter.min, parameter.max));
    parameter.whole = table.optional_bool("whole").value_or(false);
  }
  read_tries(table, parameter);
  table.check_keys();
  return parameter;
}

TomlFormPtr target_form(bool whole) {
  std::vector<std::string> formats = format_names();
  const TomlFormPtr target =
      form::make({{"scope",
                   "one for the frame, for each object, or for each light that casts",
                   {form::word({"frame", "object", "light"})}},
                  {"size",
                   "\"frame\", [width, height], or a texture of the object",
                   {form::text(), form::numbers(1, largest_size, {2}), form::texts({}, parameter_pattern)}},
                  {"scale", "factor of the size", {form::number(1.0 / 64, 16), form::text(parameter_pattern)}},
                  {"format", "of a texel", {form::text(fmt::format("^({}|\\$.+)$", fmt::join(formats, "|")))}, whole},
                  {"mips", "it has a full mip chain", {form::flag()}},
                  {"buffers", "2: a pass may read what the one before wrote", {form::whole(1, 2)}},
                  {"shared", "one for all effects that declare the same", {form::flag()}},
                  filter_key,
                  wrap_key});
  return form::make({}, TomlKey{"NAME", "a target", {form::table(target)}});
}

TomlFormPtr buffer_form() {
  const TomlFormPtr buffer = form::make({{"scope", "one for the frame, or for each object", {form::word({"frame", "object"})}},
                                         {"bytes", "a fixed number of bytes", {form::number(0, 1e10)}},
                                         {"bytes_per_vertex", "for each vertex of the object", {form::number(0, 1e4)}},
                                         {"bytes_per_pixel", "for each pixel of the frame", {form::number(0, 1e4)}}});
  return form::make({}, TomlKey{"NAME", "a storage buffer", {form::table(buffer)}});
}

TomlFormPtr parameter_form(bool whole) {
  const TomlValue number = form::number(-largest_number, largest_number);
  const TomlFormPtr parameter = form::make(
      {{"value", "the default", {number, form::text()}, whole},
       {"of", "the words to choose among: it is then a word", {form::texts()}},
       {"min", "least", {number}},
       {"max", "greatest", {number}},
       {"whole", "whole numbers only", {form::flag()}},
       {"try", "what lamina choose tries beside the default", {form::numbers(-largest_number, largest_number), form::texts()}},
       {"unit", "its unit", {form::text()}},
       {"title", "what it is, for people", {form::text()}}});
  return form::make({}, TomlKey{"NAME", "a parameter", {form::table(parameter)}});
}

// `whole`: of a manifest that says all itself, or has what it is like laid under it. One that is like another may leave out
// what that one says.
TomlFormPtr manifest_form(bool whole) {
  const TomlFormPtr head =
      form::make({{"name", "the variant's name, unique in its effect", {form::text()}, true},
                  {"effect", "what it is a variant of; the folder's effect where it is left out", {form::text()}},
                  {"title", "what it is, for people", {form::text()}},
                  {"baseline", "the others are compared with this one", {form::flag()}},
                  {"like", "the manifest beside this one that it has all from but what it says itself", {form::text()}, !whole},
                  {"leave_out", "passes of that manifest that this one has not", {form::texts()}},
                  {"closed", "each mesh of the effect must be a closed hull", {form::flag()}}});
  const TomlFormPtr bake =
      form::make({}, TomlKey{"NAME", "an option of the effect's baker", {form::number(-largest_number, largest_number)}});
  return form::make({{"variant", "the variant", {form::table(head)}, true},
                     {"parameters", "what users may set", {form::table(parameter_form(whole))}},
                     {"targets", "what passes write", {form::table(target_form(whole))}},
                     {"buffers", "storage buffers", {form::table(buffer_form())}},
                     {"bake", "what the effect's baker is asked for", {form::table(bake)}},
                     {"pass", "steps of the frame, in order", {form::tables(pass_form(whole))}, whole}});
}

}  // namespace

TomlFormPtr variant_form() { return form::one_of({}, {manifest_form(true), manifest_form(false)}); }

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

VariantManifest VariantManifest::with_defaults(const std::map<std::string, double>& values) const {
  VariantManifest other = *this;
  for (ParameterManifest& each : other.parameters)
    if (const auto found = values.find(each.name); found != values.end()) each.value = found->second;
  return other;
}

VariantManifest read_variant(const std::filesystem::path& file, const std::string& effect,
                             const std::filesystem::path& shaders) {
  static const TomlFormPtr whole = manifest_form(true);
  const TomlTable root = manifest_nodes(file, whole);
  const TomlTable head = root.table("variant");
  VariantManifest variant;
  variant.file = file;
  variant.name = head.string("name");
  variant.effect = head.optional_string("effect").value_or(effect);
  if (variant.effect.empty()) throw head.error({}, "'effect' is missing: which effect is this a variant of?");
  variant.title = head.optional_string("title").value_or(variant.name);
  variant.baseline = head.optional_bool("baseline").value_or(false);
  if (!head.optional_string("like") && head.has("leave_out"))
    throw head.error("leave_out", "'leave_out' needs 'like': whose passes are left out?");
  head.optional_strings("leave_out");
  variant.closed = head.optional_bool("closed").value_or(false);
  head.check_keys();
  for (const auto& [name, table] : root.tables("parameters")) variant.parameters.push_back(read_parameter(name, table));
  for (const auto& [name, table] : root.tables("targets")) variant.targets.push_back(read_target(name, table, variant));
  for (const auto& [name, table] : root.tables("buffers")) variant.buffers.push_back(read_buffer(name, table));
  const TomlTable bake = root.table("bake");
  for (const std::string& option : bake.keys()) variant.bake[option] = bake.optional_number(option).value_or(0);
  for (const TomlTable& table : root.array_of_tables("pass")) variant.passes.push_back(read_pass(table, variant, shaders));
  if (variant.passes.empty()) throw root.error({}, "a variant needs at least one [[pass]]");
  root.check_keys();
  return variant;
}

}  // namespace lamina
