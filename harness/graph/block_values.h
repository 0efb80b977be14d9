// SPDX-License-Identifier: Apache-2.0
// Values for the members of uniform blocks, by name. A shader declares the members that it wants, in any order; reflection says
// where they lie, and the values are written there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/shader/shader.h"

namespace lamina {

// What is known for a block's members. Names keep the order in which they were first set; setting one again replaces its value.
class BlockValues {
 public:
  void set(std::string_view name, float value) { set_real(name, 1, 1, {}, {&value, 1}); }
  void set(std::string_view name, const glm::vec2& value) { set_real(name, 2, 1, {}, {&value.x, 2}); }
  void set(std::string_view name, const glm::vec3& value) { set_real(name, 3, 1, {}, {&value.x, 3}); }
  void set(std::string_view name, const glm::vec4& value) { set_real(name, 4, 1, {}, {&value.x, 4}); }
  void set(std::string_view name, const glm::mat3& value) { set_real(name, 3, 3, {}, {&value[0].x, 9}); }
  void set(std::string_view name, const glm::mat4& value) { set_real(name, 4, 4, {}, {&value[0].x, 16}); }
  void set(std::string_view name, int value) { set_integer(name, 1, {}, {&value, 1}); }
  void set(std::string_view name, const glm::ivec2& value) { set_integer(name, 2, {}, {&value.x, 2}); }
  void set(std::string_view name, const glm::ivec3& value) { set_integer(name, 3, {}, {&value.x, 3}); }
  void set(std::string_view name, const glm::ivec4& value) { set_integer(name, 4, {}, {&value.x, 4}); }
  // Arrays.
  void set(std::string_view name, std::span<const float> values);
  void set(std::string_view name, std::span<const glm::vec4> values);
  void set(std::string_view name, std::span<const glm::ivec4> values);
  void set(std::string_view name, std::span<const glm::mat4> values);

  std::vector<std::string> names() const;

 private:
  friend class BlockFiller;
  struct Value {
    std::string name;
    bool real = true;  // else of integers
    uint32_t rows = 1, columns = 1;
    std::optional<uint32_t> elements;  // of an array
    std::vector<uint32_t> words;       // 32 bits a component; columns and elements follow each other without gaps
  };

  void set_real(std::string_view name, uint32_t rows, uint32_t columns, std::optional<size_t> elements,
                std::span<const float> numbers);
  void set_integer(std::string_view name, uint32_t rows, std::optional<size_t> elements, std::span<const int> numbers);
  void put(Value value);
  const Value* find(std::string_view name) const;

  std::vector<Value> values_;
};

// The block's bytes, size_bytes of them: every member that the block declares, at its offset and with its strides, and 0
// between them. Values that the block does not declare are left out.
//
// A member is declared with its value's type. A number set as a float (or an array of them) may also be declared int or uint
// where it is whole, and integers may be declared unsigned where none is negative. An array may be declared shorter than its
// value, never longer.
// Throws Error(bad_input, "variants", `where`) for any other type or length, for a member of a type that no value has, and for
// a member that is not known, with the nearest known name.
std::vector<std::byte> fill_block(const ShaderResource& block, const BlockValues& values, const std::string& where);

// Throws what fill_block() would.
void check_block(const ShaderResource& block, const BlockValues& values, const std::string& where);

// Equal for blocks of one name that the same values fill with the same bytes: their size, and their members' names, places and
// types are equal. Such blocks may share a buffer, at whatever binding each has it.
std::string layout_key(const ShaderResource& block);

}  // namespace lamina
