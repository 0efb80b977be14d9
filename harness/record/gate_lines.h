// SPDX-License-Identifier: Apache-2.0
// Lines of the record about a gate. One of kind "gate" is its answer and comes last, so a gate that died has none; one of kind
// "aa" is an arm measured against itself; one of kind "verdict" is what a figure of a cell came to. Each check throws
// Error(bad_input, "record", where, ...) for a field that is missing, of the wrong type, or a word that is none of those known.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace lamina {

void check_gate(const nlohmann::json& line, const std::string& where);
void check_aa(const nlohmann::json& line, const std::string& where);
void check_verdict(const nlohmann::json& line, const std::string& where);
// Of kind "pairs": the samples that verdicts on times are made of.
void check_pairs(const nlohmann::json& line, const std::string& where);

}  // namespace lamina
