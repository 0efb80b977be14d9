# SPDX-License-Identifier: Apache-2.0
# The page's style and script, and the library that its charts are drawn with: npm fetches what reports/page/package-lock.json
# pins, and C++ files hold them with the licences, so that the program needs no other file.
set(PAGE ${PROJECT_SOURCE_DIR}/reports/page)
# One script in this order: what the later files call stands in the earlier ones.
set(PAGE_SCRIPTS)
foreach(name data controls chart_frame pareto passes sweeps pixels magnifier pictures strip_plot strips samples functions)
  list(APPEND PAGE_SCRIPTS ${PAGE}/${name}.js)
endforeach()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PAGE}/package-lock.json ${PAGE}/style.css ${PAGE_SCRIPTS})

# npm leaves a copy of the lock file behind, with other text and the same time stamp.
if(NOT EXISTS ${PAGE}/node_modules/.package-lock.json OR
   ${PAGE}/package-lock.json IS_NEWER_THAN ${PAGE}/node_modules/.package-lock.json)
  find_program(NPM npm)
  if(NOT NPM)
    message(FATAL_ERROR "npm is missing, which fetches the report's chart library: install Debian's package npm, or call ./run, which does")
  endif()
  message(STATUS "Fetching the report's chart library")
  execute_process(COMMAND ${NPM} ci --prefix ${PAGE} --ignore-scripts --no-audit --no-fund --loglevel=error
    RESULT_VARIABLE failure OUTPUT_QUIET ERROR_VARIABLE words)
  if(failure)
    message(FATAL_ERROR "npm cannot fetch what ${PAGE}/package-lock.json pins; is there a network? It says: ${words}")
  endif()
  file(TOUCH ${PAGE}/node_modules/.package-lock.json)
endif()

# The text as a C++ raw string; `name` is a variable of reports/html/html.h. It goes into a <script>, which it must not end.
function(page_string name)
  set(text "")
  foreach(source ${ARGN})
    file(READ ${source} one)
    if(source MATCHES "LICENSE$")
      string(PREPEND one "/*\n")
      string(APPEND one "*/\n")
    endif()
    string(APPEND text "${one}\n")
  endforeach()
  foreach(forbidden "</script" "<!--" ")page\"")
    string(FIND "${text}" "${forbidden}" at)
    if(NOT at EQUAL -1)
      message(FATAL_ERROR "${ARGN}: holds ${forbidden}, which would end the script or the string that it is put into")
    endif()
  endforeach()
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/${name}.cpp @ONLY CONTENT [[
// SPDX-License-Identifier: Apache-2.0
#include "reports/html/html.h"
namespace lamina {
const std::string_view @name@ = R"page(@text@)page";
}
]])
endfunction()

page_string(page_library ${PAGE}/node_modules/d3/LICENSE ${PAGE}/node_modules/d3/dist/d3.min.js
  ${PAGE}/node_modules/@observablehq/plot/LICENSE ${PAGE}/node_modules/@observablehq/plot/dist/plot.umd.min.js)
page_string(page_script ${PAGE_SCRIPTS})
page_string(page_style ${PAGE}/style.css)
