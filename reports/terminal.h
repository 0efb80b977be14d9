// SPDX-License-Identifier: Apache-2.0
// Lines and aligned columns for a terminal.
#pragma once

#include <string>
#include <vector>

namespace lamina::terminal {

// ECMA-48 "select graphic rendition".
inline constexpr const char *bold = "\x1b[1m", *dim = "\x1b[2m", *red = "\x1b[31m", *green = "\x1b[32m", *yellow = "\x1b[33m",
                            *reset = "\x1b[0m";

// Lines, emphasized only where `colour` says that the terminal shows it.
class Lines {
 public:
  explicit Lines(bool colour) : colour_(colour) {}
  void add(const std::string& text, const char* emphasis = "");
  std::string take() { return std::move(text_); }

 private:
  bool colour_;
  std::string text_;
};

using Cells = std::vector<std::string>;

// Columns that UTF-8 text takes: its code points. Wide and combining characters are not looked for.
size_t columns_of(const std::string& text);
// The widest cell of each column. Every row has as many cells as the first.
std::vector<size_t> column_widths(const std::vector<Cells>& table);
// The cells beside each other, two spaces between, without spaces at the end; `figures[i]` puts column i to the right.
std::string aligned(const Cells& cells, const std::vector<size_t>& widths, const std::vector<bool>& figures);

}  // namespace lamina::terminal
