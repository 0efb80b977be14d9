// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/mesh/texel_density.h"

#include <cmath>

#include "harness/core/error.h"

namespace lamina {

float length_in_texels(float length, const Mesh& mesh, const TextureImage& texture, const std::string& subject) {
  double texture_area = 0, surface_area = 0;  // both doubled
  for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Vertex &a = mesh.vertices[mesh.indices[i]], &b = mesh.vertices[mesh.indices[i + 1]],
                 &c = mesh.vertices[mesh.indices[i + 2]];
    const glm::dvec2 uv_1 = glm::dvec2(b.uv) - glm::dvec2(a.uv), uv_2 = glm::dvec2(c.uv) - glm::dvec2(a.uv);
    texture_area += std::abs(uv_1.x * uv_2.y - uv_2.x * uv_1.y);
    surface_area += glm::length(
        glm::cross(glm::dvec3(b.position) - glm::dvec3(a.position), glm::dvec3(c.position) - glm::dvec3(a.position)));
  }
  if (!(texture_area > 0 && surface_area > 0))
    throw Error(ErrorKind::bad_input, "scene", subject,
                "its texture coordinates cover no area, so a thickness in metres has no length in texels; unwrap the mesh");
  return static_cast<float>(length * std::sqrt(texture_area * texture.width * texture.height / surface_area));
}

}  // namespace lamina
