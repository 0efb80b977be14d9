// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/block_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "harness/core/text.h"

namespace lamina {
namespace {

using Scalar = BlockMember::Scalar;

// "float", "ivec3", "mat4", "mat2x3", "vec4[8]": the type as GLSL spells it.
std::string type_name(Scalar scalar, uint32_t rows, uint32_t columns, std::optional<uint32_t> elements) {
  std::string name;
  if (columns > 1)
    name = rows == columns ? fmt::format("mat{}", rows) : fmt::format("mat{}x{}", columns, rows);
  else if (rows > 1)
    name = fmt::format("{}vec{}", scalar == Scalar::real ? "" : scalar == Scalar::integer ? "i" : "u", rows);
  else
    name = scalar == Scalar::real ? "float" : scalar == Scalar::integer ? "int" : "uint";
  return elements ? fmt::format("{}[{}]", name, *elements) : name;
}
std::string type_name(const BlockMember& member) {
  return type_name(member.scalar, member.rows, member.columns,
                   member.array_count > 0 ? std::optional(member.array_count) : std::nullopt);
}

}  // namespace

void BlockValues::set(std::string_view name, std::span<const float> values) { set_real(name, 1, 1, values.size(), values); }
void BlockValues::set(std::string_view name, std::span<const glm::vec4> values) {
  set_real(name, 4, 1, values.size(), {reinterpret_cast<const float*>(values.data()), 4 * values.size()});
}
void BlockValues::set(std::string_view name, std::span<const glm::ivec4> values) {
  set_integer(name, 4, values.size(), {reinterpret_cast<const int*>(values.data()), 4 * values.size()});
}
void BlockValues::set(std::string_view name, std::span<const glm::mat4> values) {
  set_real(name, 4, 4, values.size(), {reinterpret_cast<const float*>(values.data()), 16 * values.size()});
}

void BlockValues::set_real(std::string_view name, uint32_t rows, uint32_t columns, std::optional<size_t> elements,
                           std::span<const float> numbers) {
  Value value{std::string(name), true, rows, columns, elements, {}};
  for (const float number : numbers) value.words.push_back(std::bit_cast<uint32_t>(number));
  put(std::move(value));
}

void BlockValues::set_integer(std::string_view name, uint32_t rows, std::optional<size_t> elements,
                              std::span<const int> numbers) {
  Value value{std::string(name), false, rows, 1, elements, {}};
  for (const int number : numbers) value.words.push_back(std::bit_cast<uint32_t>(number));
  put(std::move(value));
}

void BlockValues::put(Value value) {
  const auto old = std::ranges::find(values_, value.name, &Value::name);
  if (old == values_.end())
    values_.push_back(std::move(value));
  else
    *old = std::move(value);
}

const BlockValues::Value* BlockValues::find(std::string_view name) const {
  const auto found = std::ranges::find(values_, name, &Value::name);
  return found == values_.end() ? nullptr : &*found;
}

std::vector<std::string> BlockValues::names() const {
  std::vector<std::string> result;
  for (const Value& value : values_) result.push_back(value.name);
  return result;
}

// A block's members with their values, checked one by one.
class BlockFiller {
 public:
  BlockFiller(const ShaderResource& block, const BlockValues& values, const std::string& where)
      : block_(block), values_(values), where_(where) {}

  // Calls use(member, words) for each member, with the value's words in the member's scalar type.
  template <class Use>
  void for_each_member(const Use& use) const {
    for (const BlockMember& member : block_.members) {
      const Value* value = values_.find(member.name);
      if (!value)
        throw Error(ErrorKind::bad_input, "variants", where_,
                    unknown_name(fmt::format("member of block '{}'", block_.name), member.name, values_.names()));
      check_type(member, *value);
      use(member, converted(member, *value));
    }
  }

 private:
  using Value = BlockValues::Value;

  [[noreturn]] void refuse(const BlockMember& member, std::string_view what) const {
    throw Error(ErrorKind::bad_input, "variants", where_, fmt::format("block '{}': '{}' {}", block_.name, member.name, what));
  }

  void check_type(const BlockMember& member, const Value& value) const {
    const bool array = member.array_count > 0;
    // What is not converted() needs the very type.
    const bool convertible = member.scalar != Scalar::real && (!value.real || (value.rows == 1 && value.columns == 1));
    const bool same_scalar = value.real == (member.scalar == Scalar::real);
    const std::string known = type_name(value.real ? Scalar::real : Scalar::integer, value.rows, value.columns, value.elements);
    const std::string_view article = known.starts_with('i') ? "an" : "a";
    if (!member.supported)
      refuse(member, fmt::format("is declared with a type that no value has, and it is {} {}", article, known));
    if (member.rows != value.rows || member.columns != value.columns || array != value.elements.has_value() ||
        !(same_scalar || convertible))
      refuse(member, fmt::format("is declared as {}, and it is {} {}", type_name(member), article, known));
    if (array && member.array_count > *value.elements)
      refuse(member, fmt::format("is declared as {}, and there are {} elements", type_name(member), *value.elements));
  }

  std::vector<uint32_t> converted(const BlockMember& member, const Value& value) const {
    std::vector<uint32_t> words(value.words.begin(),
                                value.words.begin() + member.rows * member.columns * std::max(member.array_count, 1u));
    if (member.scalar == Scalar::real) return words;
    const bool is_unsigned = member.scalar == Scalar::unsigned_integer;
    for (uint32_t& word : words) {
      const double number = value.real ? double(std::bit_cast<float>(word)) : double(std::bit_cast<int>(word));
      if (number != std::floor(number) || std::isinf(number))  // NaN is unequal to itself
        refuse(member, fmt::format("is declared as {}, and {:.9g} is no whole number", type_name(member), number));
      if (is_unsigned && number < 0)
        refuse(member, fmt::format("is declared as {}, and {:.9g} is negative", type_name(member), number));
      if (number < -0x1p31 || number >= (is_unsigned ? 0x1p32 : 0x1p31))
        refuse(member, fmt::format("is declared as {}, and {:.9g} does not fit into 32 bits", type_name(member), number));
      word = static_cast<uint32_t>(static_cast<int64_t>(number));
    }
    return words;
  }

  const ShaderResource& block_;
  const BlockValues& values_;
  const std::string& where_;
};

std::vector<std::byte> fill_block(const ShaderResource& block, const BlockValues& values, const std::string& where) {
  std::vector<std::byte> bytes(block.size_bytes);
  BlockFiller(block, values, where).for_each_member([&](const BlockMember& member, const std::vector<uint32_t>& words) {
    const uint32_t* column_words = words.data();
    for (uint32_t element = 0; element < std::max(member.array_count, 1u); ++element)
      for (uint32_t column = 0; column < member.columns; ++column) {
        const size_t offset = size_t{member.offset_bytes} + size_t{element} * member.array_stride_bytes +
                              size_t{column} * member.matrix_stride_bytes;
        std::memcpy(bytes.data() + offset, column_words, 4 * member.rows);
        column_words += member.rows;
      }
  });
  return bytes;
}

void check_block(const ShaderResource& block, const BlockValues& values, const std::string& where) {
  BlockFiller(block, values, where).for_each_member([](const BlockMember&, const std::vector<uint32_t>&) {});
}

std::string layout_key(const ShaderResource& block) {
  std::string key = fmt::format("{} {}", block.name, block.size_bytes);
  for (const BlockMember& m : block.members)
    key += fmt::format("; {} {} {} +{} {} {}", m.name, m.supported ? type_name(m) : "unsupported", m.size_bytes, m.offset_bytes,
                       m.array_stride_bytes, m.matrix_stride_bytes);
  return key;
}

}  // namespace lamina
