// SPDX-License-Identifier: Apache-2.0
// Verdicts on what does not depend on the machine's mood: counts, pictures and errors of one cell before and after a change.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "harness/core/image.h"
#include "harness/gate/limits.h"
#include "harness/gate/verdict.h"

namespace lamina {

// What is seen of a picture beyond its errors.
struct PictureFacts {
  double range = 0;  // greatest less least value over all pixels, of the channel where it is most; linear light
  std::optional<double> most_change;  // greatest difference from the picture before, linear light; absent where unknown
};
// Throws Error(failed) for pictures of two sizes. `before` may be null.
PictureFacts picture_facts(const Image& picture, const Image* before);

// One variant on one backend: the cells of all its views, in one order before and after, as read from a record or made by
// to_json(). Null: there is none. `facts` is beside `after`, or empty where pictures are unknown.
struct CellPair {
  std::vector<nlohmann::json> before, after;
  std::vector<PictureFacts> facts;
  // One machine and driver drew both: then a hash that changed is a picture that changed, however little.
  bool hashes_tell = false;
};

// A row for each kind of figure that is the same in all views, and one for each view, pass and texture where it is not.
std::vector<VerdictRow> judge_cells(const CellPair& pair, const Limits& limits);

}  // namespace lamina
