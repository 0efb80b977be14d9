// SPDX-License-Identifier: Apache-2.0
// Whether a fragment shader's depth test comes before it, and whether it discards.
#pragma once

#include <span>

#include "harness/shader/spirv_module.h"

namespace lamina {

// Whether a fragment shader says itself that its tests come first: `layout(early_fragment_tests) in`.
bool demands_early_tests(const SpirvModule& module);

// Whether depth and stencil tests before the shader leave its picture and its writes as they are after it, so that drivers test
// early: it neither discards, nor writes depth, stencil or its sample mask, nor writes memory, which hidden fragments would do
// too.
bool allows_early_tests(const SpirvModule& module);

// Whether some function of the shader, called or not, discards fragments.
bool may_discard(std::span<const uint32_t> spirv);

}  // namespace lamina
