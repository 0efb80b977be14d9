// SPDX-License-Identifier: Apache-2.0
// Whether a variant is the same in two trees: byte-identical code run by one harness on one driver cannot differ, and a gate
// that times it can only raise false alarms.
#pragma once

#include <string>

#include "harness/graph/graph.h"

namespace lamina {

// A hash over the manifests of the variant and its effect, as bytes, and over the compiled shaders of its passes in order.
std::string identity_of(const VariantManifest& variant, const Graph& graph);

}  // namespace lamina
