// SPDX-License-Identifier: Apache-2.0
// Of a frame's counts: the levels that passes read, by texture and size, and what passes are made of.
#include <algorithm>

#include "tests/graph/made_effects.h"

namespace lamina {
namespace {

using Levels = std::vector<uint64_t>;

class CountedLevels : public MadeEffects {
 protected:
  static constexpr const char* pyramid_target = "[targets.pyramid]\nsize = [8, 8]\nformat = \"r32_float\"\nmips = true\n";
  static constexpr const char* base_shader =
      "layout(location = 0) out vec4 value;\nvoid main() { value = vec4(gl_FragCoord.x, 0, 0, 1); }\n";
  // Of the frame's passes, by name.
  std::map<std::string, PassCounts> counts_of(const std::string& passes) {
    write_effect("top", "key = \"top\"");
    write_variant("top", "top_full", pyramid_target + passes);
    const Library library = made();
    const auto frame = drawn(library, squares({square("a", 0, {"top"})}), {}, Build::counting);
    std::map<std::string, PassCounts> counts;
    const std::vector<PassCounts> all = frame->frame.frame_counts();
    for (size_t i = 0; i < all.size(); ++i) counts[frame->frame.frame_names()[i]] = all[i];
    return counts;
  }
  static const WrittenTexels& written(const PassCounts& pass, const std::string& format) {
    static const WrittenTexels none;
    const auto found = std::ranges::find(pass.written, format, &WrittenTexels::format);
    return found == pass.written.end() ? none : *found;
  }
};

TEST_P(CountedLevels, AreTheTexturesOwnWhereAPassWalksAlongThem) {
  write("top/base.frag", base_shader);
  write("top/two.frag",
        "layout(binding = 4) uniform sampler2D pyramid;\nlayout(location = 0) out vec4 value;\nvoid main() {\n"
        "  ivec2 at = ivec2(gl_FragCoord.xy) * 2;\n"
        "  value = texelFetch(pyramid, at, 0) + texelFetch(pyramid, at + ivec2(1, 0), 0);\n}\n");
  write("top/show.frag",
        "layout(binding = 4) uniform sampler2D pyramid;\nlayout(location = 0) out vec4 color;\n"
        "void main() { color = texelFetch(pyramid, ivec2(0), 3) + texelFetch(pyramid, ivec2(0), 2); }\n");
  const auto counts =
      counts_of(fullscreen_pass("base", "base.frag", "pyramid") +
                fullscreen_pass("down", "two.frag", "pyramid", "levels = \"down\"\n") + objects_pass("show.frag"));
  const PassCounts& down = counts.at("down");
  ASSERT_EQ(down.by_texture.size(), 1u);
  const TextureFetches& row = down.by_texture[0];
  EXPECT_EQ(row.fetches, 2u * (16 + 4 + 1));
  EXPECT_EQ(row.unfiltered, row.fetches);
  EXPECT_EQ(row.levels, (Levels{32, 8, 2}));
  EXPECT_EQ(row.size, (std::vector<uint64_t>{8, 8}));
  EXPECT_EQ(row.dimensions, 2u);
  EXPECT_EQ(down.runs, 3u);
  EXPECT_EQ(down.triangles, 3u);
  ASSERT_EQ(down.written.size(), 1u);
  EXPECT_EQ(down.written[0].load, "discard") << "each covers all";
  EXPECT_EQ(down.written[0].combine, "none");
  EXPECT_EQ(down.written[0].texels, 16u + 4 + 1);
  const PassCounts& draw = counts.at("draw");
  ASSERT_EQ(draw.by_texture.size(), 1u);
  EXPECT_EQ(draw.by_texture[0].levels, (Levels{0, 0, 256, 256}));
  EXPECT_EQ(draw.triangles, 2u);
  EXPECT_EQ(written(draw, "rgba16_float").load, "clear");
  EXPECT_EQ(written(draw, "rgba16_float").texels, 256u);
  if (backend_->info().issued_fragment_counts) {
    ASSERT_TRUE(draw.issued_fragments);
    EXPECT_GE(*draw.issued_fragments, draw.fragments);
  }
}

TEST_P(CountedLevels, OfAWalkUpAndOfMips) {
  write("top/base.frag", base_shader);
  write("top/add.frag",
        "layout(binding = 4) uniform sampler2D pyramid;\nlayout(location = 0) out vec4 value;\nvoid main() {\n"
        "  value = textureLod(pyramid, gl_FragCoord.xy / 8.0, 0.0);\n}\n");
  write("top/show.frag",
        "layout(binding = 4) uniform sampler2D pyramid;\nlayout(location = 0) out vec4 color;\n"
        "void main() { color = texelFetch(pyramid, ivec2(0), 0); }\n");
  const auto counts = counts_of(fullscreen_pass("base", "base.frag", "pyramid") +
                                pass_text("mips", "draw = \"mips\"\nwrite = [\"pyramid\"]\n") +
                                fullscreen_pass("up", "add.frag", "pyramid", "levels = \"up\"\n") + objects_pass("show.frag"));
  ASSERT_EQ(counts.at("up").by_texture.size(), 1u);
  EXPECT_EQ(counts.at("up").by_texture[0].levels, (Levels{0, 64, 16, 4}));
  EXPECT_EQ(counts.at("up").by_texture[0].unfiltered, 0u);
  EXPECT_EQ(counts.at("up").runs, 3u);
  const PassCounts& mips = counts.at("mips");
  EXPECT_EQ(mips.runs, 1u);
  EXPECT_EQ(mips.triangles, 0u);
  ASSERT_EQ(mips.written.size(), 1u);
  EXPECT_EQ(mips.written[0].load, "mips");
  EXPECT_EQ(mips.written[0].texels, 16u + 4 + 1);
}

INSTANTIATE_TEST_SUITE_P(Backends, CountedLevels, backend_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
