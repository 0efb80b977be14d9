// SPDX-License-Identifier: Apache-2.0
// What is OpenGL's alone: contexts that come and go, and the differences from Vulkan that its backend takes away.
#include <cstdlib>

#include "tests/backend/rig.h"

namespace lamina {
namespace {

using ::testing::IsNotSubstring;
using ::testing::IsSubstring;

// Clears one pixel to 1, 2, 3, 4 and reads it back: a sign of life.
void expect_alive(Backend& backend) {
  const TextureId texture = backend.create_texture({.name = "life", .format = Format::rgba32_float, .target = true});
  Pass pass{.name = "clear"};
  pass.colors = {{.texture = texture, .clear = {1, 2, 3, 4}}};
  backend.run({&pass, 1}, Timing::off);
  EXPECT_EQ(values_of<float>(backend.read_texture(texture)), (std::vector<float>{1, 2, 3, 4})) << backend.info().backend;
  backend.destroy(texture);
}

TEST(OpenGlContext, ComesAndGoesOnEitherPlatform) {
  for (const char* name : {"osmesa", "egl", "osmesa", "osmesa", "egl", "egl"}) {
    const auto backend = open_backend(name);
    EXPECT_EQ(backend->info().backend, name);
    expect_alive(*backend);
  }
}

TEST(OpenGlContext, SecondIsRefusedUntilTheFirstIsClosed) {
  auto first = open_backend("egl");
  for (const char* name : {"osmesa", "egl"}) {
    const Error error = error_of([&] { open_backend(name); });
    EXPECT_EQ(error.kind(), ErrorKind::failed);
    EXPECT_PRED_FORMAT2(IsSubstring, "egl backend is still open", error.message());
  }
  expect_alive(*first);
  first.reset();
  expect_alive(*open_backend("osmesa"));
}

TEST(OpenGlContext, LivesBesideVulkan) {
  if (survey_devices("vulkan").usable.empty()) GTEST_SKIP() << "no Vulkan device on this machine";
  const auto vulkan = open_backend("vulkan");
  for (const char* name : {"osmesa", "egl"}) {
    const auto opengl = open_backend(name);
    expect_alive(*opengl);
    expect_alive(*vulkan);
    expect_alive(*opengl);
  }
}

class OpenGl : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Platforms, OpenGl, ::testing::Values("osmesa", "egl"),
                         [](const auto& case_of) { return std::string(case_of.param); });

TEST_P(OpenGl, DeviceIsDescribed) {
  const DeviceInfo& info = backend().info();
  EXPECT_PRED_FORMAT2(IsNotSubstring, "(", info.driver);  // "4.5 (Core Profile) Mesa 22.3.6" is for parsing, not for reading
  EXPECT_GE(info.api_version, "4.5");
  EXPECT_EQ(info.software, info.device.find("llvmpipe") != std::string::npos);
  EXPECT_GE(info.max_texture_size, 16384u) << "OpenGL 4.5, table 23.53";
}

TEST_P(OpenGl, ListingLeavesTheOpenBackendAlone) {
  close();
  const size_t devices = survey_devices(GetParam()).usable.size();
  open("osmesa");
  const BufferId out = buffer<uint32_t>(BufferUse::storage, {0});
  Draw draw{.pipeline = compute("layout(binding = 0) buffer Out { uint value; } o; void main() { o.value = 7; }\n")};
  draw.buffers = {{0, out, BindingKind::storage_buffer}};
  EXPECT_EQ(survey_devices(GetParam()).usable.size(), devices);
  run({{.name = "after", .kind = PassKind::compute, .draws = {draw}}});
  EXPECT_EQ(read<uint32_t>(out), std::vector<uint32_t>{7});
}

// Mesa hides versions and extensions on request, once a process: each case has a process of its own. Ends it with status 0
// where the backend cannot be opened and says `reason`.
[[noreturn]] void exit_after_opening(std::string_view backend, const char* variable, const char* value,
                                     std::string_view reason) {
  ::setenv(variable, value, 1);
  try {
    const std::string driver = open_backend(backend)->info().driver;
    std::fprintf(stderr, "opened on %s\n", driver.c_str());
    std::_Exit(driver.starts_with("Mesa") ? 1 : 0);  // no other driver can hide what it has
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    const bool as_told = error.kind() == ErrorKind::no_device && error.message().find(reason) != std::string::npos &&
                         error.message().find("install lib") != std::string::npos && survey_devices(backend).usable.empty();
    std::_Exit(as_told ? 0 : 1);
  }
}

class OpenGlDriver : public ::testing::TestWithParam<std::string_view> {};
INSTANTIATE_TEST_SUITE_P(Platforms, OpenGlDriver, ::testing::Values("osmesa", "egl"),
                         [](const auto& case_of) { return std::string(case_of.param); });

TEST_P(OpenGlDriver, ThatLacksSomethingIsNoDevice) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto as_told = ::testing::ExitedWithCode(0);
  EXPECT_EXIT(exit_after_opening(GetParam(), "MESA_EXTENSION_OVERRIDE", "-GL_ARB_gl_spirv", "lacks GL_ARB_gl_spirv"), as_told,
              "");
  EXPECT_EXIT(exit_after_opening(GetParam(), "MESA_GL_VERSION_OVERRIDE", "4.4", "no OpenGL 4.5 core context"), as_told, "");
}

TEST_P(OpenGl, RowZeroIsTheTopWhereClipYIsMinusOne) {
  const TextureId corner = target(Format::rgba32_float, 3, 2);
  for (const Cull cull : {Cull::none, Cull::back, Cull::front}) {
    Look look;
    look.cull = cull;
    const PipelineId draws = pipeline(R"(
layout(location = 0) out vec2 clip;
void main() {
  // Counter-clockwise as seen with y down: left top, left bottom, right top. It covers x + y <= 0.
  vec2 corners[3] = vec2[](vec2(-1, -1), vec2(-1, 1), vec2(1, -1));
  clip = corners[LAMINA_VERTEX_INDEX];
  gl_Position = vec4(clip, 0.25, 1);
})",
                                      R"(
layout(location = 0) in vec2 clip;
layout(location = 0) out vec4 color;
void main() { color = vec4(clip.y, gl_FragCoord.y, gl_FragCoord.z, gl_FrontFacing ? 1 : 0); })",
                                      look);
    Pass pass = raster(corner, {triangles(draws)});
    pass.colors[0].clear = {9, 9, 9, 9};
    run({pass});
    // Pixel centres at x = -2/3, 0, 2/3 and y = -1/2, 1/2: two are covered in the top row, one in the bottom row.
    std::vector<float> expected(3 * 2 * 4, 9.0f);
    if (cull != Cull::front) {
      for (const size_t pixel : {0, 1}) std::ranges::copy(std::array{-0.5f, 0.5f, 0.25f, 1.0f}, &expected[4 * pixel]);
      std::ranges::copy(std::array{0.5f, 1.5f, 0.25f, 1.0f}, &expected[4 * 3]);
    }
    const auto pixels = read<float>(corner);
    for (size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(pixels[i], expected[i], 1e-6) << "value " << i << ", cull " << static_cast<int>(cull);
  }
}

TEST_P(OpenGl, OriginThatAShaderDeclaresChangesNothing) {
  const Floats pixels = draw_over(1, 3,
                                  "layout(origin_upper_left) in vec4 gl_FragCoord;\n"
                                  "layout(location = 0) out vec4 color; void main() { color = vec4(gl_FragCoord.y); }\n");
  for (uint32_t row = 0; row < 3; ++row) EXPECT_EQ(pixels.at(0, row), static_cast<float>(row) + 0.5f);
}

// OpenGL refuses a constant's id that a module lacks.
TEST_P(OpenGl, ConstantReachesOnlyTheStageThatHasIt) {
  Look look;
  look.constants = {{3, std::bit_cast<uint32_t>(0.5f)}, {6, 1}, {44, 12}};
  const PipelineId draws = pipeline(full_screen,
                                    "layout(constant_id = 3) const float a = 1; layout(constant_id = 5) const int b = 2;\n"
                                    "layout(constant_id = 6) const bool c = false;\n"
                                    "layout(location = 0) out vec4 color; void main() { color = vec4(a, b, c ? 1 : 0, 1); }\n",
                                    look);
  const TextureId pixel = target(Format::rgba32_float, 1, 1);
  run({raster(pixel, {triangles(draws)})});
  EXPECT_EQ(read<float>(pixel), (std::vector<float>{0.5f, 2, 1, 1}));
}

// Vulkan's bindings are plain numbers; OpenGL has few image units, and far fewer than 300 of any kind. (glslang takes no
// sampler's or image's binding over 79.)
TEST_P(OpenGl, BindingsMayBeLargeAndAreUniqueAcrossKinds) {
  Draw draw{.pipeline = compute(R"(
layout(binding = 300) uniform In { float a; } ina;
layout(binding = 301) uniform Second { float b; } inb;
layout(binding = 78, rgba32f) uniform image2D image;
layout(binding = 79) uniform sampler2D map;
layout(binding = 304) buffer Out { float value[4]; } o;
void main() {
  o.value = float[](ina.a, inb.b, imageLoad(image, ivec2(0)).x, texelFetch(map, ivec2(0), 0).x);
})")};
  const auto texel = [&](float value) {
    const std::vector<std::vector<std::byte>> levels = {bytes_of(std::vector<float>{value, 0, 0, 0})};
    return backend().create_texture({.name = "in", .format = Format::rgba32_float, .storage = true}, levels);
  };
  const auto uniform = [&](float value) { return buffer<float>(BufferUse::uniform, {value, 0, 0, 0}); };
  const BufferId out = buffer<float>(BufferUse::storage, {0, 0, 0, 0});
  draw.textures = {{79, texel(4), {}}};
  draw.images = {{78, texel(3), 0}};
  draw.buffers = {{304, out, BindingKind::storage_buffer},
                  {301, uniform(2), BindingKind::uniform_buffer},
                  {300, uniform(1), BindingKind::uniform_buffer}};
  run({{.name = "gather", .kind = PassKind::compute, .draws = {draw}}});
  EXPECT_EQ(read<float>(out), (std::vector<float>{1, 2, 3, 4}));

  draw.images.clear();
  const Error error = error_of([&] { run({{.name = "gather", .kind = PassKind::compute, .draws = {draw}}}); });
  EXPECT_EQ(error.kind(), ErrorKind::bad_input);
  EXPECT_PRED_FORMAT2(IsSubstring, "binding 78", error.message());
}

TEST_P(OpenGl, SpirvThatBreaksOffIsRefused) {
  PipelineDesc desc{.name = "broken"};
  desc.stages = {{Stage::compute, shader(Stage::compute, "void main() {}\n").spirv}};
  desc.stages[0].spirv.resize(6);  // within the first instruction
  const Error error = error_of([&] { backend().create_pipeline(desc); });
  EXPECT_EQ(error.kind(), ErrorKind::failed);
  EXPECT_EQ(error.subject(), "broken");
  EXPECT_PRED_FORMAT2(IsSubstring, "breaks off", error.message());
}

TEST_P(OpenGl, CheckerSpeaksOnlyWhenSomethingIsWrong) {
  expect_alive(backend());
  EXPECT_TRUE(backend().take_messages().empty());

  // OpenGL 4.5, section 8.14.4: no mipmaps of integer textures.
  Pass wrong{.name = "integer mips", .kind = PassKind::mips};
  wrong.mips_of = target(Format::r32_uint, 2, 2, 2);
  const Error error = error_of([&] { run({wrong}); });
  EXPECT_EQ(error.kind(), ErrorKind::failed);
  EXPECT_EQ(error.subject(), "integer mips");
  EXPECT_PRED_FORMAT2(IsSubstring, "GL_INVALID_OPERATION", error.message());
  const std::vector<std::string> messages = backend().take_messages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_PRED_FORMAT2(IsSubstring, "GL_INVALID_OPERATION", messages[0]);
  EXPECT_TRUE(backend().take_messages().empty()) << "they are taken once";
  expect_alive(backend());
}

// The timer keeps its queries from run to run.
TEST_P(OpenGl, LongerAndShorterFramesAreTimedInTurn) {
  const Pass pass = raster(target(Format::rgba8_unorm, 64, 64), {});
  for (const size_t count : {3u, 1u, 5u}) {
    const RunTimes times = run(std::vector<Pass>(count, pass), Timing::bracketed);
    ASSERT_EQ(times.pass_ms.size(), count);
    for (const double pass_ms : times.pass_ms) EXPECT_GT(pass_ms, 0);
  }
}

}  // namespace
}  // namespace lamina
