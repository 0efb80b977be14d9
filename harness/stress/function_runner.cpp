// SPDX-License-Identifier: Apache-2.0
#include "harness/stress/function_runner.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>

#include "harness/shader/shader.h"

namespace lamina {
namespace {

// As in shaders/stress/function.glsl.
constexpr uint32_t group_size = 64, points_binding = 0, values_binding = 1, work_binding = 2, first_table_binding = 3;

constexpr double long_run_ms = 40;  // of the timed runs; the short ones make an eighth of the calls
constexpr int max_calls = 1 << 16;

TextureId make_texture(Backend& backend, const TextureImage& image) {
  const TextureDesc desc{
      .name = image.name, .width = image.width, .height = image.height, .format = image.format, .depth = image.depth};
  return backend.create_texture(desc, image.levels);
}

// "CAP_TABLE_BINDING", for a table "cap_table".
std::string binding_definition(std::string table) {
  std::ranges::transform(table, table.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return table + "_BINDING";
}

ShaderRequest request_of(Api api, const std::filesystem::path& shaders, const Family& family, const std::string& function) {
  std::vector<std::string> arguments;
  for (size_t i = 0; i < family.inputs.size(); ++i) arguments.push_back(fmt::format("x[{}]", i));
  ShaderRequest request{.file = family.shader, .stage = Stage::compute, .api = api, .include_dirs = {shaders}};
  request.defines = {{family.definition, function},
                     {"FUNCTION_INPUTS", std::to_string(arguments.size())},
                     {"FUNCTION_CALL", fmt::format("{}({})", family.function, fmt::join(arguments, ", "))}};
  for (size_t i = 0; i < family.tables.size(); ++i)
    request.defines[binding_definition(family.tables[i].name)] = std::to_string(first_table_binding + i);
  return request;
}

}  // namespace

FunctionRunner::FunctionRunner(Backend& backend, const std::filesystem::path& shaders, const Family& family,
                               const std::string& function)
    : backend_(backend) {
  const CompiledShader compute = compile_shader(request_of(backend.info().api, shaders, family, function));
  PipelineDesc desc;
  desc.name = function;
  desc.stages = {{Stage::compute, compute.spirv}};
  for (const ShaderResource& resource : compute.reflection.resources) {
    desc.bindings.push_back(resource.slot());
    if (resource.binding < first_table_binding) continue;
    const auto table = std::ranges::find(family.tables, resource.name, &FamilyTable::name);
    if (resource.kind != BindingKind::texture || table == family.tables.end())
      throw Error(ErrorKind::bad_input, "stress", family.shader.string(),
                  fmt::format("{} reads '{}', which is no texture that {} has in 'tables'", function, resource.name,
                              family.file.string()));
    tables_.push_back({resource.binding, make_texture(backend, table->make())});
  }
  pipeline_ = backend.create_pipeline(desc);
  work_ = backend.create_buffer(family.name + " work", BufferUse::uniform, 4 * sizeof(int32_t));
}

FunctionRunner::~FunctionRunner() {
  for (const BufferId buffer : {points_, values_, work_})
    if (buffer) backend_.destroy(buffer);
  for (const Table& table : tables_) backend_.destroy(table.texture);
  backend_.destroy(pipeline_);
}

std::vector<float> FunctionRunner::values(const Points& points) {
  for (const BufferId buffer : {points_, values_})
    if (buffer) backend_.destroy(buffer);
  count_ = points.size();
  const std::span<const float> numbers = points.numbers();
  points_ = backend_.create_buffer("points", BufferUse::storage, numbers.size_bytes(), std::as_bytes(numbers));
  values_ = backend_.create_buffer("values", BufferUse::storage, count_ * sizeof(float));
  run(1, Timing::off);
  const std::vector<std::byte> bytes = backend_.read_buffer(values_);
  std::vector<float> values(count_);
  std::memcpy(values.data(), bytes.data(), count_ * sizeof(float));
  return values;
}

double FunctionRunner::time_ms(int calls) { return run(calls, Timing::bracketed).pass_ms.front(); }

RunTimes FunctionRunner::run(int calls, Timing timing) {
  const std::array<int32_t, 4> work = {static_cast<int32_t>(count_), calls, 0, 0};
  backend_.write_buffer(work_, std::as_bytes(std::span(work)));
  Pass pass;
  pass.name = "functions";
  pass.kind = PassKind::compute;
  Draw draw;
  draw.pipeline = pipeline_;
  draw.buffers = {{points_binding, points_, BindingKind::storage_buffer},
                  {values_binding, values_, BindingKind::storage_buffer},
                  {work_binding, work_, BindingKind::uniform_buffer}};
  for (const Table& table : tables_) draw.textures.push_back({table.binding, table.texture, {Filter::linear, Wrap::clamp}});
  draw.groups = {(static_cast<uint32_t>(count_) + group_size - 1) / group_size, 1, 1};
  pass.draws = {draw};
  return backend_.run({&pass, 1}, timing);
}

std::vector<std::vector<double>> nanoseconds_per_call(std::span<FunctionRunner* const> runners, size_t rounds, uint64_t seed) {
  std::vector<Arm> arms;  // of each runner a long one and a short one
  std::vector<double> calls_apart;
  for (FunctionRunner* runner : runners) {
    int calls = 8;
    while (runner->time_ms(calls) < long_run_ms && calls < max_calls) calls *= 2;
    for (const int of_arm : {calls, calls / 8})
      arms.push_back({[runner, of_arm] { return FrameTimes{{runner->time_ms(of_arm)}, 0}; }, std::nullopt});
    calls_apart.push_back((calls - calls / 8) * static_cast<double>(runner->points()));
  }
  RoundOptions options;
  options.min_rounds = options.max_rounds = rounds;
  options.seed = seed;
  const RoundsResult result = run_rounds(arms, options);
  std::vector<std::vector<double>> all;
  for (size_t i = 0; i < runners.size(); ++i) {
    const ArmSamples &many = result.arms[2 * i], &few = result.arms[2 * i + 1];
    if (const std::string& failure = many.failure.empty() ? few.failure : many.failure; !failure.empty())
      throw Error(ErrorKind::failed, "stress", "timing", failure);
    std::vector<double>& ns = all.emplace_back();
    for (size_t round = 0; round < rounds; ++round)
      ns.push_back((many.frame_ms[round] - few.frame_ms[round]) * 1e6 / calls_apart[i]);
  }
  return all;
}

}  // namespace lamina
