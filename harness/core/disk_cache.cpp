// SPDX-License-Identifier: Apache-2.0
#include "harness/core/disk_cache.h"

#include <cstdlib>
#include <utility>

#include "harness/core/error.h"
#include "harness/core/text.h"

namespace lamina {
namespace {

// The first line of a file: what it is, and the hash of the rest.
std::string first_line(std::string_view bytes) { return fmt::format("lamina cache 1 {}\n", hash_hex(bytes)); }

}  // namespace

std::filesystem::path DiskCache::file_of(std::string_view key) const { return folder_ / (std::string(key) + ".cache"); }

std::optional<std::string> DiskCache::find(std::string_view key) {
  if (folder_.empty() || !std::filesystem::exists(file_of(key))) return std::nullopt;
  try {
    std::string text = read_file(file_of(key), "cache");
    const size_t line = text.find('\n');
    if (line != std::string::npos) {
      const std::string bytes = text.substr(line + 1);
      if (text.compare(0, line + 1, first_line(bytes)) == 0) return bytes;
    }
    warnings_.push_back(fmt::format("{} is damaged; it is made again", file_of(key).string()));
  } catch (const Error& error) {
    warnings_.push_back(fmt::format("{}; it is made again", error.what()));
  }
  return std::nullopt;
}

void DiskCache::keep(std::string_view key, std::string_view bytes) {
  if (folder_.empty()) return;
  try {
    std::filesystem::create_directories(folder_);
    write_file_atomically(file_of(key), first_line(bytes) + std::string(bytes));
  } catch (const std::exception& error) {
    warnings_.push_back(fmt::format("what was computed is not kept for the next run: {}", error.what()));
  }
}

std::vector<std::string> DiskCache::take_warnings() { return std::exchange(warnings_, {}); }

std::filesystem::path default_cache_folder() {
  if (const char* own = std::getenv("LAMINA_CACHE")) return own;
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache) return std::filesystem::path(cache) / "lamina";
  if (const char* home = std::getenv("HOME"); home && *home) return std::filesystem::path(home) / ".cache" / "lamina";
  return {};
}

}  // namespace lamina
