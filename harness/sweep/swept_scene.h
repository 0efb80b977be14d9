// SPDX-License-Identifier: Apache-2.0
// A scene at every point of a sweep. It is loaded once; only another moment in time is loaded again, and keeps the textures
// that are as they were.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "harness/graph/frame.h"
#include "harness/sweep/parameters.h"
#include "harness/sweep/points.h"

namespace lamina {

class SweptScene {
 public:
  // `scene` as load_scene() left it, but for views that were taken out; `library` must outlive this. Checks every path and
  // value, and fills in units. Throws Error(bad_input).
  SweptScene(Scene scene, const Library& library, SweepPoints points);

  const Scene& scene() const { return base_; }
  const SweepPoints& points() const { return points_; }
  Scene at(size_t point);
  // Every swept path with its value, as cells name them.
  std::map<std::string, double> params(size_t point) const;
  // Of those that take words, the words.
  std::map<std::string, std::string> words_at(size_t point) const;
  // "thickness 6.2 texels", for people.
  std::string words(size_t point) const;

 private:
  const Scene& at_time(float time_s);

  const Library& library_;
  Scene base_;
  std::optional<Scene> moment_;  // the last that was loaded for its time; what was given none may be another at the same
  SweepPoints points_;
  std::vector<Parameter> parameters_;  // beside the points'
};

}  // namespace lamina
