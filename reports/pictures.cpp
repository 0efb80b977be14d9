// SPDX-License-Identifier: Apache-2.0
// Pictures beside the page, copied, or inside it.
#include "reports/pictures.h"

#include <fmt/format.h>

#include "harness/core/error.h"
#include "harness/core/text.h"

namespace lamina {
namespace {

// Base 64 (Josefsson, "The Base16, Base32, and Base64 Data Encodings", RFC 4648, 2006, section 4).
std::string base64(const std::string& bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t three = 0;
    for (size_t k = 0; k < 3; ++k) three = three << 8 | (i + k < bytes.size() ? static_cast<uint8_t>(bytes[i + k]) : 0u);
    for (size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? digits[three >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

// A record is only text: its paths must not lead out of the run's folder.
bool stays_inside(const std::string& path) {
  const auto normal = std::filesystem::path(path).lexically_normal();
  return !normal.is_absolute() && !normal.empty() && *normal.begin() != "..";
}

void refuse_outside(const std::string& path) {
  if (!stays_inside(path))
    throw Error(ErrorKind::bad_input, "report", path, "leads out of the run's folder; mend the record's line that names it");
}

}  // namespace

void for_each_picture(CellRow& cell, const std::function<void(std::string& path)>& change) {
  for (std::string* path : {&cell.image, &cell.difference, &cell.flip, &cell.truth_image, &cell.before_image})
    if (!path->empty()) change(*path);
}

void for_each_picture(Record& record, const std::function<void(std::string& path)>& change) {
  for (CellRow& cell : record.cells) {
    for_each_picture(cell, change);
    for (AssumptionRow& assumption : cell.assumptions)
      if (!assumption.image.empty()) change(assumption.image);
  }
  for (FunctionPictureRow& picture : record.function_pictures)
    if (!picture.image.empty()) change(picture.image);
}

std::string data_url(const std::filesystem::path& folder, const std::string& path) {
  refuse_outside(path);
  return "data:image/png;base64," + base64(read_file(folder / path, "report"));
}

void write_pixel_script(const std::filesystem::path& folder, const std::string& path) {
  refuse_outside(path);
  if (!std::filesystem::is_regular_file(folder / path)) return;
  write_file_atomically(folder / (path + ".js"),
                        fmt::format("lamina_pixels({}, \"{}\")\n", nlohmann::json(path).dump(), data_url(folder, path)));
}

void copy_picture(const std::filesystem::path& from, const std::filesystem::path& to, const std::string& path) {
  refuse_outside(path);
  std::filesystem::create_directories((to / path).parent_path());
  write_file_atomically(to / path, read_file(from / path, "report"));
}

}  // namespace lamina
