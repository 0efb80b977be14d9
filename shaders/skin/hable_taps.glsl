// SPDX-License-Identifier: Apache-2.0
// Hable's thirteen taps ("Uncharted 2: Character Lighting and Shading", SIGGRAPH 2010 course): weights in each channel, and
// places in millimetres. Green and blue spread nearly as far as red: more than the profile says.
const vec3 hable_weights[13] = vec3[13](
    vec3(0.220441, 0.437000, 0.635000), vec3(0.076356, 0.064487, 0.039097), vec3(0.116515, 0.103222, 0.064912),
    vec3(0.064844, 0.086388, 0.062272), vec3(0.131798, 0.151695, 0.103676), vec3(0.025690, 0.042728, 0.033003),
    vec3(0.048593, 0.064740, 0.046131), vec3(0.048092, 0.003042, 0.000400), vec3(0.048845, 0.005406, 0.001222),
    vec3(0.051322, 0.006034, 0.001420), vec3(0.061428, 0.009152, 0.002511), vec3(0.030936, 0.002868, 0.000652),
    vec3(0.073580, 0.023239, 0.009703));
const vec2 hable_places[13] = vec2[13](
    vec2(0.000000, 0.000000), vec2(1.633992, 0.036795), vec2(0.177801, 1.717593), vec2(-0.194906, 0.091094),
    vec2(-0.239737, -0.220217), vec2(-0.003530, -0.118219), vec2(1.320107, -0.181542), vec2(5.970690, 0.253378),
    vec2(-1.089250, 4.958349), vec2(-4.015465, 4.156699), vec2(-4.063099, -4.110150), vec2(-0.638605, -6.297663),
    vec2(2.542348, -3.245901));
