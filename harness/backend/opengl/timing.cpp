// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/opengl/timing.h"

namespace lamina::gl {

void PassTimer::prepare(size_t passes) {
  if (mask_ == 0) {
    GLint bits = 0;
    glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
    if (bits <= 0) throw_failed("timer", "the device has no timestamps (GL_QUERY_COUNTER_BITS is 0); run without timing");
    mask_ = bits >= 64 ? ~uint64_t{0} : (uint64_t{1} << bits) - 1;
  }
  while (queries_.size() < 2 * passes) {
    GLuint name = 0;
    glCreateQueries(GL_TIMESTAMP, 1, &name);
    label(GL_QUERY, name, fmt::format("timestamp {}", queries_.size()));
    queries_.emplace_back(name);
  }
}

void PassTimer::stamp(size_t query) const {
  glFinish();
  glQueryCounter(queries_[query].name(), GL_TIMESTAMP);
  glFinish();
}

std::vector<double> PassTimer::read_ms(size_t passes) const {
  constexpr double ms_per_ns = 1e-6;  // timestamps are in nanoseconds (OpenGL 4.5, section 4.3)
  std::vector<double> pass_ms(passes);
  for (size_t pass = 0; pass < passes; ++pass) {
    GLuint64 begin = 0, end = 0;
    glGetQueryObjectui64v(queries_[2 * pass].name(), GL_QUERY_RESULT, &begin);
    glGetQueryObjectui64v(queries_[2 * pass + 1].name(), GL_QUERY_RESULT, &end);
    pass_ms[pass] = static_cast<double>((end - begin) & mask_) * ms_per_ns;  // the mask undoes a counter's turning over
  }
  return pass_ms;
}

}  // namespace lamina::gl
