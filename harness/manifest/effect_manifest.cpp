// SPDX-License-Identifier: Apache-2.0
#include "harness/manifest/effect_manifest.h"

#include <algorithm>
#include <cmath>

#include "harness/core/text.h"
#include "harness/manifest/choices.h"

namespace lamina {
namespace {

const std::vector<std::string> meaning_names = {"colour", "number", "normal", "normal_mean", "data"};
const std::vector<std::string> model_textures = {"model.base_colour", "model.normal"};
const std::vector<std::string> model_alphas = {"model.transparency"};
const std::vector<std::string> model_numbers = {"model.thickness"};
const std::vector<std::string> fact_functions = {"seen_alpha", "largest", "largest_channel", "least_alpha"};

template <class Row>
const Row* named(const std::vector<Row>& rows, std::string_view name) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.name == name; });
  return found == rows.end() ? nullptr : &*found;
}

template <class Row>
std::vector<std::string> names_of(const std::vector<Row>& rows) {
  std::vector<std::string> names;
  for (const Row& row : rows) names.push_back(row.name);
  return names;
}

template <class Code>
void expect_code(const TomlTable& table, std::string_view key, const std::string& name,
                 const std::map<std::string, Code>& code) {
  std::vector<std::string> known;
  for (const auto& [other, made] : code) known.push_back(other);
  if (!code.contains(name)) throw table.error(key, unknown_name(key, name, known));
}

void expect_one_of(const TomlTable& table, std::string_view key, const std::string& name,
                   const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) == known.end()) throw table.error(key, unknown_name(key, name, known));
}

void read_range(const TomlTable& table, double& min, double& max) {
  const auto range = table.optional_numbers("range");
  if (!range) return;
  if (range->size() != 2 || !((*range)[0] <= (*range)[1])) throw table.error("range", "'range' must be [least, greatest]");
  min = (*range)[0], max = (*range)[1];
}

// What numbers and words have in common.
template <class Row>
void read_head(const std::string& name, const TomlTable& table, Row& row) {
  row.name = name;
  row.key = table.optional_string("key").value_or(name);
  row.title = table.optional_string("title").value_or("");
}

NumberManifest read_number(const std::string& name, const TomlTable& table, const Declarations& declared) {
  NumberManifest number;
  read_head(name, table, number);
  number.unit = table.optional_string("unit").value_or("");
  number.min = -largest_number, number.max = largest_number;
  read_range(table, number.min, number.max);
  number.or_zero = table.optional_bool("or_zero").value_or(false);
  number.whole = table.optional_bool("whole").value_or(false);
  number.value = table.optional_number("value", -largest_number, largest_number);
  if (number.value && !(number.or_zero && *number.value == 0) && !(*number.value >= number.min && *number.value <= number.max))
    throw table.error("value", fmt::format("'value' must lie in the range, {} to {}", number.min, number.max));
  number.scales_with = table.optional_string("scales_with").value_or("");
  if (!number.scales_with.empty()) expect_one_of(table, "scales_with", number.scales_with, names_of(declared.textures));
  number.share = table.optional_number("share", 0, 1).value_or(0);
  if (number.share > 0 && number.scales_with.empty())
    throw table.error("share", "a share is of the texture that 'scales_with' names, which is missing");
  number.otherwise = table.optional_string("otherwise").value_or("");
  if (!number.otherwise.empty()) {
    expect_one_of(table, "otherwise", number.otherwise, model_numbers);
    if (number.scales_with.empty())
      throw table.error("otherwise",
                        "a model's length becomes texels of the texture that 'scales_with' names, which is missing");
  }
  table.refuse_unknown_keys();
  return number;
}

WordManifest read_word(const std::string& name, const TomlTable& table) {
  WordManifest word;
  read_head(name, table, word);
  const auto [words, value] = read_words(table);
  word.of = words;
  word.value = words[value];
  word.needed = table.optional_string("needed").value_or("");
  if (!word.needed.empty()) expect_one_of(table, "needed", word.needed, words);
  table.refuse_unknown_keys();
  return word;
}

TextureManifest read_texture(const std::string& name, const TomlTable& table, const EffectCode& code) {
  TextureManifest texture;
  texture.name = name;
  texture.rgb = table.optional_string("rgb").value_or(name);
  texture.alpha = table.optional_string("alpha").value_or("");
  texture.alpha_title = table.optional_string("alpha_title").value_or("");
  texture.meaning = choice(table, "meaning", meaning_names, TextureMeaning::colour);
  texture.otherwise = table.optional_string("otherwise").value_or("");
  if (texture.otherwise.starts_with("model."))
    expect_one_of(table, "otherwise", texture.otherwise, model_textures);
  else if (!texture.otherwise.empty())
    expect_code(table, "otherwise", texture.otherwise, code.makers);
  texture.value = table.optional_numbers("value").value_or(std::vector<double>{});
  if (!texture.value.empty() && texture.value.size() != 1 && texture.value.size() != 3)
    throw table.error("value", "'value' must be [number] or [red, green, blue]");
  texture.alpha_otherwise = table.optional_string("alpha_otherwise").value_or("");
  if (!texture.alpha_otherwise.empty()) expect_one_of(table, "alpha_otherwise", texture.alpha_otherwise, model_alphas);
  texture.alpha_value = table.optional_number("alpha_value", 0, 1).value_or(1);
  texture.sampler = read_sampler(table, texture.sampler);
  texture.min_width = static_cast<uint32_t>(table.optional_number("min_width", 1, 16384).value_or(1));
  texture.required = texture.value.empty() && texture.meaning == TextureMeaning::colour &&
                     (texture.otherwise.empty() || texture.otherwise.starts_with("model."));
  table.refuse_unknown_keys();
  return texture;
}

Declarations read_declarations(const TomlTable& root, const EffectCode& code) {
  Declarations declared;
  for (const auto& [name, table] : root.tables("textures")) declared.textures.push_back(read_texture(name, table, code));
  for (const auto& [name, table] : root.tables("numbers")) declared.numbers.push_back(read_number(name, table, declared));
  for (const auto& [name, table] : root.tables("words")) declared.words.push_back(read_word(name, table));
  // A member of the block Effect has one meaning.
  for (const WordManifest& word : declared.words)
    if (declared.number(word.name))
      throw root.table("words").error(word.name, fmt::format("'{}' is a number already: choose another name", word.name));
  return declared;
}

FactManifest read_fact(const std::string& name, const TomlTable& table, const Declarations& declared) {
  const std::vector<std::string> given = table.keys();
  if (given.size() != 1) throw table.error({}, "a fact is one function of one texture: FUNCTION = \"TEXTURE\"");
  expect_one_of(table, given[0], given[0], fact_functions);
  FactManifest fact{name, given[0], table.string(given[0])};
  expect_one_of(table, given[0], fact.texture, names_of(declared.textures));
  return fact;
}

std::vector<std::string> facts_and_numbers(const EffectManifest& effect) {
  std::vector<std::string> names = names_of(effect.facts);
  for (const Declarations* declared : {&effect.object, &effect.scene})
    for (const NumberManifest& number : declared->numbers) names.push_back(number.name);
  return names;
}

NeedManifest read_need(const TomlTable& table, const std::string& text) {
  const size_t sign = text.find(" >= ");
  if (sign == std::string::npos) return {text, std::nullopt};
  const std::string number = text.substr(sign + 4);
  char* end = nullptr;
  const double at_least = std::strtod(number.c_str(), &end);
  if (number.empty() || *end != 0 || !std::isfinite(at_least))
    throw table.error("needs", fmt::format("'{}' must be a name, or NAME >= NUMBER", text));
  return {text.substr(0, sign), at_least};
}

std::vector<NeedManifest> read_needs(const TomlTable& table, const EffectManifest& effect) {
  const std::vector<std::string> known = facts_and_numbers(effect);
  std::vector<NeedManifest> needs;
  for (const std::string& text : table.optional_strings("needs").value_or(std::vector<std::string>{})) {
    needs.push_back(read_need(table, text));
    if (std::find(known.begin(), known.end(), needs.back().name) == known.end())
      throw table.error("needs", unknown_name("fact or number", needs.back().name, known));
  }
  return needs;
}

MirrorManifest read_mirror(const TomlTable& table, const EffectManifest& effect) {
  MirrorManifest mirror;
  if (const auto normal = table.optional_vec3("normal")) {
    if (!(glm::length(*normal) > 0)) throw table.error("normal", "'normal' has no length");
    mirror.normal = glm::normalize(*normal);
  }
  if (table.is_string("height")) {
    mirror.height_number = table.string("height");
    expect_one_of(table, "height", mirror.height_number, names_of(effect.scene.numbers));
  } else {
    mirror.height = table.optional_number("height", -1e6, 1e6).value_or(0);
  }
  table.refuse_unknown_keys();
  return mirror;
}

}  // namespace

const NumberManifest* Declarations::number(std::string_view name) const { return named(numbers, name); }
const WordManifest* Declarations::word(std::string_view name) const { return named(words, name); }
const TextureManifest* Declarations::texture(std::string_view name) const { return named(textures, name); }

EffectManifest read_effect(const std::filesystem::path& file, const EffectCode& code) {
  const TomlTable root = TomlTable::parse(file, "variants");
  const TomlTable head = root.table("effect");
  EffectManifest effect;
  effect.file = file;
  effect.digest = hash_hex(read_file(file, "variants"));
  effect.name = head.string("name");
  effect.title = head.string("title");
  effect.order = static_cast<int>(head.optional_number("order", -1000, 1000).value_or(100));
  effect.key = head.optional_string("key").value_or("");
  effect.models = head.optional_bool("models").value_or(false);
  effect.otherwise = head.optional_bool("otherwise").value_or(false);
  effect.solid = head.optional_bool("solid").value_or(true);
  effect.blocks_light = head.optional_bool("blocks_light").value_or(effect.solid);
  effect.closed = head.optional_bool("closed").value_or(false);
  effect.unique_unwrap = head.optional_bool("unique_unwrap").value_or(false);
  effect.only_where_seen = head.optional_bool("only_where_seen").value_or(false);
  if (effect.only_where_seen && !effect.of_objects())
    throw head.error("only_where_seen", "'only_where_seen' is about objects, and no 'key' lets objects call for the effect");
  effect.reads_frame = head.optional_bool("reads_frame").value_or(false);
  effect.instead_of = head.optional_strings("instead_of").value_or(std::vector<std::string>{});
  effect.because = head.string("because");
  effect.not_because = head.string("not_because");
  effect.object = read_declarations(root, code);
  const TomlTable scene = root.table("scene");
  effect.scene = read_declarations(scene, code);
  scene.refuse_unknown_keys();
  if (!effect.of_objects() && !effect.object.empty())
    throw head.error({}, "'key' is missing: objects call for the effect by it, and the effect declares what they may say");
  for (const auto& [name, table] : root.tables("facts")) effect.facts.push_back(read_fact(name, table, effect.object));
  for (const auto& [define, table] : root.tables("features")) {
    FeatureManifest& feature = effect.features.emplace_back();
    feature.define = define;
    feature.needs = read_needs(table, effect);
    if (feature.needs.empty()) throw table.error({}, "'needs' is missing: the facts or numbers that must be above 0");
    feature.because = table.string("because"), feature.not_because = table.string("not_because");
    table.refuse_unknown_keys();
  }
  effect.needs = read_needs(head, effect);
  if (root.has("mirror")) effect.mirror = read_mirror(root.table("mirror"), effect);
  effect.baker = head.optional_string("bake").value_or("");
  if (!effect.baker.empty()) expect_code(head, "bake", effect.baker, code.bakers);
  effect.truth = head.optional_string("truth").value_or("");
  if (!effect.truth.empty()) expect_code(head, "truth", effect.truth, code.truths);
  head.refuse_unknown_keys();
  root.refuse_unknown_keys();
  return effect;
}

}  // namespace lamina
