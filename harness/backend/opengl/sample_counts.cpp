// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/opengl/sample_counts.h"

#include <algorithm>

#include "harness/backend/common/pass_counts.h"

namespace lamina::gl {
namespace {

// Of OpenGL 4.6, and of GL_ARB_pipeline_statistics_query before it, which need no entry point of their own.
constexpr GLenum fragment_shader_invocations = 0x82F4;

uint64_t result_of(const QueryObject& query) {
  GLuint64 count = 0;
  glGetQueryObjectui64v(query.name(), GL_QUERY_RESULT, &count);
  return count;
}

}  // namespace

void SampleCounts::prepare(std::span<const Pass> passes) {
  if (const auto asks = std::find_if(passes.begin(), passes.end(), counts_samples); asks != passes.end()) {
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
  if (tells_issued_ && std::any_of(passes.begin(), passes.end(), counts_issued_fragments)) {
    while (issued_.size() < passes.size()) {
      GLuint name = 0;  // without a label: Mesa's glCreateQueries does not know the target, so the first use makes it
      glGenQueries(1, &name);
      issued_.emplace_back(name);
    }
  }
}

void SampleCounts::begin(const Pass& pass, size_t index) const {
  if (counts_samples(pass)) glBeginQuery(GL_SAMPLES_PASSED, queries_[index].name());
  if (counts_issued_fragments(pass) && tells_issued_) glBeginQuery(fragment_shader_invocations, issued_[index].name());
}

void SampleCounts::end(const Pass& pass) const {
  if (counts_issued_fragments(pass) && tells_issued_) glEndQuery(fragment_shader_invocations);
  if (counts_samples(pass)) glEndQuery(GL_SAMPLES_PASSED);
}

void SampleCounts::read(std::span<const Pass> passes, RunTimes& times) const {
  times.samples = counts_of(passes, counts_samples, [&](size_t pass) { return result_of(queries_[pass]); });
  if (!tells_issued_) return;
  times.issued_fragments = counts_of(passes, counts_issued_fragments, [&](size_t pass) { return result_of(issued_[pass]); });
}

}  // namespace lamina::gl
