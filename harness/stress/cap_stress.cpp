// SPDX-License-Identifier: Apache-2.0
#include "harness/stress/cap_stress.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "harness/caps/cap_area.h"
#include "harness/caps/cap_table.h"
#include "harness/shader/shader.h"

namespace lamina {
namespace {

constexpr uint32_t group_size = 64;  // as in caps.comp
constexpr double long_run_ms = 40;   // of the timed runs; the short ones make an eighth of the calls
constexpr int most_calls = 1 << 16;
constexpr double eps = 0x1p-23;
constexpr uint32_t table_binding = 3;

TextureId make_table(Backend& backend) {
  const TextureImage table = make_cap_table();
  TextureDesc desc{
      .name = table.name, .width = table.width, .height = table.height, .format = table.format, .depth = table.depth};
  return backend.create_texture(desc, table.levels);
}

}  // namespace

std::vector<std::string> cap_variants(const std::filesystem::path& shaders) {
  constexpr std::string_view ending = "_cap.glsl", baseline = "exact_cap";
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(shaders / "cap_intersection"))
    if (entry.path().filename().string().ends_with(ending)) names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return std::pair(a != baseline, a) < std::pair(b != baseline, b);
  });
  return names;
}

CapRunner::CapRunner(Backend& backend, const std::filesystem::path& shaders, const std::string& variant) : backend_(backend) {
  const CompiledShader compute =
      compile_shader({shaders / "stress/caps.comp",
                      Stage::compute,
                      backend.info().api,
                      {{"CAP_INTERSECTION", variant}, {"CAP_TABLE_BINDING", std::to_string(table_binding)}},
                      {shaders}});
  PipelineDesc desc;
  desc.name = variant;
  desc.stages = {{Stage::compute, compute.spirv}};
  for (const ShaderResource& resource : compute.reflection.resources) {
    desc.bindings.push_back(resource.slot());
    if (resource.kind == BindingKind::texture) table_ = make_table(backend);  // the only texture there is
  }
  pipeline_ = backend.create_pipeline(desc);
  work_ = backend.create_buffer("cap work", BufferUse::uniform, 4 * sizeof(int32_t));
}

CapRunner::~CapRunner() {
  for (const BufferId buffer : {inputs_, areas_, work_})
    if (buffer) backend_.destroy(buffer);
  if (table_) backend_.destroy(table_);
  backend_.destroy(pipeline_);
}

std::vector<float> CapRunner::areas(std::span<const CapInput> inputs) {
  for (const BufferId buffer : {inputs_, areas_})
    if (buffer) backend_.destroy(buffer);
  std::vector<std::array<float, 4>> padded;
  for (const CapInput& input : inputs) padded.push_back({input.r0, input.r1, input.d, 0});
  count_ = inputs.size();
  inputs_ = backend_.create_buffer("cap inputs", BufferUse::storage, padded.size() * sizeof(padded[0]),
                                   std::as_bytes(std::span(padded)));
  areas_ = backend_.create_buffer("cap areas", BufferUse::storage, count_ * sizeof(float));
  run(1, Timing::off);
  const std::vector<std::byte> bytes = backend_.read_buffer(areas_);
  std::vector<float> areas(count_);
  std::memcpy(areas.data(), bytes.data(), count_ * sizeof(float));
  return areas;
}

double CapRunner::time_ms(int calls) { return run(calls, Timing::bracketed).pass_ms.front(); }

RunTimes CapRunner::run(int calls, Timing timing) {
  const std::array<int32_t, 4> work = {static_cast<int32_t>(count_), calls, 0, 0};
  backend_.write_buffer(work_, std::as_bytes(std::span(work)));
  Pass pass;
  pass.name = "caps";
  pass.kind = PassKind::compute;
  Draw draw;
  draw.pipeline = pipeline_;
  draw.buffers = {{0, inputs_, BindingKind::storage_buffer},
                  {1, areas_, BindingKind::storage_buffer},
                  {2, work_, BindingKind::uniform_buffer}};
  if (table_) draw.textures = {{table_binding, table_, {Filter::linear, Wrap::clamp}}};
  draw.groups = {(static_cast<uint32_t>(count_) + group_size - 1) / group_size, 1, 1};
  pass.draws = {draw};
  return backend_.run({&pass, 1}, timing);
}

CapTruth truth_of(const CapSet& set) {
  CapTruth truth;
  for (size_t i = 0; i < set.inputs.size(); ++i) {
    const auto& [r0, r1, d] = set.inputs[i];
    const double area = cap_intersection_area(r0, r1, d);
    truth.conditions.push_back(cap_intersection_condition(r0, r1, d, area));
    truth.areas.push_back(i < set.areas.size() && !std::isnan(set.areas[i]) ? set.areas[i] : area);
  }
  return truth;
}

CapErrors judge_caps(std::span<const CapInput> inputs, std::span<const float> areas, const CapTruth& truth) {
  CapErrors errors;
  size_t finite = 0;
  for (size_t i = 0; i < inputs.size(); ++i) {
    const CapInput& input = inputs[i];
    const bool fault = !std::isfinite(areas[i]) || areas[i] < 0 || (truth.areas[i] == 0 && areas[i] != 0);
    if (fault && !errors.first_fault) errors.first_fault = input;
    if (!std::isfinite(areas[i])) {
      ++errors.nonfinite;
      continue;
    }
    ++finite;
    errors.negative += areas[i] < 0;
    errors.not_zero += truth.areas[i] == 0 && areas[i] != 0;
    const double difference = areas[i] - truth.areas[i], error = difference / smaller_cap_area(input.r0, input.r1);
    if (error > errors.max_over) errors.max_over = error, errors.worst_over = input;
    if (error < errors.max_under) errors.max_under = error, errors.worst_under = input;
    errors.mean_absolute += std::abs(error);
    errors.rms += error * error;
    errors.most_eps = std::max(errors.most_eps, std::abs(error) / eps);
    if (truth.areas[i] > 0)
      errors.most_eps_kappa =
          std::max(errors.most_eps_kappa, std::abs(difference) / truth.areas[i] / (eps * std::max(1.0, truth.conditions[i])));
  }
  if (finite > 0) {
    errors.mean_absolute /= static_cast<double>(finite);
    errors.rms = std::sqrt(errors.rms / static_cast<double>(finite));
  }
  return errors;
}

std::vector<std::vector<double>> nanoseconds_per_call(std::span<CapRunner* const> runners, size_t rounds, uint64_t seed) {
  std::vector<Arm> arms;  // of each runner a long one and a short one
  std::vector<double> calls_apart;
  for (CapRunner* runner : runners) {
    int calls = 8;
    while (runner->time_ms(calls) < long_run_ms && calls < most_calls) calls *= 2;
    for (const int of_arm : {calls, calls / 8})
      arms.push_back({[runner, of_arm] { return FrameTimes{{runner->time_ms(of_arm)}, 0}; }, std::nullopt});
    calls_apart.push_back((calls - calls / 8) * static_cast<double>(runner->inputs()));
  }
  RoundOptions options;
  options.least_rounds = options.most_rounds = rounds;
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
