// SPDX-License-Identifier: Apache-2.0
// Text on its way into Markdown (GitHub Flavored Markdown Spec 0.29).
#pragma once

#include <string>

namespace lamina {

// Text that no Markdown or HTML in it can break out of: one line, with what has a meaning escaped, and no name after an @ that
// would be notified. Underscores stay, for inside words they mean nothing and names are full of them.
std::string escaped_markdown(const std::string& text);

}  // namespace lamina
