// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/opengl/commands.h"

#include <algorithm>
#include <chrono>

#include "harness/backend/opengl/gl_format.h"

namespace lamina::gl {
namespace {

// Shows a pass by its name in graphics debuggers.
class DebugGroup {
 public:
  explicit DebugGroup(std::string_view name) {
    constexpr size_t longest = 255;  // as in label(): GL_MAX_DEBUG_MESSAGE_LENGTH may be far less than text
    name = name.substr(0, longest);
    glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, static_cast<GLsizei>(name.size()), name.data());
  }
  ~DebugGroup() { glPopDebugGroup(); }
  DebugGroup(const DebugGroup&) = delete;
  DebugGroup& operator=(const DebugGroup&) = delete;
};

void load_attachments(Resources& resources, const Pass& pass, GLuint framebuffer) {
  glDepthMask(GL_TRUE);  // clears obey the mask
  for (size_t i = 0; i < pass.colors.size(); ++i) {
    const Attachment& color = pass.colors[i];
    const auto index = static_cast<GLint>(i);
    if (color.load == Load::discard) {
      const GLenum point = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
      glInvalidateNamedFramebufferData(framebuffer, 1, &point);
    } else if (color.load == Load::clear && resources.textures.at(color.texture).desc.format == Format::r32_uint) {
      const std::array<GLuint, 4> value = {static_cast<GLuint>(color.clear[0]), 0, 0, 0};
      glClearNamedFramebufferuiv(framebuffer, GL_COLOR, index, value.data());
    } else if (color.load == Load::clear) {
      glClearNamedFramebufferfv(framebuffer, GL_COLOR, index, color.clear.data());
    }
  }
  if (!pass.depth) return;
  if (pass.depth->load == Load::discard) {
    const GLenum point = GL_DEPTH_ATTACHMENT;
    glInvalidateNamedFramebufferData(framebuffer, 1, &point);
  } else if (pass.depth->load == Load::clear) {
    glClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, pass.depth->clear.data());
  }
}

// The member of `list` for a slot of the pipeline. What an earlier draw has left bound must never stand in for it.
template <class Binding>
const Binding& bound_at(const std::vector<Binding>& list, const Pipeline& pipeline, const BindingSlot& slot, const Pass& pass) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const Binding& b) { return b.binding == slot.binding; });
  if (found == list.end())
    throw Error(ErrorKind::failed, "opengl", fmt::format("pass '{}'", pass.name),
                fmt::format("a draw with pipeline '{}' leaves binding {} unset", pipeline.name, slot.binding));
  return *found;
}

void bind(Resources& resources, const Pipeline& pipeline, const Draw& draw, const Pass& pass) {
  for (const auto& [slot, unit] : pipeline.slots) {
    switch (slot.kind) {
      case BindingKind::texture: {
        const TextureBinding& bound = bound_at(draw.textures, pipeline, slot, pass);
        const Texture& texture = resources.textures.at(bound.texture);
        // An integer texture under a linear sampler is incomplete, even to a shader that only fetches texels.
        const Sampler fetch{Filter::nearest, bound.sampler.wrap};
        glBindTextureUnit(unit, texture.object.name());
        glBindSampler(unit, resources.samplers.of(texture.desc.format == Format::r32_uint ? fetch : bound.sampler));
        break;
      }
      case BindingKind::uniform_buffer:
      case BindingKind::storage_buffer: {
        const BufferBinding& bound = bound_at(draw.buffers, pipeline, slot, pass);
        const GLenum target = slot.kind == BindingKind::uniform_buffer ? GL_UNIFORM_BUFFER : GL_SHADER_STORAGE_BUFFER;
        glBindBufferBase(target, unit, resources.buffers.at(bound.buffer).object.name());
        break;
      }
      case BindingKind::storage_image: {
        const ImageBinding& bound = bound_at(draw.images, pipeline, slot, pass);
        const Texture& texture = resources.textures.at(bound.texture);
        glBindImageTexture(unit, texture.object.name(), static_cast<GLint>(bound.level), GL_FALSE, 0, GL_READ_WRITE,
                           gl_format(texture.desc.format).internal);
        break;
      }
    }
  }
}

void draw_vertices(Resources& resources, const Pipeline& pipeline, const Draw& draw, const Pass& pass) {
  const GLuint vertex_array = pipeline.vertex_array.name();
  const auto count = static_cast<GLsizei>(draw.count), instances = static_cast<GLsizei>(draw.instances);
  if (pipeline.has_vertices) {
    if (!draw.vertices)
      throw Error(ErrorKind::failed, "opengl", fmt::format("pass '{}'", pass.name),
                  fmt::format("a draw with pipeline '{}' has no vertex buffer", pipeline.name));
    glVertexArrayVertexBuffer(vertex_array, 0, resources.buffers.at(draw.vertices).object.name(), 0, vertex_stride_bytes);
  }
  if (draw.indices) {
    glVertexArrayElementBuffer(vertex_array, resources.buffers.at(draw.indices).object.name());
    glDrawElementsInstanced(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr, instances);
  } else {
    glDrawArraysInstanced(GL_TRIANGLES, 0, count, instances);
  }
}

void execute(Resources& resources, const Pass& pass, const Framebuffers::Target& target) {
  if (pass.kind == PassKind::mips) {
    glGenerateTextureMipmap(resources.textures.at(pass.mips_of).object.name());
    return;
  }
  if (pass.kind == PassKind::raster) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.name);
    glViewport(0, 0, static_cast<GLsizei>(target.width), static_cast<GLsizei>(target.height));
    load_attachments(resources, pass, target.name);
  }
  for (const Draw& draw : pass.draws) {
    const Pipeline& pipeline = resources.pipelines.at(draw.pipeline);
    use(pipeline);
    bind(resources, pipeline, draw, pass);
    if (pass.kind == PassKind::compute)
      glDispatchCompute(draw.groups[0], draw.groups[1], draw.groups[2]);
    else
      draw_vertices(resources, pipeline, draw, pass);
  }
}

}  // namespace

RunTimes run_passes(Resources& resources, PassTimer& timer, std::span<const Pass> passes, Timing timing) {
  // What is made once is made before the clock starts.
  std::vector<Framebuffers::Target> targets(passes.size());
  for (size_t i = 0; i < passes.size(); ++i)
    if (passes[i].kind == PassKind::raster) targets[i] = resources.framebuffers.of(passes[i], resources.textures);
  const bool timed = timing == Timing::bracketed;
  if (timed) timer.prepare(passes.size());
  glFinish();

  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  for (size_t i = 0; i < passes.size(); ++i) {
    const DebugGroup group(passes[i].name);
    if (timed) timer.begin(i);
    execute(resources, passes[i], targets[i]);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    if (timed) timer.end(i);
  }
  glFinish();

  RunTimes times;
  times.wall_ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  throw_on_error(passes.size() == 1 ? fmt::format("pass '{}'", passes[0].name)
                                    : fmt::format("a run of {} passes", passes.size()));
  if (timed) times.pass_ms = timer.read_ms(passes.size());
  return times;
}

}  // namespace lamina::gl
