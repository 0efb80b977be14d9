// SPDX-License-Identifier: Apache-2.0
// The parts of the page. Every string of a record goes through escaped_html(), picture_url() or for_script() on its way in.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/words.h"

namespace lamina {

// For element content and for attribute values in double quotes.
std::string escaped_html(std::string_view text);
// A path relative to the page as a URL that can only be relative: no scheme, no host, no query.
std::string picture_url(std::string_view path);
// JSON for a <script type="application/json">: no tag can begin in it, and what is not UTF-8 becomes U+FFFD.
std::string for_script(const nlohmann::json& data);
// <img> of a picture of the record. The page's script finds it by its path, so that a picture stands in the page once.
// width and height are left out where they are "".
std::string picture_tag(const std::string& path, const std::string& alt, const PictureUrl& url, const std::string& width = "",
                        const std::string& height = "");
std::string html_list(const std::vector<std::string>& lines);

// The sections of the page in its order; each is "" where the record has nothing for it.
std::string html_summary(const std::vector<SummaryRow>& rows);
// What a gate says in a box, and what it found. "" where the record is not a gate's.
std::string html_gate_answer(const Record& record);
std::string html_gate(const Record& record);
std::string html_passes(const Record& record);
// The pictures and figures of every backend, view and point, the baseline's and the variants' side by side.
std::string html_gallery(const Record& record, const PictureUrl& url);
// A strip plot of every round on one axis, a row each, without a script; "" where no row has a sample above 0. `words` makes
// a number of a sample, whose unit is `unit`.
struct SampleRow {
  std::string name;
  std::vector<double> samples;
};
enum class SampleAxis {
  from_zero,
  logarithmic  // from the least sample on; from_zero where not all are above 0
};
std::string html_rounds(const std::vector<SampleRow>& rows, SampleAxis axis, std::string (*words)(double), const char* unit);
// That of the frame times of these cells; "" where no times are shown.
std::string html_samples(const Record& record, const std::vector<const CellRow*>& cells);
// What a difference picture is: "difference, times 4".
std::string difference_words(const Record& record);
// For every view with a truth, what each assumption costs by itself: pictures, figures, and which costs the most.
std::string html_assumptions(const Record& record, const PictureUrl& url);
// What the frame saves that runs only what the scene calls for, a bar an effect; "" where the record does not hold it.
std::string html_saving(const Record& record);
// The passes of the frame and the targets that they write and read, what is left out too; "" in records of before.
std::string html_frame_graph(const Record& record);
// What was run and what was not: effects, failures, certificates, A/A arms, device, commit, hashes, command.
std::string html_run(const Record& record);

// What cells that show the same thing have in common; it refers to the cell.
inline auto shot_key(const CellRow& cell) {
  return std::tie(cell.effect, cell.backend, cell.scene, cell.width, cell.height, cell.params, cell.view);
}
using ShotKey = decltype(shot_key(std::declval<const CellRow&>()));
// The charts and the picture viewer of all records, which the page's script fills from page_data(); "" without cells.
std::string html_charts(const std::vector<Record>& records);
// What the page's script draws, at most six significant digits a number: reports/page/data.js says how it is laid out.
nlohmann::json page_data(const std::vector<Record>& records);
// What the records differ in, and their figures side by side.
std::string html_side_by_side(const std::vector<Record>& records);

extern const std::string_view page_style;    // reports/page/style.css,
extern const std::string_view page_library;  // D3 and Observable Plot with their licences, and
extern const std::string_view page_script;   // reports/page/*.js, put here by CMake

}  // namespace lamina
