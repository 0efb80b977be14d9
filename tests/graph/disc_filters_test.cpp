// SPDX-License-Identifier: Apache-2.0
// The filters that take the place of the 13 taps, alone: what they make of a constant, of one bright texel, and of waves,
// against the disc's and the taps' own responses.
#include <complex>

#include "tests/graph/made_effects.h"

namespace lamina {
namespace {

constexpr int probe_side = 128;
constexpr double shift_u = 0.0281, shift_v = -0.0966;  // the mean of listing 2's 13 points, in radii

class DiscFilters : public MadeEffects {
 protected:
  void SetUp() override {
    MadeEffects::SetUp();
    if (!backend_) return;
    write_effect("probe", "key = \"probe\"", "[textures.picture]\nrgb = \"probe.picture\"\nvalue = [1, 1, 1]\n");
    write("probe/probe.frag", R"(#include "common/frame.glsl"
#include "common/surface.glsl"
#include "common/mesh_in.glsl"
#include "layered_material/poisson_disc.glsl"
#include "layered_material/footprints.glsl"
#include "layered_material/one_fetch.glsl"
#include "layered_material/ring_disc.glsl"
#include "layered_material/golden_disc.glsl"
#include "layered_material/merged_disc.glsl"
layout(constant_id = 0) const float radius = 0.0;
layout(binding = 4) uniform sampler2D picture;
layout(location = 0) out vec4 out_color;
void main() {
  vec2 texel = 1.0 / vec2(textureSize(picture, 0));
  Footprint one_texel = Footprint(vec2(texel.x, 0.0), vec2(0.0, texel.y));
  out_color = vec4(FILTER(picture, gl_FragCoord.xy * texel, radius * texel, one_texel).rgb, 1.0);
}
)");
    bool first = true;
    for (const char* filter : filters) {
      write_variant("probe", filter,
                    "[parameters.radius]\nvalue = 0\nmin = 0\nmax = 100\n" +
                        objects_pass("probe.frag", std::string("define = { FILTER = \"") + filter + "\" }\n"),
                    first);
      first = false;
    }
    library_ = made();
  }

  Image filtered(const char* filter, double radius, const std::function<glm::vec4(uint32_t, uint32_t)>& texel) {
    Object object = square("probe", 0, {"probe"});
    object.effects["probe"].textures["picture"] = make_texture("picture", filled(probe_side, texel), TexelMeaning::colour);
    const Scene scene = squares({object});
    return DrawnFrame(*backend_, library_, scene,
                      {.variant = library_.effect("probe").variant(filter),
                       .width = probe_side,
                       .height = probe_side,
                       .parameters = {{std::string(filter) + ".radius", radius}},
                       .aspect = 1})
        .picture();
  }

  // What the filter makes of a wave of `cycles` over the picture, along u or v: its amplitude and phase against the wave's own.
  std::complex<double> response(const char* filter, double radius, int cycles, bool along_v) {
    const double step = 2 * M_PI * cycles / probe_side;
    const Image image = filtered(filter, radius, [&](uint32_t x, uint32_t y) {
      return glm::vec4(0.5 + 0.5 * std::cos(step * ((along_v ? y : x) + 0.5)), 0, 0, 1);
    });
    std::complex<double> sum = 0;
    for (int y = 0; y < probe_side; ++y)
      for (int x = 0; x < probe_side; ++x)
        sum += double(pixel(image, x, y).r) * std::polar(1.0, -step * ((along_v ? y : x) + 0.5));
    return sum * 4.0 / double(probe_side * probe_side);
  }

  static constexpr const char* filters[] = {"poisson_disc", "golden_disc",    "ring_disc",
                                            "merged_disc",  "one_fetch_disc", "one_fetch_thirteen"};
  Library library_;
};
INSTANTIATE_TEST_SUITE_P(Backends, DiscFilters, backend_parameters, backend_test_name);

// The numbers are odd in binary, so that a mean that is summed first and divided last would round.
TEST_P(DiscFilters, AConstantComesBackToTheBit) {
  const auto constant = [](uint32_t, uint32_t) { return glm::vec4(0.3f, 0.7f, 0.9f, 1); };
  const Image plain = filtered("one_fetch_disc", 0, constant);
  for (const char* filter : filters)
    for (const double radius : {0.3, 3.0, 17.0, 60.0})
      EXPECT_EQ(filtered(filter, radius, constant).rgba, plain.rgba) << filter << radius;
}

TEST_P(DiscFilters, RadiusZeroIsTheTexelToTheBit) {
  const auto noise = [](uint32_t x, uint32_t y) { return glm::vec4(float((x * 37 + y * 101) % 128) / 127, 0, 0, 1); };
  const Image plain = filtered("poisson_disc", 0, noise);
  EXPECT_NEAR(pixel(plain, 5, 9).r, 70.0 / 127, 0.01);
  for (const char* filter : filters) EXPECT_EQ(filtered(filter, 0, noise).rgba, plain.rgba) << filter;
}

TEST_P(DiscFilters, OneBrightTexelKeepsItsLight) {
  for (const char* filter : filters)
    for (const double radius : {2.0, 8.0}) {
      const Image image =
          filtered(filter, radius, [](uint32_t x, uint32_t y) { return glm::vec4(x == 60 && y == 66 ? 1 : 0); });
      double sum = 0;
      for (size_t i = 0; i < image.rgba.size(); i += 4) sum += image.rgba[i];
      // Mip levels are stored in 8 bits of sRGB, and bilinear filters of a rasterizer have 8 bits of weight.
      EXPECT_NEAR(sum, 1, 0.04) << filter << " " << radius;
    }
}

// A wave a quarter of whose length is the radius: a disc leaves 2 J1(pi/2) / (pi/2) = 0.7217 of it, where it is.
TEST_P(DiscFilters, DiscsLeaveOfAWaveWhatADiscLeaves) {
  const double left = 2 * std::cyl_bessel_j(1.0, M_PI / 2) / (M_PI / 2);
  for (const bool along_v : {false, true}) {
    for (const char* filter : {"golden_disc", "ring_disc", "one_fetch_disc"}) {
      const std::complex<double> found = response(filter, 8, 4, along_v);
      EXPECT_NEAR(std::abs(found), left, 0.025) << filter << along_v;
      EXPECT_NEAR(std::arg(found), 0, 0.05) << filter << along_v;
    }
    EXPECT_GT(std::abs(std::abs(response("poisson_disc", 8, 4, along_v)) - left), 0.03) << "the 13 taps are no disc";
  }
}

// The imitations leave what the 13 taps leave, and shift as they do.
TEST_P(DiscFilters, ImitationsShiftAndBlurAsThe13TapsDo) {
  for (const bool along_v : {false, true}) {
    const std::complex<double> taps = response("poisson_disc", 8, 4, along_v);
    // A wave filtered by taps whose mean lies at +s is the wave moved by -s.
    EXPECT_NEAR(std::arg(taps), M_PI / 2 * (along_v ? shift_v : shift_u), 0.06) << along_v;
    for (const char* filter : {"merged_disc", "one_fetch_thirteen"}) {
      const std::complex<double> found = response(filter, 8, 4, along_v);
      EXPECT_NEAR(std::arg(found), std::arg(taps), 0.05) << filter << along_v;
      EXPECT_NEAR(std::abs(found), std::abs(taps), 0.06) << filter << along_v;
    }
  }
}

// Two cycles a radius are finer than any disc shows (0.025); taps without footprints let them through again.
TEST_P(DiscFilters, FootprintsKeepFineDetailFromAliasing) {
  for (const char* filter : {"ring_disc", "one_fetch_disc", "one_fetch_thirteen"})
    for (const bool along_v : {false, true}) EXPECT_LT(std::abs(response(filter, 16, 16, along_v)), 0.06) << filter << along_v;
}

}  // namespace
}  // namespace lamina
