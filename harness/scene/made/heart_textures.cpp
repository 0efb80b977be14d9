// SPDX-License-Identifier: Apache-2.0
// See heart_textures.h. Colours and amplitudes below are an artist's choices, by eye on the finished picture.
#include "harness/scene/made/heart_textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>

#include "harness/scene/made/heart_mesh.h"
#include "harness/scene/made/heart_rows.h"
#include "harness/scene/made/heart_shape.h"
#include "harness/scene/made/heart_vessels.h"
#include "harness/scene/made/kept.h"
#include "harness/scene/made/noise.h"
#include "harness/scene/textures.h"

namespace lamina {
namespace {

// A colour as artists write it, 0xRRGGBB in sRGB, to linear light (IEC 61966-2-1).
glm::vec3 linear(uint32_t srgb) {
  glm::vec3 color;
  for (int i = 0; i < 3; ++i) {
    const float c = static_cast<float>((srgb >> (16 - 8 * i)) & 255u) / 255;
    color[i] = c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
  }
  return color;
}

// 1 at 0, falling over `width`.
float bell(float x, float width) { return std::exp(-(x / width) * (x / width)); }

// ---- Where a texel lies on the heart ------------------------------------------------------------------------------------

struct Site {
  glm::vec3 p;  // at rest, metres
  HeartRegions r;
};

// The heart's grid with what is where at its points, read between them.
class Sites {
 public:
  explicit Sites(const HeartGrid& grid) : grid_(grid) {
    regions_.reserve(grid.points.size());
    for (const glm::vec3& p : grid.points) regions_.push_back(heart_regions(p));
  }

  // `uv` in the unit square, margins included.
  Site at(glm::vec2 uv) const {
    const glm::vec2 g = (uv - heart_margin) / (1 - 2 * heart_margin) * static_cast<float>(grid_.cells);
    const glm::vec2 cell = glm::floor(g), t = g - cell;
    const glm::ivec2 i(cell);
    Site site{glm::vec3(0), {}};
    // Catmull and Rom's cubic (1974) for the place: the normal map takes slopes of it.
    const glm::vec4 wx = cubic(t.x), wy = cubic(t.y);
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x) site.p += wx[x] * wy[y] * grid_.point(i + glm::ivec2(x - 1, y - 1));
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 2; ++x) {
        const float w = (x == 0 ? 1 - t.x : t.x) * (y == 0 ? 1 - t.y : t.y);
        const HeartRegions& r = regions_[grid_.index(grid_.fold(i + glm::ivec2(x, y)))];
        site.r.sulcus += w * r.sulcus;
        site.r.base += w * r.base;
        site.r.tube += w * r.tube;
        site.r.aorta += w * r.aorta;
        site.r.pulmonary += w * r.pulmonary;
        site.r.cava += w * r.cava;
        site.r.lumen += w * r.lumen;
      }
    return site;
  }

 private:
  static glm::vec4 cubic(float t) {
    const float t2 = t * t, t3 = t2 * t;
    return 0.5f * glm::vec4(-t + 2 * t2 - t3, 2 - 5 * t2 + 3 * t3, t + 4 * t2 - 3 * t3, t3 - t2);
  }
  const HeartGrid& grid_;
  std::vector<HeartRegions> regions_;
};

// ---- Vessels --------------------------------------------------------------------------------------------------------------

struct Networks {
  VesselMap coronary_arteries, coronary_veins, inner_arteries, inner_veins;
};

// Points of the heart itself and the roots of the great vessels, evenly enough since the grid is.
std::vector<glm::vec3> scattered(const HeartGrid& grid, size_t count, uint32_t seed) {
  Random random(seed);
  std::vector<glm::vec3> points;
  while (points.size() < count) {
    const glm::vec3 p = grid.points[random.below(static_cast<uint32_t>(grid.points.size()))];
    if (heart_regions(p).tube < 0.12f) points.push_back(p);
  }
  return points;
}

Networks make_networks() {
  const HeartGrid& grid = heart_grid();
  // Courses by anatomy: the left anterior descending artery down the groove between the ventricles, the circumflex and the
  // right coronary artery around the groove under the atria; the great and small cardiac veins beside them.
  const std::vector<std::vector<glm::vec3>> arteries = {
      {{0.36f, 0.26f, 0.34f}, {0.34f, 0.05f, 0.42f}, {0.36f, -0.35f, 0.44f}, {0.44f, -0.75f, 0.40f}, {0.52f, -1.05f, 0.28f}},
      {{0.36f, 0.24f, 0.32f}, {0.62f, 0.16f, 0.22f}, {0.78f, 0.06f, -0.15f}, {0.62f, 0.02f, -0.55f}},
      {{-0.06f, 0.36f, 0.46f},
       {-0.36f, 0.22f, 0.50f},
       {-0.62f, -0.05f, 0.30f},
       {-0.66f, -0.22f, 0.0f},
       {-0.40f, -0.30f, -0.40f}},
      {{-0.62f, -0.05f, 0.30f}, {-0.52f, -0.34f, 0.34f}, {-0.22f, -0.72f, 0.34f}, {0.14f, -0.98f, 0.24f}}};
  const std::vector<std::vector<glm::vec3>> veins = {
      {{0.70f, 0.10f, 0.10f}, {0.46f, 0.16f, 0.36f}, {0.42f, -0.05f, 0.42f}, {0.46f, -0.40f, 0.42f}, {0.55f, -0.80f, 0.34f}},
      {{0.72f, 0.02f, -0.20f}, {0.78f, -0.30f, 0.06f}, {0.70f, -0.75f, 0.16f}},
      {{-0.60f, -0.16f, 0.30f}, {-0.40f, -0.05f, 0.50f}, {-0.14f, -0.30f, 0.60f}, {0.08f, -0.62f, 0.50f}}};
  const auto plan = [&](const auto& courses, size_t tips, float supply, float tip_radius, float wander, uint32_t seed) {
    return grow_vessels({courses, scattered(grid, tips, seed), 0.022f, supply, tip_radius, wander, seed});
  };
  constexpr float reach = 0.03f;  // of the shade around a vessel
  return {VesselMap(plan(arteries, 110, 0.07f, 0.0062f, 0.35f, 11), reach),
          VesselMap(plan(veins, 70, 0.07f, 0.0066f, 0.35f, 23), reach),
          VesselMap(plan(arteries, 300, 0.04f, 0.0088f, 0.45f, 37), reach),
          VesselMap(plan(veins, 240, 0.04f, 0.0100f, 0.45f, 51), reach)};
}

const Networks& networks() {
  static const Networks made = make_networks();
  return made;
}

// ---- What the heart is made of at a site ----------------------------------------------------------------------------------

struct Tissue {
  float bundles, strands, threads;  // fibre noise from coarse to fine, about [-1, 1]
  float membrane;                   // 0 muscle .. 1 membrane
  float fat;                        // 0 .. 1, lobules of fat, mostly in the grooves
  float patches;                    // slow noise
  float tube;                       // 0 heart .. 1 great vessel
  float lumen;                      // 0 .. 1 inside a vessel's cut end
  CellSample lobule;                // where fat > 0
};

// Fibres wind around the axis from base to apex, and meet in a whorl at the apex, as a heart's do.
struct Fibres {
  static inline const glm::vec3 axis = glm::normalize(heart_apex - heart_base);
  static inline const glm::vec3 side = glm::normalize(glm::cross(axis, glm::vec3(0, 0, 1)));
  static inline const glm::vec3 front = glm::cross(side, axis);

  explicit Fibres(glm::vec3 p) {
    const glm::vec3 from_base = p - heart_base;
    along = glm::dot(from_base, axis);
    const float x = glm::dot(from_base, side), z = glm::dot(from_base, front);
    across = std::sqrt(x * x + z * z + 1e-6f);
    const float wind = 0.9f * along + 0.25f * gradient_noise(p * 1.7f, 3);
    const float c = std::cos(wind), n = std::sin(wind);
    // On a cylinder of the ventricles' mean radius, so that bundles keep their width but at the apex.
    ring = glm::vec2(c * x - n * z, n * x + c * z) * (0.5f / across);
  }
  // Noise stretched along the fibres; bumps a metre around the heart and along it.
  float noise(float around_hz, float along_hz, uint32_t seed) const {
    return gradient_noise(glm::vec3(ring * around_hz, along * along_hz), seed);
  }

  float along, across;  // metres from the base and from the axis
  glm::vec2 ring;
};

Tissue tissue_at(const Site& s) {
  Tissue t{};
  t.tube = glm::smoothstep(-0.03f, 0.05f, s.r.tube);
  t.lumen = t.tube * glm::smoothstep(-0.01f, 0.02f, s.r.lumen);
  t.patches = fractal_noise(s.p * 2.3f, 4, 17);
  const float groove = std::max(bell(s.r.base, 0.09f), s.r.base < 0 ? 0.85f * bell(s.r.sulcus, 0.11f) : 0.0f);
  const float root = bell(s.r.tube - 0.01f, 0.05f);
  t.fat = (1 - glm::smoothstep(0.03f, 0.10f, s.r.tube)) *
          glm::smoothstep(0.45f, 1.0f, std::max(groove, 0.85f * root) + 0.9f * t.patches);
  if (t.fat > 0) {
    const glm::vec3 q = s.p * 9.0f;
    const glm::vec3 warp(gradient_noise(q, 31), gradient_noise(q, 32), gradient_noise(q, 33));
    t.lobule = cell_noise(s.p * 21.0f + 0.8f * warp, 29);
  }
  if (t.tube == 1) return t;

  const Fibres fibres(s.p);
  t.bundles = fibres.noise(13, 1.8f, 5);
  t.strands = fibres.noise(34, 3.6f, 6) * glm::smoothstep(0.03f, 0.15f, fibres.across);
  t.threads = fibres.noise(85, 8.0f, 7) * glm::smoothstep(0.08f, 0.30f, fibres.across);
  // Windows stretch along the fibres.
  const float windows = fibres.noise(4.0f, 1.3f, 19) + 0.55f * fibres.noise(9.0f, 2.4f, 20) + 0.4f * t.patches;
  t.membrane =
      (1 - t.tube) * glm::smoothstep(-0.22f, 0.20f, windows + 0.25f * groove + 0.12f * glm::smoothstep(0.0f, 0.12f, s.r.base));
  return t;
}

// Coronary vessels fade into the great vessels' walls.
float bare(const Site& s) { return 1 - glm::smoothstep(0.06f, 0.20f, s.r.tube); }

// Height of the outer surface over the mesh, metres.
float relief(const Site& s, const Tissue& t, const VesselMap::Hit& artery, const VesselMap::Hit& vein) {
  const float muscle = (1 - t.tube) * (1 - t.membrane) * (1 - t.fat);
  float height = muscle * (0.0120f * t.bundles + 0.0062f * t.strands + 0.0022f * t.threads);
  // Membrane lies lower, taut over strands, and wrinkles.
  if (t.membrane > 0)
    height += t.membrane * (1 - t.fat) * (-0.006f + 0.0030f * t.strands + 0.0075f * fractal_noise(s.p * 10.0f, 3, 41));
  height += t.fat * 0.008f * (1 - t.lobule.nearest * t.lobule.nearest);
  if (t.tube > 0) height += t.tube * (1 - t.lumen) * 0.0045f * fractal_noise(s.p * 14.0f, 3, 43);
  for (const VesselMap::Hit& hit : {artery, vein}) {
    const float d = std::max(1 + hit.gap / hit.radius, 0.0f);  // 0 on the axis, 1 at the wall
    height += bare(s) * 0.75f * hit.radius * (1 - glm::smoothstep(0.0f, 1.6f, d));
  }
  return height;
}

glm::vec4 outer_color(const Site& s, const Tissue& t, const VesselMap::Hit& artery, const VesselMap::Hit& vein) {
  static const glm::vec3 deep = linear(0x5c1416), red = linear(0x9c2f29), pale = linear(0xc4685a), film = linear(0xd79a8c),
                         yellow = linear(0xe3b36b), cream = linear(0xefd9b4), aorta = linear(0xd79c86),
                         trunk = linear(0xb08a94), cava = linear(0x7d6e93), hollow = linear(0x3a0b10),
                         arterial = linear(0xb3201c), venous = linear(0x4a4878);
  const float mottle = t.patches;
  glm::vec3 color = glm::mix(deep, red, glm::smoothstep(-0.7f, 0.5f, t.bundles + 0.5f * t.strands + 0.5f * mottle));
  color = glm::mix(color, pale, 0.55f * glm::smoothstep(0.15f, 0.9f, t.strands + 0.6f * t.threads + 0.2f * t.bundles));
  float clear = 0.04f;

  // Membrane: a clear film with whitish strands stretched across it.
  const float strand = glm::smoothstep(0.18f, 0.55f, t.strands + 0.35f * t.threads);
  color = glm::mix(color, glm::mix(film, cream, 0.5f * strand), t.membrane);
  clear = glm::mix(clear, 0.96f - 0.50f * strand, t.membrane);

  const glm::vec3 lobule = glm::mix(yellow, cream, t.lobule.shade) *
                           (0.78f + 0.22f * glm::smoothstep(0.0f, 0.45f, t.lobule.second - t.lobule.nearest));
  color = glm::mix(color, lobule, 0.9f * t.fat);
  clear = glm::mix(clear, 0.34f, t.fat);

  if (t.tube > 0) {
    const glm::vec3 wall = (s.r.aorta * aorta + s.r.pulmonary * trunk + s.r.cava * cava) *
                           (0.92f + 0.35f * mottle + 0.16f * gradient_noise(s.p * 30.0f, 67));
    color = glm::mix(glm::mix(color, wall, t.tube), hollow, t.lumen);
    clear = glm::mix(glm::mix(clear, 0.16f + 0.12f * mottle, t.tube), 0.0f, t.lumen);
  }

  // Coronary vessels lie on top, in a shade of their own.
  const auto lay = [&](const VesselMap::Hit& hit, glm::vec3 blood) {
    const float shade = bare(s) * (1 - glm::smoothstep(0.0f, 0.022f, hit.gap));
    color *= 1 - 0.45f * shade;
    clear *= 1 - 0.5f * shade;
    const float inside = bare(s) * (1 - glm::smoothstep(-0.002f, 0.003f, hit.gap));
    const float middle = glm::smoothstep(0.0f, 1.0f, -hit.gap / hit.radius);
    color = glm::mix(color, blood * (0.65f + 0.75f * middle), 0.92f * inside);
    clear = glm::mix(clear, 0.05f, inside);
  };
  lay(vein, venous);
  lay(artery, arterial);
  return {glm::clamp(color, 0.0f, 1.0f), std::clamp(clear, 0.0f, 1.0f)};
}

glm::vec4 inner_color(const Site& s) {
  static const glm::vec3 dark = linear(0x34080c), flesh = linear(0x7a1c1a), warm = linear(0xb8523c),
                         arterial = linear(0xf03020), venous = linear(0x4463d0);
  const float cloud = fractal_noise(s.p * 4.0f, 4, 71), grain = fractal_noise(s.p * 26.0f, 2, 73);
  glm::vec3 color = glm::mix(dark, flesh, glm::smoothstep(-0.45f, 0.45f, cloud + 0.35f * grain));
  color = glm::mix(color, warm, 0.5f * glm::smoothstep(0.15f, 0.6f, fractal_noise(s.p * 2.6f, 2, 79) + 0.2f * grain));
  const auto lay = [&](const VesselMap::Hit& hit, glm::vec3 blood) {
    color *= 1 - 0.4f * (1 - glm::smoothstep(0.0f, 0.016f, hit.gap));
    const float middle = glm::smoothstep(0.0f, 1.0f, -hit.gap / hit.radius);
    color = glm::mix(color, blood * (0.6f + 0.5f * middle), 1 - glm::smoothstep(-0.003f, 0.003f, hit.gap));
  };
  lay(networks().inner_veins.nearest(s.p), venous);
  lay(networks().inner_arteries.nearest(s.p), arterial);
  return {glm::clamp(color, 0.0f, 1.0f), 1.0f};
}

// ---- Texels -----------------------------------------------------------------------------------------------------------------

// Slopes of the relief against the surface itself, in the frame of LayeredMaterial's normal map.
Texels normals_of(const std::vector<glm::vec3>& place, const std::vector<float>& height, uint32_t size) {
  Texels normals{size, size, std::vector<glm::vec4>(place.size())};
  each_row(size, [&](uint32_t y) {
    for (uint32_t x = 0; x < size; ++x) {
      const auto index = [size](uint32_t i, uint32_t j) { return static_cast<size_t>(j) * size + i; };
      const size_t left = index(x == 0 ? 0 : x - 1, y), right = index(std::min(x + 1, size - 1), y);
      const size_t above = index(x, y == 0 ? 0 : y - 1), below = index(x, std::min(y + 1, size - 1));
      const glm::vec3 along_u = place[right] - place[left], along_v = place[below] - place[above];
      const float rise_u = height[right] - height[left], rise_v = height[below] - height[above];
      const float u_length = std::max(glm::length(along_u), 1e-6f);
      const glm::vec3 tangent = along_u / u_length, rest = along_v - tangent * glm::dot(along_v, tangent);
      const float slope_u = rise_u / u_length;
      const float slope_v = (rise_v - slope_u * glm::dot(along_v, tangent)) / std::max(glm::length(rest), 1e-6f);
      // Slopes are held to 2 (63 degrees): what is steeper than that shades as noise.
      const glm::vec3 n = glm::normalize(glm::vec3(glm::clamp(glm::vec2(-slope_u, -slope_v), -2.0f, 2.0f), 1));
      normals.rgba[index(x, y)] = glm::vec4(n * 0.5f + 0.5f, 1);
    }
  });
  return normals;
}

// Outer albedo, outer normal, inner albedo.
std::vector<std::shared_ptr<const TextureImage>> make_textures(uint32_t size) {
  const Sites sites(heart_grid());
  const Networks& vessels = networks();
  const size_t count = static_cast<size_t>(size) * size;
  Texels outer{size, size, std::vector<glm::vec4>(count)}, inner{size, size, std::vector<glm::vec4>(count)};
  std::vector<glm::vec3> place(count);
  std::vector<float> height(count);
  each_row(size, [&](uint32_t y) {
    for (uint32_t x = 0; x < size; ++x) {
      const size_t i = static_cast<size_t>(y) * size + x;
      const Site site = sites.at((glm::vec2(x, y) + 0.5f) / static_cast<float>(size));
      const Tissue tissue = tissue_at(site);
      const VesselMap::Hit artery = vessels.coronary_arteries.nearest(site.p), vein = vessels.coronary_veins.nearest(site.p);
      place[i] = site.p;
      height[i] = relief(site, tissue, artery, vein);
      outer.rgba[i] = outer_color(site, tissue, artery, vein);
      inner.rgba[i] = inner_color(site);
    }
  });
  return {make_texture("heart outer albedo", outer, TexelMeaning::colour),
          make_texture("heart outer normal", normals_of(place, height, size), TexelMeaning::normal),
          make_texture("heart inner albedo", inner, TexelMeaning::colour)};
}

}  // namespace

HeartTextures heart_textures(uint32_t size) {
  static std::mutex lock;
  static std::map<uint32_t, HeartTextures> made;
  const std::scoped_lock held(lock);
  auto found = made.find(size);
  if (found == made.end()) {
    const auto textures = kept_textures(fmt::format("heart_{}", size), [&] { return make_textures(size); });
    found = made.emplace(size, HeartTextures{textures[0], textures[1], textures[2]}).first;
  }
  return found->second;
}

}  // namespace lamina
