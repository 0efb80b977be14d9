// SPDX-License-Identifier: Apache-2.0
#include "harness/manifest/like.h"

#include <algorithm>

#include "harness/core/text.h"

namespace lamina {
namespace {

namespace fs = std::filesystem;

constexpr int max_steps = 8;

Error refuse(const fs::path& file, const toml::node& node, std::string message) {
  return {ErrorKind::bad_input, "variants", fmt::format("{}:{}", file.string(), node.source().begin.line), std::move(message)};
}

// Entries of `over` replace those of `under`; where both are tables and `deep` is above 0, their entries do.
void lay_over(toml::table& under, toml::table&& over, int deep) {
  for (auto&& [key, node] : over) {
    toml::table *mine = node.as_table(), *theirs = under[key.str()].as_table();
    if (deep > 0 && mine && theirs)
      lay_over(*theirs, std::move(*mine), deep - 1);
    else
      node.visit([&, name = key.str()](auto& value) { under.insert_or_assign(name, std::move(value)); });
  }
}

std::string text_of(const toml::table& table, std::string_view key) { return table[key].value<std::string>().value_or(""); }

toml::array::iterator pass_named(toml::array& passes, const std::string& name) {
  return std::find_if(passes.begin(), passes.end(),
                      [&](const toml::node& pass) { return pass.is_table() && text_of(*pass.as_table(), "name") == name; });
}

void lay_passes(toml::array& under, toml::array&& over, const fs::path& file) {
  for (toml::node& node : over) {
    toml::table* pass = node.as_table();
    if (!pass) continue;
    if (const auto same = pass_named(under, text_of(*pass, "name")); same != under.end()) {
      lay_over(*same->as_table(), std::move(*pass), 1);
      continue;
    }
    const std::string next = text_of(*pass, "before");
    const auto place = next.empty() ? under.end() : pass_named(under, next);
    if (!next.empty() && place == under.end())
      throw refuse(file, *(*pass)["before"].node(), fmt::format("no pass before this one is named '{}'", next));
    pass->erase("before");
    under.insert(place, std::move(*pass));
  }
}

toml::table nodes_of(const fs::path& file, int steps) {
  toml::table over = TomlTable::parse_nodes(file, "variants");
  const toml::node* like = over["variant"]["like"].node();
  if (!like) return over;
  const std::string name = like->value<std::string>().value_or("");
  const fs::path base = file.parent_path() / (name + ".toml");
  if (!fs::is_regular_file(base)) throw refuse(file, *like, fmt::format("like = \"{}\": there is no {}", name, base.string()));
  if (steps == 0) throw refuse(file, *like, "this manifest is like one that is like it");
  toml::table under = nodes_of(base, steps - 1);
  toml::array passes, mine;
  if (toml::array* all = under["pass"].as_array()) passes = std::move(*all);
  if (toml::array* all = over["pass"].as_array()) mine = std::move(*all);
  // A truth is told once, by the variant that others are like.
  for (auto pass = passes.begin(); pass != passes.end();)
    pass = pass->is_table() && text_of(*pass->as_table(), "when") == "truth" ? passes.erase(pass) : pass + 1;
  if (const toml::array* left_out = over["variant"]["leave_out"].as_array())
    for (const toml::node& entry : *left_out) {
      const auto found = pass_named(passes, entry.value<std::string>().value_or(""));
      if (found == passes.end()) throw refuse(file, entry, fmt::format("{} has no such pass", base.string()));
      passes.erase(found);
    }
  lay_passes(passes, std::move(mine), file);
  under.erase("variant");
  under.erase("pass");
  over.erase("pass");
  lay_over(under, std::move(over), 1);
  under.insert_or_assign("pass", std::move(passes));
  return under;
}

}  // namespace

TomlTable manifest_nodes(const fs::path& file, TomlFormPtr form) {
  return {nodes_of(file, max_steps), file, "variants", std::move(form)};
}

}  // namespace lamina
