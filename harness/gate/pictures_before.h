// SPDX-License-Identifier: Apache-2.0
// What the tree before a change has drawn, so that errors which cannot differ are not computed again.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "harness/core/image.h"

namespace lamina {

class PicturesBefore {
 public:
  struct Drawn {
    Image picture;
    Mask covered;
  };
  void add(const std::string& variant, size_t view, Image picture, Mask covered);
  // Null: there was none.
  const Drawn* of(const std::string& variant, size_t view) const;

  // Takes what the changed tree has drawn; in each view the baseline first. Returns whether the errors to the baseline are the
  // same as before: the picture, the pixels that it covers, and both of the baseline are equal to the bit.
  bool same_errors(const std::string& variant, bool baseline, size_t view, const Image& picture, const Mask& covered);

 private:
  std::map<std::pair<std::string, size_t>, Drawn> drawn_;  // by variant and view
  std::map<size_t, bool> same_baseline_;                   // by view
};

}  // namespace lamina
