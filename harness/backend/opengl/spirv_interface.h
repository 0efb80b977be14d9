// SPDX-License-Identifier: Apache-2.0
// What OpenGL needs to know of a SPIR-V module, and to change in it, before glShaderBinary.
// Source: SPIR-V 1.0 unified specification, section 2.3 (layout of a module), 3.20 (decorations), 3.6 (execution modes).
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string_view>
#include <vector>

namespace lamina::gl {

// The specialization ids that a module declares. OpenGL refuses an id that a module lacks.
// Throws Error(failed) about `subject` where the words are no SPIR-V.
std::set<uint32_t> specialization_ids(const std::vector<uint32_t>& spirv, std::string_view subject);

// The module with every binding replaced by units[binding] (kept where `units` lacks it), and with the origin of gl_FragCoord
// at the lower left, OpenGL's name for row 0, which is the top row of a picture here.
// Throws Error(failed) about `subject` where the words are no SPIR-V.
std::vector<uint32_t> with_units(std::vector<uint32_t> spirv, const std::map<uint32_t, uint32_t>& units,
                                 std::string_view subject);

}  // namespace lamina::gl
