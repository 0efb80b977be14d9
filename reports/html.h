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
// A dot for each round's frame time, ms, on an axis from 0 to `axis_ms`.
std::string html_strip_plot(const std::vector<double>& samples_ms, double axis_ms);

extern const std::string_view html_style;   // the content of <style>
extern const std::string_view html_script;  // the content of <script>

}  // namespace lamina
