// SPDX-License-Identifier: Apache-2.0
// What is OpenGL's alone: contexts that come and go, devices, and the differences from Vulkan that the backend takes away.
#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <cstring>

#include "harness/backend/backend.h"
#include "tests/shader/shader_files.h"

namespace lamina {
namespace {

using ::testing::IsSubstring;

template <class T>
std::vector<T> values_of(const std::vector<std::byte>& bytes) {
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}

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
  if (list_devices("vulkan").empty()) GTEST_SKIP() << "no Vulkan device on this machine";
  const auto vulkan = open_backend("vulkan");
  for (const char* name : {"osmesa", "egl"}) {
    const auto opengl = open_backend(name);
    expect_alive(*opengl);
    expect_alive(*vulkan);
    expect_alive(*opengl);
  }
}

class OpenGl : public ShaderFiles, public ::testing::WithParamInterface<const char*> {
 protected:
  // A compute shader that writes into the buffer that it has at binding `output`.
  PipelineId compute(Backend& backend, std::string_view body, std::vector<BindingSlot> bindings) const {
    const CompiledShader shader = compile(Stage::compute, Api::opengl, body);
    return backend.create_pipeline(
        {.name = "compute", .stages = {{Stage::compute, shader.spirv}}, .bindings = std::move(bindings)});
  }
  // Draws one triangle over the whole of a `width` x `height` picture and reads it back.
  std::vector<float> draw_over(Backend& backend, uint32_t width, uint32_t height, std::string_view fragment,
                               std::vector<SpecConstant> constants = {}) const {
    const CompiledShader over = compile(Stage::vertex, Api::opengl,
                                        "void main() { gl_Position = vec4(LAMINA_VERTEX_INDEX == 1 ? 3 : -1, "
                                        "LAMINA_VERTEX_INDEX == 2 ? 3 : -1, 0, 1); }\n");
    const CompiledShader shade = compile(Stage::fragment, Api::opengl, fragment);
    const PipelineId pipeline = backend.create_pipeline({
        .name = "over",
        .stages = {{Stage::vertex, over.spirv}, {Stage::fragment, shade.spirv}},
        .constants = std::move(constants),
        .colors = {Format::rgba32_float},
    });
    const TextureId texture = backend.create_texture(
        {.name = "picture", .width = width, .height = height, .format = Format::rgba32_float, .target = true});
    Pass pass{.name = "draw"};
    pass.colors = {{.texture = texture, .clear = {-1, -1, -1, -1}}};
    pass.draws = {Draw{.pipeline = pipeline, .count = 3}};
    backend.run({&pass, 1}, Timing::off);
    return values_of<float>(backend.read_texture(texture));
  }
};
INSTANTIATE_TEST_SUITE_P(Platforms, OpenGl, ::testing::Values("osmesa", "egl"),
                         [](const auto& platform) { return platform.param; });

TEST_P(OpenGl, DeviceIsDescribed) {
  const std::vector<DeviceInfo> devices = list_devices(GetParam());
  ASSERT_FALSE(devices.empty());
  const auto backend = open_backend(GetParam(), {.device = "0"});
  const DeviceInfo& info = backend->info();
  EXPECT_EQ(info.api, Api::opengl);
  EXPECT_EQ(info.device, devices[0].device);
  EXPECT_EQ(info.driver, devices[0].driver);
  EXPECT_PRED_FORMAT2(::testing::IsNotSubstring, "(", info.driver);
  EXPECT_GE(info.api_version, "4.5");
  EXPECT_EQ(info.software, info.device.find("llvmpipe") != std::string::npos);
  EXPECT_GE(info.max_texture_size, 16384u) << "OpenGL 4.5, table 23.53";
}

TEST_P(OpenGl, DeviceIsFoundByPartOfItsName) {
  const std::string name = list_devices(GetParam()).at(0).device;
  std::string part = name.substr(1, 5);
  part[0] = static_cast<char>(std::toupper(part[0]));
  EXPECT_EQ(open_backend(GetParam(), {.device = part})->info().device, name);
  for (const char* wrong : {"99", "no such device"}) {
    const Error error = error_of([&] { open_backend(GetParam(), {.device = wrong}); });
    EXPECT_EQ(error.kind(), ErrorKind::no_device);
    EXPECT_EQ(error.subject(), wrong);
    EXPECT_PRED_FORMAT2(IsSubstring, "0: " + name, error.message());
  }
}

TEST_P(OpenGl, ListingLeavesTheOpenBackendAlone) {
  const size_t devices = list_devices(GetParam()).size();
  const auto backend = open_backend("osmesa");
  const PipelineId pipeline = compute(*backend,
                                      "layout(binding = 0) buffer Out { uint value; } o;\n"
                                      "void main() { o.value = 7; }\n",
                                      {{0, BindingKind::storage_buffer}});
  const BufferId out = backend->create_buffer("out", BufferUse::storage, 4);
  EXPECT_EQ(list_devices(GetParam()).size(), devices);
  Pass pass{.name = "after", .kind = PassKind::compute};
  pass.draws = {Draw{.pipeline = pipeline, .buffers = {{0, out, BindingKind::storage_buffer}}}};
  backend->run({&pass, 1}, Timing::off);
  EXPECT_EQ(values_of<uint32_t>(backend->read_buffer(out)), std::vector<uint32_t>{7});
}

// Mesa hides versions and extensions on request, once a process: each case has a process of its own. Ends it with status 0
// where the backend cannot be opened and says `reason`.
[[noreturn]] void exit_after_opening(const char* backend, const char* variable, const char* value, std::string_view reason) {
  ::setenv(variable, value, 1);
  try {
    const std::string driver = open_backend(backend)->info().driver;
    std::fprintf(stderr, "opened on %s\n", driver.c_str());
    std::_Exit(driver.starts_with("Mesa") ? 1 : 0);  // no other driver can hide what it has
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    const bool as_told = error.kind() == ErrorKind::no_device && error.message().find(reason) != std::string::npos &&
                         error.message().find("install lib") != std::string::npos && list_devices(backend).empty();
    std::_Exit(as_told ? 0 : 1);
  }
}

TEST_P(OpenGl, DriverThatLacksSomethingIsNoDevice) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto as_told = ::testing::ExitedWithCode(0);
  EXPECT_EXIT(exit_after_opening(GetParam(), "MESA_EXTENSION_OVERRIDE", "-GL_ARB_gl_spirv", "lacks GL_ARB_gl_spirv"), as_told,
              "");
  EXPECT_EXIT(exit_after_opening(GetParam(), "MESA_GL_VERSION_OVERRIDE", "4.4", "no OpenGL 4.5 core context"), as_told, "");
}

TEST_P(OpenGl, RowZeroIsTheTopWhereClipYIsMinusOne) {
  const auto backend = open_backend(GetParam());
  const CompiledShader vertex = compile(Stage::vertex, Api::opengl, R"(
layout(location = 0) out vec2 clip;
void main() {
  // Counter-clockwise as seen with y down: left top, left bottom, right top. It covers x + y <= 0.
  vec2 corners[3] = vec2[](vec2(-1, -1), vec2(-1, 1), vec2(1, -1));
  clip = corners[LAMINA_VERTEX_INDEX];
  gl_Position = vec4(clip, 0.25, 1);
}
)");
  const CompiledShader fragment = compile(Stage::fragment, Api::opengl, R"(
layout(location = 0) in vec2 clip;
layout(location = 0) out vec4 color;
void main() { color = vec4(clip.y, gl_FragCoord.y, gl_FragCoord.z, gl_FrontFacing ? 1 : 0); }
)");
  const TextureId picture =
      backend->create_texture({.name = "picture", .width = 3, .height = 2, .format = Format::rgba32_float, .target = true});
  for (const Cull cull : {Cull::none, Cull::back, Cull::front}) {
    const PipelineId pipeline =
        backend->create_pipeline({.name = "corner",
                                  .stages = {{Stage::vertex, vertex.spirv}, {Stage::fragment, fragment.spirv}},
                                  .colors = {Format::rgba32_float},
                                  .cull = cull});
    Pass pass{.name = "corner"};
    pass.colors = {{.texture = picture, .clear = {9, 9, 9, 9}}};
    pass.draws = {Draw{.pipeline = pipeline, .count = 3}};
    backend->run({&pass, 1}, Timing::off);
    const auto pixels = values_of<float>(backend->read_texture(picture));
    // Pixel centres at x = -2/3, 0, 2/3 and y = -1/2, 1/2: two are covered in the top row, one in the bottom row.
    std::vector<float> expected(3 * 2 * 4, 9.0f);
    if (cull != Cull::front) {
      for (const size_t pixel : {0, 1}) std::ranges::copy(std::array{-0.5f, 0.5f, 0.25f, 1.0f}, &expected[4 * pixel]);
      std::ranges::copy(std::array{0.5f, 1.5f, 0.25f, 1.0f}, &expected[4 * 3]);
    }
    for (size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(pixels[i], expected[i], 1e-6) << "value " << i << ", cull " << static_cast<int>(cull);
  }
}

TEST_P(OpenGl, OriginThatAShaderDeclaresChangesNothing) {
  const auto backend = open_backend(GetParam());
  const auto pixels = draw_over(*backend, 1, 3,
                                "layout(origin_upper_left) in vec4 gl_FragCoord;\n"
                                "layout(location = 0) out vec4 color; void main() { color = vec4(gl_FragCoord.y); }\n");
  for (size_t row = 0; row < 3; ++row) EXPECT_EQ(pixels[4 * row], static_cast<float>(row) + 0.5f);
}

TEST_P(OpenGl, ConstantReachesOnlyTheStageThatHasIt) {
  const auto backend = open_backend(GetParam());
  const auto pixels = draw_over(*backend, 1, 1,
                                "layout(constant_id = 3) const float a = 1; layout(constant_id = 5) const int b = 2;\n"
                                "layout(constant_id = 6) const bool c = false;\n"
                                "layout(location = 0) out vec4 color; void main() { color = vec4(a, b, c ? 1 : 0, 1); }\n",
                                {{3, std::bit_cast<uint32_t>(0.5f)}, {6, 1}, {44, 12}});
  EXPECT_EQ(pixels, (std::vector<float>{0.5f, 2, 1, 1}));
}

// Vulkan's bindings are plain numbers; OpenGL has few image units, and far fewer than 300 of any kind. (glslang takes no
// sampler's or image's binding over 79.)
TEST_P(OpenGl, BindingsMayBeLargeAndAreUniqueAcrossKinds) {
  const auto backend = open_backend(GetParam());
  const PipelineId pipeline = compute(*backend, R"(
layout(binding = 300) uniform In { float a; } ina;
layout(binding = 301) uniform Second { float b; } inb;
layout(binding = 78, rgba32f) uniform image2D image;
layout(binding = 79) uniform sampler2D map;
layout(binding = 304) buffer Out { float value[4]; } o;
void main() {
  o.value = float[](ina.a, inb.b, imageLoad(image, ivec2(0)).x, texelFetch(map, ivec2(0), 0).x);
}
)",
                                      {{304, BindingKind::storage_buffer},
                                       {79, BindingKind::texture},
                                       {300, BindingKind::uniform_buffer},
                                       {78, BindingKind::storage_image},
                                       {301, BindingKind::uniform_buffer}});
  const auto uniform = [&](float value) {
    return backend->create_buffer("in", BufferUse::uniform, 16, std::as_bytes(std::span(&value, 1)));
  };
  const auto texture = [&](float value) {
    const std::array<float, 4> texel = {value, 0, 0, 0};
    const std::vector<std::vector<std::byte>> levels = {
        {std::as_bytes(std::span(texel)).begin(), std::as_bytes(std::span(texel)).end()}};
    return backend->create_texture({.name = "in", .format = Format::rgba32_float, .storage = true}, levels);
  };
  const BufferId out = backend->create_buffer("out", BufferUse::storage, 16);
  Pass pass{.name = "gather", .kind = PassKind::compute};
  pass.draws = {Draw{.pipeline = pipeline,
                     .textures = {{79, texture(4), {}}},
                     .buffers = {{304, out, BindingKind::storage_buffer},
                                 {301, uniform(2), BindingKind::uniform_buffer},
                                 {300, uniform(1), BindingKind::uniform_buffer}},
                     .images = {{78, texture(3), 0}}}};
  backend->run({&pass, 1}, Timing::off);
  EXPECT_EQ(values_of<float>(backend->read_buffer(out)), (std::vector<float>{1, 2, 3, 4}));

  pass.draws[0].images.clear();
  const Error error = error_of([&] { backend->run({&pass, 1}, Timing::off); });
  EXPECT_EQ(error.subject(), "compute");
  EXPECT_PRED_FORMAT2(IsSubstring, "binding 78", error.message());
}

TEST_P(OpenGl, WordsThatAreNoSpirvAreRefused) {
  const auto backend = open_backend(GetParam());
  std::vector<uint32_t> cut = compile(Stage::compute, Api::opengl, "layout(local_size_x = 1) in; void main() {}\n").spirv;
  cut.resize(6);  // within the first instruction
  for (const std::vector<uint32_t>& words : {std::vector<uint32_t>{}, std::vector<uint32_t>{1, 2, 3, 4, 5, 6}, cut}) {
    PipelineDesc desc;
    desc.name = "broken";
    desc.stages = {{Stage::compute, words}};
    const Error error = error_of([&] { backend->create_pipeline(desc); });
    EXPECT_EQ(error.kind(), ErrorKind::failed);
    EXPECT_EQ(error.subject(), "broken");
    EXPECT_PRED_FORMAT2(IsSubstring, "SPIR-V", error.message());
  }
}

TEST_P(OpenGl, CheckerSpeaksOnlyWhenSomethingIsWrong) {
  const auto backend = open_backend(GetParam(), {.validation = true});
  expect_alive(*backend);
  EXPECT_TRUE(backend->take_messages().empty());

  // OpenGL 4.5, section 8.14.4: no mipmaps of integer textures.
  Pass wrong{.name = "integer mips", .kind = PassKind::mips};
  wrong.mips_of = backend->create_texture({.name = "ids", .width = 2, .height = 2, .levels = 2, .format = Format::r32_uint});
  const Error error = error_of([&] { backend->run({&wrong, 1}, Timing::off); });
  EXPECT_EQ(error.kind(), ErrorKind::failed);
  EXPECT_EQ(error.subject(), "integer mips");
  EXPECT_PRED_FORMAT2(IsSubstring, "GL_INVALID_OPERATION", error.message());
  const std::vector<std::string> messages = backend->take_messages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_PRED_FORMAT2(IsSubstring, "GL_INVALID_OPERATION", messages[0]);
  EXPECT_TRUE(backend->take_messages().empty());
  expect_alive(*backend);
}

TEST_P(OpenGl, EveryPassIsTimedOnlyWhenAsked) {
  const auto backend = open_backend(GetParam());
  const TextureId texture = backend->create_texture({.name = "t", .width = 64, .height = 64, .target = true});
  Pass pass{.name = "clear"};
  pass.colors = {{.texture = texture}};
  for (const size_t count : {3u, 1u, 5u}) {
    const std::vector<Pass> passes(count, pass);
    EXPECT_TRUE(backend->run(passes, Timing::off).pass_ms.empty());
    const RunTimes times = backend->run(passes, Timing::bracketed);
    ASSERT_EQ(times.pass_ms.size(), count);
    double sum_ms = 0;
    for (const double ms : times.pass_ms) {
      EXPECT_GT(ms, 0);
      sum_ms += ms;
    }
    EXPECT_LE(sum_ms, times.wall_ms) << "the passes lie one after another within the frame";
  }
}

}  // namespace
}  // namespace lamina
