// SPDX-License-Identifier: Apache-2.0
#include "harness/shader/changed_constants.h"

#include <bit>
#include <map>
#include <optional>
#include <set>

#include "harness/shader/spirv_module.h"

namespace lamina {
namespace {

using Words = std::vector<uint32_t>;

// The place in `words` of each 32-bit float constant's value, by id.
std::map<uint32_t, size_t> float_constants(const Words& words) {
  const SpirvModule module(words);
  std::map<uint32_t, size_t> places;
  for (const SpirvInstruction& i : module.instructions())
    if (i.op() == spv::OpConstant && module.definition(i.type).op() == spv::OpTypeFloat &&
        module.definition(i.type).words[2] == 32)
      places[i.result] = static_cast<size_t>(i.words.data() - words.data()) + 3;
  return places;
}

bool scale_offsets(Words& words, float factor) {
  const std::map<uint32_t, size_t> places = float_constants(words);
  std::set<size_t> scaled;  // a constant may stand in several vectors
  const SpirvModule module(words);
  for (const SpirvInstruction& i : module.instructions()) {
    if (i.op() != spv::OpConstantComposite || i.words.size() != 5 || module.definition(i.type).op() != spv::OpTypeVector)
      continue;
    for (const uint32_t member : i.words.subspan(3))
      if (const auto found = places.find(member); found != places.end()) scaled.insert(found->second);
  }
  for (const size_t place : scaled) words[place] = std::bit_cast<uint32_t>(factor * std::bit_cast<float>(words[place]));
  return !scaled.empty();
}

bool swap_weights(Words& words) {
  std::optional<size_t> least, most;
  const auto value = [&](size_t place) { return std::bit_cast<float>(words[place]); };
  for (const auto& [id, place] : float_constants(words)) {
    if (!(value(place) > 0 && value(place) < 1)) continue;
    if (!least || value(place) < value(*least)) least = place;
    if (!most || value(place) > value(*most)) most = place;
  }
  if (!least || value(*least) == value(*most)) return false;
  std::swap(words[*least], words[*most]);
  return true;
}

}  // namespace

bool scale_offsets(CompiledShader& shader, float factor) {
  scale_offsets(shader.spirv_with_lines, factor);
  return scale_offsets(shader.spirv, factor);
}

bool swap_weights(CompiledShader& shader) {
  swap_weights(shader.spirv_with_lines);
  return swap_weights(shader.spirv);
}

}  // namespace lamina
