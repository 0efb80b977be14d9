// SPDX-License-Identifier: Apache-2.0
// GLSL 450 to SPIR-V 1.0 through glslang, for Vulkan or OpenGL, and what the module asks for, read back from the SPIR-V.
//
// Sources: no `set=`, no push constants, combined samplers, 2D textures and images, 3D textures of floats, std140 uniform
// blocks, no arrays of resources, no uniforms outside blocks, explicit locations and bindings, bindings unique across kinds.
// #include "path" is looked up beside the including file, then in the include folders. LAMINA_VULKAN or LAMINA_OPENGL is
// defined (1), and LAMINA_VERTEX_INDEX stands for gl_VertexIndex / gl_VertexID.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "harness/backend/backend.h"
#include "harness/shader/block_work.h"
#include "harness/shader/operations.h"

namespace lamina {

struct ShaderRequest {
  std::filesystem::path file;  // .vert, .frag or .comp
  Stage stage = Stage::fragment;
  Api api = Api::vulkan;
  std::map<std::string, std::string> defines;  // name -> text
  std::vector<std::filesystem::path> include_dirs;
};

struct BlockMember {
  std::string name;
  uint32_t offset_bytes = 0;
  // The type, where it is a number, a vector or a column-major matrix of 32-bit numbers, or an array of known length of one of
  // them. Other types (structs, doubles, row-major matrices, arrays of arrays or of no fixed length) are not `supported`, and
  // what follows but for the size says nothing. A block holds no booleans: what GLSL declares bool is a uint in SPIR-V.
  bool supported = false;
  enum class Scalar : uint8_t { real, integer, unsigned_integer } scalar = Scalar::real;
  uint32_t rows = 1;                 // components of a vector, or of a matrix's column: 1 to 4
  uint32_t columns = 1;              // 1 to 4; more than 1: a matrix
  uint32_t array_count = 0;          // 0: no array
  uint32_t array_stride_bytes = 0;   // from an element to the next; 0: no array
  uint32_t matrix_stride_bytes = 0;  // from a column to the next; 0: no matrix
  uint32_t size_bytes = 0;           // without what pads it at its end; of an array of no fixed length 0
};
struct ByteRange {
  uint32_t offset = 0, size = 0;
};
struct ShaderResource {
  std::string name;  // of the sampler or image variable, or of the block (its type's name: `uniform Frame {...}` is "Frame")
  uint32_t binding = 0;
  BindingKind kind = BindingKind::texture;
  uint32_t size_bytes = 0;           // of a block; a uniform block's is padded to 16, a runtime array at the end has none
  std::vector<BlockMember> members;  // of a block, the outermost only
  std::vector<ByteRange> read;       // of a uniform block: the members that some code of the shader reads
  uint32_t dimensions = 2;           // of a texture: 2 or 3

  BindingSlot slot() const { return {binding, kind, dimensions}; }
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
  std::vector<uint32_t> input_locations;   // sorted, used or not; vertex stage: of the mesh layout
  std::vector<uint32_t> output_locations;  // sorted, used or not; fragment stage: colour attachments
};

struct CompiledShader {
  Stage stage = Stage::fragment;
  std::vector<uint32_t> spirv;             // for a device: Mesa's OpenGL takes no module that says its lines
  std::vector<uint32_t> spirv_with_lines;  // the same, for counting
  Reflection reflection;
  // 16 hex digits of the preprocessed source, the API and the stage; the files' places, comments and empty lines do not count.
  std::string hash;
};

// Throws Error(bad_input, "shader", "FILE:LINE", glslang's words) when the source does not compile (the first error's file and
// line, included files named as themselves), when a file is missing, or, naming the file and the resource, when a resource
// breaks the rules above. The module is what glslang writes, unoptimized and with its names, validated with SPIRV-Tools for the
// API's environment. May be called from several threads.
CompiledShader compile_shader(const ShaderRequest& request);

// The same shader with the resource at binding `from` at binding `to`, which is free.
CompiledShader rebound(const CompiledShader& shader, uint32_t from, uint32_t to);

// Words of SPIR-V to the names and numbers of its interface. Throws Error(failed) for words that are not SPIR-V.
Reflection reflect(const std::vector<uint32_t>& spirv);

// ---- The counting build (counting.cpp): the same shader, made to count what it executes. --------------------------------

// Where the counts go: one storage buffer of 32-bit words at a binding of its own. Counters are 64 bits, low word first.
//   word 0: width of the coverage map in pixels (written by the host), word 1: 0
//   words 2,3: invocations of the stage's shader (helper invocations excluded)
//   words 4+2k, 5+2k: how often they ran the block that has counter k; then how often they read each level of the textures
//                     whose levels are counted (BlockWork::counted_levels)
//   from `coverage_word` on, where it is not 0: one word a pixel, times the fragment shader ran there
struct CountingLayout {
  uint32_t binding = 0;           // of the counter buffer
  uint32_t first_word = 2;        // of this stage's counters, so that two stages may share a buffer
  uint32_t coverage_word = 0;     // fragment stage only
  LeveledTextures textures = {};  // by binding; of others no levels are told
};
struct CountingShader {
  std::vector<uint32_t> spirv;
  BlockWork work;  // has the counters
  // Depth is tested before the shader, so hidden fragments are not counted: the shader says so, or it is forced because the
  // shader neither discards nor writes depth, its sample mask or memory. Otherwise hidden and discarded fragments are counted
  // too.
  bool early_fragment_tests = false;

  uint32_t counters() const { return static_cast<uint32_t>(work.counters()); }
  uint32_t words() const { return 2 + 2 * counters(); }  // from first_word on
};
// What the source says is counted, loops, branches and function calls included, whether or not a driver would leave it out:
// texture operations (every sample, fetch and gather; size and level queries are none) and the levels that they read
// (level_reads.h), and operations by class; fetches and operations by line too. Functions are inlined first (SPIRV-Tools).
// Throws Error(failed) for a module it cannot rewrite, or when the layout's binding is taken. The device needs stores and
// atomics in the stage; the module made says no lines. An invocation may run a block up to 2^32 - 1 times.
CountingShader add_counters(const CompiledShader& shader, Api api, const CountingLayout& layout);

}  // namespace lamina
