// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/aperture_keys.h"

#include "harness/core/text.h"
#include "harness/scene/toml_values.h"

namespace lamina {

ApertureBake read_aperture(const TomlTable& table, ApertureBake bake) {
  expect_keys(table, {"baker", "map_texels", "rays", "seed", "bias"});
  if (table.has("baker")) {
    static const std::vector<std::string> bakers = {"rays", "spherical_harmonics"};
    const std::string baker = table.string("baker");
    if (baker != bakers[0] && baker != bakers[1]) throw table.error("baker", unknown_name("baker", baker, bakers));
    bake.baker = baker == bakers[0] ? ApertureBake::Baker::rays : ApertureBake::Baker::spherical_harmonics;
  }
  if (const auto texels = whole_number(table, "map_texels", 0, 4096)) {
    if (*texels > 0 && *texels < 8)
      throw table.error("map_texels", "'map_texels' must be 0 (a point is a vertex) or from 8 to 4096");
    bake.map_texels = static_cast<uint32_t>(*texels);
  }
  if (const auto rays = whole_number(table, "rays", 16, 65536)) bake.rays = static_cast<uint32_t>(*rays);
  // As far as every whole number is a double.
  if (const auto seed = whole_number(table, "seed", 0, 9007199254740992)) bake.seed = static_cast<uint64_t>(*seed);
  if (const auto bias = table.optional_number("bias", 0, 1e6)) {
    if (!(static_cast<float>(*bias) > 0))
      throw table.error("bias", "'bias' must be above 0 metres; leave it out for the usual one");
    bake.bias_m = static_cast<float>(*bias);
  }
  return bake;
}

}  // namespace lamina
