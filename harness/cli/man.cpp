// SPDX-License-Identifier: Apache-2.0
// lamina man: the manual, made of the options and the lists that the program itself works with. Pages are for man(7) of groff.
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "commit.h"
#include "harness/backend/backend.h"
#include "harness/cli/commands.h"
#include "harness/cli/common.h"
#include "harness/cli/exit_status.h"
#include "harness/core/text.h"
#include "harness/stress/family.h"
#include "harness/sweep/parameters.h"

namespace lamina {
namespace {

// Text that roff takes as it stands.
std::string roff(std::string_view text) {
  std::string out;
  for (size_t i = 0; i < text.size(); ++i) {
    const bool begins_line = i == 0 || text[i - 1] == '\n';
    if (begins_line && (text[i] == '.' || text[i] == '\'')) out += "\\&";
    if (text[i] == '-')
      out += "\\-";
    else if (text[i] == '\\')
      out += "\\e";
    else
      out += text[i];
  }
  return out;
}

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + roff(text) + "\\fR"; }
std::string section(std::string_view name) { return fmt::format(".SH {}\n", name); }
std::string entry(const std::string& what, std::string_view about) { return fmt::format(".TP\n{}\n{}\n", what, roff(about)); }

std::string head(const std::string& name, const std::string& about) {
  const std::string date = std::string(LAMINA_COMMIT_DATE).substr(0, 10);
  return fmt::format(".TH {} 1 \"{}\" \"lamina {}\" \"User Commands\"\n{}{} \\- {}\n", roff(name), date, LAMINA_VERSION,
                     section("NAME"), roff(name), roff(about));
}

std::string statuses() {
  std::string text = section("EXIT STATUS");
  for (const auto& [status, meaning] : exit_statuses) text += entry(bold(std::to_string(status)), meaning);
  return text;
}

// CLI11 joins an option's type and what its values are checked against: "UINT:INT in [0 - 65536]".
std::pair<std::string, std::string> type_of(const CLI::Option& option) {
  const std::string both = option.get_type_name();
  const size_t colon = both.find(':');
  if (colon == std::string::npos) return {both, ""};
  const size_t open = both.find('[', colon), close = both.find(']', colon);
  const std::string type = both.substr(0, colon);
  if (open == std::string::npos || close == std::string::npos) return {type, ""};
  return {type == "FLOAT" || type == "UINT" || type == "INT" ? "NUMBER" : type, both.substr(open + 1, close - open - 1)};
}

// "--backend BACKEND"
std::string name_of(const CLI::Option& option) {
  if (!option.nonpositional()) return italic(option.get_name(true));
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back(bold("-" + name));
  for (const std::string& name : option.get_lnames()) names.push_back(bold("--" + name));
  std::string text = fmt::format("{}", fmt::join(names, ", "));
  if (option.get_items_expected_max() > 0) text += " " + italic(type_of(option).first);
  return text;
}

std::string options_of(const CLI::App& command, bool positional) {
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    if (option->nonpositional() == positional) continue;
    std::string about = option->get_description();
    if (const std::string range = type_of(*option).second; !range.empty()) about += fmt::format(", in {}", range);
    if (!option->get_default_str().empty()) about += fmt::format(" (default: {})", option->get_default_str());
    text += entry(name_of(*option), about + ".");
  }
  return text;
}

std::vector<const CLI::App*> shown_commands(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

std::string paths_section() {
  const SceneOptions options;
  const Library library = load_library_for(options);
  std::string text =
      section("PATHS") + roff(fmt::format("Of the built-in scene {}; 'lamina list SCENE --parameters' prints those of "
                                          "another, with their values.\n",
                                          options.scene));
  for (const Parameter& parameter : parameters_of(load_scene_for(options, library), library))
    text += entry(bold(parameter.path),
                  fmt::format("{}{}from {:g} to {:g} {}", parameter.title, parameter.title.empty() ? "" : ", ", parameter.min,
                              parameter.max, parameter.unit));
  return text;
}

std::string page_of(const CLI::App& command) {
  const std::string name = "lamina-" + command.get_name();
  std::string text = head(name, command.get_description());
  text += section("SYNOPSIS") + bold("lamina " + command.get_name());
  for (const CLI::Option* option : command.get_options())
    if (!option->nonpositional())
      text += option->get_required() ? " " + italic(option->get_name(true)) : " [" + italic(option->get_name(true)) + "]";
  text += " [" + italic("OPTIONS") + "]\n";
  text += section("DESCRIPTION") + roff(command.get_description()) + ".\n";
  if (const std::string arguments = options_of(command, true); !arguments.empty()) text += section("ARGUMENTS") + arguments;
  text += section("OPTIONS") + options_of(command, false);
  if (command.get_option_no_throw("--set")) text += paths_section();
  return text + statuses() + section("SEE ALSO") + bold("lamina") + "(1)\n";
}

std::string lists() {
  std::string text = section("SCENES") + "Built in, besides scene files and glTF models:\n";
  text += roff(fmt::format("{}.\n", fmt::join(builtin_scenes(), ", ")));
  text += section("EFFECTS AND VARIANTS");
  for (const EffectManifest& effect : load_library_for({}).effects) {
    text += entry(bold(effect.name), effect.title + ".");
    text += ".RS\n";
    for (const VariantManifest& variant : effect.variants)
      text += entry(bold(variant.name), fmt::format("{}{}", variant.baseline ? "baseline: " : "", variant.title));
    text += ".RE\n";
  }
  text += section("FUNCTIONS");
  for (const Family& family : load_families(home_folder() / "shaders", effect_code()))
    text += entry(bold(family.name), fmt::format("{}: {}", family.title, fmt::join(family.function_names(), ", ")));
  text += section("BACKENDS") +
          roff(fmt::format("{}. 'lamina list' prints the devices of each.\n", fmt::join(backend_names(), ", ")));
  return text;
}

std::string page_of_program(const CLI::App& program) {
  std::string text = head("lamina", "measures what real-time translucency techniques cost and lose");
  text += section("SYNOPSIS") + bold("lamina") + " " + italic("COMMAND") + " [" + italic("OPTIONS") + "]\n";
  text += section("DESCRIPTION") + roff(program.get_description()) + "\n" + section("COMMANDS");
  std::string others;
  for (const CLI::App* command : shown_commands(program)) {
    text += entry(bold(command->get_name()), command->get_description() + ".");
    others += fmt::format("{}{}(1)", others.empty() ? "" : ", ", bold("lamina-" + command->get_name()));
  }
  text += section("OPTIONS") + options_of(program, false) + lists() + section("ENVIRONMENT");
  text += entry(bold("LAMINA_HOME"), "Folder with variants/ and shaders/, in place of those that lie beside the program.");
  text += entry(bold("LAMINA_CACHE"),
                "Folder that keeps bakes, truths and what built-in scenes are made of, in place of lamina in the user's cache; "
                "empty: nothing is kept.");
  text += entry(bold("LP_NUM_THREADS"),
                "Threads of Mesa's rasterizers on the CPU; a run sets it to one for each core where it is not set.");
  return text + statuses() + section("SEE ALSO") + others + "\n";
}

std::string page_named(const CLI::App& program, const std::string& name) {
  if (name.empty()) return page_of_program(program);
  std::vector<std::string> known;
  for (const CLI::App* command : shown_commands(program)) {
    if (command->get_name() == name) return page_of(*command);
    known.push_back(command->get_name());
  }
  throw Error(ErrorKind::bad_input, "man", name, unknown_name("command", name, known));
}

void write_pages(const CLI::App& program, const std::filesystem::path& out) {
  make_folder("man", out);
  write_file_atomically(out / "lamina.1", page_of_program(program));
  for (const CLI::App* command : shown_commands(program))
    write_file_atomically(out / fmt::format("lamina-{}.1", command->get_name()), page_of(*command));
}

}  // namespace

Command add_man(CLI::App& program) {
  struct Options {
    std::string command;
    std::filesystem::path out;
  };
  auto options = std::make_shared<Options>();
  CLI::App& command =
      *program.add_subcommand("man", "Prints the manual of the program, or of a command: lamina man compare | man -l -");
  command.add_option("command", options->command, "Command")->type_name(placeholder::command);
  command.add_option("--out", options->out, "Folder for all pages, instead of printing one")->type_name(placeholder::directory);
  return {&command, [=, &program](const std::string&) {
            if (options->out.empty())
              fmt::print("{}", page_named(program, options->command));
            else
              write_pages(program, options->out);
            return 0;
          }};
}

}  // namespace lamina
