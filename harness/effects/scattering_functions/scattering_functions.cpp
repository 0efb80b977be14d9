// SPDX-License-Identifier: Apache-2.0
// The oracles of the families of functions that scattering is made of, by the names in their family.toml.
#include "harness/effects/scattering_functions/exact_function.h"
#include "harness/manifest/effect_code.h"

namespace lamina {

void add_scattering_functions(EffectCode& code);

void add_scattering_functions(EffectCode& code) {
  static const std::map<std::string, ExactOracle> oracles = {{"henyey_greenstein", ExactOracle(henyey_greenstein_function())},
                                                             {"cornette_shanks", ExactOracle(cornette_shanks_function())},
                                                             {"rayleigh", ExactOracle(rayleigh_function())},
                                                             {"transmittance", ExactOracle(transmittance_function())},
                                                             {"mean_transmittance", ExactOracle(mean_transmittance_function())},
                                                             {"slab_in_scatter", ExactOracle(slab_in_scatter_function())},
                                                             {"fresnel", ExactOracle(fresnel_function())}};
  for (const auto& [name, oracle] : oracles) code.oracles[name] = &oracle;
}

}  // namespace lamina
