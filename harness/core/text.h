// SPDX-License-Identifier: Apache-2.0
// Small helpers on names and files.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lamina {

// The candidate nearest to `name` by edit distance (Levenshtein 1966), or "" where none is within half of name's length.
std::string nearest_name(std::string_view name, std::span<const std::string> candidates);

// "unknown key 'tickness' (did you mean 'thickness'?)": the words every unknown name is reported in. `what` is "key",
// "variant", ... With no near candidate, all of them are listed.
std::string unknown_name(std::string_view what, std::string_view name, std::span<const std::string> candidates);

// Whole file as bytes. Throws Error(bad_input) of `stage` when it is missing or unreadable.
std::string read_file(const std::filesystem::path& path, std::string_view stage);

// Writes to another name and renames it over the target, so that a reader never sees half a file. Throws Error(failed).
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

// The double that is written as shortly as this float: 10.24, not 10.239999771118164.
double decimal(float value);

// 16 hex digits of XXH3-64 of the bytes.
std::string hash_hex(std::string_view bytes);

}  // namespace lamina
