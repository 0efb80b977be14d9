// SPDX-License-Identifier: Apache-2.0
// lamina schema: JSON Schemas of the files that Lamina reads and writes, made of the declarations that it checks them by.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <functional>
#include <nlohmann/json.hpp>

#include "harness/backend/backend.h"
#include "harness/cli/commands.h"
#include "harness/cli/common.h"
#include "harness/cli/form_schema.h"
#include "harness/plan/configuration_file.h"
#include "harness/cli/schemas.h"
#include "harness/core/text.h"
#include "harness/gate/limits.h"
#include "harness/record/record.h"
#include "harness/scene/scene_file.h"
#include "harness/stress/family.h"

namespace lamina {
namespace {

using Schema = nlohmann::ordered_json;

// What a gate file may name of everything that there is; a gate itself takes what its scene calls for.
GateNames all_names(const Library& library) {
  GateNames names;
  for (const EffectManifest& effect : library.effects) {
    names.effects.push_back(effect.name);
    for (const VariantManifest& variant : effect.variants) names.variants.push_back(variant.name);
  }
  for (const std::string_view backend : backend_names()) names.backends.emplace_back(backend);
  return names;
}

struct SchemaKind {
  const char *name, *of;
  Schema (*make)(const Library& library);
};
const std::array<SchemaKind, 6> kinds_of_schemas = {
    {{"scene", "a scene file", [](const Library& library) { return schema_of_form(*scene_form(library)); }},
     {"manifest", "a variant's manifest", [](const Library&) { return schema_of_form(*variant_form()); }},
     {"effect", "an effect.toml", [](const Library& library) { return schema_of_form(*effect_form(*library.code)); }},
     {"family", "a family.toml", [](const Library& library) { return schema_of_form(*family_form(*library.code)); }},
     {"configuration", "a configuration file", [](const Library&) { return schema_of_form(*configuration_form()); }},
     {"gate", "a gate file", [](const Library& library) { return schema_of_form(*limits_form(all_names(library))); }},
     {"record", "a line of record.jsonl", [](const Library&) { return record_line_schema(); }}}};

std::string text_of(const SchemaKind& kind, const Library& library) {
  Schema schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                   {"title", fmt::format("Lamina {}: {}", LAMINA_VERSION, kind.of)}};
  schema.update(kind.make(library));
  return schema.dump(1) + "\n";
}

struct SchemaOptions : SceneOptions {
  std::string kind;
  std::filesystem::path out;  // empty: one is printed
};

int run_schema(const SchemaOptions& options) {
  const Library library = load_library_for(options);
  if (options.out.empty()) {
    std::vector<std::string> known;
    for (const SchemaKind& kind : kinds_of_schemas) {
      known.emplace_back(kind.name);
      if (options.kind == kind.name) return fmt::print("{}", text_of(kind, library)), 0;
    }
    throw Error(ErrorKind::bad_input, "schema", options.kind, unknown_name("kind of file", options.kind, known));
  }
  make_folder("schema", options.out);
  for (const SchemaKind& kind : kinds_of_schemas)
    write_file_atomically(options.out / fmt::format("{}.schema.json", kind.name), text_of(kind, library));
  return 0;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> schema_names() {
  std::vector<std::pair<std::string, std::string>> names;
  for (const SchemaKind& kind : kinds_of_schemas) names.emplace_back(kind.name, kind.of);
  return names;
}

Command add_schema(CLI::App& program) {
  auto options = std::make_shared<SchemaOptions>();
  CLI::App& command = *program.add_subcommand("schema", "Prints the JSON Schema of a kind of file, for editors and scripts");
  command.add_option("kind", options->kind, "scene, manifest, effect, family, gate or record")->type_name(placeholder::schema);
  command.add_option("--out", options->out, "Folder for all of them, instead of printing one")
      ->type_name(placeholder::directory);
  add_variants_dir(command, *options);
  return {&command, [=](const std::string&) { return run_schema(*options); }};
}

}  // namespace lamina
