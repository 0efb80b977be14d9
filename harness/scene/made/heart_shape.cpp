// SPDX-License-Identifier: Apache-2.0
// See heart_shape.h.
#include "harness/scene/made/heart_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace lamina {
namespace {

float smooth_min(float a, float b, float width) {
  const float h = std::max(width - std::abs(a - b), 0.0f) / width;
  return std::min(a, b) - h * h * width * 0.25f;
}

// An ellipsoid whose cross-section narrows along its axis: by `taper` of itself at the far end.
class Egg {
 public:
  // `radii`: across, across towards `front`, along `axis`. All in metres.
  Egg(glm::vec3 center, glm::vec3 axis, glm::vec3 front, glm::vec3 radii, float taper)
      : center_(center), along_(glm::normalize(axis)), radii_(radii), taper_(taper) {
    side_ = glm::normalize(glm::cross(along_, front));
    front_ = glm::cross(side_, along_);
  }
  float distance(glm::vec3 p) const {
    const glm::vec3 q = p - center_;
    const float h = glm::dot(q, along_);
    const float narrow = std::max(1 - taper_ * h / radii_.z, 0.25f);
    const glm::vec3 radii(radii_.x * narrow, radii_.y * narrow, radii_.z);
    const glm::vec3 scaled = glm::vec3(glm::dot(q, side_), glm::dot(q, front_), h) / radii;
    const float k = glm::length(scaled);
    // Quilez's estimate k (k - 1) / |q / r^2|; at the centre, where it is 0/0, minus the smallest radius.
    const float slope = glm::length(scaled / radii);
    return slope > 1e-6f ? k * (k - 1) / slope : -std::min({radii.x, radii.y, radii.z});
  }

 private:
  glm::vec3 center_, along_, side_{}, front_{}, radii_;
  float taper_;
};

// A tube around a smooth curve through points, cut off straight at its end.
class Tube {
 public:
  struct Knot {
    glm::vec3 at;
    float radius;
  };
  explicit Tube(const std::vector<Knot>& knots) {
    const auto knot = [&](size_t i) { return knots[std::min(i, knots.size() - 1)]; };
    for (size_t k = 0; k + 1 < knots.size(); ++k) {
      const Knot before = knot(k == 0 ? 0 : k - 1), from = knot(k), to = knot(k + 1), after = knot(k + 2);
      for (size_t i = 0; i < per_span; ++i) {
        // Catmull and Rom's cubic (1974).
        const float t = static_cast<float>(i) / static_cast<float>(per_span);
        const glm::vec3 c1 = 0.5f * (to.at - before.at), c2 = before.at - 2.5f * from.at + 2.0f * to.at - 0.5f * after.at,
                        c3 = 1.5f * (from.at - to.at) + 0.5f * (after.at - before.at);
        path_.push_back({from.at + t * (c1 + t * (c2 + t * c3)), from.radius + t * (to.radius - from.radius)});
      }
    }
    path_.push_back(knots.back());
    whole_ = ball_around(0, path_.size() - 1);
    for (size_t i = 0; i + 1 < path_.size(); i += per_span) spans_.push_back(ball_around(i, i + per_span));
    for (size_t i = 0; i + 1 < path_.size(); ++i) {
      const Knot &a = path_[i], &b = path_[i + 1];
      const glm::vec3 along = b.at - a.at;
      pieces_.push_back({a.at, along, 1 / glm::dot(along, along), a.radius, b.radius - a.radius});
    }
  }

  // No greater than the distance: cheap.
  float lower_bound(glm::vec3 p) const { return glm::distance(p, whole_.at) - whole_.radius; }

  // The distance, or `farthest` where that is less.
  float distance(glm::vec3 p, float growth, float farthest) const {
    const float grown = growth * static_cast<float>(pieces_.size());
    float nearest = farthest;
    for (size_t span = 0; span < spans_.size(); ++span) {
      // Most spans are farther than the nearest so far, which a ball around them shows without a root.
      const glm::vec3 to_ball = p - spans_[span].at;
      const float bound = nearest + spans_[span].radius;
      if (bound <= 0 || glm::dot(to_ball, to_ball) >= bound * bound) continue;
      for (size_t i = span * per_span; i < (span + 1) * per_span; ++i) {
        // The last piece grows.
        const float share = grown - static_cast<float>(i);
        if (share <= 0 && i > 0) break;
        const Piece& piece = pieces_[i];
        const glm::vec3 to_p = p - piece.from;
        const float t = std::clamp(glm::dot(to_p, piece.along) * piece.inverse_square, 0.0f, std::clamp(share, 0.0f, 1.0f));
        const glm::vec3 off = to_p - t * piece.along;
        nearest = std::min(nearest, std::sqrt(glm::dot(off, off)) - (piece.radius + t * piece.widening));
      }
    }
    return nearest;
  }

  // Beyond the plane that cuts the end off, a third of a radius after the last knot. With `opening` from 0 to 1 the plane comes
  // in from outside.
  float beyond_cut(glm::vec3 p, float opening) const {
    const Knot& end = path_.back();
    return glm::dot(p - end.at, along_end()) - (0.33f + 0.9f * (1 - opening)) * end.radius;
  }
  // Depth inside the opening that shows on the cut: positive within seven tenths of the radius.
  float inside_opening(glm::vec3 p) const {
    const Knot& end = path_.back();
    const glm::vec3 from_end = p - end.at;
    const float h = glm::dot(from_end, along_end());
    return std::min(0.7f * end.radius - glm::length(from_end - h * along_end()), h - 0.15f * end.radius);
  }

 private:
  static constexpr size_t per_span = 4;  // straight pieces between knots: bends stay under 20 degrees

  glm::vec3 along_end() const { return glm::normalize(path_.back().at - path_[path_.size() - 2].at); }
  Knot ball_around(size_t first, size_t last) const {
    Knot ball{glm::vec3(0), 0};
    for (size_t i = first; i <= last; ++i) ball.at += path_[i].at / static_cast<float>(last - first + 1);
    for (size_t i = first; i <= last; ++i)
      ball.radius = std::max(ball.radius, glm::distance(path_[i].at, ball.at) + path_[i].radius);
    return ball;
  }

  struct Piece {
    glm::vec3 from, along;
    float inverse_square;  // 1 / |along|^2
    float radius, widening;
  };
  std::vector<Knot> path_;
  std::vector<Piece> pieces_;
  Knot whole_{};             // a ball around the tube
  std::vector<Knot> spans_;  // and around the pieces between two knots
};

enum class Kind : uint8_t { aorta, pulmonary, cava };
float branch_growth(float whole) { return std::clamp((whole - trunks_grown) / (branches_grown - trunks_grown), 0.0f, 1.0f); }

struct Vessel {
  Kind kind;
  bool branch;  // of the aorta: it can only grow once that is there
  Tube tube;
  // Trunks grow first, then branches, then the ends open.
  float growth(float whole) const { return branch ? branch_growth(whole) : std::min(whole / trunks_grown, 1.0f); }
};

struct Anatomy {
  glm::vec3 axis = heart_apex - heart_base;
  Egg left_ventricle{{0.25f, -0.34f, -0.10f}, {0.46f, -1.0f, 0.22f}, {0, 0, 1}, {0.54f, 0.56f, 0.84f}, 0.22f};
  Egg right_ventricle{{-0.13f, -0.24f, 0.20f}, {0.52f, -1.0f, 0.02f}, {0.15f, 0, 1}, {0.54f, 0.44f, 0.74f}, 0.24f};
  std::array<Egg, 3> atria{
      {{{-0.12f, 0.40f, -0.14f}, {1, 0, 0}, {0, 0, 1}, {0.24f, 0.24f, 0.36f}, 0.0f},  // what lies between them
       {{-0.56f, 0.26f, -0.06f}, {-0.1f, 1, 0}, {0, 0, 1}, {0.32f, 0.36f, 0.42f}, 0.10f},
       {{0.20f, 0.44f, -0.40f}, {1, 0.1f, 0}, {0, 0, 1}, {0.30f, 0.32f, 0.52f}, 0.0f}}};
  std::array<Tube, 2> auricles{
      {Tube({{{-0.54f, 0.36f, 0.00f}, 0.19f}, {{-0.43f, 0.47f, 0.25f}, 0.16f}, {{-0.25f, 0.42f, 0.38f}, 0.10f}}),
       Tube({{{0.42f, 0.46f, -0.20f}, 0.19f}, {{0.61f, 0.40f, 0.02f}, 0.17f}, {{0.52f, 0.22f, 0.27f}, 0.10f}})}};
  std::array<Vessel, 6> vessels{
      {{Kind::aorta, false,
        Tube({{{-0.06f, 0.25f, 0.06f}, 0.18f},
              {{-0.17f, 0.72f, 0.12f}, 0.185f},
              {{-0.09f, 1.10f, 0.04f}, 0.18f},
              {{0.14f, 1.31f, -0.14f}, 0.17f},
              {{0.44f, 1.30f, -0.36f}, 0.16f},
              {{0.62f, 1.10f, -0.50f}, 0.155f}})},
       {Kind::aorta, true,
        Tube({{{-0.04f, 1.17f, 0.02f}, 0.09f}, {{-0.14f, 1.48f, 0.05f}, 0.088f}, {{-0.26f, 1.66f, 0.06f}, 0.09f}})},
       {Kind::aorta, true,
        Tube({{{0.14f, 1.31f, -0.13f}, 0.075f}, {{0.14f, 1.54f, -0.12f}, 0.072f}, {{0.10f, 1.70f, -0.10f}, 0.074f}})},
       {Kind::aorta, true,
        Tube({{{0.36f, 1.31f, -0.29f}, 0.075f}, {{0.42f, 1.52f, -0.31f}, 0.073f}, {{0.52f, 1.66f, -0.30f}, 0.075f}})},
       {Kind::pulmonary, false,
        Tube({{{0.12f, 0.15f, 0.30f}, 0.19f},
              {{0.20f, 0.56f, 0.39f}, 0.19f},
              {{0.36f, 0.82f, 0.28f}, 0.18f},
              {{0.60f, 0.92f, 0.14f}, 0.16f},
              {{0.80f, 0.88f, 0.06f}, 0.15f}})},
       {Kind::cava, false,
        Tube({{{-0.56f, 0.30f, -0.08f}, 0.15f},
              {{-0.57f, 0.76f, -0.12f}, 0.145f},
              {{-0.62f, 1.06f, -0.14f}, 0.145f},
              {{-0.66f, 1.22f, -0.13f}, 0.15f}})}}};
};

const Anatomy& anatomy() {
  static const Anatomy made;
  return made;
}

// Widths of the unions in metres: soft between chambers, tight around vessels so that their necks stay.
constexpr float ventricle_blend = 0.10f, atrium_blend = 0.10f, auricle_blend = 0.10f, vessel_blend = 0.15f, cut_blend = 0.04f;

float ventricles(const Anatomy& a, glm::vec3 p) {
  return smooth_min(a.left_ventricle.distance(p), a.right_ventricle.distance(p), ventricle_blend);
}

float atria(const Anatomy& a, glm::vec3 p, float growth) {
  float d = a.atria[0].distance(p);
  d = smooth_min(d, a.atria[1].distance(p), atrium_blend);
  d = smooth_min(d, a.atria[2].distance(p), atrium_blend);
  for (const Tube& auricle : a.auricles)
    if (auricle.lower_bound(p) < d + auricle_blend && growth > trunks_grown)
      d = smooth_min(d, auricle.distance(p, branch_growth(growth), d + auricle_blend), auricle_blend);
  return d;
}

}  // namespace

float heart_distance(glm::vec3 p, float growth) {
  const Anatomy& a = anatomy();
  float d = smooth_min(ventricles(a, p), atria(a, p, growth), atrium_blend);
  const float opening = (growth - branches_grown) / (1 - branches_grown);
  for (const Vessel& vessel : a.vessels) {
    if (vessel.tube.lower_bound(p) > d + vessel_blend || vessel.growth(growth) <= 0) continue;
    float tube = vessel.tube.distance(p, vessel.growth(growth), d + vessel_blend);
    if (opening > 0) tube = -smooth_min(-tube, -vessel.tube.beyond_cut(p, opening), cut_blend);
    d = smooth_min(d, tube, vessel_blend);
  }
  return d;
}

glm::vec3 onto_heart(glm::vec3 p, float growth, int steps) {
  // Differences along a tetrahedron's corners give the gradient from four evaluations, and their mean the distance. 2 mm is
  // below every blend width and far above a float's rounding at this size.
  constexpr float step = 0.002f;
  for (int i = 0; i < steps; ++i) {
    glm::vec3 sum(0);
    float distance = 0;
    for (const glm::vec3 corner : {glm::vec3(1, -1, -1), glm::vec3(-1, -1, 1), glm::vec3(-1, 1, -1), glm::vec3(1, 1, 1)}) {
      const float d = heart_distance(p + step * corner, growth);
      sum += corner * d;
      distance += 0.25f * d;
    }
    const glm::vec3 gradient = sum / (4 * step);
    // Steps are held to 5 cm: the estimate is only first-order far from the surface.
    const glm::vec3 move = gradient * (distance / std::max(glm::dot(gradient, gradient), 0.1f));
    p -= move * std::min(1.0f, 0.05f / std::max(glm::length(move), 1e-9f));
  }
  return p;
}

float vessel_distance(glm::vec3 p, float farthest) {
  for (const Vessel& vessel : anatomy().vessels)
    if (vessel.tube.lower_bound(p) < farthest) farthest = vessel.tube.distance(p, 1, farthest);
  return farthest;
}

HeartRegions heart_regions(glm::vec3 p) {
  const Anatomy& a = anatomy();
  const float left = a.left_ventricle.distance(p), right = a.right_ventricle.distance(p);
  const float below = smooth_min(left, right, ventricle_blend), above = atria(a, p, 1);
  std::array<float, 3> kinds = {1e9f, 1e9f, 1e9f};
  HeartRegions r;
  r.lumen = -1;
  for (const Vessel& vessel : a.vessels) {
    float& nearest = kinds[static_cast<size_t>(vessel.kind)];
    nearest = vessel.tube.distance(p, 1, nearest);
    r.lumen = std::max(r.lumen, vessel.tube.inside_opening(p));
  }
  r.sulcus = left - right;
  r.base = below - above;
  r.tube = std::min(below, above) - *std::min_element(kinds.begin(), kinds.end());
  // Shares fall over 4 cm, so that colours meet softly.
  const float best = *std::min_element(kinds.begin(), kinds.end());
  std::array<float, 3> share{};
  float sum = 0;
  for (size_t i = 0; i < 3; ++i) sum += share[i] = std::exp(-(kinds[i] - best) / 0.04f);
  r.aorta = share[0] / sum;
  r.pulmonary = share[1] / sum;
  r.cava = share[2] / sum;
  return r;
}

}  // namespace lamina
