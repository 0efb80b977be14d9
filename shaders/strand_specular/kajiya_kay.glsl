// SPDX-License-Identifier: Apache-2.0
// Kajiya and Kay, "Rendering Fur with Three Dimensional Textures", SIGGRAPH 1989: light leaves a thin cylinder on a cone around
// it. With l and v both away from the strand the cosine to that cone is sin l sin v - (t.l)(t.v): greatest where t.v = -t.l. The
// printed sum is for the other way of the light.
//
// The power 1 / (2 ax^2) is as wide along the strand as microfacets of slope ax; the lobe is divided by what it adds up to over
// all light at a view square to the strand, 2 pi sqrt(2 pi / (p + 2.5)). A cylinder has no side of its own, so light from behind
// the card is faded out as in Scheuermann, "Hair Rendering and Shading", SIGGRAPH 2004 (sketch).
float cone_cosine(float tl, float tv) {
  return sqrt(max((1.0 - tl) * (1.0 + tl), 0.0) * max((1.0 - tv) * (1.0 + tv), 0.0)) - tl * tv;
}

float kajiya_kay(vec3 l, vec3 v, float ax, float ay) {
  float cone = cone_cosine(l.x, v.x), power = 0.5 / (ax * ax);
  float lobe = cone > 0.0 ? pow(min(cone, 1.0), power) : 0.0;
  float lit = clamp(1.75 * l.z + 0.25, 0.0, 1.0);
  return lobe * lit * sqrt(max((1.0 - l.x) * (1.0 + l.x), 0.0)) * 0.5 * sqrt((power + 2.5) / 6.2831853);
}
