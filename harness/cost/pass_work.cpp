// SPDX-License-Identifier: Apache-2.0
#include "harness/cost/pass_work.h"

#include <algorithm>
#include <numeric>

#include "harness/core/format.h"

namespace lamina {
namespace {

// Classes of operations (shader/operations.h): what one costs beside an addition, about, and the kind of those whose price
// differs so much from device to device that they have one of their own besides.
struct OperationPrice {
  double additions = 1;
  const char* kind = nullptr;
};
OperationPrice price_of(const std::string& operation) {
  static const std::map<std::string, OperationPrice> prices = {
      {"divide", {3}},
      {"root", {3}},
      {"exp", {6, "exponential"}},
      {"log", {6, "exponential"}},
      {"pow", {6, "exponential"}},
      {"sin", {12, "trigonometric operation"}},
      {"cos", {12, "trigonometric operation"}},
      {"tan", {12, "trigonometric operation"}},
      {"asin", {12, "trigonometric operation"}},
      {"acos", {12, "trigonometric operation"}},
      {"atan", {12, "trigonometric operation"}},
      {"hyperbolic", {12, "trigonometric operation"}},
      {"uniform", {0.5}},
      {"storage", {4}},
      {"image", {4}},
      {"query", {4}},
  };
  const auto found = prices.find(operation);
  return found == prices.end() ? OperationPrice() : found->second;
}
// Fragments are drawn by all threads of a software rasterizer, vertices by one: of two threads, as measured.
constexpr double vertex_price = 2;

// Formats that are decoded alike.
std::string decoding_of(const std::string& format) {
  if (format == "rgba8_srgb") return "sRGB";
  if (format.find("16_float") != std::string::npos) return "half floats";
  return format.find("8_unorm") != std::string::npos ? "8 bits" : "floats";
}

double as_double(const std::optional<uint64_t>& count) { return static_cast<double>(count.value_or(0)); }

// 4 where a record names a format that this build does not know.
double bytes_of(const std::string& format) {
  const std::optional<Format> known = format_named(format);
  return known ? bytes_per_texel(*known) : 4;
}

class Adding {
 public:
  Adding(const PassRow& pass, CountedWork counted) : pass_(pass), counted_(counted) {
    const double fragments = as_double(pass.fragments);
    issued_fragments_ = pass.issued_fragments.value_or(0) > 0 ? as_double(pass.issued_fragments) : fragments;
    a_fragment_ = fragments > 0 ? issued_fragments_ / fragments : 1;
  }

  PassWork work() {
    add("run", pass_.runs ? as_double(pass_.runs) : 1);
    add("fragment", issued_fragments_);
    add("vertex", as_double(pass_.vertices));
    add("triangle", as_double(pass_.triangles));
    add_operations();
    for (const TextureFetches& texture : pass_.by_texture) add_fetches(texture);
    for (const WrittenTexels& written : pass_.written) add_written(written);
    return work_;
  }

 private:
  void add(const std::string& kind, double amount) {
    if (amount > 0) work_[kind] += amount;
  }

  void add_operations() {
    for (const auto& [operation, count] : pass_.vertex_issued)
      add("operation", vertex_price * price_of(operation).additions * static_cast<double>(count));
    for (const auto& [operation, count] : counted_ == CountedWork::issued ? pass_.issued : pass_.operations) {
      const auto of_vertices = pass_.vertex_issued.find(operation);
      const uint64_t vertices = of_vertices == pass_.vertex_issued.end() ? 0 : std::min(count, of_vertices->second);
      const double of_fragments = a_fragment_ * static_cast<double>(count - vertices);
      const OperationPrice price = price_of(operation);
      add("operation", price.additions * of_fragments);
      if (price.kind) add(price.kind, of_fragments);
    }
  }

  // A fetch pays for its format, for its filter, and again where it blends two levels. What it reads for the first time comes
  // from farther away: at most a cache line a read, and no more than the level holds.
  void add_fetches(const TextureFetches& texture) {
    const double fetches =
        static_cast<double>(counted_ == CountedWork::issued ? texture.issued : texture.fetches) * a_fragment_;
    if (fetches == 0) return;
    const double executed = std::max(static_cast<double>(texture.fetches), 1.0);
    const double unfiltered = std::min(as_double(texture.unfiltered) / executed, 1.0);
    add("fetch, " + texture.filter, fetches * (1 - unfiltered));
    add("fetch, a texel", fetches * unfiltered);
    add("fetch, of " + decoding_of(texture.format), fetches);
    if (texture.levels.empty()) return;
    const auto reads = std::accumulate(texture.levels.begin(), texture.levels.end(), 0.0,
                                       [](double sum, uint64_t count) { return sum + static_cast<double>(count); });
    add("fetch, a second level", fetches * (reads / executed - 1));
    constexpr double line_bytes = 64;
    double bytes = 0;
    for (size_t level = 0; level < texture.levels.size(); ++level) {
      double level_bytes = bytes_of(texture.format);
      for (const uint64_t side : texture.size) level_bytes *= static_cast<double>(std::max<uint64_t>(side >> level, 1));
      bytes += std::min(level_bytes, static_cast<double>(texture.levels[level]) * a_fragment_ * line_bytes);
    }
    add("byte of textures", bytes);
  }

  void add_written(const WrittenTexels& written) {
    const double bytes = static_cast<double>(written.texels) * bytes_of(written.format);
    if (written.load == "mips" || written.load == "copy" || written.load == "clear" || written.load == "keep")
      add("byte of targets, " + written.load, bytes);
    if (written.load == "mips" || written.load == "copy") return;
    if (written.combine == "test" || written.combine == "test and write")
      add("fragment, depth test", issued_fragments_);
    else
      add("fragment, to " + written.format, issued_fragments_);
    if (written.combine != "none" && written.combine != "test" && written.combine != "test and write")
      add("fragment, blended", issued_fragments_);
  }

  const PassRow& pass_;
  const CountedWork counted_;
  double issued_fragments_ = 0;
  double a_fragment_ = 1;  // issued fragments for each that is executed
  PassWork work_;
};

}  // namespace

PassWork work_of(const PassRow& pass, CountedWork counted) { return Adding(pass, counted).work(); }

}  // namespace lamina
