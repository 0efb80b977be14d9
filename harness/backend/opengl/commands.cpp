// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/opengl/commands.h"

#include "harness/core/stopwatch.h"

namespace lamina::gl {
namespace {

// Shows a pass by its name in graphics debuggers.
class DebugGroup {
 public:
  DebugGroup(std::string_view name, size_t longest) {
    name = name.substr(0, longest);
    glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, static_cast<GLsizei>(name.size()), name.data());
  }
  ~DebugGroup() { glPopDebugGroup(); }
  DebugGroup(const DebugGroup&) = delete;
  DebugGroup& operator=(const DebugGroup&) = delete;
};

// Clears obey the scissor. What is discarded is discarded everywhere, so an area keeps it instead.
void load_attachments(const PreparedPass& prepared) {
  const GLuint framebuffer = prepared.framebuffer;
  const bool whole = !prepared.pass->area;
  for (size_t i = 0; i < prepared.colors.size(); ++i) {
    const PreparedAttachment& color = prepared.colors[i];
    const auto index = static_cast<GLint>(i);
    if (color.load == Load::discard) {
      if (!whole) continue;
      const GLenum point = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
      glInvalidateNamedFramebufferData(framebuffer, 1, &point);
    } else if (color.load == Load::clear && color.integer) {
      const std::array<GLuint, 4> value = {static_cast<GLuint>(color.clear[0]), 0, 0, 0};
      glClearNamedFramebufferuiv(framebuffer, GL_COLOR, index, value.data());
    } else if (color.load == Load::clear) {
      glClearNamedFramebufferfv(framebuffer, GL_COLOR, index, color.clear.data());
    }
  }
  const std::optional<Attachment>& depth = prepared.pass->depth;
  if (depth && depth->load == Load::discard && whole) {
    const GLenum point = GL_DEPTH_ATTACHMENT;
    glInvalidateNamedFramebufferData(framebuffer, 1, &point);
  } else if (depth && depth->load == Load::clear) {
    glDepthMask(GL_TRUE);  // a clear obeys the mask that the last draw has left
    glClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, depth->clear.data());
  }
}

void bind(const BoundResource& bound) {
  switch (bound.kind) {
    case BindingKind::texture:
      glBindTextureUnit(bound.unit, bound.name);
      glBindSampler(bound.unit, bound.sampler);
      break;
    case BindingKind::uniform_buffer:
      glBindBufferBase(GL_UNIFORM_BUFFER, bound.unit, bound.name);
      break;
    case BindingKind::storage_buffer:
      glBindBufferBase(GL_SHADER_STORAGE_BUFFER, bound.unit, bound.name);
      break;
    case BindingKind::storage_image:
      glBindImageTexture(bound.unit, bound.name, bound.level, GL_FALSE, 0, GL_READ_WRITE, bound.format);
      break;
  }
}

void draw_triangles(const PreparedDraw& prepared) {
  const GLuint vertex_array = prepared.pipeline->vertex_array.name();
  const auto count = static_cast<GLsizei>(prepared.draw->count);
  if (prepared.vertices != 0) glVertexArrayVertexBuffer(vertex_array, 0, prepared.vertices, 0, vertex_stride_bytes);
  if (prepared.indices != 0) {
    glVertexArrayElementBuffer(vertex_array, prepared.indices);
    glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr);
  } else {
    glDrawArrays(GL_TRIANGLES, 0, count);
  }
}

void execute(const PreparedPass& prepared, const SampleCounts& samples, size_t index) {
  const PassKind kind = prepared.pass->kind;
  if (kind == PassKind::mips) glGenerateTextureMipmap(prepared.mips_of);
  if (kind == PassKind::copy) {
    const PreparedCopy& copy = prepared.copy;
    glCopyImageSubData(copy.from, GL_TEXTURE_2D, 0, 0, 0, 0, copy.to, GL_TEXTURE_2D, 0, 0, 0, 0, copy.width, copy.height, 1);
  }
  if (kind == PassKind::raster) {
    glBindFramebuffer(GL_FRAMEBUFFER, prepared.framebuffer);
    glViewport(0, 0, static_cast<GLsizei>(prepared.size.width), static_cast<GLsizei>(prepared.size.height));
    if (const std::optional<Area>& area = prepared.pass->area) {
      glEnable(GL_SCISSOR_TEST);
      glScissor(static_cast<GLint>(area->x), static_cast<GLint>(area->y), static_cast<GLsizei>(area->width),
                static_cast<GLsizei>(area->height));
    }
    load_attachments(prepared);
  }
  samples.begin(*prepared.pass, index);
  for (const PreparedDraw& draw : prepared.draws) {
    use(*draw.pipeline);
    for (const BoundResource& bound : draw.bound) bind(bound);
    if (kind == PassKind::compute)
      glDispatchCompute(draw.draw->groups[0], draw.draw->groups[1], draw.draw->groups[2]);
    else
      draw_triangles(draw);
  }
  samples.end(*prepared.pass);
  if (prepared.pass->area) glDisable(GL_SCISSOR_TEST);
}

}  // namespace

RunTimes run_passes(Resources& resources, PassTimer& timer, SampleCounts& samples, std::span<const Pass> passes,
                    Timing timing) {
  const std::vector<PreparedPass> prepared = prepare(resources, passes);
  const bool timed = timing == Timing::bracketed;
  if (timed) timer.prepare(passes.size());
  samples.prepare(passes);
  GLint message_limit = 1;  // with the terminator
  glGetIntegerv(GL_MAX_DEBUG_MESSAGE_LENGTH, &message_limit);
  const auto longest_name = static_cast<size_t>(message_limit - 1);
  glFinish();

  const Stopwatch watch;
  for (size_t i = 0; i < passes.size(); ++i) {
    const DebugGroup group(passes[i].name, longest_name);
    if (timed) timer.begin(i);
    execute(prepared[i], samples, i);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    if (timed) timer.end(i);
  }
  glFinish();

  RunTimes times;
  times.wall_ms = watch.elapsed_ms();
  throw_on_error(passes.size() == 1 ? passes[0].name : fmt::format("a frame of {} passes", passes.size()));
  if (timed) times.pass_ms = timer.read_ms(passes.size());
  samples.read(passes, times);
  return times;
}

}  // namespace lamina::gl
