// SPDX-License-Identifier: Apache-2.0
// Files that a person edits: which of them changed. By their times and sizes, asked again and again, for notices of the system
// do not reach over network file systems.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace lamina {

class WatchedFiles {
 public:
  // Files, and folders with all that lies in them.
  explicit WatchedFiles(std::vector<std::filesystem::path> places);

  // What changed, came or went since the last call, or since this was made; sorted. Where something did, waits until nothing
  // more does, since editors write in several steps.
  std::vector<std::filesystem::path> changed();

 private:
  using Stamp = std::pair<std::filesystem::file_time_type, uintmax_t>;
  std::map<std::filesystem::path, Stamp> stamps() const;

  std::vector<std::filesystem::path> places_;
  std::map<std::filesystem::path, Stamp> known_;
};

}  // namespace lamina
