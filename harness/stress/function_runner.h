// SPDX-License-Identifier: Apache-2.0
// A family's functions themselves, run on a device over points, and timed.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "harness/backend/backend.h"
#include "harness/measure/rounds.h"
#include "harness/stress/family.h"

namespace lamina {

// One function of a family on a backend.
class FunctionRunner {
 public:
  // `shaders` is the folder of the built-in shaders. Throws as compile_shader() and create_pipeline() do, and Error(bad_input)
  // where the function reads a texture that its family does not name, or a buffer.
  FunctionRunner(Backend& backend, const std::filesystem::path& shaders, const Family& family, const std::string& function);
  ~FunctionRunner();
  FunctionRunner(const FunctionRunner&) = delete;
  FunctionRunner& operator=(const FunctionRunner&) = delete;

  // The function's value at each point.
  std::vector<float> values(const Points& points);
  // Device time in ms of `calls` calls at each of the points last given to values().
  double time_ms(int calls);
  size_t points() const { return count_; }

 private:
  struct Table {
    uint32_t binding = 0;
    TextureId texture;
  };
  RunTimes run(int calls, Timing timing);

  Backend& backend_;
  PipelineId pipeline_;
  std::vector<Table> tables_;  // that the function reads
  BufferId points_, values_, work_;
  size_t count_ = 0;
};

// Nanoseconds of one call in each of `runners` in each of `rounds` shuffled rounds, as the difference of a long and a short
// run.
std::vector<std::vector<double>> nanoseconds_per_call(std::span<FunctionRunner* const> runners, size_t rounds, uint64_t seed);

}  // namespace lamina
