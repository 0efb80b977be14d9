// SPDX-License-Identifier: Apache-2.0
// The oracles of the families of functions that scattering is made of, by the names in their family.toml.
#include "harness/effects/scattering_functions/formulas.h"
#include "harness/manifest/effect_code.h"

namespace lamina {

void add_scattering_functions(EffectCode& code);

void add_scattering_functions(EffectCode& code) {
  static const std::map<std::string, FormulaOracle> oracles = {
      {"henyey_greenstein", FormulaOracle(henyey_greenstein_formula())},
      {"cornette_shanks", FormulaOracle(cornette_shanks_formula())},
      {"rayleigh", FormulaOracle(rayleigh_formula())},
      {"transmittance", FormulaOracle(transmittance_formula())},
      {"mean_transmittance", FormulaOracle(mean_transmittance_formula())},
      {"slab_in_scatter", FormulaOracle(slab_in_scatter_formula())},
      {"fresnel", FormulaOracle(fresnel_formula())},
      {"refraction", FormulaOracle(refraction_formula())}};
  for (const auto& [name, oracle] : oracles) code.oracles[name] = &oracle;
}

}  // namespace lamina
