// SPDX-License-Identifier: Apache-2.0
#include "harness/stress/family.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "harness/core/text.h"
#include "harness/core/toml_table.h"

namespace lamina {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Words for ends of ranges.
const std::map<std::string, double> constants = {{"-pi", -std::numbers::pi},
                                                 {"-pi/2", -std::numbers::pi / 2},
                                                 {"pi/2", std::numbers::pi / 2},
                                                 {"pi", std::numbers::pi},
                                                 {"2 pi", 2 * std::numbers::pi}};
constexpr const char* identifier_pattern = "^[A-Za-z_][A-Za-z0-9_]*$";
// What a set may not be called, for those that a person gives are.
constexpr const char* given_sets[] = {"grid", "points"};

std::string non_empty(const TomlTable& table, std::string_view key) {
  std::string text = table.string(key);
  if (text.empty()) throw table.error(key, fmt::format("'{}' must not be empty", key));
  return text;
}

bool is_identifier(std::string_view name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return !name.empty() && letter(name[0]) &&
         std::ranges::all_of(name, [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

// Names of functions and inputs stand in GLSL, in names of files and of columns.
void check_identifier(const TomlTable& table, std::string_view key, std::string_view name) {
  if (!is_identifier(name)) throw table.error(key, fmt::format("'{}' must be letters, digits and '_', no digit first", name));
}

std::string identifier(const TomlTable& table, std::string_view key) {
  const std::string name = table.string(key);
  check_identifier(table, key, name);
  return name;
}

size_t place_of(const std::vector<std::string>& names, const TomlTable& table, std::string_view key, std::string_view name) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) throw table.error(key, unknown_name("input", name, names));
  return static_cast<size_t>(found - names.begin());
}

// Whether the file and the oracle know the same names: each of those in the file must be the oracle's and the reverse.
void check_same_names(const char* kind, const std::vector<std::pair<std::string, TomlTable>>& declared,
                      const std::vector<std::string>& known, const TomlTable& root, const std::string& tables) {
  for (const auto& [name, table] : declared)
    if (std::ranges::find(known, name) == known.end()) throw table.error({}, unknown_name(kind, name, known));
  for (const std::string& name : known)
    if (std::ranges::none_of(declared, [&](const auto& one) { return one.first == name; }))
      throw root.error(tables,
                       fmt::format("the oracle's {} '{}' is missing: give it a table [{}.{}]", kind, name, tables, name));
}

// An end of a range: a number or a word for one.
double read_end(const TomlTable& table, std::string_view key, std::string& words) {
  if (table.is_string(key)) {
    words = table.string(key);
    return constants.at(words);
  }
  const double value = table.number(key);
  words = fmt::format("{}", value);
  return value;
}

FamilyInput read_input(const std::string& name, const TomlTable& table) {
  FamilyInput input{.name = name, .unit = non_empty(table, "unit")};
  check_identifier(table, {}, name);
  input.from = read_end(table, "from", input.from_words);
  input.to = read_end(table, "to", input.to_words);
  if (!(input.from < input.to))
    throw table.error("to", fmt::format("'to' ({}) must be above 'from' ({})", input.to_words, input.from_words));
  if (const auto open = table.optional_string("open")) {
    input.low_open = *open != "high", input.high_open = *open != "low";
  }
  table.check_keys();
  return input;
}

FamilyClaim read_claim(const TomlTable& table, const std::vector<std::string>& sets) {
  FamilyClaim claim{.over = table.number("over"),
                    .under = table.number("under"),
                    .eps_kappa = table.optional_number("eps_kappa"),
                    .sets = table.optional_strings("sets").value_or(std::vector<std::string>{})};
  if (table.has("sets") && claim.sets.empty())
    throw table.error("sets", "'sets' is empty: leave it out for a claim on every set");
  for (const std::string& set : claim.sets)
    if (std::ranges::find(sets, set) == sets.end()) throw table.error("sets", unknown_name("set", set, sets));
  table.check_keys();
  return claim;
}

FamilyFunction read_function(const std::string& name, const TomlTable& table, const std::vector<std::string>& sets) {
  check_identifier(table, {}, name);
  FamilyFunction function{.name = name, .baseline = table.optional_bool("baseline").value_or(false)};
  for (const TomlTable& claim : table.array_of_tables("claims")) function.claims.push_back(read_claim(claim, sets));
  table.check_keys();
  return function;
}

std::vector<FamilyFunction> read_functions(const TomlTable& root, const std::vector<std::string>& sets) {
  std::vector<FamilyFunction> functions;
  const FamilyFunction* baseline = nullptr;
  const auto tables = root.tables("functions");
  functions.reserve(tables.size());
  for (const auto& [name, table] : tables) {
    const FamilyFunction& function = functions.emplace_back(read_function(name, table, sets));
    if (!function.baseline) continue;
    if (baseline) throw table.error("baseline", fmt::format("'{}' is the baseline already: there is one", baseline->name));
    baseline = &function;
  }
  if (!baseline)
    throw root.error("functions", "none of the functions has baseline = true: the others' times are compared to it");
  std::stable_partition(functions.begin(), functions.end(), [](const FamilyFunction& function) { return function.baseline; });
  return functions;
}

void add_slice(const TomlTable& place, const FamilySlice& slice, std::vector<FamilySlice>& slices) {
  for (const FamilySlice& other : slices)
    if (other.at == slice.at && std::set{other.right, other.up} == std::set{slice.right, slice.up})
      throw place.error({}, "this slice is there already");
  slices.push_back(slice);
}

// The slices of one [[slices]], one for each point of its `at`; without, the one that the axes are enough for.
void read_slices(const TomlTable& table, const Family& family, std::vector<FamilySlice>& slices) {
  const std::vector<std::string> names = family.input_names();
  FamilySlice slice{.right = place_of(names, table, "right", table.string("right")),
                    .up = place_of(names, table, "up", table.string("up")),
                    .at = std::vector<float>(names.size()),
                    .full_error = table.number("full_error")};
  if (slice.right == slice.up) throw table.error("up", "'right' and 'up' must be two inputs");
  const std::vector<TomlTable> places = table.array_of_tables("at");
  table.check_keys();
  if (places.empty()) {
    if (names.size() > 2) throw table.error({}, "'at' is missing: it says where the inputs that are no axes stand");
    return add_slice(table, slice, slices);
  }
  for (const TomlTable& place : places) {
    for (const std::string& key : place.keys())
      if (const size_t input = place_of(names, place, key, key); input == slice.right || input == slice.up)
        throw place.error(key, fmt::format("'{}' runs over this slice; it has no one place", key));
    for (size_t i = 0; i < names.size(); ++i) {
      if (i == slice.right || i == slice.up) continue;
      const FamilyInput& input = family.inputs[i];
      if (!place.has(names[i])) throw place.error({}, fmt::format("needs {} = NUMBER: it is no axis", names[i]));
      const double value = place.number(names[i]);
      if (value < input.from || value > input.to)
        throw place.error(names[i], fmt::format("'{}' must be a number from {} to {}", names[i], input.from, input.to));
      slice.at[i] = static_cast<float>(value);
    }
    add_slice(place, slice, slices);
  }
}

std::vector<FamilyTable> read_tables(const TomlTable& head, const EffectCode& code) {
  std::vector<FamilyTable> tables;
  for (const std::string& name : head.optional_strings("tables").value_or(std::vector<std::string>{}))
    tables.push_back({name, code.tables.at(name)});
  return tables;
}

void read_head(const TomlTable& head, const EffectCode& code, Family& family) {
  family.name = identifier(head, "name");
  family.function = identifier(head, "function");
  family.title = non_empty(head, "title");
  family.definition = identifier(head, "definition");
  family.scale = non_empty(head, "scale");
  family.value = identifier(head, "value");
  family.grid = head.optional_string("grid").value_or("");
  family.shader = family.file.parent_path() / non_empty(head, "shader");
  if (!std::filesystem::is_regular_file(family.shader))
    throw head.error("shader", fmt::format("{} is no file", family.shader.string()));
  family.oracle = code.oracles.at(head.string("oracle"));
  family.tables = read_tables(head, code);
  head.check_keys();
}

void read_inputs(const TomlTable& root, Family& family) {
  const auto tables = root.tables("inputs");
  const std::vector<std::string> known = family.oracle->inputs();
  check_same_names("input", tables, known, root, "inputs");
  for (const auto& [name, table] : tables) family.inputs.push_back(read_input(name, table));
  if (family.input_names() != known)
    throw root.error("inputs", fmt::format("the oracle takes them in the order {}", fmt::join(known, ", ")));
}

void read_sets(const TomlTable& root, Family& family) {
  const auto tables = root.tables("sets");
  for (const auto& [name, table] : tables)
    if (std::ranges::find(given_sets, name) != std::end(given_sets))
      throw table.error({}, fmt::format("a set cannot be called '{}': one that a person gives is", name));
  check_same_names("set", tables, family.oracle->sets(), root, "sets");
  for (const auto& [name, table] : tables) {
    family.sets.push_back({name, non_empty(table, "what")});
    table.check_keys();
  }
}

}  // namespace

const FamilyClaim* FamilyFunction::claim(const std::string& set) const {
  for (const FamilyClaim& one : claims)
    if (one.sets.empty() || std::ranges::find(one.sets, set) != one.sets.end()) return &one;
  return nullptr;
}

std::vector<std::string> Family::input_names() const {
  std::vector<std::string> names;
  for (const FamilyInput& input : inputs) names.push_back(input.name);
  return names;
}

std::vector<std::string> Family::function_names() const {
  std::vector<std::string> names;
  for (const FamilyFunction& one : functions) names.push_back(one.name);
  return names;
}

TomlFormPtr family_form(const EffectCode& code) {
  std::vector<std::string> oracles, tables, ends;
  for (const auto& [name, made] : code.oracles) oracles.push_back(name);
  for (const auto& [name, made] : code.tables) tables.push_back(name);
  for (const auto& [name, value] : constants) ends.push_back(name);
  TomlValue tables_value = form::texts(tables);
  tables_value.what = "table";
  const TomlValue id = form::text(identifier_pattern), words = form::text("."), any = form::number(-infinity, infinity);
  const auto named = [](const char* name, const char* about, TomlFormPtr of, bool required) {
    return TomlKey{name, about, {form::table(form::make({}, TomlKey{"NAME", about, {form::table(std::move(of))}}))}, required};
  };
  const TomlFormPtr head = form::make({{"name", "the family's name", {id}, true},
                                       {"function", "the function that its variants compute", {id}, true},
                                       {"title", "what it is, for people", {words}, true},
                                       {"definition", "that the shader gets for each variant", {id}, true},
                                       {"scale", "what errors are divided by, for people", {words}, true},
                                       {"value", "what the value is called in tables", {id}, true},
                                       {"grid", "what --grid holds, for people", {form::text()}},
                                       {"shader", "the file with the functions", {words}, true},
                                       {"oracle", "C++ that knows the exact values", {form::word(oracles)}, true},
                                       {"tables", "textures that the functions read", {tables_value}}});
  const TomlFormPtr input =
      form::make({{"unit", "its unit", {words}, true},
                  {"from", "least", {any, form::word(ends, "constant")}, true},
                  {"to", "greatest", {any, form::word(ends, "constant")}, true},
                  {"open", "ends that are not in the range", {form::word({"low", "high", "both"}, "end")}}});
  const TomlFormPtr set = form::make({{"what", "what is in it, for people", {words}, true}});
  const TomlFormPtr claim =
      form::make({{"over", "greatest error at most", {form::number(0, infinity)}, true},
                  {"under", "least error at least", {form::number(-infinity, 0)}, true},
                  {"eps_kappa", "errors in units of 2^-23 times the condition number", {form::number(0, infinity)}},
                  {"sets", "on these sets; on all where it is left out", {form::texts()}}});
  const TomlFormPtr function = form::make({{"baseline", "the others' times are compared to it", {form::flag()}},
                                           {"claims", "what it errs by", {form::tables(claim)}}});
  const TomlFormPtr place = form::make({}, TomlKey{"INPUT", "where this input stands", {any}});
  const TomlFormPtr slice = form::make(
      {{"right", "the input that runs to the right", {form::text()}, true},
       {"up", "the input that runs upwards", {form::text()}, true},
       {"at", "where the other inputs stand", {form::tables(place)}},
       {"full_error", "the error that has full colour", {form::number(std::numeric_limits<double>::min(), infinity)}, true}});
  return form::make({{"family", "the family", {form::table(head)}, true},
                     named("inputs", "an input of the functions", input, true),
                     named("sets", "a set of inputs, as the oracle knows it", set, true),
                     named("functions", "a variant of the function", function, true),
                     {"slices", "pictures of errors", {form::tables(slice)}}});
}

Family load_family(const std::filesystem::path& file, const EffectCode& code) {
  const TomlTable root = TomlTable::parse(file, "family", family_form(code));
  Family family;
  family.file = file;
  if (!root.has("family")) throw root.error({}, "has no [family]");
  read_head(root.table("family"), code, family);
  read_inputs(root, family);
  read_sets(root, family);
  std::vector<std::string> sets;
  for (const FamilySet& set : family.sets) sets.push_back(set.name);
  family.functions = read_functions(root, sets);
  for (const TomlTable& table : root.array_of_tables("slices")) read_slices(table, family, family.slices);
  root.check_keys();
  return family;
}

std::vector<Family> load_families(const std::filesystem::path& shaders, const EffectCode& code) {
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(shaders))
    if (const auto file = entry.path() / "family.toml"; std::filesystem::is_regular_file(file)) files.insert(file);
  std::vector<Family> families;
  std::map<std::string, std::filesystem::path> owners;  // of "family caps", "function exact_cap", ...
  for (const std::filesystem::path& file : files) {
    const Family& family = families.emplace_back(load_family(file, code));
    std::vector<std::string> names = {"family " + family.name, "GLSL function " + family.function};
    for (const std::string& function : family.function_names()) names.push_back("function " + function);
    for (const std::string& name : names)
      if (const auto [owner, added] = owners.emplace(name, file); !added)
        throw Error(ErrorKind::bad_input, "family", file.string(),
                    fmt::format("{} is declared by {} too; give it another name", name, owner->second.string()));
  }
  return families;
}

}  // namespace lamina
