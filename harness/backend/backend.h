// SPDX-License-Identifier: Apache-2.0
// What a backend does, and nothing it decides. A frame is a list of passes, plain data with typed handles; everything about
// which passes, targets and shaders there are is settled before it gets here.
//
// Life of a backend:
//   1. open_backend() finds the device and makes a context; it throws Error(no_device) where there is none.
//   2. create_*() makes textures, buffers and pipelines; each keeps its debug name. destroy() gives one back.
//   3. run() executes passes in order. Every pass sees all that the passes before it wrote.
//   4. read_*() waits for the device and copies back.
// Not thread-safe. At most one OpenGL backend is alive at a time in a process.
//
// Conventions, the same on every backend: clip space is Vulkan's (x right, y down, depth 0 to 1); texture and framebuffer row 0
// is the top row of the picture; gl_FragCoord.y grows downwards from 0.5; counter-clockwise triangles, as seen in the picture,
// face front. Shaders are SPIR-V 1.0 made for the backend's API (see shader/shader.h), resources in one set, bindings unique
// across kinds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/core/error.h"
#include "harness/core/format.h"
#include "harness/core/ids.h"

namespace lamina {

enum class Api : uint8_t { vulkan, opengl };

struct DeviceInfo {
  std::string backend;  // "vulkan", "osmesa", "egl"
  Api api = Api::vulkan;
  std::string device;  // as the driver names it
  std::string driver;  // driver name and version
  std::string api_version;
  bool software = false;          // a rasterizer on the CPU
  uint32_t max_texture_size = 0;  // pixels on a side, textures and targets alike
  // What shaders may use, and what can be measured.
  bool vertex_storage = false, fragment_storage = false;  // they write storage buffers and images in these stages
  bool half_floats = false;                               // they compute with 16-bit floats
  bool doubles = false;                                   // with 64-bit floats
  bool exact_sample_counts = false;                       // `until_empty` needs them
  bool issued_fragment_counts = false;  // it tells how many fragments it shades, those at triangles' edges too
  uint32_t timestamp_bits = 0;          // of a timestamp, that count; 0: no pass can be timed
};

// A device that is there, but lacks what Lamina needs.
struct RefusedDevice {
  std::string device, reason;
};

struct TextureDesc {
  std::string name;
  uint32_t width = 1, height = 1, levels = 1;
  Format format = Format::rgba8_unorm;
  bool target = false;   // drawn into (colour or depth, by format), or has its mips generated
  bool storage = false;  // written by compute as an image
  uint32_t depth = 1;    // above 1: a 3D texture, sampled only: one level, no target, no storage, no r32_uint, no d32_float
  bool operator==(const TextureDesc&) const = default;
};
inline bool is_3d(const TextureDesc& desc) { return desc.depth > 1; }

// Places in an order of passes, both included.
struct Lifetime {
  uint32_t first = 0, last = 0;
  bool operator==(const Lifetime&) const = default;
};
inline bool overlap(const Lifetime& a, const Lifetime& b) { return a.first <= b.last && b.first <= a.last; }

// A texture of which only this part of the passes needs what it holds: the one at `first` must fill it, as its memory may have
// held another texture before, and what it holds after `last` is lost. Without a lifetime it is needed always.
struct TransientDesc {
  TextureDesc texture;
  std::optional<Lifetime> lifetime;
  bool operator==(const TransientDesc&) const = default;
};
struct PlacedTextures {
  std::vector<TextureId> textures;  // beside what was asked for; several may be one: destroy each once
  uint64_t bytes = 0;               // of device memory that they take; on OpenGL, which tells none, as their formats say
  uint64_t bytes_alone = 0;         // that they would take if each had its own
};

enum class BufferUse : uint8_t { vertex, index, uniform, storage };  // indices are uint32

// Every mesh has this one vertex layout: 48 bytes interleaved. Shaders take what they need by location.
//   0: vec3 position   1: vec3 normal   2: vec4 tangent (w = handedness)   3: vec2 uv
inline constexpr uint32_t vertex_stride_bytes = 48;
inline constexpr std::array<uint32_t, 4> vertex_offset_bytes = {0, 12, 24, 40};

enum class Stage : uint8_t { vertex, fragment, compute };
struct ShaderStage {
  Stage stage = Stage::vertex;
  std::vector<uint32_t> spirv;  // entry point "main"
};
// Of a SPIR-V module: magic number, version, generator, bound of ids, schema (SPIR-V specification, section 2.3).
inline constexpr size_t spirv_header_words = 5;
struct SpecConstant {
  uint32_t id = 0;
  uint32_t bits = 0;  // of a 32-bit int, uint, float or bool
};
enum class BindingKind : uint8_t { texture, uniform_buffer, storage_buffer, storage_image };
struct BindingSlot {
  uint32_t binding = 0;
  BindingKind kind = BindingKind::texture;
  uint32_t dimensions = 2;  // of a texture: 2 for a sampler2D, 3 for a sampler3D
  auto operator<=>(const BindingSlot&) const = default;
};

enum class Blend : uint8_t {
  none,
  alpha,          // src.rgb * src.a + dst.rgb * (1 - src.a); alpha: src.a + dst.a * (1 - src.a)
  premultiplied,  // src + dst * (1 - src.a)
  additive,       // src + dst, alpha too
  multiplied,     // src * dst, alpha too
};
enum class Depth : uint8_t { none, read, read_write };
enum class DepthTest : uint8_t { less_equal, equal, greater };  // what is drawn, against what is there
enum class Cull : uint8_t { none, back, front };                // the faces left out

struct PipelineDesc {
  std::string name;
  std::vector<ShaderStage> stages;         // vertex and fragment, or compute alone
  std::vector<SpecConstant> constants;     // applied to every stage that has the id
  std::vector<BindingSlot> bindings;       // the union over the stages
  std::vector<uint32_t> vertex_locations;  // of the mesh layout; empty: no vertex buffer (gl_VertexIndex only)
  std::vector<Format> colors;              // of the attachments, in order
  std::optional<Format> depth_format;
  std::vector<Blend> blend;  // beside `colors`; empty: none for all
  Depth depth = Depth::none;
  DepthTest depth_test = DepthTest::less_equal;  // where `depth` is not none
  Cull cull = Cull::none;
};
inline Blend blend_of(const PipelineDesc& desc, size_t color) { return desc.blend.empty() ? Blend::none : desc.blend[color]; }

struct TextureBinding {
  uint32_t binding = 0;
  TextureId texture;
  Sampler sampler;  // d32_float: nearest; on Vulkan a device may lack the other filters, and run() then throws Error(failed)
  std::optional<uint32_t> level = {};  // the shader sees a texture of this one level, as its level 0; absent: all levels
};
struct BufferBinding {
  uint32_t binding = 0;
  BufferId buffer;
  BindingKind kind = BindingKind::uniform_buffer;
};
struct ImageBinding {
  uint32_t binding = 0;
  TextureId texture;
  uint32_t level = 0;
};

// One draw, or in a compute pass one dispatch.
struct Draw {
  PipelineId pipeline;
  std::vector<TextureBinding> textures;
  std::vector<BufferBinding> buffers;
  std::vector<ImageBinding> images;
  BufferId vertices, indices;                  // none: `count` vertices are made from gl_VertexIndex
  uint32_t count = 0;                          // indices, or vertices without an index buffer
  std::array<uint32_t, 3> groups = {1, 1, 1};  // compute
};

enum class Load : uint8_t { clear, keep, discard };
struct Attachment {
  TextureId texture;
  uint32_t level = 0;
  Load load = Load::clear;
  std::array<float, 4> clear = {0, 0, 0, 0};  // depth uses clear[0]
};

enum class PassKind : uint8_t {
  raster,
  compute,
  mips,  // fill levels 1.. of `mips_of` from level 0, each by a linear filter of the one above
  copy,  // level 0 of `copy_from` into level 0 of `copy_to`: two 2D textures of one size and format
};

// Pixels of a target, from its top left corner.
struct Area {
  uint32_t x = 0, y = 0, width = 0, height = 0;
};

// A pass may read one level of a texture and draw into another. It must not read, as a texture, a level that it draws into: a
// binding that names that level is refused, and of one that names none the shader must leave it alone.
struct Pass {
  std::string name;
  PassKind kind = PassKind::raster;
  std::vector<Attachment> colors;  // all of one size
  std::optional<Attachment> depth;
  std::vector<Draw> draws;
  TextureId mips_of, copy_from, copy_to;
  // Of a raster pass: count the samples that its draws cover and that pass the depth test, or all that they cover where a
  // pipeline tests none; those that a shader discards do not count.
  bool count_samples = false;
  // Of a raster pass: count the fragments that the device runs its shaders for, in the blocks in which it runs them: those
  // beyond a triangle's edge too. What a block is, the device decides.
  bool count_issued_fragments = false;
  // Of a raster pass: only these pixels are loaded, cleared and drawn; what the others hold stays. Absent: all. It must lie
  // inside the targets.
  std::optional<Area> area;
};

inline bool counts_samples(const Pass& pass) { return pass.kind == PassKind::raster && pass.count_samples; }
inline bool counts_issued_fragments(const Pass& pass) { return pass.kind == PassKind::raster && pass.count_issued_fragments; }

enum class Timing : uint8_t { off, bracketed };

struct RunTimes {
  std::vector<double> pass_ms;             // device time of each pass; empty where timing was off
  std::vector<uint64_t> samples;           // that each pass has counted, 0 where it did not ask; empty where none asked
  std::vector<uint64_t> issued_fragments;  // likewise; empty too where the device does not tell
  double wall_ms = 0;                      // host clock, from before the first command to the device's idle
};

class Backend {
 public:
  virtual ~Backend() = default;
  virtual const DeviceInfo& info() const = 0;

  // `levels` are the texels of levels 0.., tightly packed, row by row and slice by slice, or empty for an undefined content.
  // Throws Error(failed) when the device has no room, Error(bad_input) when the size is over max_texture_size (3D: over what
  // the device makes in three dimensions) or a 3D texture asks for what it cannot have.
  virtual TextureId create_texture(const TextureDesc& desc, std::span<const std::vector<std::byte>> levels = {}) = 0;
  // Textures without content, of which those that are needed at different times share memory: on Vulkan they lie in one
  // allocation, on OpenGL, where memory cannot be shared, equal ones are one texture. Throws as create_texture(). On Vulkan,
  // run() and read_texture() throw Error(bad_input) where they need what a texture has lost.
  virtual PlacedTextures create_textures(std::span<const TransientDesc> descs) = 0;
  virtual BufferId create_buffer(std::string name, BufferUse use, size_t size_bytes, std::span<const std::byte> data = {}) = 0;
  // Throws Error(failed) with the driver's words when the device refuses a shader.
  virtual PipelineId create_pipeline(const PipelineDesc& desc) = 0;
  virtual void destroy(TextureId id) = 0;
  virtual void destroy(BufferId id) = 0;
  virtual void destroy(PipelineId id) = 0;

  // Writes from the start of the buffer. The device must be idle, which it is outside run().
  virtual void write_buffer(BufferId id, std::span<const std::byte> data) = 0;

  // Executes the passes in order and waits for the device. With Timing::bracketed each pass lies between two device timestamps,
  // each with a full barrier before and after it (OpenGL: a finish), as software rasterizers need; the results are read after
  // the frame, and so are counts of samples. Throws Error(failed) on device loss, any API error, or where samples are to be
  // counted and the device does not count them exactly.
  virtual RunTimes run(std::span<const Pass> passes, Timing timing) = 0;

  virtual std::vector<std::byte> read_texture(TextureId id, uint32_t level = 0) = 0;
  virtual std::vector<std::byte> read_buffer(BufferId id) = 0;

  // Messages of warning or error severity from the API's own checker (validation layers, GL debug output) since the last call.
  virtual std::vector<std::string> take_messages() = 0;
};

struct BackendOptions {
  std::string device;  // part of one device's name, or its index in survey_devices(); empty: the default (docs/figures.md)
  bool validation =
      false;  // Vulkan's validation layers / an OpenGL debug context. Error(no_device) where they are not installed.
};

// `name` is "vulkan", "osmesa" or "egl"; another throws Error(bad_input) naming the three.
std::unique_ptr<Backend> open_backend(std::string_view name, const BackendOptions& options = {});
// What a backend finds on this machine.
struct DeviceSurvey {
  std::vector<DeviceInfo> usable;      // every device it could open, in its own order
  std::vector<RefusedDevice> refused;  // the others, and why; empty where a driver tells nothing of them
};

DeviceSurvey survey_devices(std::string_view backend);
// The backends compiled in, in the order in which they run.
std::span<const std::string_view> backend_names();

}  // namespace lamina
