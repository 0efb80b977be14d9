// SPDX-License-Identifier: Apache-2.0
// The C++ of caps: the oracle of their family of functions, and the table that lut_cap reads.
#include "harness/effects/cap_intersection/cap_area.h"
#include "harness/effects/cap_intersection/cap_sets.h"
#include "harness/effects/cap_intersection/cap_table.h"
#include "harness/manifest/effect_code.h"
#include "harness/stress/oracle.h"

namespace lamina {
namespace {

// The double form, which tests/effects holds to 400 bits.
class CapOracle : public Oracle {
 public:
  std::vector<std::string> inputs() const override { return {"r0", "r1", "d"}; }
  std::string refusal(Point p) const override {
    return are_caps(p[0], p[1], p[2]) ? "" : "radii must lie above 0 and up to pi, the distance from 0 to pi (radians)";
  }
  double value(Point p) const override { return cap_intersection_area(p[0], p[1], p[2]); }
  double condition(Point p, double value) const override { return cap_intersection_condition(p[0], p[1], p[2], value); }
  double scale(Point p) const override { return smaller_cap_area(p[0], p[1]); }
  std::vector<std::string> sets() const override { return cap_set_names(); }
  Points points(const std::string& set, size_t count, uint64_t seed) const override {
    return make_cap_points(set, count, seed);
  }
};

}  // namespace

void add_cap_intersection(EffectCode& code);

void add_cap_intersection(EffectCode& code) {
  static const CapOracle oracle;
  code.oracles["cap_intersection"] = &oracle;
  code.tables["cap_table"] = [] { return make_cap_table(); };
}

}  // namespace lamina
