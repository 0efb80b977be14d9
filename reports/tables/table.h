// SPDX-License-Identifier: Apache-2.0
// A table as data, and how it is written as HTML, as Markdown and for a terminal. Its strings are plain text, which is escaped
// on its way out.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <vector>

namespace lamina {

enum class Mark : uint8_t { none, baseline, good, doubtful, bad };

struct Column {
  std::string heading;
  bool right = false;           // aligned to the right in Markdown and in a terminal
  const char* html_class = "";  // of its cells; its heading is "num" where they are
  bool whole = false;           // in HTML a cell breaks before its brackets and nowhere else
  size_t min_width = 0;         // in a terminal
};
inline Column words_column(std::string heading, const char* html_class = "") { return {std::move(heading), false, html_class}; }
inline Column number_column(std::string heading) { return {std::move(heading), true, "num"}; }
// Means with their worst, medians with their intervals.
inline Column figures_column(std::string heading) { return {std::move(heading), true, "num", true}; }

struct Cell {
  template <std::convertible_to<std::string> Words>
  Cell(Words&& words, const char* of_class = nullptr) : text(std::forward<Words>(words)), html_class(of_class) {}
  std::string text;
  const char* html_class;          // in place of its column's; null for most
  std::vector<std::string> items;  // after the text: a list in HTML, with commas between in Markdown
  std::string html;                // markup in place of the text; "" for most
};

struct Row {
  std::vector<Cell> cells;  // the first names the row; where there are fewer than columns, the last takes the rest
  Mark mark = Mark::none;   // in HTML baseline and bad show
  std::string note;         // under the row in a terminal
  Mark note_mark = Mark::none;
  std::string group, group_words;  // what rows of a group share: its name and its heading
};
Row row_of(const std::vector<std::string>& cells, Mark mark = Mark::none);

struct Table {
  std::string caption;  // "" for none
  std::vector<Column> columns;
  std::vector<Row> rows;
  std::string label;            // of its region in HTML, which scrolls; "": the caption's words
  const char* html_class = "";  // of the table
  std::string grouped_by;       // heading of the rows' groups, which follow each other; "": they have none
};

// No line end after it. Without a label and a caption there is no region around it; without headings there is no head. A group
// begins with a row that holds its heading.
std::string html_table(const Table& table);
// The caption as a paragraph where there is one, behind `before_caption`, as "## "; then the rows. A group's name is a column
// before the others.
std::string markdown_table(const Table& table, const char* before_caption = "");
// The rows alone, a line each; the first element is the head's two lines.
std::vector<std::string> markdown_lines(const Table& table);
// `colour`: with ANSI emphasis by the rows' marks. Control characters become spaces. Without headings there is no head.
std::string terminal_table(const Table& table, bool colour);

}  // namespace lamina
