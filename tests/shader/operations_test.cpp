// SPDX-License-Identifier: Apache-2.0
// Executed operations by class: of single instructions against their definitions, and of shaders whose counts are known in
// closed form, run on each backend.
#include "harness/shader/operations.h"

#include <gtest/gtest.h>

#include "harness/shader/spirv_module.h"
#include "tests/shader/counting_run.h"

namespace lamina {
namespace {

using Named = std::map<std::string, uint64_t>;

constexpr uint64_t pixels = run_width_px * run_height_px;

class OperationsOf : public ShaderFiles {
 protected:
  // Of all instructions of a fragment shader, each run once. `v`, `w` and `o` are vec3, `x` a float, all interpolated or
  // written.
  Named of(const std::string& statements, Api api, const std::string& declarations = "") {
    const CompiledShader shader = compile(Stage::fragment, api,
                                          fmt::format(R"(
layout(location = 0) in vec3 v;
layout(location = 1) in vec3 w;
layout(location = 2) in float x;
layout(location = 0) out vec4 o;
{}
void main() {{ {} }}
)",
                                                      declarations, statements));
    const SpirvModule module(shader.spirv);
    Operations all;
    for (const SpirvInstruction& instruction : module.instructions())
      all.add(operations_of(module, instruction, Stage::fragment));
    return all.by_name();
  }
};

TEST_F(OperationsOf, EachInstructionCountsItsDefinition) {
  struct Case {
    const char* expression;  // a vec4
    Named work;
  };
  const Case cases[] = {
      {"vec4(v + w, 1)", {{"add", 3}, {"interpolation", 6}}},
      {"vec4(-v, 1)", {{"add", 3}, {"interpolation", 3}}},
      {"vec4(v * w, 1)", {{"multiply", 3}, {"interpolation", 6}}},
      {"vec4(v * x, 1)", {{"multiply", 3}, {"interpolation", 4}}},
      {"vec4(v / x, 1)", {{"divide", 3}, {"interpolation", 4}}},
      {"vec4(mod(v, w), 1)", {{"divide", 3}, {"interpolation", 6}}},
      {"vec4(dot(v, w))", {{"multiply", 3}, {"add", 2}, {"interpolation", 6}}},
      {"vec4(cross(v, w), 1)", {{"multiply", 6}, {"add", 3}, {"interpolation", 6}}},
      {"vec4(length(v))", {{"multiply", 3}, {"add", 2}, {"root", 1}, {"interpolation", 3}}},
      {"vec4(distance(v, w))", {{"multiply", 3}, {"add", 5}, {"root", 1}, {"interpolation", 6}}},
      {"vec4(normalize(v), 1)", {{"multiply", 6}, {"add", 2}, {"root", 1}, {"interpolation", 3}}},
      {"vec4(reflect(v, w), 1)", {{"multiply", 7}, {"add", 5}, {"interpolation", 6}}},
      {"vec4(refract(v, w, x), 1)", {{"multiply", 13}, {"add", 8}, {"compare", 1}, {"root", 1}, {"interpolation", 7}}},
      {"vec4(mix(v, w, x), 1)", {{"multiply", 6}, {"add", 6}, {"interpolation", 7}}},
      {"vec4(smoothstep(v, w, vec3(0.5)), 1)",
       {{"multiply", 9}, {"add", 9}, {"divide", 3}, {"compare", 6}, {"interpolation", 6}}},
      {"vec4(clamp(v, 0.0, 1.0), 1)", {{"compare", 6}, {"interpolation", 3}}},
      {"vec4(max(v, w), 1)", {{"compare", 3}, {"interpolation", 6}}},
      {"vec4(fma(v, w, w), 1)", {{"fma", 3}, {"interpolation", 9}}},
      {"vec4(sqrt(v), inversesqrt(x))", {{"root", 4}, {"interpolation", 4}}},
      {"vec4(sin(x), cos(x), tan(x), asin(x))", {{"sin", 1}, {"cos", 1}, {"tan", 1}, {"asin", 1}, {"interpolation", 4}}},
      {"vec4(acos(x), atan(x), atan(x, 2.0), sinh(x))", {{"acos", 1}, {"atan", 2}, {"hyperbolic", 1}, {"interpolation", 4}}},
      {"vec4(exp(v), exp2(x))", {{"exp", 4}, {"interpolation", 4}}},
      {"vec4(log(v), log2(x))", {{"log", 4}, {"interpolation", 4}}},
      {"vec4(pow(v, w), 1)", {{"pow", 3}, {"interpolation", 6}}},
      {"vec4(floor(v), fract(x))", {{"convert", 4}, {"interpolation", 4}}},
      {"vec4(dFdx(v), fwidth(x))", {{"derivative", 4}, {"interpolation", 4}}},
      {"vec4(ivec3(v) + 1, 1)", {{"convert", 6}, {"integer", 3}, {"interpolation", 3}}},
      {"vec4(unpackHalf2x16(packHalf2x16(v.xy)), 0, 1)", {{"convert", 4}, {"interpolation", 3}}},
      {"vec4(mat3(v, w, v) * w, 1)", {{"multiply", 9}, {"add", 6}, {"interpolation", 12}}},
      {"vec4(v * mat3(v, w, v), 1)", {{"multiply", 9}, {"add", 6}, {"interpolation", 12}}},
      {"vec4((mat3(v, w, v) * mat3(v, w, v))[0], 1)", {{"multiply", 27}, {"add", 18}, {"interpolation", 18}}},
      {"vec4(determinant(mat3(v, w, v)))", {{"multiply", 9}, {"add", 5}, {"interpolation", 9}}},
      {"vec4(inverse(mat2(v.xy, w.xy))[0], 0, 1)", {{"multiply", 6}, {"add", 1}, {"divide", 1}, {"interpolation", 6}}},
      {"vec4(mix(v, w, greaterThan(v, w)), 1)", {{"compare", 3}, {"select", 3}, {"interpolation", 12}}},
      {"gl_FragCoord", {}},
  };
  for (const Api api : both_apis)
    for (const Case& c : cases) EXPECT_EQ(of(fmt::format("o = {};", c.expression), api), c.work) << c.expression;
}

TEST_F(OperationsOf, MemoryCountsByWhatItIs) {
  struct Case {
    const char* declaration;
    const char* statement;
    Named work;
  };
  const Case cases[] = {
      {"layout(std140, binding = 1) uniform B { vec4 a; mat3 m; };", "o = a;", {{"uniform", 4}}},
      {"layout(std140, binding = 1) uniform B { vec4 a; mat3 m; };", "o = vec4(m[1], 1);", {{"uniform", 3}}},
      {"layout(std430, binding = 1) buffer B { vec2 s[]; };", "s[0] = s[1]; o = vec4(1);", {{"storage", 4}}},
      {"layout(std430, binding = 1) buffer B { uint s[]; };", "atomicAdd(s[0], 2u); o = vec4(1);", {{"storage", 1}}},
      {"layout(binding = 1, rgba8) uniform image2D i;",
       "imageStore(i, ivec2(0), imageLoad(i, ivec2(1))); o = vec4(1);",
       {{"image", 2}}},
      {"layout(binding = 1, r32ui) uniform uimage2D i;", "imageAtomicMax(i, ivec2(0), 3u); o = vec4(1);", {{"image", 1}}},
      {"layout(location = 3) flat in vec2 f;", "o = vec4(f, 0, 1);", {{"input", 2}}},
      {"layout(binding = 1) uniform sampler2D t;", "o = texture(t, v.xy);", {{"interpolation", 3}}},
      {"layout(binding = 1) uniform sampler2D t;",
       "o = vec4(textureSize(t, 0), textureQueryLevels(t), 1);",
       {{"query", 2}, {"convert", 3}}},
      {"vec4 kept;", "vec4 local = vec4(x); kept = local; o = kept;", {{"interpolation", 1}}},
  };
  for (const Api api : both_apis)
    for (const Case& c : cases) EXPECT_EQ(of(c.statement, api, c.declaration), c.work) << c.declaration << " " << c.statement;
}

TEST(OperationNames, AreTheirOwn) {
  std::set<std::string_view> names;
  for (size_t k = 0; k < operation_class_count; ++k) names.insert(name_of(static_cast<OperationClass>(k)));
  EXPECT_EQ(names.size(), operation_class_count);
  EXPECT_FALSE(names.contains(""));
  EXPECT_EQ(name_of(OperationClass::convert), "convert");
  EXPECT_EQ(name_of(OperationClass::query), "query");
}

class OperationsRun : public CountingRun {};

TEST_P(OperationsRun, ALoopOfNWithKAdditions) {
  for (const uint64_t n : {0, 1, 7}) {
    const std::string source = fmt::format(R"(
layout(location = 0) out vec4 o;
void main() {{
  float sum = gl_FragCoord.x;
  for (int i = 0; i < {}; ++i) {{ sum += 0.5; sum += 0.25; sum += 0.125; }}
  o = vec4(sum);
}}
)",
                                           n);
    Named expected = {{"compare", (n + 1) * pixels}, {"branch", (n + 1) * pixels}};
    if (n > 0) expected["add"] = 3 * n * pixels, expected["integer"] = n * pixels;
    EXPECT_EQ(run({.fragment = source}).operations, expected) << n;
  }
}

TEST_P(OperationsRun, ABranchThatHalfOfThePixelsTake) {
  const Counts counts = run({.fragment = R"(
layout(location = 0) out vec4 o;
void main() {
  o = vec4(0);
  if (gl_FragCoord.x < 32.0) o = vec4(exp(gl_FragCoord.y * -0.01));
  else o.x = sin(gl_FragCoord.y) + cos(gl_FragCoord.y);
}
)"});
  EXPECT_EQ(counts.operations, (Named{{"compare", pixels},
                                      {"branch", pixels},
                                      {"exp", pixels / 2},
                                      {"multiply", pixels / 2},
                                      {"sin", pixels / 2},
                                      {"cos", pixels / 2},
                                      {"add", pixels / 2}}));
  EXPECT_EQ(counts.issued, (Named{{"compare", pixels},
                                  {"branch", pixels},
                                  {"exp", pixels},
                                  {"multiply", pixels},
                                  {"sin", pixels},
                                  {"cos", pixels},
                                  {"add", pixels}}))
      << "both sides";
}

// The untaken side of a branch is issued as often as the code around it, a loop within it once at least.
TEST_P(OperationsRun, WhatIsIssuedFollowsTheCodeAround) {
  const Counts counts = run({.fragment = R"(
layout(location = 0) out vec4 o;
layout(binding = 1) uniform sampler2D t;
void main() {
  float a = gl_FragCoord.y;
  for (int i = 0; i < 4; ++i) {
    if (i == 1 && gl_FragCoord.x < 16.0) {
      a = exp(a);
      if (a > 2.0) a = textureLod(t, vec2(a), 0.0).x;
    }
    a = log(a);
  }
  if (gl_FragCoord.x < 16.0)
    for (int i = 0; i < 8; ++i) a = atan(a);
  if (gl_FragCoord.x < 0.0)
    for (int i = 0; i < 8; ++i) a = sin(a);
  o = vec4(a);
}
)"});
  EXPECT_EQ(counts.operations.at("exp"), pixels / 4);
  EXPECT_EQ(counts.issued.at("exp"), 4 * pixels);
  EXPECT_EQ(counts.issued_fetches.at(1), 4 * pixels) << "of the outermost branch in the loop";
  EXPECT_EQ(counts.issued.at("log"), counts.operations.at("log"));
  EXPECT_EQ(counts.issued.at("atan"), 2 * pixels) << "8 times by a quarter";
  EXPECT_FALSE(counts.operations.contains("sin"));
  EXPECT_EQ(counts.issued.at("sin"), pixels) << "a loop that nobody enters is gone through once";
}

TEST_P(OperationsRun, AnEarlyReturnCountsWhatCameBefore) {
  const Counts counts = run({.fragment = R"(
layout(location = 0) out vec4 o;
void main() {
  o = vec4(sqrt(gl_FragCoord.x));
  if (gl_FragCoord.y < 12.0) return;
  o = vec4(log(gl_FragCoord.x));
}
)"});
  EXPECT_EQ(counts.operations.at("root"), pixels);
  EXPECT_EQ(counts.operations.at("log"), pixels * 3 / 4);
}

TEST_P(OperationsRun, ADiscardedFragmentCountsUntilItIsDiscarded) {
  const Counts counts = run({.fragment = R"(
layout(location = 0) out vec4 o;
void main() {
  float a = pow(gl_FragCoord.x, 0.5);
  if (gl_FragCoord.x < 16.0) discard;
  o = vec4(a / gl_FragCoord.y);
}
)"});
  EXPECT_EQ(counts.operations.at("pow"), pixels);
  EXPECT_EQ(counts.operations.at("divide"), pixels * 3 / 4);
}

TEST_P(OperationsRun, AFunctionCalledTwiceCountsTwiceAndItsBranchesByCall) {
  const Counts counts = run({.fragment = R"(
layout(location = 0) out vec4 o;
float of(float a) {
  if (a < 20.0) return acos(a * 0.01);
  for (int i = 0; i < 3; ++i) a = atan(a);
  return a;
}
void main() { o = vec4(of(gl_FragCoord.x), of(5.0), 0, 1); }
)"});
  EXPECT_EQ(counts.operations.at("acos"), pixels * 20 / 64 + pixels) << "columns 0 to 19, and every second call";
  EXPECT_EQ(counts.operations.at("atan"), 3 * pixels * 44 / 64);
}

TEST_P(OperationsRun, ASwitchCountsTheCaseTaken) {
  const Counts counts = run({.fragment = R"(
layout(location = 0) out vec4 o;
void main() {
  o = vec4(0);
  switch (int(gl_FragCoord.x) / 16) {
    case 0: o.x = exp(gl_FragCoord.y);
    case 1: o.y = log(gl_FragCoord.y); break;
    default: o.z = sin(gl_FragCoord.y);
  }
}
)"});
  EXPECT_EQ(counts.operations.at("exp"), pixels / 4);
  EXPECT_EQ(counts.operations.at("log"), pixels / 2) << "case 0 falls through";
  EXPECT_EQ(counts.operations.at("sin"), pixels / 2);
}

TEST_P(OperationsRun, VerticesAndComputeCountToo) {
  const Counts vertices = run({.vertex = R"(
void main() {
  gl_Position = vec4(LAMINA_VERTEX_INDEX == 1 ? 3 : -1, LAMINA_VERTEX_INDEX == 2 ? 3 : -1, tan(0.001 * LAMINA_VERTEX_INDEX), 1);
}
)",
                               .fragment = "layout(location = 0) out vec4 o;\nvoid main() { o = vec4(1); }\n",
                               .count_vertex = true});
  EXPECT_EQ(vertices.operations.at("tan"), 3u);
  const Counts compute = dispatch(R"(
layout(local_size_x = 4) in;
layout(std430, binding = 1) buffer B { float s[]; };
void main() { s[gl_GlobalInvocationID.x] = sqrt(float(gl_GlobalInvocationID.x)); }
)",
                                  {5, 1, 1});
  EXPECT_EQ(compute.operations, (Named{{"root", 20}, {"convert", 20}, {"storage", 20}}));
}

INSTANTIATE_TEST_SUITE_P(Backends, OperationsRun, ::testing::ValuesIn(backend_names().begin(), backend_names().end()),
                         [](const auto& backend) { return std::string(backend.param); });

}  // namespace
}  // namespace lamina
