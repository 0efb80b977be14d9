// SPDX-License-Identifier: Apache-2.0
#include "reports/markdown.h"

#include <string_view>

#include "reports/words.h"

namespace lamina {

std::string escaped_markdown(const std::string& text) {
  std::string out;
  for (const char c : one_line(text)) {
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '@')
      out += "@<!-- -->";
    else if (std::string_view("\\`*|[]#~").find(c) != std::string_view::npos)
      out += std::string("\\") + c;
    else
      out += c;
  }
  return out;
}

}  // namespace lamina
