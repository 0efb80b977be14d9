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
const std::vector<std::string> fact_functions = {"seen_alpha", "largest", "largest_channel", "least_alpha", "largest_bend"};

template <class Code>
std::vector<std::string> names_in(const std::map<std::string, Code>& code) {
  std::vector<std::string> names;
  for (const auto& [name, made] : code) names.push_back(name);
  return names;
}

// The keys that numbers, words and textures are declared by.
std::vector<TomlKey> declaration_keys(const EffectCode& code) {
  constexpr double largest = largest_number;
  const TomlKey key = {"key", "key of scene files and path of sweeps; the name where it is left out", {form::text()}};
  const TomlKey title = {"title", "what it is, for people", {form::text()}};
  const TomlFormPtr number =
      form::make({key,
                  title,
                  {"unit", "its unit", {form::text()}},
                  {"value", "the default", {form::number(-largest, largest)}},
                  {"range", "[least, greatest]", {form::numbers(-largest, largest, {2})}},
                  {"or_zero", "0 is allowed beside the range", {form::flag()}},
                  {"whole", "whole numbers only", {form::flag()}},
                  {"over_unwrap", "above 0, something is laid out over the object's unwrap", {form::flag()}},
                  {"scales_with", "the texture whose texels are the unit", {form::text()}},
                  {"share", "the default is this share of that texture's width", {form::number(0, 1)}},
                  {"otherwise", "the default is what the model says", {form::word(model_numbers)}}});
  const TomlFormPtr word = form::make({key,
                                       title,
                                       {"of", "the words to choose among", {form::texts()}, true},
                                       {"value", "the default; the first where it is left out", {form::text()}},
                                       {"needed", "the effect is left out where no object says this word", {form::text()}}});
  std::vector<std::string> makers = model_textures;
  for (const std::string& name : names_in(code.makers)) makers.push_back(name);
  const TomlFormPtr texture =
      form::make({{"rgb", "scene key of a file or a colour; the name where it is left out", {form::text()}},
                  {"alpha", "scene key of a file's red channel or a number", {form::text()}},
                  {"alpha_title", "what alpha is, for people", {form::text()}},
                  {"meaning", "what a texel means, and so how levels are filtered", {form::word(meaning_names)}},
                  {"otherwise", "what stands in for it: the model's, or a maker's", {form::word(makers)}},
                  {"value", "one texel that stands in for it, linear", {form::numbers(-largest, largest, {1, 3})}},
                  {"alpha_otherwise", "what stands in for alpha", {form::word(model_alphas)}},
                  {"alpha_value", "alpha where nothing says another", {form::number(0, 1)}},
                  {"min_width", "texels that a given one must have along its width", {form::whole(1, 16384)}},
                  filter_key,
                  wrap_key});
  return {{"textures",
           "samplers of these names",
           {form::table(form::make({}, TomlKey{"NAME", "a texture", {form::table(texture)}}))}},
          {"numbers",
           "floats of the block Effect",
           {form::table(form::make({}, TomlKey{"NAME", "a number", {form::table(number)}}))}},
          {"words", "ints of the block Effect", {form::table(form::make({}, TomlKey{"NAME", "a word", {form::table(word)}}))}}};
}

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

void expect_one_of(const TomlTable& table, std::string_view key, const std::string& name,
                   const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) == known.end()) throw table.error(key, unknown_name(key, name, known));
}

void read_range(const TomlTable& table, double& min, double& max) {
  const auto range = table.optional_numbers("range");
  if (!range) return;
  if (!((*range)[0] <= (*range)[1])) throw table.error("range", "'range' must be [least, greatest]");
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
  number.over_unwrap = table.optional_bool("over_unwrap").value_or(false);
  number.value = table.optional_number("value");
  if (number.value && !(number.or_zero && *number.value == 0) && !(*number.value >= number.min && *number.value <= number.max))
    throw table.error("value", fmt::format("'value' must lie in the range, {} to {}", number.min, number.max));
  number.scales_with = table.optional_string("scales_with").value_or("");
  if (!number.scales_with.empty()) expect_one_of(table, "scales_with", number.scales_with, names_of(declared.textures));
  number.share = table.optional_number("share").value_or(0);
  if (number.share > 0 && number.scales_with.empty())
    throw table.error("share", "a share is of the texture that 'scales_with' names, which is missing");
  number.otherwise = table.optional_string("otherwise").value_or("");
  if (!number.otherwise.empty() && number.scales_with.empty())
    throw table.error("otherwise", "a model's length becomes texels of the texture that 'scales_with' names, which is missing");
  table.check_keys();
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
  table.check_keys();
  return word;
}

TextureManifest read_texture(const std::string& name, const TomlTable& table) {
  TextureManifest texture;
  texture.name = name;
  texture.rgb = table.optional_string("rgb").value_or(name);
  texture.alpha = table.optional_string("alpha").value_or("");
  texture.alpha_title = table.optional_string("alpha_title").value_or("");
  texture.meaning = choice(table, "meaning", TextureMeaning::colour);
  texture.otherwise = table.optional_string("otherwise").value_or("");
  texture.value = table.optional_numbers("value").value_or(std::vector<double>{});
  texture.alpha_otherwise = table.optional_string("alpha_otherwise").value_or("");
  texture.alpha_value = table.optional_number("alpha_value").value_or(1);
  texture.sampler = read_sampler(table, texture.sampler);
  texture.min_width = static_cast<uint32_t>(table.optional_number("min_width").value_or(1));
  texture.required = texture.value.empty() && texture.meaning == TextureMeaning::colour &&
                     (texture.otherwise.empty() || texture.otherwise.starts_with("model."));
  table.check_keys();
  return texture;
}

Declarations read_declarations(const TomlTable& root) {
  Declarations declared;
  for (const auto& [name, table] : root.tables("textures")) declared.textures.push_back(read_texture(name, table));
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
  if (std::find(fact_functions.begin(), fact_functions.end(), given[0]) == fact_functions.end())
    throw table.error(given[0], unknown_name(given[0], given[0], fact_functions));
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
    mirror.height = table.optional_number("height").value_or(0);
  }
  table.check_keys();
  return mirror;
}

}  // namespace

const NumberManifest* Declarations::number(std::string_view name) const { return named(numbers, name); }
const WordManifest* Declarations::word(std::string_view name) const { return named(words, name); }
const TextureManifest* Declarations::texture(std::string_view name) const { return named(textures, name); }

const VariantManifest* EffectManifest::variant(std::string_view wanted) const { return named(variants, wanted); }

TomlFormPtr effect_form(const EffectCode& code) {
  const auto needs = [](const char* about, bool required) {
    return TomlKey{"needs", about, {form::texts({}, "^[^ ]+( >= [^ ]+)?$")}, required};
  };
  const TomlFormPtr head =
      form::make({{"name", "the effect's name", {form::text()}, true},
                  {"title", "what it is, for people", {form::text()}, true},
                  {"order", "its place in the frame; 100 where it is left out", {form::whole(-1000, 1000)}},
                  {"key", "objects.NAME.KEY = true calls for the effect, false takes it away", {form::text()}},
                  {"models", "a model without a scene file gets it", {form::flag()}},
                  {"otherwise", "it draws what no other effect draws", {form::flag()}},
                  {"solid", "false: passes of all objects skip its own, and rays pass through them", {form::flag()}},
                  {"blocks_light", "false: rays pass through its objects", {form::flag()}},
                  {"closed", "each mesh must be a closed hull", {form::flag()}},
                  {"unique_unwrap", "a mesh whose parts share texels is taken apart", {form::flag()}},
                  {"only_where_seen", "an object that no view can see is left out", {form::flag()}},
                  {"reads_frame", "drawn after the effects that do not read the frame", {form::flag()}},
                  {"instead_of", "an object has only one of these effects", {form::texts()}},
                  {"quick", "variants that compare --quick looks at, beside the baseline; all without", {form::texts()}},
                  {"because", "the plan's reason where it is called for", {form::text()}, true},
                  {"not_because", "the plan's reason where it is not", {form::text()}, true},
                  needs("left out where one of these numbers or facts is 0", false),
                  {"vanishes", "an object that does not meet 'needs' is nowhere; else it is a plain surface", {form::flag()}},
                  {"bake", "C++ that bakes what its variants want", {form::word(names_in(code.bakers))}},
                  {"truth", "C++ that makes the offline picture", {form::word(names_in(code.truths))}}});
  const TomlFormPtr feature = form::make({needs("facts or numbers that must be above 0, or NAME >= NUMBER", true),
                                          {"because", "the plan's reason where shaders get it", {form::text()}, true},
                                          {"not_because", "the plan's reason where they do not", {form::text()}, true},
                                          {"at_zero",
                                           "shaders draw the same to the bit with it where its needs are 0; a frame of "
                                           "everything has it",
                                           {form::flag()}}});
  std::vector<TomlKey> functions;
  for (const std::string& name : fact_functions) functions.push_back({name, "the texture that is looked at", {form::text()}});
  const TomlFormPtr mirror =
      form::make({{"normal", "of the plane", {form::numbers(-largest_number, largest_number, {3})}},
                  {"height", "metres, or a number of the scene", {form::number(-1e6, 1e6), form::text()}}});
  std::vector<TomlKey> keys = {{"effect", "the effect", {form::table(head)}, true}};
  const std::vector<TomlKey> declarations = declaration_keys(code);
  keys.insert(keys.end(), declarations.begin(), declarations.end());
  keys.push_back({"scene", "what is said of the whole scene, under [effects.NAME]", {form::table(form::make(declarations))}});
  keys.push_back(
      {"facts",
       "what follows from meshes and textures",
       {form::table(form::make({}, TomlKey{"NAME", "one function of one texture", {form::table(form::make(functions))}}))}});
  keys.push_back({"features",
                  "definitions that shaders get, per object",
                  {form::table(form::make({}, TomlKey{"NAME", "a definition", {form::table(feature)}}))}});
  keys.push_back({"mirror", "the plane of views of kind mirror", {form::table(mirror)}});
  return form::make(keys);
}

EffectManifest read_effect(const std::filesystem::path& file, const EffectCode& code) {
  const TomlTable root = TomlTable::parse(file, "variants", effect_form(code));
  const TomlTable head = root.table("effect");
  EffectManifest effect;
  effect.file = file;
  effect.digest = hash_hex(read_file(file, "variants"));
  effect.name = head.string("name");
  effect.title = head.string("title");
  effect.order = static_cast<int>(head.optional_number("order").value_or(100));
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
  effect.quick = head.optional_strings("quick").value_or(std::vector<std::string>{});
  effect.because = head.string("because");
  effect.not_because = head.string("not_because");
  effect.object = read_declarations(root);
  const TomlTable scene = root.table("scene");
  effect.scene = read_declarations(scene);
  scene.check_keys();
  if (!effect.of_objects() && !effect.object.empty())
    throw head.error({}, "'key' is missing: objects call for the effect by it, and the effect declares what they may say");
  for (const auto& [name, table] : root.tables("facts")) effect.facts.push_back(read_fact(name, table, effect.object));
  for (const auto& [define, table] : root.tables("features")) {
    FeatureManifest& feature = effect.features.emplace_back();
    feature.define = define;
    feature.needs = read_needs(table, effect);
    if (feature.needs.empty()) throw table.error({}, "'needs' is missing: the facts or numbers that must be above 0");
    feature.because = table.string("because"), feature.not_because = table.string("not_because");
    feature.at_zero = table.optional_bool("at_zero").value_or(false);
    table.check_keys();
  }
  effect.needs = read_needs(head, effect);
  effect.vanishes = head.optional_bool("vanishes").value_or(false);
  if (effect.vanishes && effect.needs.empty())
    throw head.error("vanishes", "'vanishes' is about objects that do not meet 'needs', and there are none");
  if (root.has("mirror")) effect.mirror = read_mirror(root.table("mirror"), effect);
  effect.baker = head.optional_string("bake").value_or("");
  effect.truth = head.optional_string("truth").value_or("");
  head.check_keys();
  root.check_keys();
  return effect;
}

}  // namespace lamina
