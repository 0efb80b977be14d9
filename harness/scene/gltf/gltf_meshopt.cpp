// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/gltf/gltf_meshopt.h"

#include <fmt/format.h>
#include <meshoptimizer.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "harness/scene/gltf/gltf_json.h"
#include "harness/scene/gltf/gltf_values.h"

namespace lamina {
namespace {

using Json = nlohmann::json;

constexpr const char* meshopt_extension = "EXT_meshopt_compression";
constexpr std::array mode_names = {"ATTRIBUTES", "TRIANGLES", "INDICES"};
constexpr std::array filter_names = {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"};

const Json* extension_of(const Json& part) {
  const auto extensions = part.find("extensions");
  if (extensions == part.end() || !extensions->is_object()) return nullptr;
  const auto found = extensions->find(meshopt_extension);
  return found == extensions->end() ? nullptr : &*found;
}

template <class Choice, size_t size>
Choice word_in(const Json& said, const char* name, const std::array<const char*, size>& words, const char* otherwise,
               const std::string& about) {
  const auto found = said.find(name);
  const std::string word = found == said.end() ? otherwise : found->is_string() ? found->get<std::string>() : "";
  const auto known = std::ranges::find(words, word);
  if (known == words.end()) refuse_gltf(about, fmt::format("its '{}' is none of {}", name, fmt::join(words, ", ")));
  return static_cast<Choice>(known - words.begin());
}

// The strides that the extension allows for each mode and filter.
bool stride_fits(const CompressedView& view) {
  using Filter = CompressedView::Filter;
  if (view.mode != CompressedView::Mode::attributes) return view.stride == 2 || view.stride == 4;
  if (view.filter == Filter::octahedral) return view.stride == 4 || view.stride == 8;
  if (view.filter == Filter::quaternion) return view.stride == 8;
  return view.stride % 4 == 0 && view.stride > 0 && view.stride <= 256;
}

CompressedView read_view(const Json& said, const Json& view_json, size_t view_index, const std::string& about) {
  if (!said.is_object()) refuse_gltf(about, "is not an object");
  const int buffer = index_in(said, "buffer", about);
  if (buffer < 0) refuse_gltf(about, "names no 'buffer'");
  CompressedView view;
  view.mode = word_in<CompressedView::Mode>(said, "mode", mode_names, "", about);
  view.filter = word_in<CompressedView::Filter>(said, "filter", filter_names, "NONE", about);
  view.view = view_index, view.buffer = size_t(buffer);
  view.offset = size_in(said, "byteOffset", 0, about), view.bytes = size_in(said, "byteLength", 0, about);
  view.count = size_in(said, "count", 0, about), view.stride = size_in(said, "byteStride", 0, about);
  if (!stride_fits(view))
    refuse_gltf(about, fmt::format("elements of {} bytes do not go with mode {} and filter {}", view.stride,
                                   mode_names[size_t(view.mode)], filter_names[size_t(view.filter)]));
  if (view.mode != CompressedView::Mode::attributes && view.filter != CompressedView::Filter::none)
    refuse_gltf(about, "only attributes may have a filter");
  if (view.mode == CompressedView::Mode::triangles && view.count % 3 != 0)
    refuse_gltf(about, fmt::format("{} indices are no whole triangles", view.count));
  const uint64_t bytes = size_in(view_json, "byteLength", 0, about);
  if (view.count == 0 || bytes / view.stride != view.count || bytes % view.stride != 0)
    refuse_gltf(about,
                fmt::format("has {} elements of {} bytes, where its buffer view has {} bytes", view.count, view.stride, bytes));
  return view;
}

// The most elements that so many bytes can stand for. A block of up to 256 vertices has, for each byte of a vertex, two bits
// for every 16 of them; a triangle has a byte, and an index by itself too (the extension's appendix A).
size_t max_elements(const CompressedView& view) {
  switch (view.mode) {
    case CompressedView::Mode::attributes:
      return view.bytes * 64 / view.stride;
    case CompressedView::Mode::triangles:
      return view.bytes * 3;
    default:
      return view.bytes;
  }
}

bool decode(const CompressedView& view, const unsigned char* from, std::vector<unsigned char>& to) {
  switch (view.mode) {
    case CompressedView::Mode::attributes:
      if (meshopt_decodeVertexBuffer(to.data(), view.count, view.stride, from, view.bytes) != 0) return false;
      break;
    case CompressedView::Mode::triangles:
      return meshopt_decodeIndexBuffer(to.data(), view.count, view.stride, from, view.bytes) == 0;
    default:
      return meshopt_decodeIndexSequence(to.data(), view.count, view.stride, from, view.bytes) == 0;
  }
  if (view.filter == CompressedView::Filter::octahedral) meshopt_decodeFilterOct(to.data(), view.count, view.stride);
  if (view.filter == CompressedView::Filter::quaternion) meshopt_decodeFilterQuat(to.data(), view.count, view.stride);
  if (view.filter == CompressedView::Filter::exponential) meshopt_decodeFilterExp(to.data(), view.count, view.stride);
  return true;
}

}  // namespace

std::vector<CompressedView> take_compressed_views(Json& root, const std::string& subject, bool has_binary) {
  std::vector<CompressedView> views;
  if (Json* list = list_of(root, "bufferViews", subject))
    for (size_t i = 0; i < list->size(); ++i) {
      Json& view = (*list)[i];
      if (const Json* said = extension_of(view))
        views.push_back(read_view(*said, view, i, fmt::format("{}: buffer view {}, {}", subject, i, meshopt_extension)));
      view.erase("extensions");
    }
  if (Json* buffers = list_of(root, "buffers", subject))
    for (size_t i = 0; i < buffers->size(); ++i) {
      Json& buffer = (*buffers)[i];
      const bool is_binary_chunk = i == 0 && has_binary;
      if (extension_of(buffer) && !buffer.contains("uri") && !is_binary_chunk)
        buffer = Json{{"byteLength", uint64_t{1}}, {"uri", "data:application/octet-stream;base64,AA=="}};
      buffer.erase("extensions");
    }
  return views;
}

void decompress_views(tinygltf::Model& model, const std::vector<CompressedView>& views, const std::string& subject) {
  for (const CompressedView& view : views) {
    const std::string about = fmt::format("{}: buffer view {}, {}", subject, view.view, meshopt_extension);
    if (view.buffer >= model.buffers.size() || view.view >= model.bufferViews.size())
      refuse_gltf(about, fmt::format("refers to buffer {}; the file has {}", view.buffer, model.buffers.size()));
    const std::vector<unsigned char>& bytes = model.buffers[view.buffer].data;
    if (view.offset > bytes.size() || view.bytes > bytes.size() - view.offset)
      refuse_gltf(about, fmt::format("its {} bytes from {} leave buffer {} of {} bytes", view.bytes, view.offset, view.buffer,
                                     bytes.size()));
    if (view.count > max_elements(view))
      refuse_gltf(about, fmt::format("claims {} elements of {} bytes; its {} bytes cannot hold more than {}", view.count,
                                     view.stride, view.bytes, max_elements(view)));
    tinygltf::Buffer to;
    to.data.resize(view.count * view.stride);
    if (!decode(view, bytes.data() + view.offset, to.data))
      refuse_gltf(about, "its bytes are damaged or of a version that is not known; export the model again");
    tinygltf::BufferView& put = model.bufferViews[view.view];
    put.buffer = static_cast<int>(model.buffers.size());
    put.byteOffset = 0, put.byteLength = to.data.size(), put.byteStride = view.stride;
    model.buffers.push_back(std::move(to));
  }
}

}  // namespace lamina
