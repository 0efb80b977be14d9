// SPDX-License-Identifier: Apache-2.0
// The share of unpolarized light that a smooth boundary of dielectrics reflects: Fresnel's equations, in the form of Cook and
// Torrance, "A Reflectance Model for Computer Graphics", SIGGRAPH 1981. eta: the index of refraction behind over that before.

// Differences of squares as products: nothing cancels but what the inputs' own digits cancel. 1 where reflection is total.
float stable_fresnel(float cosine, float eta) {
  float excess = (eta - 1.0) * (eta + 1.0), squared = excess + cosine * cosine;
  if (squared <= 0.0) return 1.0;
  float g = sqrt(squared), across = excess / ((g + cosine) * (g + cosine));
  float along = excess * (cosine * (g + cosine) - 1.0) / ((g + cosine) * (eta * eta * cosine + g));
  return 0.5 * (across * across + along * along);
}

// By the sine of the refracted angle: not a number beyond the critical angle.
float naive_fresnel(float cosine, float eta) {
  float sine = sqrt(1.0 - cosine * cosine) / eta, refracted = sqrt(1.0 - sine * sine);
  float across = (cosine - eta * refracted) / (cosine + eta * refracted);
  float along = (eta * cosine - refracted) / (eta * cosine + refracted);
  return 0.5 * (across * across + along * along);
}

// Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", Eurographics 1994.
float schlick_fresnel(float cosine, float eta) {
  float straight = (eta - 1.0) / (eta + 1.0), part = 1.0 - cosine;
  straight *= straight;
  return straight + (1.0 - straight) * part * part * part * part * part;
}

// By the function that FRESNEL names.
#ifdef FRESNEL
float fresnel(float cosine, float eta) { return FRESNEL(cosine, eta); }
#endif
