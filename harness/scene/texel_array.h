// SPDX-License-Identifier: Apache-2.0
// The texels of a picture in memory: floats, or, as long as nobody writes to them, the 8-bit codes of the file that they came
// from, which take a quarter of the memory.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <initializer_list>
#include <utility>
#include <vector>

namespace lamina {

// Linear values of the 256 codes of sRGB (IEC 61966-2-1:1999).
const std::array<float, 256>& linear_of_srgb_codes();

class TexelArray {
 public:
  using value_type = glm::vec4;

  TexelArray() = default;
  TexelArray(std::vector<glm::vec4> texels) : floats_(std::move(texels)) {}
  TexelArray(std::initializer_list<glm::vec4> texels) : floats_(texels) {}
  // Four codes a texel. `srgb`: those of r, g and b are sRGB's; the others mean code / 255.
  static TexelArray of_codes(std::vector<uint8_t> codes, bool srgb) {
    TexelArray array;
    array.codes_ = std::move(codes), array.srgb_ = srgb;
    return array;
  }

  size_t size() const { return codes_.empty() ? floats_.size() : codes_.size() / 4; }
  bool empty() const { return size() == 0; }
  glm::vec4 operator[](size_t i) const { return codes_.empty() ? floats_[i] : decoded(i); }
  glm::vec4 at(size_t i) const { return codes_.empty() ? floats_.at(i) : (static_cast<void>(codes_.at(4 * i)), decoded(i)); }
  bool operator==(const TexelArray& other) const {
    if (size() != other.size()) return false;
    for (size_t i = 0; i < size(); ++i)
      if ((*this)[i] != other[i]) return false;
    return true;
  }

  // In turn, as values.
  class ConstIterator {
   public:
    ConstIterator(const TexelArray& array, size_t at) : array_(&array), at_(at) {}
    glm::vec4 operator*() const { return (*array_)[at_]; }
    ConstIterator& operator++() { return ++at_, *this; }
    bool operator==(const ConstIterator& other) const { return at_ == other.at_; }

   private:
    const TexelArray* array_;
    size_t at_;
  };
  ConstIterator begin() const { return {*this, 0}; }
  ConstIterator end() const { return {*this, size()}; }

  // From here on they are floats.
  glm::vec4& operator[](size_t i) { return floats()[i]; }
  auto begin() { return floats().begin(); }
  auto end() { return floats().end(); }
  void resize(size_t size) { floats().resize(size); }
  void push_back(const glm::vec4& texel) { floats().push_back(texel); }
  template <class... Parts>
  void emplace_back(Parts&&... parts) {
    floats().emplace_back(std::forward<Parts>(parts)...);
  }

  // The codes, and whether they are sRGB's; none where the texels are floats.
  const std::vector<uint8_t>& codes() const { return codes_; }
  bool srgb() const { return srgb_; }
  // Applies `of_code` to the codes of a channel, or, where there are floats, `of_value` to its values.
  template <class OfCode, class OfValue>
  void change(int channel, OfCode of_code, OfValue of_value) {
    for (size_t i = static_cast<size_t>(channel); i < codes_.size(); i += 4) codes_[i] = of_code(codes_[i]);
    for (glm::vec4& texel : floats_) texel[channel] = of_value(texel[channel]);
  }

  // Red in every channel.
  void spread_red() {
    for (size_t i = 0; i + 3 < codes_.size(); i += 4) codes_[i + 1] = codes_[i + 2] = codes_[i + 3] = codes_[i];
    for (glm::vec4& texel : floats_) texel = glm::vec4(texel.r);
  }
  // Takes the alpha of as many texels, where both are codes; returns whether they are.
  bool take_alpha_codes(const TexelArray& from) {
    if (codes_.empty() || codes_.size() != from.codes_.size()) return false;
    for (size_t i = 3; i < codes_.size(); i += 4) codes_[i] = from.codes_[i];
    return true;
  }

 private:
  glm::vec4 decoded(size_t i) const {
    const uint8_t* code = &codes_[4 * i];
    if (!srgb_) return glm::vec4(code[0], code[1], code[2], code[3]) / 255.0f;
    const std::array<float, 256>& linear = linear_of_srgb_codes();
    return {linear[code[0]], linear[code[1]], linear[code[2]], static_cast<float>(code[3]) / 255};
  }
  std::vector<glm::vec4>& floats() {
    if (!codes_.empty()) {
      floats_.resize(size());
      for (size_t i = 0; i < floats_.size(); ++i) floats_[i] = decoded(i);
      codes_ = {};
    }
    return floats_;
  }

  std::vector<glm::vec4> floats_;
  std::vector<uint8_t> codes_;
  bool srgb_ = false;
};

}  // namespace lamina
