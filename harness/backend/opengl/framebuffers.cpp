// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/opengl/framebuffers.h"

namespace lamina::gl {
namespace {

FramebufferObject make_framebuffer(const Pass& pass, Table<TextureId, Texture>& textures) {
  GLuint name = 0;
  glCreateFramebuffers(1, &name);
  FramebufferObject framebuffer(name);
  label(GL_FRAMEBUFFER, name, pass.name);
  const auto attach = [&](GLenum point, const Attachment& to) {
    glNamedFramebufferTexture(name, point, textures.at(to.texture, pass.name).object.name(), static_cast<GLint>(to.level));
  };
  std::vector<GLenum> draw_buffers;
  for (const Attachment& color : pass.colors) {
    draw_buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(draw_buffers.size()));
    attach(draw_buffers.back(), color);
  }
  if (pass.depth) attach(GL_DEPTH_ATTACHMENT, *pass.depth);
  glNamedFramebufferDrawBuffers(name, static_cast<GLsizei>(draw_buffers.size()), draw_buffers.data());
  throw_on_error(pass.name);
  const GLenum status = glCheckNamedFramebufferStatus(name, GL_DRAW_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE)
    throw_failed(pass.name,
                 fmt::format("the driver cannot draw into this set of attachments (framebuffer status 0x{:04x})", status));
  return framebuffer;
}

}  // namespace

GLuint Framebuffers::of(const Pass& pass, Table<TextureId, Texture>& textures) {
  Key key;
  for (const Attachment& color : pass.colors) key.attachments.emplace_back(color.texture, color.level);
  if (pass.depth) key.attachments.emplace_back(pass.depth->texture, pass.depth->level);
  key.depth = pass.depth.has_value();
  auto found = framebuffers_.find(key);
  if (found == framebuffers_.end()) found = framebuffers_.emplace(std::move(key), make_framebuffer(pass, textures)).first;
  return found->second.name();
}

void Framebuffers::forget(TextureId texture) {
  std::erase_if(framebuffers_, [&](const auto& item) {
    for (const auto& [id, level] : item.first.attachments)
      if (id == texture) return true;
    return false;
  });
}

}  // namespace lamina::gl
