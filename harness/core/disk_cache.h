// SPDX-License-Identifier: Apache-2.0
// Results that take long to make, kept on disk. The cache key is a hash of everything that they depend on.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lamina {

class DiskCache {
 public:
  // An empty folder keeps nothing. The folder is made when the first result is kept.
  explicit DiskCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // The result that was kept as `key` (a file name without its ending). A damaged file counts as missing, with a warning.
  std::optional<std::string> find(std::string_view key);
  // Written to another name and renamed, so that nobody reads half of it. A failed write is a warning, not an error.
  void keep(std::string_view key, std::string_view bytes);

  // Sentences for the user, since the last call.
  std::vector<std::string> take_warnings();
  std::filesystem::path file_of(std::string_view key) const;

 private:
  std::filesystem::path folder_;
  std::vector<std::string> warnings_;
};

// LAMINA_CACHE in the environment ("" keeps nothing), else lamina in XDG_CACHE_HOME, else ~/.cache/lamina; empty without a
// home.
std::filesystem::path default_cache_folder();

}  // namespace lamina
