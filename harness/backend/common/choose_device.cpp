// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/common/choose_device.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace lamina {
namespace {

bool contains_ignoring_case(std::string_view text, std::string_view part) {
  const auto same = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
  return std::search(text.begin(), text.end(), part.begin(), part.end(), same) != text.end();
}

std::string names_of(std::span<const DeviceInfo> devices, std::span<const size_t> which) {
  std::string names;
  for (const size_t i : which) names += fmt::format("{}{}: {}", names.empty() ? "" : ", ", i, devices[i].device);
  return names;
}

}  // namespace

size_t choose_device(std::string_view backend, std::span<const DeviceInfo> devices, std::string_view wanted) {
  if (wanted.empty()) {
    const auto software = std::ranges::find_if(devices, &DeviceInfo::software);
    return software == devices.end() ? 0 : static_cast<size_t>(software - devices.begin());
  }
  size_t index = 0;
  const char* end = wanted.data() + wanted.size();
  const auto parsed = std::from_chars(wanted.data(), end, index);
  if (parsed.ec == std::errc() && parsed.ptr == end && index < devices.size()) return index;
  std::vector<size_t> all, named, whole;
  for (size_t i = 0; i < devices.size(); ++i) {
    all.push_back(i);
    if (contains_ignoring_case(devices[i].device, wanted)) named.push_back(i);
    if (devices[i].device == wanted) whole.push_back(i);
  }
  if (named.size() == 1) return named.front();
  if (whole.size() == 1) return whole.front();  // the name of one may be part of another's
  if (!named.empty())
    throw Error(ErrorKind::bad_input, std::string(backend), std::string(wanted),
                fmt::format("{} devices have this in their names ({}); give more of one's name, or its number", named.size(),
                            names_of(devices, named)));
  throw Error(ErrorKind::no_device, std::string(backend), std::string(wanted),
              fmt::format("no device has this index or this in its name; there is {}", names_of(devices, all)));
}

}  // namespace lamina
