// SPDX-License-Identifier: Apache-2.0
// What each cap intersection claims to err by: the bounds that its hard cases are judged by. The figures are those of
// shaders/cap_intersection/README.md; tests/stress holds the shaders to them.
#pragma once

#include <optional>
#include <string>

#include "harness/record/function_rows.h"

namespace lamina {

// Of a function on one of make_cap_sets()'s sets, or on another's by the name given to it. Nothing where it claims nothing
// there: for what was never meant for small or large caps, and for functions that are not known here.
std::optional<FunctionBounds> cap_bounds(const std::string& variant, const std::string& set);

}  // namespace lamina
