// SPDX-License-Identifier: Apache-2.0
#include "harness/truth/truth.h"

#include "harness/core/error.h"
#include "harness/core/text.h"

namespace lamina {

const Image& Told::target(const std::string& name, const std::string& truth) const {
  const auto found = targets.find(name);
  if (found == targets.end())
    throw Error(
        ErrorKind::bad_input, "truth", "target '" + name + "'",
        fmt::format("is missing: the truth {} asks for it, as four floats a pixel, of passes with when = \"truth\"", truth));
  return found->second;
}

}  // namespace lamina
