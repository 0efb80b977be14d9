// SPDX-License-Identifier: Apache-2.0
// The parts of the page. Every string of a record goes through escaped_html() or picture_url() on its way in.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/words.h"

namespace lamina {

// For element content and for attribute values in double quotes.
std::string escaped_html(std::string_view text);
// A path relative to the page as a URL that can only be relative: no scheme, no host, no query.
std::string picture_url(std::string_view path);

// The pictures of every backend and view, side by side, with each cell's figures.
std::string html_gallery(const Record& record);
// Whether two cells show the same thing: one effect, backend, scene, size, parameters and view.
bool same_shot(const nlohmann::json& a, const nlohmann::json& b);
// A dot for each round's frame time, ms, on an axis from 0 to `axis_ms`.
std::string html_strip_plot(const std::vector<double>& samples_ms, double axis_ms);

// For every view with a truth, what each assumption costs by itself: pictures, figures, and which costs the most. "" where the
// record has no truth.
std::string html_assumptions(const Record& record);

extern const std::string_view chart_library;  // D3 and Observable Plot with their licences, and
extern const std::string_view chart_script;   // what draws with them: reports/page, put here by CMake
extern const std::string_view html_style;     // the content of <style>
extern const std::string_view html_script;    // the content of <script>

}  // namespace lamina
