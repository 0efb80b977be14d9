// SPDX-License-Identifier: Apache-2.0
// Vessels that branch over the heart's surface: trunks along given courses, from which branches grow towards points to be
// supplied. Sources: Runions et al., "Modeling and Visualization of Leaf Venation Patterns", SIGGRAPH 2005 (space colonization,
// open venation); Murray, "The Physiological Principle of Minimum Work", PNAS 1926 (the cube of a vessel's radius is the sum of
// its branches' cubes).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace lamina {

struct VesselPlan {
  std::vector<std::vector<glm::vec3>> courses;  // of the trunks, at least two points each, near the surface; metres
  std::vector<glm::vec3> supplied;              // points on the surface to be reached
  float step = 0.02f;                           // length of one piece, metres
  float supply = 0.04f;                         // a point this near to a vessel is supplied, metres
  float tip_radius = 0.005f;                    // metres
  float wander = 0.3f;                          // sideways part of a step: 0 grows straight
  uint32_t seed = 0;
};

struct VesselPiece {
  glm::vec3 from, to;
  float from_radius, to_radius;
};
std::vector<VesselPiece> grow_vessels(const VesselPlan& plan);

// Finds the vessel at a point without looking at all of them.
class VesselMap {
 public:
  // `reach` is how far beyond their walls vessels are found, metres.
  VesselMap(std::vector<VesselPiece> pieces, float reach);

  struct Hit {
    float gap = 1e9f;  // metres to the wall, negative inside; huge where no vessel is within reach
    float radius = 1;  // metres, > 0
  };
  Hit nearest(glm::vec3 p) const;

 private:
  size_t cell_of(glm::ivec3 at) const;
  std::vector<VesselPiece> pieces_;
  float reach_;
  glm::vec3 low_{0};
  glm::ivec3 cells_{0};
  std::vector<uint32_t> first_;    // of each cell's entries in `entries_`; one more than cells
  std::vector<uint32_t> entries_;  // pieces by cell
};

}  // namespace lamina
