// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/watched_files.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <thread>

namespace lamina {

namespace fs = std::filesystem;

WatchedFiles::WatchedFiles(std::vector<fs::path> places) : places_(std::move(places)), known_(stamps()) {}

std::map<fs::path, WatchedFiles::Stamp> WatchedFiles::stamps() const {
  std::map<fs::path, Stamp> found;
  std::error_code gone;  // a file may go while it is looked at
  const auto add = [&](const fs::path& file) {
    const fs::file_time_type time = fs::last_write_time(file, gone);
    if (!gone) found[file] = {time, fs::file_size(file, gone)};
  };
  for (const fs::path& place : places_) {
    if (!fs::is_directory(place, gone)) {
      add(place);
      continue;
    }
    for (const auto& entry : fs::recursive_directory_iterator(place, gone))
      if (entry.is_regular_file(gone)) add(entry.path());
  }
  return found;
}

std::vector<fs::path> WatchedFiles::changed() {
  std::map<fs::path, Stamp> now = stamps();
  if (now == known_) return {};
  for (std::map<fs::path, Stamp> next;; now = std::move(next)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    next = stamps();
    if (next == now) break;
  }
  std::vector<std::pair<fs::path, Stamp>> differing;
  std::set_symmetric_difference(known_.begin(), known_.end(), now.begin(), now.end(), std::back_inserter(differing));
  std::vector<fs::path> files;
  for (const auto& [file, stamp] : differing) files.push_back(file);
  files.erase(std::unique(files.begin(), files.end()), files.end());
  known_ = std::move(now);
  return files;
}

}  // namespace lamina
