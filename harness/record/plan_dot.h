// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "harness/record/plan_row.h"

namespace lamina {

// The frame of the plan as a graph in the DOT language (graphviz.org/doc/info/lang.html): a box for each pass in order, with
// why it runs and what it reads of the scene; an ellipse for each target, once, with arrows from the passes that write it and
// to those that read it; grey and dashed what is left out, with the reason. `scene`: the graph's name. Equal rows give equal
// bytes.
std::string plan_dot(const PlanRow& plan, const std::string& scene);

}  // namespace lamina
