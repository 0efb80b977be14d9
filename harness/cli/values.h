// SPDX-License-Identifier: Apache-2.0
// What may stand in the place of a placeholder, as the program itself finds it: scenes, variants, paths, devices.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace lamina {

// A word that may stand there, and what it is; one that ends in '=' goes on.
struct Completion {
  std::string word, about;
};

struct Completions {
  std::vector<Completion> words;
  bool folders = false;                   // folders may stand there too
  bool files = false;                     // or files
  std::vector<std::string> file_endings;  // of these kinds, where there are some: "toml"
};

// What the command line says before, by the options' names without dashes ("scene", "variants-dir").
using Typed = std::map<std::string, std::vector<std::string>>;

// `word`: a placeholder. Nothing for what is free, a number or a text. Throws Error where a scene or a folder that was typed
// cannot be read.
Completions completions_for(std::string_view word, const Typed& typed);

}  // namespace lamina
