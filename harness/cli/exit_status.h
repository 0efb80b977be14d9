// SPDX-License-Identifier: Apache-2.0
// What the program's exit statuses mean: the manual says it with these words.
#pragma once

#include <array>
#include <utility>

namespace lamina {

inline constexpr int usage_status = 2;
inline constexpr std::array<std::pair<int, const char*>, 6> exit_statuses = {
    {{0, "All went well."},
     {1, "A cell or a gate failed, a timer could not be certified, or the API's checker complained."},
     {usage_status, "Bad input or usage."},
     {3, "A gate could not decide."},
     {4, "No usable device."},
     {130, "Ctrl-C stopped a run; what was measured until then is in its report."}}};

}  // namespace lamina
