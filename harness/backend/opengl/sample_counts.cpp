// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/opengl/sample_counts.h"

#include <algorithm>

namespace lamina::gl {

void SampleCounts::prepare(std::span<const Pass> passes) {
  const auto asks = std::find_if(passes.begin(), passes.end(), counts_samples);
  if (asks == passes.end()) return;
  GLint bits = 0;
  glGetQueryiv(GL_SAMPLES_PASSED, GL_QUERY_COUNTER_BITS, &bits);
  if (bits <= 0) throw_failed(asks->name, "the device does not count samples (GL_QUERY_COUNTER_BITS is 0)");
  while (queries_.size() < passes.size()) {
    GLuint name = 0;
    glCreateQueries(GL_SAMPLES_PASSED, 1, &name);
    label(GL_QUERY, name, fmt::format("samples {}", queries_.size()));
    queries_.emplace_back(name);
  }
}

std::vector<uint64_t> SampleCounts::read(std::span<const Pass> passes) const {
  if (std::none_of(passes.begin(), passes.end(), counts_samples)) return {};
  std::vector<uint64_t> samples(passes.size());
  for (size_t pass = 0; pass < passes.size(); ++pass) {
    if (!counts_samples(passes[pass])) continue;
    GLuint64 count = 0;
    glGetQueryObjectui64v(queries_[pass].name(), GL_QUERY_RESULT, &count);
    samples[pass] = count;
  }
  return samples;
}

}  // namespace lamina::gl
