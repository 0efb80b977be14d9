// SPDX-License-Identifier: Apache-2.0
#include "harness/stress/cap_bounds.h"

#include <algorithm>
#include <array>

#include "harness/caps/cap_table.h"

namespace lamina {
namespace {

struct Claim {
  const char* variant;
  FunctionBounds bounds;
  bool all_radii;  // else radii up to pi/2
};

constexpr double exact_error = 32 * 0x1p-23;

const std::array<Claim, 8> claims = {{{"exact_cap", {exact_error, -exact_error, 4}, true},
                                      {"folded_fit_cap", {0.008, -0.008, {}}, true},
                                      {"lut_cap", {cap_table_error, -cap_table_error, {}}, true},
                                      {"close_fit_cap", {0.0051, -0.0051, {}}, false},
                                      {"fitted_cap", {0.008, -0.008, {}}, false},
                                      {"quick_fit_cap", {0.016, -0.016, {}}, false},
                                      {"linear_cap", {0.116, -0.058, {}}, false},
                                      {"smoothstep_cap", {0.162, -0.097, {}}, false}}};

constexpr std::array<const char*, 5> sets_up_to_hemispheres = {"overlaps", "box", "tiny", "tangent_outside", "tangent_inside"};

}  // namespace

std::optional<FunctionBounds> cap_bounds(const std::string& variant, const std::string& set) {
  const bool small = std::ranges::find(sets_up_to_hemispheres, set) != sets_up_to_hemispheres.end();
  for (const Claim& claim : claims)
    if (claim.variant == variant && (claim.all_radii || small)) return claim.bounds;
  return std::nullopt;
}

}  // namespace lamina
