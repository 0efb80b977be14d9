// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/spec_constants.h"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "harness/core/error.h"

namespace lamina {
namespace {

uint32_t constant_bits(const SpecConstantInfo& constant, const std::string& text, const std::string& where) {
  using Type = SpecConstantInfo::Type;
  const auto refuse = [&](const char* what) {
    throw Error(ErrorKind::bad_input, "variants", where,
                fmt::format("constant '{}' must be {}, not '{}'", constant.name, what, text));
  };
  const char* begin = text.c_str();
  char* end = nullptr;
  const double value = text == "true" ? 1 : text == "false" ? 0 : std::strtod(begin, &end);
  if ((end && (end == begin || *end)) || !std::isfinite(value)) refuse("a number");
  if (constant.type == Type::boolean) return value != 0;
  if (constant.type == Type::real) return std::bit_cast<uint32_t>(static_cast<float>(value));
  const bool is_signed = constant.type == Type::integer;
  const double low = is_signed ? std::numeric_limits<int32_t>::min() : 0;
  const double high = is_signed ? std::numeric_limits<int32_t>::max() : std::numeric_limits<uint32_t>::max();
  if (value != std::floor(value) || value < low || value > high) refuse("a whole number that 32 bits hold");
  return static_cast<uint32_t>(static_cast<int64_t>(value));
}

}  // namespace

std::vector<SpecConstant> spec_constants(const GraphPass& pass, const GraphDraw& draw, const Parameters& parameters) {
  std::vector<SpecConstant> values;
  for (const auto& stage : draw.stages)
    for (const SpecConstantInfo& constant : stage->reflection.constants) {
      std::optional<std::string> text;
      if (const auto given = pass.pass->constants.find(constant.name); given != pass.pass->constants.end())
        text = given->second;
      if (const ParameterManifest* parameter = pass.variant->parameter(constant.name))
        text = fmt::format("{}", pass.variant->value_of(*parameter, parameters));
      if (text) values.push_back({constant.id, constant_bits(constant, *text, pass.pass->where)});
    }
  return values;
}

}  // namespace lamina
