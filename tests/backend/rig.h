// SPDX-License-Identifier: Apache-2.0
// What the conformance tests share: a fixture that runs over every backend, with the API's checker on and listened to, and
// short ways to make shaders, pipelines, targets and passes. A test of this fixture runs on every backend that opens here;
// where one does not open, its tests are skipped and say why.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "harness/backend/backend.h"
#include "harness/core/srgb.h"
#include "tests/open_backend.h"
#include "tests/shader/shader_files.h"

namespace lamina {

// A fragment shader that paints all it covers.
inline constexpr const char* white = "layout(location = 0) out vec4 c; void main() { c = vec4(1); }";
// Filter weights may have as few as 8 bits (Vulkan 1.3, limits subTexelPrecisionBits and mipmapPrecisionBits are at least 4;
// every device of interest has 8).
inline constexpr float weight_step = 1.0f / 256;

template <class T>
std::vector<std::byte> bytes_of(const std::vector<T>& values) {
  std::vector<std::byte> bytes(values.size() * sizeof(T));
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

template <class T>
std::vector<T> values_of(const std::vector<std::byte>& bytes) {
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}

// IEC 61966-2-1.
inline double srgb_decoded(double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); }
inline double srgb_encoded(double l) { return l <= 0.0031308 ? l * 12.92 : 1.055 * std::pow(l, 1 / 2.4) - 0.055; }

// A triangle over the whole target, at depth `z`.
inline constexpr const char* full_screen = R"(
layout(constant_id = 100) const float z = 0.5;
void main() {
  vec2 corner = vec2(LAMINA_VERTEX_INDEX == 1 ? 3 : -1, LAMINA_VERTEX_INDEX == 2 ? 3 : -1);
  gl_Position = vec4(corner, z, 1);
}
)";
inline SpecConstant depth_at(float z) { return {100, std::bit_cast<uint32_t>(z)}; }

// How a test's pipeline draws; what it binds and reads is taken from its shaders.
struct Look {
  std::vector<Format> colors = {Format::rgba32_float};
  std::optional<Format> depth_format = {};
  Depth depth = Depth::none;
  DepthTest depth_test = DepthTest::less_equal;
  std::vector<Blend> blend = {};
  Cull cull = Cull::none;
  std::vector<SpecConstant> constants = {};
};

// A picture as floats, `channels` a pixel.
struct Floats {
  uint32_t width = 0, channels = 4;
  std::vector<float> values;
  float at(uint32_t x, uint32_t y, uint32_t channel = 0) const {
    return values.at((size_t{y} * width + x) * channels + channel);
  }
};

class BackendTest : public ShaderFiles, public ::testing::WithParamInterface<std::string_view> {
 protected:
  void SetUp() override { open(GetParam()); }
  void TearDown() override { expect_silence(); }

  // Opens a backend, or skips the test where it has no device.
  void open(std::string_view name) {
    std::string missing;
    backend_ = open_or_say(name, missing, {.device = "", .validation = true});
    if (!backend_) GTEST_SKIP() << missing;
  }
  void expect_silence() {
    if (!backend_) return;
    for (const std::string& message : backend_->take_messages()) ADD_FAILURE() << "the API's checker says: " << message;
  }
  void close() {
    expect_silence();
    backend_.reset();
  }
  Backend& backend() { return *backend_; }

  CompiledShader shader(Stage stage, std::string_view body) { return compile(stage, backend().info().api, body); }

  PipelineId pipeline(std::string_view vertex, std::string_view fragment, const Look& look = {}) {
    PipelineDesc desc{.name = "test pipeline",
                      .constants = look.constants,
                      .colors = look.colors,
                      .depth_format = look.depth_format,
                      .blend = look.blend,
                      .depth = look.depth,
                      .depth_test = look.depth_test,
                      .cull = look.cull};
    const CompiledShader vertex_shader = shader(Stage::vertex, vertex);
    add_stage(desc, vertex_shader);
    add_stage(desc, shader(Stage::fragment, fragment));
    desc.vertex_locations = vertex_shader.reflection.input_locations;
    return backend().create_pipeline(desc);
  }
  PipelineId compute(std::string_view source, std::vector<SpecConstant> constants = {}) {
    PipelineDesc desc{.name = "test compute", .constants = std::move(constants)};
    add_stage(desc, shader(Stage::compute, source));
    return backend().create_pipeline(desc);
  }

  TextureId target(Format format, uint32_t width, uint32_t height, uint32_t levels = 1) {
    return backend().create_texture(
        {.name = "test target", .width = width, .height = height, .levels = levels, .format = format, .target = true});
  }
  // A texture of one level with these texels.
  template <class T>
  TextureId texture(Format format, uint32_t width, uint32_t height, const std::vector<T>& texels) {
    const std::vector<std::vector<std::byte>> levels = {bytes_of(texels)};
    return backend().create_texture({.name = "test texture", .width = width, .height = height, .format = format}, levels);
  }
  template <class T>
  BufferId buffer(BufferUse use, const std::vector<T>& values) {
    return backend().create_buffer("test buffer", use, values.size() * sizeof(T), bytes_of(values));
  }
  template <class T>
  std::vector<T> read(BufferId id) {
    return values_of<T>(backend().read_buffer(id));
  }
  template <class T>
  std::vector<T> read(TextureId id, uint32_t level = 0) {
    return values_of<T>(backend().read_texture(id, level));
  }
  // Of an rgba32_float or (channels = 1) r32_float or d32_float texture.
  Floats picture(TextureId id, uint32_t width, uint32_t channels = 4, uint32_t level = 0) {
    return {width, channels, read<float>(id, level)};
  }

  static Pass raster(TextureId color, std::vector<Draw> draws, Load load = Load::clear) {
    Pass pass{.name = "test pass", .draws = std::move(draws)};
    pass.colors = {{.texture = color, .load = load}};
    return pass;
  }
  static Draw triangles(PipelineId pipeline, uint32_t vertices = 3) { return {.pipeline = pipeline, .count = vertices}; }
  RunTimes run(const std::vector<Pass>& passes, Timing timing = Timing::off) { return backend().run(passes, timing); }

  // Draws `fragment` over a new rgba32_float target and returns what it wrote.
  Floats draw_over(uint32_t width, uint32_t height, std::string_view fragment, Draw draw = {}) {
    const TextureId over = target(Format::rgba32_float, width, height);
    draw.pipeline = pipeline(full_screen, fragment);
    draw.count = 3;
    run({raster(over, {draw})});
    Floats result = picture(over, width);
    backend().destroy(over);
    backend().destroy(draw.pipeline);
    return result;
  }

 private:
  static void add_stage(PipelineDesc& desc, const CompiledShader& shader) {
    desc.stages.push_back({shader.stage, shader.spirv});
    for (const ShaderResource& resource : shader.reflection.resources) {
      const BindingSlot slot = resource.slot();
      if (std::find(desc.bindings.begin(), desc.bindings.end(), slot) == desc.bindings.end()) desc.bindings.push_back(slot);
    }
  }

  std::unique_ptr<Backend> backend_;
};

// Runs every TEST_P of `Suite` over every backend.
#define LAMINA_ON_EVERY_BACKEND(Suite)                                            \
  INSTANTIATE_TEST_SUITE_P(Backends, Suite, ::testing::ValuesIn(backend_names()), \
                           [](const auto& case_of) { return std::string(case_of.param); })

}  // namespace lamina
