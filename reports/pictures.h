// SPDX-License-Identifier: Apache-2.0
// The picture files that a record names.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "harness/record/record.h"

namespace lamina {

// Calls `change` with the path of every picture that the record names, "" left out, to read it or to put another in its place.
// Those of a cell alone, without its assumptions', are what the page reads the pixels of.
void for_each_picture(CellRow& cell, const std::function<void(std::string& path)>& change);
void for_each_picture(Record& record, const std::function<void(std::string& path)>& change);
// The picture as a data: URL. Throws Error(bad_input, "report", ...) where it cannot be read or its path leads out of the
// folder, as the others do too.
std::string data_url(const std::filesystem::path& folder, const std::string& path);
// Writes PNG.js beside the picture, which hands its bytes to the page's lamina_pixels(). Where there is no such picture, the
// page shows its words and nothing is written.
void write_pixel_script(const std::filesystem::path& folder, const std::string& path);
// Copies the picture at the same path below `to`. Throws as data_url() does.
void copy_picture(const std::filesystem::path& from, const std::filesystem::path& to, const std::string& path);

}  // namespace lamina
