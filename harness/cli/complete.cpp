// SPDX-License-Identifier: Apache-2.0
// lamina complete: what may stand at the end of a command line. The scripts of packaging/completions call it for bash, zsh and
// fish, so that what they offer is what the program parses. A line each: the word, and after a tab what it is; ":folders", or
// ":files" with the endings of their names, where the shell itself knows them.
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "harness/cli/commands.h"
#include "harness/cli/values.h"
#include "harness/core/error.h"

namespace lamina {
namespace {

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }
bool takes_many(const CLI::Option& option) { return option.get_expected_max() > 1; }
bool is_shown(const CLI::App& command) { return !command.get_group().empty(); }

// Where the words before the last one lead: which command, and whose value comes next.
class Position {
 public:
  explicit Position(const CLI::App& program) : command_(&program) {}

  void pass(const std::string& word) {
    if (const size_t equals = word.find('='); word.starts_with("--") && equals != std::string::npos) {
      if (const CLI::Option* option = command_->get_option_no_throw(word.substr(0, equals)))
        typed_[option->get_single_name()].push_back(word.substr(equals + 1));
      option_ = nullptr;
    } else if (word.starts_with('-')) {
      option_ = command_->get_option_no_throw(word);
      if (option_ && !takes_value(*option_)) option_ = nullptr;
      has_one_ = false;
    } else if (option_) {
      typed_[option_->get_single_name()].push_back(word);
      has_one_ = true;
      if (!takes_many(*option_)) option_ = nullptr;
    } else if (const auto next = command_->get_subcommands([&](const CLI::App* one) { return one->get_name() == word; });
               !next.empty()) {
      command_ = next.front();
    } else if (const CLI::Option* next_one = positional()) {
      typed_[next_one->get_single_name()].push_back(word);
    }
  }

  const CLI::App& command() const { return *command_; }
  const Typed& typed() const { return typed_; }
  // The option whose value is to come, if it must come.
  const CLI::Option* wanted() const { return has_one_ ? nullptr : option_; }
  const CLI::Option* possible() const { return option_ ? option_ : positional(); }

 private:
  const CLI::Option* positional() const {
    for (const CLI::Option* option : command_->get_options())
      if (!option->nonpositional() && (takes_many(*option) || !typed_.contains(option->get_single_name()))) return option;
    return nullptr;
  }

  const CLI::App* command_;
  const CLI::Option* option_ = nullptr;
  bool has_one_ = false;
  Typed typed_;
};

void print_one(const std::string& word, const std::string& about, const std::string& begun) {
  if (word.starts_with(begun)) fmt::print("{}\t{}\n", word, about);
}

void print_values(const CLI::Option& option, const Typed& typed, const std::string& begun, const std::string& before = "") {
  const Completions all = completions_for(option.get_type_name(), typed);
  for (const Completion& one : all.words) print_one(before + one.word, one.about, begun);
  if (all.folders) fmt::print(":folders\n");
  if (all.files) fmt::print(":files {}\n", fmt::join(all.file_endings, " "));
}

void print_options(const CLI::App& command, const std::string& begun) {
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) print_one("--" + name, option->get_description(), begun);
}

void complete(const CLI::App& program, const std::vector<std::string>& words) {
  Position position(program);
  for (size_t i = 0; i + 1 < words.size(); ++i) position.pass(words[i]);
  const std::string last = words.empty() ? "" : words.back();
  const CLI::App& command = position.command();
  if (position.wanted()) return print_values(*position.wanted(), position.typed(), last);
  if (const size_t equals = last.find('='); last.starts_with("--") && equals != std::string::npos) {
    const CLI::Option* option = command.get_option_no_throw(last.substr(0, equals));
    if (option && takes_value(*option)) print_values(*option, position.typed(), last, last.substr(0, equals + 1));
    return;
  }
  if (last.starts_with('-')) return print_options(command, last);
  for (const CLI::App* next : command.get_subcommands([](const CLI::App* one) { return is_shown(*one); }))
    print_one(next->get_name(), next->get_description(), last);
  if (position.possible()) print_values(*position.possible(), position.typed(), last);
  if (last.empty()) print_options(command, last);
}

}  // namespace

Command add_complete(CLI::App& program) {
  auto words = std::make_shared<std::vector<std::string>>();
  CLI::App& command = *program.add_subcommand("complete", "Prints what may stand at the end of a command line, for shells");
  command.group("");  // not shown: nobody types it
  command.add_option("words", *words, "The words after 'lamina', the last one as far as it is typed");
  return {&command, [=, &program](const std::string&) {
            try {
              complete(program, *words);
            } catch (const Error&) {  // a scene that cannot be read has no paths: nothing is offered
            }
            return 0;
          }};
}

}  // namespace lamina
