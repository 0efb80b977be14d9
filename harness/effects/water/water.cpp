// SPDX-License-Identifier: Apache-2.0
// The C++ of water: variants/water/effect.toml names its truth; shaders read its tables; families name its oracles.
#include "harness/effects/water/caustic_table.h"
#include "harness/effects/water/water_oracles.h"
#include "harness/effects/water/water_rays.h"
#include "harness/manifest/effect_code.h"

namespace lamina {

void add_water(EffectCode& code);

void add_water(EffectCode& code) {
  static const std::map<std::string, FormulaOracle> oracles = {{"gerstner", FormulaOracle(gerstner_formula())},
                                                               {"wave_phase", FormulaOracle(wave_phase_formula())},
                                                               {"water_in_scatter", FormulaOracle(water_in_scatter_formula())},
                                                               {"water_extinction", FormulaOracle(water_extinction_formula())},
                                                               {"rgbm8", FormulaOracle(rgbm8_formula())},
                                                               {"refraction_way", FormulaOracle(refraction_way_formula())}};
  for (const auto& [name, oracle] : oracles) code.oracles[name] = &oracle;
  code.tables["caustic_table"] = make_caustic_table;
  code.tables["foam_table"] = make_foam_table;
  code.tables["ripple_table"] = make_ripple_table;
  code.truths["water_rays"] = water_rays;
}

}  // namespace lamina
