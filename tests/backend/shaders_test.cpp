// SPDX-License-Identifier: Apache-2.0
// What shaders are given and may write: uniform blocks, storage buffers in every stage, storage images, constants, vertices.
#include "tests/backend/rig.h"

namespace lamina {
namespace {

using BackendShaders = BackendTest;
LAMINA_ON_EVERY_BACKEND(BackendShaders);

TEST_P(BackendShaders, UniformBlockIsReadAsStd140LaysItOut) {
  // float at byte 0, vec3 at 16, mat2 at 32 with its columns 16 apart, vec4 at 64.
  std::vector<float> block(20, 0);
  block[0] = 1;
  block[4] = 2, block[5] = 3, block[6] = 4;
  block[8] = 5, block[9] = 6, block[12] = 7, block[13] = 8;
  block[16] = 9;
  constexpr const char* fragment = R"(
layout(std140, binding = 4) uniform Block { float scalar; vec3 vector; mat2 matrix; vec4 last; };
layout(location = 0) out vec4 c;
void main() { c = vec4(scalar, vector.z, matrix[1][0], last.x); })";
  const BufferId uniform = buffer(BufferUse::uniform, block);
  Draw draw;
  draw.buffers = {{.binding = 4, .buffer = uniform, .kind = BindingKind::uniform_buffer}};
  EXPECT_EQ(draw_over(1, 1, fragment, draw).values, (std::vector<float>{1, 4, 7, 9}));
  backend().write_buffer(uniform, bytes_of(std::vector<float>{-1}));
  EXPECT_EQ(draw_over(1, 1, fragment, draw).values, (std::vector<float>{-1, 4, 7, 9}))
      << "written from the start, the rest kept";
}

TEST_P(BackendShaders, DrawsOfOnePassReadTheirOwnBuffers) {
  const PipelineId add = pipeline(full_screen, R"(
layout(std140, binding = 0) uniform Block { vec4 value; };
layout(location = 0) out vec4 c;
void main() { c = value; })",
                                  {.blend = {Blend::additive}});
  std::vector<Draw> draws;
  for (int i = 0; i < 40; ++i) {
    draws.push_back(triangles(add));
    draws.back().buffers = {{.binding = 0, .buffer = buffer<float>(BufferUse::uniform, {float(i), 1, 0, 0})}};
  }
  const TextureId id = target(Format::rgba32_float, 1, 1);
  run({raster(id, draws)});
  EXPECT_EQ(read<float>(id), (std::vector<float>{780, 40, 0, 0}));  // 0 + 1 + ... + 39
}

TEST_P(BackendShaders, EveryBufferUseComesBackAsItWent) {
  for (const BufferUse use : {BufferUse::vertex, BufferUse::index, BufferUse::uniform, BufferUse::storage}) {
    const BufferId id = buffer<uint32_t>(use, {1, 2, 3, 4});
    EXPECT_EQ(read<uint32_t>(id), (std::vector<uint32_t>{1, 2, 3, 4})) << static_cast<int>(use);
    backend().write_buffer(id, bytes_of(std::vector<uint32_t>{9, 8}));
    EXPECT_EQ(read<uint32_t>(id), (std::vector<uint32_t>{9, 8, 3, 4})) << static_cast<int>(use);
  }
}

TEST_P(BackendShaders, VertexStageWritesAStorageBuffer) {
  const BufferId out = buffer(BufferUse::storage, std::vector<uint32_t>(5, 0));
  Draw draw = triangles(pipeline(R"(
layout(std430, binding = 1) buffer Out { uint seen[]; };
void main() {
  seen[LAMINA_VERTEX_INDEX] = uint(LAMINA_VERTEX_INDEX) + 10u;
  gl_Position = vec4(0, 0, 0, 1);
})",
                                 "layout(location = 0) out vec4 c; void main() { c = vec4(1); }"));
  draw.buffers = {{.binding = 1, .buffer = out, .kind = BindingKind::storage_buffer}};
  run({raster(target(Format::rgba32_float, 1, 1), {draw})});
  EXPECT_EQ(read<uint32_t>(out), (std::vector<uint32_t>{10, 11, 12, 0, 0}));
}

TEST_P(BackendShaders, FragmentStageCountsEveryPixelOnce) {
  const BufferId out = buffer(BufferUse::storage, std::vector<uint32_t>(2 + 7 * 5, 0));
  Draw draw;
  draw.buffers = {{.binding = 0, .buffer = out, .kind = BindingKind::storage_buffer}};
  draw_over(7, 5, R"(
layout(std430, binding = 0) buffer Out { uint total; uint unused; uint at[]; };
layout(location = 0) out vec4 c;
void main() {
  atomicAdd(total, 1u);
  atomicAdd(at[int(gl_FragCoord.y) * 7 + int(gl_FragCoord.x)], 1u);
  c = vec4(0);
})",
            draw);
  std::vector<uint32_t> expected(2 + 7 * 5, 1);
  expected[0] = 35, expected[1] = 0;
  EXPECT_EQ(read<uint32_t>(out), expected);
}

TEST_P(BackendShaders, ComputeStageWritesAndLaterDispatchesSeeIt) {
  const BufferId numbers = buffer(BufferUse::storage, std::vector<uint32_t>(64, 0));
  const PipelineId square = compute(R"(
layout(local_size_x = 16) in;
layout(std430, binding = 0) buffer Out { uint n[]; };
void main() { n[gl_GlobalInvocationID.x] += gl_GlobalInvocationID.x * gl_GlobalInvocationID.x; })");
  const PipelineId reverse_sum = compute(R"(
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Out { uint n[]; };
void main() { uint sum = 0; for (int i = 0; i < 64; ++i) sum += n[i]; n[0] = sum; })");
  const auto dispatch = [&](PipelineId pipeline, uint32_t groups) {
    Draw draw{.pipeline = pipeline, .groups = {groups, 1, 1}};
    draw.buffers = {{.binding = 0, .buffer = numbers, .kind = BindingKind::storage_buffer}};
    return draw;
  };
  run({{.name = "both", .kind = PassKind::compute, .draws = {dispatch(square, 4), dispatch(reverse_sum, 1)}}});
  const auto result = read<uint32_t>(numbers);
  EXPECT_EQ(result[63], 63u * 63);
  EXPECT_EQ(result[0], 63u * 64 * 127 / 6);  // the sum of squares
}

TEST_P(BackendShaders, StorageImageIsWrittenReadAndSampled) {
  const TextureDesc desc{
      .name = "image", .width = 8, .height = 8, .levels = 2, .format = Format::rgba32_float, .target = false, .storage = true};
  const TextureId image = backend().create_texture(desc);
  Draw write{.pipeline = compute(R"(
layout(local_size_x = 4, local_size_y = 4) in;
layout(rgba32f, binding = 0) uniform writeonly image2D image;
void main() { ivec2 p = ivec2(gl_GlobalInvocationID.xy); imageStore(image, p, vec4(p, 0, 1)); })"),
             .groups = {2, 2, 1}};
  write.images = {{.binding = 0, .texture = image}};
  Draw halve{.pipeline = compute(R"(
layout(local_size_x = 4, local_size_y = 4) in;
layout(rgba32f, binding = 1) uniform readonly image2D from;
layout(rgba32f, binding = 0) uniform writeonly image2D to;
void main() { ivec2 p = ivec2(gl_GlobalInvocationID.xy); imageStore(to, p, imageLoad(from, p * 2) + vec4(0, 0, 5, 0)); })")};
  halve.images = {{.binding = 1, .texture = image}, {.binding = 0, .texture = image, .level = 1}};
  run({{.name = "write", .kind = PassKind::compute, .draws = {write}},
       {.name = "halve", .kind = PassKind::compute, .draws = {halve}}});
  const Floats half = picture(image, 4, 4, 1);
  EXPECT_EQ(half.at(3, 1, 0), 6);
  EXPECT_EQ(half.at(3, 1, 1), 2);
  EXPECT_EQ(half.at(3, 1, 2), 5);

  Draw look;
  look.textures = {{.binding = 0, .texture = image, .sampler = {.filter = Filter::nearest}}};
  EXPECT_EQ(draw_over(1, 1, R"(
layout(binding = 0) uniform sampler2D t;
layout(location = 0) out vec4 c;
void main() { c = texelFetch(t, ivec2(6, 3), 0); })",
                      look)
                .values,
            (std::vector<float>{6, 3, 0, 1}));
}

TEST_P(BackendShaders, StorageImagesOfSeveralFormats) {
  const auto stored = [&](Format format, const std::string& declared, const std::string& value) {
    const TextureId image = backend().create_texture(
        {.name = "image", .width = 1, .height = 1, .format = format, .target = false, .storage = true});
    Draw write{.pipeline = compute("layout(local_size_x = 1) in;\nlayout(binding = 0, " + declared +
                                   " image;\nvoid main() { imageStore(image, ivec2(0), " + value + "); }")};
    write.images = {{.binding = 0, .texture = image}};
    run({{.name = "write", .kind = PassKind::compute, .draws = {write}}});
    return backend().read_texture(image);
  };
  EXPECT_EQ(stored(Format::r32_float, "r32f) uniform writeonly image2D", "vec4(0.1)"), bytes_of<float>({0.1f}));
  EXPECT_EQ(stored(Format::r32_uint, "r32ui) uniform writeonly uimage2D", "uvec4(4000000000u)"),
            bytes_of<uint32_t>({4000000000u}));
  EXPECT_EQ(stored(Format::rgba8_unorm, "rgba8) uniform writeonly image2D", "vec4(0, 0.2, 0.4, 1)"),
            bytes_of<uint8_t>({0, 51, 102, 255}));
  EXPECT_EQ(stored(Format::rgba16_float, "rgba16f) uniform writeonly image2D", "vec4(0.5, 1, -2, 4)"),
            bytes_of<uint16_t>({0x3800, 0x3c00, 0xc000, 0x4400}));
}

TEST_P(BackendShaders, SpecializationConstantsReplaceTheirDefaultsByTheirIds) {
  constexpr const char* fragment = R"(
layout(constant_id = 3) const int a = 1;
layout(constant_id = 7) const float b = 2.5;
layout(constant_id = 5) const bool d = false;
layout(constant_id = 9) const uint e = 4u;
layout(location = 0) out vec4 c;
void main() { c = vec4(a, b, d ? 1 : 0, e); })";
  const auto drawn = [&](std::vector<SpecConstant> constants) {
    const TextureId id = target(Format::rgba32_float, 1, 1);
    run({raster(id, {triangles(pipeline(full_screen, fragment, {.constants = std::move(constants)}))})});
    return read<float>(id);
  };
  EXPECT_EQ(drawn({}), (std::vector<float>{1, 2.5f, 0, 4}));
  EXPECT_EQ(drawn({{7, std::bit_cast<uint32_t>(-0.75f)}, {3, static_cast<uint32_t>(-8)}, {5, 1}, {9, 1u << 20}}),
            (std::vector<float>{-8, -0.75f, 1, 1 << 20}));
  EXPECT_EQ(drawn({{5, 1}, depth_at(0.25f)}), (std::vector<float>{1, 2.5f, 1, 4})) << "each stage takes those that it has";
}

class BackendMeshes : public BackendTest {
 protected:
  struct Mesh {
    BufferId vertices, indices;
  };
  // Two triangles over the target by six indices into four vertices; uv runs from 0 to 1, the rest is the same everywhere.
  Mesh quad() {
    std::vector<float> vertices;
    for (const auto& [x, y] : {std::pair{-1.0f, -1.0f}, {-1.0f, 1.0f}, {1.0f, 1.0f}, {1.0f, -1.0f}})
      vertices.insert(vertices.end(), {x, y, 0.5f, 10, 20, 30, 40, 50, 60, 70, x / 2 + 0.5f, y / 2 + 0.5f});
    EXPECT_EQ(vertices.size() * sizeof(float), 4 * vertex_stride_bytes);
    return {buffer(BufferUse::vertex, vertices), buffer<uint32_t>(BufferUse::index, {0, 1, 2, 0, 2, 3})};
  }
  Floats draw(const Mesh& mesh, std::string_view vertex, std::string_view fragment) {
    const TextureId id = target(Format::rgba32_float, 8, 4);
    Draw draw{.pipeline = pipeline(vertex, fragment), .vertices = mesh.vertices, .indices = mesh.indices, .count = 6};
    run({raster(id, {draw})});
    return picture(id, 8);
  }
};
LAMINA_ON_EVERY_BACKEND(BackendMeshes);

TEST_P(BackendMeshes, EveryAttributeArrivesFromItsPlaceInTheLayout) {
  constexpr const char* vertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv;
layout(location = 0) out vec4 a;
layout(location = 1) out vec4 b;
void main() { gl_Position = vec4(position, 1); a = vec4(normal, tangent.x); b = vec4(tangent.yzw, uv.x + 10 * uv.y); })";
  const Floats first = draw(quad(), vertex, R"(
layout(location = 0) in vec4 a;
layout(location = 0) out vec4 c;
void main() { c = a; })");
  const Floats second = draw(quad(), vertex, R"(
layout(location = 1) in vec4 b;
layout(location = 0) out vec4 c;
void main() { c = b; })");
  for (uint32_t y = 0; y < 4; ++y)
    for (uint32_t x = 0; x < 8; ++x) {
      for (uint32_t i = 0; i < 4; ++i) EXPECT_NEAR(first.at(x, y, i), 10 * (i + 1), 1e-4);
      for (uint32_t i = 0; i < 3; ++i) EXPECT_NEAR(second.at(x, y, i), 50 + 10 * i, 1e-4);
      EXPECT_NEAR(second.at(x, y, 3), (x + 0.5) / 8 + 10 * (y + 0.5) / 4, 1e-4);
    }
}

TEST_P(BackendMeshes, ShaderTakesOnlyTheLocationsThatItNames) {
  const Floats drawn = draw(quad(), R"(
layout(location = 3) in vec2 uv;
layout(location = 0) out vec2 at;
void main() { gl_Position = vec4(uv * 2 - 1, 0, 1); at = uv; })",
                            R"(
layout(location = 0) in vec2 at;
layout(location = 0) out vec4 c;
void main() { c = vec4(at, 0, 1); })");
  EXPECT_NEAR(drawn.at(7, 0, 0), 7.5 / 8, 1e-6);
  EXPECT_NEAR(drawn.at(0, 3, 1), 3.5 / 4, 1e-6);
}

TEST_P(BackendMeshes, VerticesWithoutIndicesAreTakenInTurn) {
  Mesh mesh = quad();
  mesh.indices = {};
  const TextureId id = target(Format::rgba32_float, 4, 4);
  Draw draw{.pipeline = pipeline("layout(location = 0) in vec3 position; void main() { gl_Position = vec4(position, 1); }",
                                 "layout(location = 0) out vec4 c; void main() { c = vec4(1); }"),
            .vertices = mesh.vertices,
            .count = 3};
  run({raster(id, {draw})});
  const Floats drawn = picture(id, 4);
  EXPECT_EQ(drawn.at(0, 3), 1) << "the first three vertices are the lower left half";
  EXPECT_EQ(drawn.at(3, 0), 0);
}

TEST_P(BackendMeshes, VertexBufferMayBeWrittenAgainBetweenRuns) {
  const Mesh mesh = quad();
  constexpr const char* vertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) out vec3 n;
void main() { gl_Position = vec4(position, 1); n = normal; })";
  constexpr const char* fragment =
      "layout(location = 0) in vec3 n; layout(location = 0) out vec4 c; void main() { c = n.xxxx; }";
  EXPECT_NEAR(draw(mesh, vertex, fragment).at(4, 2), 10, 1e-5);
  auto vertices = read<float>(mesh.vertices);
  for (size_t i = 3; i < vertices.size(); i += 12) vertices[i] = 11;
  backend().write_buffer(mesh.vertices, bytes_of(vertices));
  EXPECT_NEAR(draw(mesh, vertex, fragment).at(4, 2), 11, 1e-5);
}

}  // namespace
}  // namespace lamina
