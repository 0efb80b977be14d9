// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace lamina {

// The kinds of files that 'lamina schema' knows, and what each is of.
std::vector<std::pair<std::string, std::string>> schema_names();

}  // namespace lamina
