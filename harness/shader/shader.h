// SPDX-License-Identifier: Apache-2.0
// GLSL 450 to SPIR-V 1.0 through glslang, for Vulkan or OpenGL, and what the module asks for, read back from the SPIR-V.
//
// Sources: no `set=`, no push constants, combined samplers, std140 uniform blocks, explicit locations and bindings, bindings
// unique across kinds. #include "path" is looked up beside the including file, then in the include folders. LAMINA_VULKAN or
// LAMINA_OPENGL is defined (1), and LAMINA_VERTEX_INDEX stands for gl_VertexIndex / gl_VertexID.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "harness/backend/backend.h"

namespace lamina {

struct ShaderRequest {
  std::filesystem::path file;  // .vert, .frag or .comp
  Stage stage = Stage::fragment;
  Api api = Api::vulkan;
  std::map<std::string, std::string> defines;       // name -> text
  std::vector<std::filesystem::path> include_dirs;
};

struct BlockMember {
  std::string name;
  uint32_t offset_bytes = 0;
};
struct ShaderResource {
  std::string name;  // of the sampler or image variable, or of the block (its type's name: `uniform Frame {...}` is "Frame")
  uint32_t binding = 0;
  BindingKind kind = BindingKind::texture;
  uint32_t size_bytes = 0;           // of a block
  std::vector<BlockMember> members;  // of a block
};
struct SpecConstantInfo {
  std::string name;
  uint32_t id = 0;
  enum class Type { boolean, integer, unsigned_integer, real } type = Type::real;
  uint32_t default_bits = 0;
};
struct Reflection {
  std::vector<ShaderResource> resources;  // by binding; only those that the entry point can reach
  std::vector<SpecConstantInfo> constants;
  std::vector<uint32_t> input_locations;   // sorted; vertex stage: of the mesh layout
  std::vector<uint32_t> output_locations;  // sorted; fragment stage: colour attachments
};

struct CompiledShader {
  Stage stage = Stage::fragment;
  std::vector<uint32_t> spirv;
  Reflection reflection;
  std::string hash;  // of the preprocessed input and the API: same source and definitions, same hash
};

// Throws Error(bad_input, "shader", "FILE:LINE", glslang's words) when the source does not compile (the first error's file and
// line, included files named as themselves), when a file is missing, or when a resource has no explicit binding or a set.
// The module is validated with SPIRV-Tools for the API's environment.
CompiledShader compile_shader(const ShaderRequest& request);

// Words of SPIR-V to the names and numbers of its interface.
Reflection reflect(const std::vector<uint32_t>& spirv);

// ---- The counting build (counting.cpp): the same shader, made to count what it executes. --------------------------------

// Where the counts go: one storage buffer of 32-bit words at a binding of its own. Counters are 64 bits, low word first.
//   word 0: width of the coverage map in pixels (written by the host), word 1: 0
//   words 2,3: invocations of the stage's shader (helper invocations excluded)
//   words 4+2k, 5+2k: texture operations executed on texture slot k
//   from `coverage_word` on, where it is not 0: one word a pixel, times the fragment shader ran there
struct CountingLayout {
  uint32_t binding = 0;        // of the counter buffer
  uint32_t first_word = 2;     // of this stage's counters, so that two stages may share a buffer
  uint32_t coverage_word = 0;  // fragment stage only
};
struct CountingShader {
  std::vector<uint32_t> spirv;
  std::vector<uint32_t> slots;      // slot k counts operations on the texture at binding slots[k] (arrays: all elements together)
  bool early_fragment_tests = false;  // forced, because the shader neither discards nor writes depth: hidden fragments are not counted
  uint32_t words = 0;               // counter words used from first_word on (2 + 2 * slots.size())
};
// Every sample, fetch, gather and query-free image read through a sampler executed by the shader adds 1 to its texture's counter,
// loops, branches and function calls included. Functions are inlined first (SPIRV-Tools). Reads of storage images and size or
// level queries are not texture fetches. Throws Error(failed) for a module it cannot rewrite.
CountingShader add_counters(const CompiledShader& shader, Api api, const CountingLayout& layout);

}  // namespace lamina
