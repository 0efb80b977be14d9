// SPDX-License-Identifier: Apache-2.0
// Lines and tables for a terminal.
#pragma once

#include <string>
#include <string_view>

#include "reports/tables/table.h"

namespace lamina::terminal {

// ECMA-48 "select graphic rendition".
inline constexpr const char *bold = "\x1b[1m", *dim = "\x1b[2m", *red = "\x1b[31m", *green = "\x1b[32m", *yellow = "\x1b[33m",
                            *reset = "\x1b[0m";

// Lines, emphasized only where `colour` says that the terminal shows it.
class Lines {
 public:
  explicit Lines(bool colour) : colour_(colour) {}
  void add(const std::string& text, const char* emphasis = "");
  // As terminal_table(), its rows behind `indent`.
  void add(const Table& table, std::string_view indent = "");
  std::string take() { return std::move(text_); }

 private:
  bool colour_;
  std::string text_;
};

}  // namespace lamina::terminal
