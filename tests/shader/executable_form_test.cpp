// SPDX-License-Identifier: Apache-2.0
#include "harness/shader/executable_form.h"

#include "tests/shader/shader_files.h"

namespace lamina {
namespace {

class ExecutableForms : public ShaderFiles {
 protected:
  std::vector<uint32_t> form(Api api, std::string_view body) {
    return executable_form(compile(Stage::fragment, api, body).spirv, api);
  }
  void expect_equal(std::string_view a, std::string_view b) {
    for (const Api api : both_apis) EXPECT_EQ(form(api, a), form(api, b)) << a << "\n----\n" << b;
  }
  void expect_different(std::string_view a, std::string_view b) {
    for (const Api api : both_apis) EXPECT_NE(form(api, a), form(api, b)) << a << "\n----\n" << b;
  }
};

constexpr std::string_view shade = R"(
layout(binding = 1) uniform sampler2D albedo;
layout(binding = 2, std140) uniform Fog { float density; float height; } fog;
layout(constant_id = 3) const float scale = 2.0;
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
float extinction(float x) { return exp(-fog.density * x); }
vec3 lit(vec3 base, float x) { return base * extinction(x) + vec3(0.25); }
void main() {
  vec3 base = texture(albedo, uv).rgb;
  if (uv.x > 0.5) { color = vec4(lit(base, uv.y), 1.0); return; }
  color = vec4(base * scale * fog.height, 1.0);
}
)";

std::string with(std::string_view find, std::string_view replacement) {
  std::string text(shade);
  for (size_t at = text.find(find); at != std::string::npos; at = text.find(find, at + replacement.size()))
    text.replace(at, find.size(), replacement);
  EXPECT_NE(text, shade) << "nothing was replaced: " << find;
  return text;
}

TEST_F(ExecutableForms, NamesOfVariablesFunctionsAndArgumentsDoNotCount) {
  expect_equal(shade, with("base", "surface"));
  expect_equal(shade, with("extinction", "transmittance"));
  expect_equal(shade, with("float extinction(float x) { return exp(-fog.density * x); }",
                           "float extinction(float thickness) { return exp(-fog.density * thickness); }"));
  expect_equal(shade, with("uv", "coordinates"));
}

TEST_F(ExecutableForms, CommentsAndLinesDoNotCount) { expect_equal(shade, with("void main", "\n\n// draws\nvoid main")); }

TEST_F(ExecutableForms, OrderOfFunctionsAndDeclarationsDoesNotCount) {
  constexpr std::string_view other = R"(
layout(location = 0) out vec4 color;
layout(constant_id = 3) const float scale = 2.0;
layout(location = 0) in vec2 uv;
vec3 lit(vec3 base, float x);
void main() {
  vec3 base = texture(albedo, uv).rgb;
  if (uv.x > 0.5) { color = vec4(lit(base, uv.y), 1.0); return; }
  color = vec4(base * scale * fog.height, 1.0);
}
float extinction(float x);
vec3 lit(vec3 base, float x) { return base * extinction(x) + vec3(0.25); }
float extinction(float x) { return exp(-fog.density * x); }
)";
  expect_equal(shade,
               "layout(binding = 2, std140) uniform Fog { float density; float height; } fog;\n"
               "layout(binding = 1) uniform sampler2D albedo;\n" +
                   std::string(other));
}

TEST_F(ExecutableForms, AFunctionInPlaceOfItsBodyDoesNotCount) {
  expect_equal(shade, with("base * extinction(x)", "base * exp(-fog.density * x)"));
}

TEST_F(ExecutableForms, WhatHasNoEffectDoesNotCount) {
  expect_equal(shade,
               with("void main() {", "float unused(float a) { return sin(a); }\nvoid main() { float b = unused(uv.x) * 2.0;"));
  expect_equal(shade, with("void main() {", "layout(binding = 7) uniform sampler2D never_read;\nvoid main() {"));
}

TEST_F(ExecutableForms, AConstantCounts) {
  expect_different(shade, with("0.25", "0.250001"));
  expect_different(shade, with("uv.x > 0.5", "uv.x > 0.25"));
  expect_different(shade, with("scale = 2.0", "scale = 3.0"));
}

TEST_F(ExecutableForms, AnOperationItsOperandsAndTheirPlaceCount) {
  expect_different(shade, with("uv.x > 0.5", "uv.x >= 0.5"));
  expect_different(shade, with("uv.x > 0.5", "uv.y > 0.5"));
  expect_different(shade, with("base * scale * fog.height", "fog.height * scale * base"));
  expect_different(shade, with("exp(", "exp2("));
  expect_different(shade, with("texture(albedo, uv)", "textureLod(albedo, uv, 0.0)"));
}

TEST_F(ExecutableForms, TheNamesByWhichValuesAreFoundCount) {
  expect_different(shade, with("albedo", "mask"));
  expect_different(shade, with("density", "absorption"));
  expect_different(shade, with("float density; float height;", "float height; float density;"));
  expect_different(shade, with("uniform Fog", "uniform Mist"));
  expect_different(shade, with("scale", "strength"));
}

TEST_F(ExecutableForms, BindingsLocationsAndPrecisionCount) {
  expect_different(shade, with("binding = 1", "binding = 5"));
  expect_different(shade, with("constant_id = 3", "constant_id = 4"));
  expect_different(shade, with("layout(location = 0) in vec2", "layout(location = 1) in vec2"));
  expect_different(shade, with("in vec2 uv", "flat in vec2 uv"));
  expect_different(shade, with("void main() {", "layout(early_fragment_tests) in;\nvoid main() {"));
  expect_different(shade, with("layout(location = 0) out", "layout(location = 1) out vec4 second;\nlayout(location = 0) out"));
}

TEST_F(ExecutableForms, OrderOfLocalVariablesDoesNotCount) {
  const auto with_locals = [](std::string_view locals) {
    return "layout(location = 0) in vec2 uv;\nlayout(location = 0) out vec4 color;\nvoid main() {\n" + std::string(locals) +
           "for (int i = 0; i < 3; ++i) { a[i] = uv.x * float(i); b[2 - i] = uv.y; }\n"
           "color = vec4(a[int(uv.x)], b[int(uv.y)], 0.0, 1.0);\n}\n";
  };
  expect_equal(with_locals("float a[3]; float b[3];"), with_locals("float b[3]; float a[3];"));
}

TEST_F(ExecutableForms, ALoopIsComparedToo) {
  constexpr std::string_view loop = R"(
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
struct Ray { vec2 origin, step; };
void main() {
  Ray ray = Ray(uv, vec2(0.5));
  float kept[4];
  for (int i = 0; i < 4; ++i) { ray.origin += ray.step; kept[i] = ray.origin.x; }
  color = vec4(kept[int(uv.x * 3.0)], kept[1], 0.0, 1.0);
}
)";
  std::string renamed(loop);
  for (const auto& [find, replacement] : {std::pair("Ray", "Path"), std::pair("origin", "place"), std::pair("kept", "stored")})
    for (size_t at = renamed.find(find); at != std::string::npos; at = renamed.find(find, at + 1))
      renamed.replace(at, std::string_view(find).size(), replacement);
  expect_equal(loop, renamed);
  std::string longer(loop);
  longer.replace(longer.find("i < 4"), 5, "i < 3");
  expect_different(loop, longer);
}

}  // namespace
}  // namespace lamina
