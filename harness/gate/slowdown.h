// SPDX-License-Identifier: Apache-2.0
// A library in which one pass does a known amount of extra work. Calibration runs gates on it.
#pragma once

#include <cstdint>
#include <string>

#include "harness/manifest/library.h"

namespace lamina {

// `library` with `fetches` more texel fetches in each pixel that `pass` of `variant` draws: its shaders get the definition
// LAMINA_EXTRA_FETCHES, which one that can be made slower obeys (shaders/common/extra_fetches.glsl) and others ignore. The
// picture stays the same. 0 makes other code that costs as much. What the library has not stays so.
Library with_extra_fetches(Library library, const VariantManifest& variant, const std::string& pass, uint32_t fetches);

}  // namespace lamina
