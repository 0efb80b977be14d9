// SPDX-License-Identifier: Apache-2.0
#include "reports/gate/xml.h"

#include <cstdint>

namespace lamina {
namespace {

// Bytes of the UTF-8 sequence at the start (RFC 3629, table of section 4), or 0 where it is none that XML allows.
size_t allowed_length(std::string_view text) {
  const auto byte = [&](size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const uint32_t first = byte(0);
  const size_t length = first < 0x80 ? 1 : first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  uint32_t point = length == 1 ? first : first & (0x7fu >> length);
  for (size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
    point = point << 6 | (byte(i) & 0x3f);
  }
  constexpr uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool well_formed = first < 0x80 || (first >= 0xc0 && first < 0xf8 && point >= least[length]);
  const bool is_char = point == '\t' || point == '\n' || point == '\r' || (point >= 0x20 && point <= 0xd7ff) ||
                       (point >= 0xe000 && point <= 0xfffd) || (point >= 0x10000 && point <= 0x10ffff);
  return well_formed && is_char ? length : 0;
}

}  // namespace

std::string escaped_xml(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const size_t length = allowed_length(text);
    switch (length == 0 ? '\0' : text[0]) {
      case '\0':
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '&':
        out += "&amp;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\t':
        out += "&#9;";
        break;
      case '\n':
        out += "&#10;";
        break;
      case '\r':
        out += "&#13;";
        break;
      default:
        out += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return out;
}

}  // namespace lamina
