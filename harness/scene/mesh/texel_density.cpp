// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/mesh/texel_density.h"

#include <cmath>

#include "harness/core/error.h"
#include "harness/scene/mesh/triangle_areas.h"

namespace lamina {

float length_in_texels(float length, const Mesh& mesh, const TextureImage& texture, const std::string& subject) {
  double texture_area = 0, surface_area = 0;  // both doubled
  for (size_t triangle = 0; triangle < mesh.indices.size() / 3; ++triangle) {
    const TriangleAreas areas = doubled_areas(mesh, triangle);
    texture_area += areas.unwrapped, surface_area += areas.surface;
  }
  if (!(texture_area > 0 && surface_area > 0))
    throw Error(ErrorKind::bad_input, "scene", subject,
                "its texture coordinates cover no area, so a thickness in metres has no length in texels; unwrap the mesh");
  return static_cast<float>(length * std::sqrt(texture_area * texture.width * texture.height / surface_area));
}

}  // namespace lamina
