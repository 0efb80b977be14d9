// SPDX-License-Identifier: Apache-2.0
// Apertures: visibility as spherical caps. Oat and Sander, "Ambient Aperture Lighting" (in: Oat, "Efficient Shader Tricks That
// Will Impress Your Friends", GDC 2006, part 2): the cap has the visible area and looks along the average visible direction.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "harness/bake/visibility.h"

namespace lamina {

// xyz = unit direction, world; w = angular radius in radians, 0 (nothing is seen) to pi / 2 (the hemisphere is open).
using Aperture = glm::vec4;

// What a variant wants of every point.
struct ApertureKind {
  uint32_t count = 1;   // caps, 1 to max_apertures
  bool anti = false;    // of what is blocked, and then count is 1
  bool soft = false;    // with the width of its edge, and then count is 1
  bool choice = false;  // of what is open and of what is blocked, and which errs less; then count is 2
  auto operator<=>(const ApertureKind&) const = default;
};

// The radius of a cap of this area in steradians: arc cosine of 1 - area / 2 pi, in a form that keeps small areas.
double cap_radius(double area);

// The aperture of a point by `rays` of its directions, whose sum is `sum` in the space of Visibility::directions(). Without
// rays it has radius 0 and looks along the point's normal.
Aperture aperture_of_rays(const Visibility& visibility, size_t point, size_t rays, glm::dvec3 sum);

// One for each point. A point that sees nothing has radius 0 and looks along its normal.
std::vector<Aperture> single_apertures(const Visibility& visibility);

// The same with an edge that fades: as far as the visible directions spread beyond what a circle of their area would hold,
// whose sum is the longest that this area can have. The cap's share falls linearly in the cosine to its axis, from 1 to 0 over
// 2 w around c = cos r: the area stays, the sum of visible directions becomes pi (1 - c^2 - w^2 / 3). `edge_angle`: w / sin r,
// in radians, 0 (a circle) to 1. The direction's length is edge_length(edge_angle), so that apertures keep four floats.
double edge_angle(const Visibility& visibility, size_t rays, glm::dvec3 sum);
double edge_length(double edge_angle);
std::vector<Aperture> soft_apertures(const Visibility& visibility);

// For each point the cap of what is open, then that of what is blocked, [point * 2 + i]. The second one's direction has length
// 1 where it tells the open directions better, else min_choice_length: fewer rays, by their cosine, lie on its wrong side.
inline constexpr double min_choice_length = 1.0 / 16;
std::vector<Aperture> chosen_apertures(const Visibility& visibility);

// Visibility projected on the first four real spherical harmonics (Y00, Y1-1 ~ y, Y10 ~ z, Y11 ~ x), world axes, and the cap
// with the same first coefficient and along the next three: area = 2 sqrt(pi) c0, direction (c3, c1, c2).
using Harmonics = std::array<double, 4>;
Harmonics project_visibility(const Visibility& visibility, size_t point);
Aperture aperture_of(const Harmonics& coefficients, glm::vec3 normal);
std::vector<Aperture> harmonic_apertures(const Visibility& visibility);

// The next level of the slides: `count` (1 to 4) for each point, [point * count + i], for the contiguous regions of its visible
// directions; where there are more, those that lose the least by it are joined. Where there are fewer the rest have radius 0.
// Apertures of neighbouring points with the same i belong together, so that one may interpolate.
inline constexpr size_t max_apertures = 4;
std::vector<Aperture> region_apertures(const Visibility& visibility, const SurfacePoints& surface, size_t count);

// Anti-apertures: one for each point, the cap of its blocked directions.
std::vector<Aperture> anti_apertures(const Visibility& visibility);

}  // namespace lamina
