// SPDX-License-Identifier: Apache-2.0
// Everything that marching a ray takes.
#include "air.glsl"
#include "phase.glsl"
#ifdef TRANSMITTANCE_TABLE_BINDING
#include "transmittance_table.glsl"
#else
#include "sun_path.glsl"
#endif
#include "march.glsl"
