// SPDX-License-Identifier: Apache-2.0
// Runs a shader as it is and in its counting build, on a backend that the test names, and gives back both pictures and the
// counts.
#pragma once

#include <algorithm>
#include <cstring>
#include <memory>
#include <optional>

#include "tests/open_backend.h"
#include "tests/shader/shader_files.h"

namespace lamina {

inline constexpr uint32_t run_width_px = 64, run_height_px = 48;
inline constexpr uint32_t counter_binding = 15;

// One triangle that covers the whole target.
inline constexpr std::string_view full_screen = R"(
void main() { gl_Position = vec4(LAMINA_VERTEX_INDEX == 1 ? 3 : -1, LAMINA_VERTEX_INDEX == 2 ? 3 : -1, 0, 1); }
)";

struct RunSetup {
  std::string_view vertex = full_screen;
  std::string_view fragment;
  uint32_t vertices = 3;
  bool depth = false;                   // test and write depth, less or equal, from a clear of 1
  std::vector<SpecConstant> constants;  // of both stages
  std::vector<uint32_t> preset;         // of the counter buffer's first words
  bool count_vertex = false;            // count in the vertex stage instead of the fragment stage
  Filter filter = Filter::trilinear;    // of all textures
};

struct Counts {
  uint64_t invocations = 0;
  std::map<uint32_t, uint64_t> fetches;     // by binding
  std::map<uint32_t, uint64_t> unfiltered;  // likewise
  std::map<uint32_t, std::vector<uint64_t>> levels;
  std::map<std::string, uint64_t> operations;  // by class
  std::map<std::string, uint64_t> issued;      // likewise
  std::map<uint32_t, uint64_t> issued_fetches;
  std::map<uint32_t, LineWork> lines;  // by line of the one file
  std::vector<uint32_t> coverage;      // a word a pixel
  bool early_fragment_tests = false;
  std::vector<float> picture;  // RGBA of the counting build

  uint64_t covered() const {
    return static_cast<uint64_t>(std::ranges::count_if(coverage, [](uint32_t n) { return n != 0; }));
  }
};

// Every 2D texture that a shader binds is 16 x 16, with a full mip chain and texels that differ; every 3D one 16 x 8 x 2.
class CountingRun : public ShaderFiles, public ::testing::WithParamInterface<std::string_view> {
 protected:
  void SetUp() override {
    std::string missing;
    backend_ = open_or_say(GetParam(), missing, {.device = "", .validation = true});
    if (!backend_) GTEST_SKIP() << missing;
    TextureDesc desc{.name = "texture", .width = 16, .height = 16, .levels = 5, .format = Format::rgba8_unorm};
    std::vector<std::vector<std::byte>> levels;
    for (size_t size = 16; size > 0; size /= 2) {
      std::vector<std::byte> texels(size * size * 4);
      for (size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<std::byte>(i * 37 + size);
      levels.push_back(std::move(texels));
    }
    texture_ = backend_->create_texture(desc, levels);
    desc = {.name = "volume", .width = 16, .height = 8, .format = Format::rgba8_unorm, .depth = 2};
    volume_ = backend_->create_texture(desc, std::span(levels).first(1));
  }
  void TearDown() override {
    if (backend_ == nullptr) return;
    for (const std::string& message : backend_->take_messages()) ADD_FAILURE() << message;
  }

  Backend& backend() { return *backend_; }
  Api api() const { return backend_->info().api; }
  TextureId texture() const { return texture_; }

  // Renders the plain and the counting build, and fails the test unless their pictures are the same bits.
  Counts run(const RunSetup& setup) {
    const CompiledShader vertex = compile(Stage::vertex, api(), setup.vertex);
    const CompiledShader fragment = compile(Stage::fragment, api(), setup.fragment);
    const CompiledShader& counted = setup.count_vertex ? vertex : fragment;
    filter_ = setup.filter;
    CountingLayout layout{.binding = counter_binding, .textures = leveled(counted)};
    layout.coverage_word = 2 + add_counters(counted, api(), layout).words();
    const CountingShader counting = add_counters(counted, api(), layout);
    const uint32_t coverage_word = layout.coverage_word;

    const std::vector<float> plain = draw(setup, vertex, fragment, vertex.spirv, fragment.spirv, {});
    std::vector<uint32_t> words(coverage_word + run_width_px * run_height_px);
    std::ranges::copy(setup.preset, words.begin());
    words[0] = run_width_px;
    const BufferId buffer = make_counters(words);
    Counts counts;
    counts.picture = setup.count_vertex ? draw(setup, vertex, fragment, counting.spirv, fragment.spirv, buffer)
                                        : draw(setup, vertex, fragment, vertex.spirv, counting.spirv, buffer);
    EXPECT_EQ(std::memcmp(plain.data(), counts.picture.data(), plain.size() * sizeof(float)), 0)
        << "counting changed the picture";
    words = read_words(buffer);
    take_counts(counts, words, counting);
    counts.coverage.assign(words.begin() + coverage_word, words.end());
    return counts;
  }

  // Dispatches a compute shader's counting build, without storage of its own but what `buffers` binds.
  Counts dispatch(std::string_view source, std::array<uint32_t, 3> groups) {
    const CompiledShader shader = compile(Stage::compute, api(), source);
    const CountingShader counting = add_counters(shader, api(), {.binding = counter_binding, .textures = leveled(shader)});
    PipelineDesc desc{.name = "counted compute"};
    desc.stages = {{Stage::compute, counting.spirv}};
    Draw draw;
    bind(desc, draw, shader.reflection);
    const BufferId buffer = make_counters(std::vector<uint32_t>(2 + counting.words()));
    bind_counters(desc, draw, buffer);
    draw.pipeline = backend_->create_pipeline(desc);
    draw.groups = groups;
    Pass pass{.name = "count", .kind = PassKind::compute};
    pass.draws = {draw};
    backend_->run({&pass, 1}, Timing::off);
    Counts counts;
    take_counts(counts, read_words(buffer), counting);
    return counts;
  }

  // The textures of a shader, as bind() binds them.
  LeveledTextures leveled(const CompiledShader& shader) const {
    LeveledTextures textures;
    for (const ShaderResource& r : shader.reflection.resources)
      if (r.kind == BindingKind::texture)
        textures[r.binding] = r.dimensions == 3 ? LeveledTexture{1, filter_ == Filter::trilinear, {16, 8, 2}}
                                                : LeveledTexture{5, filter_ == Filter::trilinear, {16, 16, 1}};
    return textures;
  }

  BufferId make_counters(const std::vector<uint32_t>& words) {
    const BufferId buffer = backend_->create_buffer("counters", BufferUse::storage, words.size() * sizeof(uint32_t));
    backend_->write_buffer(buffer, std::as_bytes(std::span(words)));
    return buffer;
  }

  std::vector<uint32_t> read_words(BufferId buffer) {
    const std::vector<std::byte> bytes = backend_->read_buffer(buffer);
    std::vector<uint32_t> words(bytes.size() / sizeof(uint32_t));
    std::memcpy(words.data(), bytes.data(), bytes.size());
    return words;
  }

  static uint64_t counter_at(const std::vector<uint32_t>& words, size_t word) {
    return words[word] | static_cast<uint64_t>(words[word + 1]) << 32;
  }

  // What a stage did whose counters begin at `first_word`.
  static ShaderWork work_of(const std::vector<uint32_t>& words, const CountingShader& counting, size_t first_word,
                            bool issued = false) {
    std::vector<uint64_t> blocks(counting.counters());
    for (size_t i = 0; i < blocks.size(); ++i) blocks[i] = counter_at(words, first_word + 2 + 2 * i);
    const uint64_t invocations = counter_at(words, first_word);
    return issued ? counting.work.issued(invocations, blocks) : counting.work.executed(invocations, blocks);
  }

  static void bind_counters(PipelineDesc& desc, Draw& draw, BufferId buffer) {
    desc.bindings.push_back({counter_binding, BindingKind::storage_buffer});
    draw.buffers.push_back({counter_binding, buffer, BindingKind::storage_buffer});
  }

  // Binds `reflection`'s textures to the one texture of their dimensions, and its storage blocks to a buffer of their own.
  void bind(PipelineDesc& desc, Draw& draw, const Reflection& reflection) {
    for (const ShaderResource& r : reflection.resources) {
      desc.bindings.push_back(r.slot());
      if (r.kind == BindingKind::texture)
        draw.textures.push_back({r.binding, r.dimensions == 3 ? volume_ : texture_, Sampler{filter_, Wrap::repeat}});
      if (r.kind == BindingKind::storage_buffer) {
        const std::vector<std::byte> zeros(1024);
        draw.buffers.push_back(
            {r.binding, backend_->create_buffer("storage", BufferUse::storage, zeros.size(), zeros), r.kind});
      }
    }
  }

  std::vector<float> draw(const RunSetup& setup, const CompiledShader& vertex, const CompiledShader& fragment,
                          const std::vector<uint32_t>& vertex_spirv, const std::vector<uint32_t>& fragment_spirv,
                          BufferId counters) {
    PipelineDesc desc{.name = counters ? "counted" : "plain"};
    desc.stages = {{Stage::vertex, vertex_spirv}, {Stage::fragment, fragment_spirv}};
    desc.constants = setup.constants;
    desc.colors = {Format::rgba32_float};
    if (setup.depth) desc.depth_format = Format::d32_float, desc.depth = Depth::read_write;
    Draw draw;
    bind(desc, draw, vertex.reflection);
    bind(desc, draw, fragment.reflection);
    if (counters) bind_counters(desc, draw, counters);
    draw.pipeline = backend_->create_pipeline(desc);
    draw.count = setup.vertices;

    Pass pass{.name = desc.name};
    pass.colors = {{.texture = make_target(Format::rgba32_float)}};
    if (setup.depth) pass.depth = Attachment{.texture = make_target(Format::d32_float), .clear = {1, 0, 0, 0}};
    pass.draws = {draw};
    backend_->run({&pass, 1}, Timing::off);
    const std::vector<std::byte> bytes = backend_->read_texture(pass.colors[0].texture);
    std::vector<float> picture(bytes.size() / sizeof(float));
    std::memcpy(picture.data(), bytes.data(), bytes.size());
    return picture;
  }

 private:
  TextureId make_target(Format format) {
    return backend_->create_texture(
        {.name = "target", .width = run_width_px, .height = run_height_px, .levels = 1, .format = format, .target = true});
  }

  static void take_counts(Counts& counts, const std::vector<uint32_t>& words, const CountingShader& counting) {
    counts.invocations = counter_at(words, 2);
    const ShaderWork work = work_of(words, counting, 2);
    counts.fetches = work.fetches;
    counts.unfiltered = work.unfiltered;
    counts.levels = work.levels;
    counts.operations = work.operations.by_name();
    const ShaderWork issued = work_of(words, counting, 2, true);
    counts.issued = issued.operations.by_name();
    counts.issued_fetches = issued.fetches;
    for (const auto& [line, done] : work.lines) counts.lines[line.line].add(done);
    counts.early_fragment_tests = counting.early_fragment_tests;
  }

  std::unique_ptr<Backend> backend_;
  TextureId texture_, volume_;
  Filter filter_ = Filter::trilinear;
};

}  // namespace lamina
