// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/opengl/pipelines.h"

#include <algorithm>

#include "harness/backend/common/checks.h"
#include "harness/backend/opengl/spirv_interface.h"

namespace lamina::gl {
namespace {

GLenum gl_stage(Stage stage) {
  switch (stage) {
    case Stage::vertex:
      return GL_VERTEX_SHADER;
    case Stage::fragment:
      return GL_FRAGMENT_SHADER;
    case Stage::compute:
      return GL_COMPUTE_SHADER;
  }
  return GL_NONE;
}

std::string_view stage_name(Stage stage) {
  return stage == Stage::vertex ? "vertex" : stage == Stage::fragment ? "fragment" : "compute";
}

// The driver's words about a shader or a program.
template <class Get, class GetLog>
std::string info_log(GLuint name, Get get, GetLog get_log) {
  GLint length = 0;
  get(name, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<size_t>(std::max(length, 0)), '\0');
  if (length > 0) get_log(name, length, &length, log.data());
  log.resize(static_cast<size_t>(std::max(length, 0)));
  return log.empty() ? "the driver gives no reason" : log;
}

ShaderObject make_shader(const PipelineDesc& desc, const ShaderStage& stage, const std::map<uint32_t, uint32_t>& units) {
  const std::vector<uint32_t> words = with_units(stage.spirv, units, desc.name);
  const std::set<uint32_t> known = specialization_ids(stage.spirv, desc.name);
  std::vector<GLuint> ids, values;
  for (const SpecConstant& constant : desc.constants) {
    if (!known.contains(constant.id)) continue;
    ids.push_back(constant.id);
    values.push_back(constant.bits);
  }

  ShaderObject shader(glCreateShader(gl_stage(stage.stage)));
  const GLuint name = shader.name();
  label(GL_SHADER, name, fmt::format("{} {}", desc.name, stage_name(stage.stage)));
  glShaderBinary(1, &name, GL_SHADER_BINARY_FORMAT_SPIR_V_ARB, words.data(),
                 static_cast<GLsizei>(words.size() * sizeof(uint32_t)));
  throw_on_error(desc.name);
  glSpecializeShaderARB(name, "main", static_cast<GLuint>(ids.size()), ids.data(), values.data());
  throw_on_error(desc.name);
  GLint compiled = GL_FALSE;
  glGetShaderiv(name, GL_COMPILE_STATUS, &compiled);
  if (!compiled)
    throw_failed(desc.name, fmt::format("the driver refuses the {} shader: {}", stage_name(stage.stage),
                                        info_log(name, glGetShaderiv, glGetShaderInfoLog)));
  return shader;
}

ProgramObject link(const PipelineDesc& desc, const std::map<uint32_t, uint32_t>& units) {
  std::vector<ShaderObject> shaders;
  for (const ShaderStage& stage : desc.stages) shaders.push_back(make_shader(desc, stage, units));
  ProgramObject program(glCreateProgram());
  label(GL_PROGRAM, program.name(), desc.name);
  for (const ShaderObject& shader : shaders) glAttachShader(program.name(), shader.name());
  glLinkProgram(program.name());
  for (const ShaderObject& shader : shaders) glDetachShader(program.name(), shader.name());
  throw_on_error(desc.name);
  GLint linked = GL_FALSE;
  glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
  if (!linked)
    throw_failed(desc.name,
                 fmt::format("the driver cannot link it: {}", info_log(program.name(), glGetProgramiv, glGetProgramInfoLog)));
  return program;
}

VertexArrayObject make_vertex_array(const PipelineDesc& desc) {
  static constexpr std::array<GLint, 4> components = {3, 3, 4, 2};  // position, normal, tangent, uv
  GLuint name = 0;
  glCreateVertexArrays(1, &name);
  VertexArrayObject array(name);
  label(GL_VERTEX_ARRAY, name, desc.name);
  for (uint32_t location : desc.vertex_locations) {
    glEnableVertexArrayAttrib(name, location);
    glVertexArrayAttribFormat(name, location, components[location], GL_FLOAT, GL_FALSE, vertex_offset_bytes[location]);
    glVertexArrayAttribBinding(name, location, 0);
  }
  return array;
}

void blend(GLuint target, Blend blend) {
  blend == Blend::none ? glDisablei(GL_BLEND, target) : glEnablei(GL_BLEND, target);
  switch (blend) {
    case Blend::none:
      break;
    case Blend::alpha:
      glBlendFuncSeparatei(target, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
      break;
    case Blend::premultiplied:
      glBlendFunci(target, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
      break;
    case Blend::additive:
      glBlendFunci(target, GL_ONE, GL_ONE);
      break;
    case Blend::multiplied:
      glBlendFunci(target, GL_ZERO, GL_SRC_COLOR);
      break;
  }
}

GLenum gl_compare(DepthTest test) {
  switch (test) {
    case DepthTest::less_equal:
      return GL_LEQUAL;
    case DepthTest::equal:
      return GL_EQUAL;
    case DepthTest::greater:
      return GL_GREATER;
  }
  return GL_LEQUAL;
}

}  // namespace

Pipeline make_pipeline(const PipelineDesc& desc) {
  check_pipeline(desc);
  // Bindings are unique across kinds, while OpenGL counts each kind on its own, and some by very few (8 image units on NVIDIA):
  // so each kind gets units of its own from 0 on.
  std::array<GLuint, 4> next = {};
  std::map<uint32_t, uint32_t> units;
  Pipeline pipeline;
  for (const BindingSlot& slot : desc.bindings) {
    const GLuint unit = next[static_cast<size_t>(slot.kind)]++;
    pipeline.slots.push_back({slot, unit});
    units[slot.binding] = unit;
  }
  pipeline.program = link(desc, units);
  pipeline.vertex_array = make_vertex_array(desc);
  pipeline.desc = desc;
  for (ShaderStage& stage : pipeline.desc.stages) stage.spirv = {};  // the driver has it now
  throw_on_error(desc.name);
  return pipeline;
}

void set_conventions() {
  // OpenGL puts clip y = -1 at window y = 0, which is row 0 of a texture. With row 0 called the top row, that is Vulkan's clip
  // space as it stands; GL_UPPER_LEFT would turn the picture over. OpenGL, which takes row 0 for the bottom row, then sees
  // every triangle mirrored: what is counter-clockwise in the picture is clockwise to it.
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glFrontFace(GL_CW);
  glEnable(GL_FRAMEBUFFER_SRGB);  // sRGB targets encode what is written, as on Vulkan
  glDisable(GL_DITHER);           // on by default, and a liberty of the driver's
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  throw_on_error("conventions");
}

void use(const Pipeline& pipeline) {
  glUseProgram(pipeline.program.name());
  glBindVertexArray(pipeline.vertex_array.name());

  const auto enable = [](GLenum what, bool on) { on ? glEnable(what) : glDisable(what); };
  for (size_t i = 0; i < pipeline.desc.colors.size(); ++i) blend(static_cast<GLuint>(i), blend_of(pipeline.desc, i));
  enable(GL_DEPTH_TEST, pipeline.desc.depth != Depth::none);
  glDepthFunc(gl_compare(pipeline.desc.depth_test));
  glDepthMask(pipeline.desc.depth == Depth::read_write);
  enable(GL_CULL_FACE, pipeline.desc.cull != Cull::none);
  if (pipeline.desc.cull != Cull::none) glCullFace(pipeline.desc.cull == Cull::back ? GL_BACK : GL_FRONT);
}

}  // namespace lamina::gl
