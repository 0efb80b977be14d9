// SPDX-License-Identifier: Apache-2.0
// Text on its way into Markdown (GitHub Flavored Markdown Spec 0.29).
#pragma once

#include <fmt/format.h>

#include <string>

namespace lamina {

// Text that no Markdown or HTML in it can break out of: one line, with what has a meaning escaped, and no name after an @ that
// would be notified. Underscores stay, for inside words they mean nothing and names are full of them.
std::string escaped_markdown(const std::string& text);

// One row of a table (section 4.10), its cells escaped.
template <class Range>
std::string markdown_row(const Range& cells) {
  std::string row = "|";
  for (const auto& cell : cells) row += fmt::format(" {} |", escaped_markdown(cell));
  return row + "\n";
}

}  // namespace lamina
