// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ranges>
#include <string_view>
#include <type_traits>

namespace lamina {

// The bytes that a value lies in, or those of a contiguous range's elements: for hashes and files. Bytes that pad a
// structure are among them and hold anything, so a structure that has some is hashed member by member.
template <class T>
std::string_view bytes_of(const T& value) {
  if constexpr (std::ranges::contiguous_range<T>) {
    using Element = std::ranges::range_value_t<T>;
    static_assert(std::is_trivially_copyable_v<Element>);
    return {reinterpret_cast<const char*>(std::ranges::data(value)), std::ranges::size(value) * sizeof(Element)};
  } else {
    static_assert(std::is_trivially_copyable_v<T>);
    return {reinterpret_cast<const char*>(&value), sizeof value};
  }
}

}  // namespace lamina
