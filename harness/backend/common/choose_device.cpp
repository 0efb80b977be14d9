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

}  // namespace

size_t choose_device(std::string_view backend, std::span<const DeviceInfo> devices, std::string_view wanted) {
  const auto meant = std::ranges::find_if(devices, [&](const DeviceInfo& device) {
    return wanted.empty() ? device.software : contains_ignoring_case(device.device, wanted);
  });
  size_t index = 0;
  const char* end = wanted.data() + wanted.size();
  const auto parsed = std::from_chars(wanted.data(), end, index);
  if (!wanted.empty() && parsed.ec == std::errc() && parsed.ptr == end && index < devices.size()) return index;
  if (meant != devices.end()) return static_cast<size_t>(meant - devices.begin());
  if (wanted.empty()) return 0;
  std::string names;
  for (size_t i = 0; i < devices.size(); ++i) names += fmt::format("{}{}: {}", i > 0 ? ", " : "", i, devices[i].device);
  throw Error(ErrorKind::no_device, std::string(backend), std::string(wanted),
              fmt::format("no device has this index or this in its name; there is {}", names));
}

}  // namespace lamina
