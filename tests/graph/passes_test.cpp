// SPDX-License-Identifier: Apache-2.0
// What passes can do, each asked of a picture that is known by hand, on every backend.
#include "tests/graph/made_effects.h"

namespace lamina {
namespace {

class Passes : public MadeEffects {};
INSTANTIATE_TEST_SUITE_P(Backends, Passes, backend_parameters, backend_test_name);

constexpr float half_precision = 0.002f;

// Glass in front of a wall turns what it covers to its negative. The pass draws objects into the frame that it reads: what it
// does not cover must stay, and what it draws must be seen.
TEST_P(Passes, ObjectsMayReadTheFrameThatTheyAreDrawnInto) {
  write_effect("glass", "key = \"glass\"\nreads_frame = true\norder = -5");
  write_variant("glass", "negative", objects_pass("negative.frag"));
  write("glass/negative.frag",
        "layout(binding = 4) uniform sampler2D frame;\nlayout(location = 0) out vec4 color;\n"
        "void main() { color = vec4(1.0 - texelFetch(frame, ivec2(gl_FragCoord.xy), 0).rgb, 1.0); }\n");
  const Library library = made();
  Scene scene = squares({square("wall", 0, {}), square("glass", 1, {"glass"})});
  scene.objects[0].effects["surface"].textures["albedo"] =
      constant_texture("wall", {0.25f, 0.25f, 0.25f, 1}, TexelMeaning::colour);
  for (Vertex& vertex : scene.objects[1].mesh.vertices) vertex.position.x = std::min(vertex.position.x, 0.0f);  // the left half
  const Image picture = drawn(library, scene)->picture();
  EXPECT_NEAR(pixel(picture, 3, 8).r, 0.75f, half_precision);
  EXPECT_NEAR(pixel(picture, 12, 8).r, 0.25f, half_precision) << "what the glass does not cover stays";
}

// Two effects have a target of the same name in their passes for the truth: each tells its own.
TEST_P(Passes, TargetsOfTwoVariantsWithOneNameAreTwo) {
  for (const std::string name : {"one", "two"}) {
    write_effect(name, "key = \"" + name + "\"");
    write_variant(name, name + "_full",
                  "[targets.seen]\nformat = \"rgba32_float\"\n" +
                      pass_text("tell",
                                "when = \"truth\"\ndraw = \"objects\"\nvertex = \"common/object.vert\"\n"
                                "fragment = \"tell.frag\"\nwrite = [\"seen\"]\ncull = \"back\"\n") +
                      objects_pass("tell.frag"));
    write(name + "/tell.frag", "layout(location = 0) out vec4 seen;\nvoid main() { seen = vec4(" +
                                   std::string(name == "one" ? "1.0" : "2.0") + "); }\n");
  }
  const Library library = made();
  const Scene scene = squares({square("a", 0, {"one"}), square("b", 0, {"two"})});
  for (const auto& [name, seen] : {std::pair("one", 1.0f), std::pair("two", 2.0f)}) {
    const VariantManifest& baseline = library.effect(name).baseline();
    EXPECT_EQ(drawn(library, scene, {}, Build::timed, 16, &baseline)->frame.target(baseline, "seen").rgba[0], seen);
  }
}

// Fog's truth needs the picture that the effects before it draw, whether or not these have truths of their own.
TEST_P(Passes, OfATruthTheOtherEffectsDrawTheirFrames) {
  for (const char* name : {"before", "mist"}) {
    write_effect(name, "key = \"" + std::string(name) + "\"");
    write_variant(name, std::string(name) + "_full",
                  "[targets.seen]\nformat = \"rgba32_float\"\n" +
                      fullscreen_pass("tell", "tell.frag", "seen", "when = \"truth\"\n") +
                      fullscreen_pass("draw_" + std::string(name), "tell.frag", "frame"));
    write(std::string(name) + "/tell.frag", "layout(location = 0) out vec4 value;\nvoid main() { value = vec4(0.25); }\n");
  }
  const Library library = made();
  const Scene scene = squares({square("a", 0, {"before"}), square("b", 0, {"mist"})});
  const auto told = drawn(library, scene, {}, Build::timed, 16, &library.effect("mist").baseline());
  EXPECT_EQ(told->frame.frame_names(), (std::vector<std::string>{"draw_before", "tell"}));
}

// What a pass for both wrote is what a pass for the truth reads; a pass of the frame alone is not run for the truth.
TEST_P(Passes, APassForTheFrameAndTheTruthServesBoth) {
  write_effect("one", "key = \"one\"");
  write_variant("one", "one_full",
                "[targets.value]\nformat = \"rgba32_float\"\n[targets.seen]\nformat = \"rgba32_float\"\n" +
                    fullscreen_pass("fill", "fill.frag", "value", "when = \"frame_and_truth\"\n") +
                    fullscreen_pass("tell", "copy.frag", "seen", "when = \"truth\"\n") +
                    fullscreen_pass("show", "copy.frag", "frame"));
  write("one/fill.frag", "layout(location = 0) out vec4 value;\nvoid main() { value = vec4(0.625); }\n");
  write("one/copy.frag",
        "layout(binding = 4) uniform sampler2D value;\nlayout(location = 0) out vec4 seen;\n"
        "void main() { seen = texelFetch(value, ivec2(0), 0); }\n");
  const Library library = made();
  const Scene scene = squares({square("a", 0, {"one"})});
  const auto shown = drawn(library, scene);
  EXPECT_EQ(shown->frame.frame_names(), (std::vector<std::string>{"fill", "show"}));
  EXPECT_EQ(pixel(shown->picture(), 3, 8).r, 0.625f);
  const auto told = drawn(library, scene, {}, Build::timed, 16, &library.effect("one").baseline());
  EXPECT_EQ(told->frame.frame_names(), (std::vector<std::string>{"fill", "tell"}));
  EXPECT_EQ(told->frame.target(library.effect("one").baseline(), "seen").rgba[0], 0.625f);
}

// A pass of all opaque objects in a scene that has none leaves its target as it clears it.
TEST_P(Passes, APassWithoutObjectsClearsItsTargets) {
  write_effect("one", "key = \"one\"\nsolid = false");
  write_variant("one", "one_full",
                "[targets.value]\nformat = \"rgba32_float\"\n" +
                    pass_text("fill",
                              "draw = \"objects\"\nof = \"opaque\"\nvertex = \"common/object.vert\"\n"
                              "fragment = \"fill.frag\"\nwrite = [\"value\"]\nclear = [0.625, 0, 0, 0]\n") +
                    fullscreen_pass("show", "copy.frag", "frame"));
  write("one/fill.frag", "layout(location = 0) out vec4 value;\nvoid main() { value = vec4(1.0); }\n");
  write("one/copy.frag",
        "layout(binding = 4) uniform sampler2D value;\nlayout(location = 0) out vec4 seen;\n"
        "void main() { seen = texelFetch(value, ivec2(0), 0); }\n");
  const Library library = made();
  Scene scene = squares({square("a", 0, {"one"})});
  scene.objects[0].solid = false;
  EXPECT_EQ(pixel(drawn(library, scene)->picture(), 3, 8).r, 0.625f);
}

// Two effects share a target: the first to draw it serves both, and each reads it.
TEST_P(Passes, ASharedTargetIsDrawnOnce) {
  for (const std::string name : {"one", "two"}) {
    write_effect(name, "key = \"" + name + "\"");
    write_variant(name, name + "_full",
                  "[targets.agreed]\nformat = \"r32_float\"\nshared = true\n" +
                      fullscreen_pass("fill_" + name, "fill.frag", "agreed") +
                      objects_pass("show.frag", "depth = \"read_write\"\n"));
    write(name + "/fill.frag", "layout(location = 0) out vec4 value;\nvoid main() { value = vec4(0.625); }\n");
    write(name + "/show.frag",
          "layout(binding = 4) uniform sampler2D agreed;\nlayout(location = 0) out vec4 color;\n"
          "void main() { color = texelFetch(agreed, ivec2(0), 0); }\n");
  }
  const Library library = made();
  Scene scene = squares({square("a", 0, {"one"}), square("b", 0, {"two"})});
  for (Vertex& vertex : scene.objects[0].mesh.vertices) vertex.position.x = std::min(vertex.position.x, 0.0f);
  const auto both = drawn(library, scene);
  EXPECT_EQ(both->frame.frame_names(), (std::vector<std::string>{"fill_one", "draw", "draw"}));
  ASSERT_EQ(both->graph.dropped.size(), 1u);
  EXPECT_EQ(both->graph.dropped[0].reason, "left out: one has drawn the same");
  EXPECT_EQ(pixel(both->picture(), 3, 8).r, 0.625f);
  EXPECT_EQ(pixel(both->picture(), 12, 8).r, 0.625f);
}

// A target that nothing wrote, and a member that is not known: one message each, with the pass's place.
TEST_P(Passes, WhatIsNotThereIsNamed) {
  const auto refusal = [&](const std::string& manifest, const std::string& shader) {
    write_effect("thing", "key = \"thing\"", "[numbers.amount]\nvalue = 1\n");
    write_variant("thing", "thing_full", manifest);
    write("thing/show.frag", shader + "layout(location = 0) out vec4 color;\nvoid main() { color = VALUE; }\n");
    try {
      const Library library = made();
      drawn(library, squares({square("a", 0, {"thing"})}));
      return std::string();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      return std::string(error.what());
    }
  };
  const std::string unwritten =
      refusal("[targets.never]\nformat = \"r32_float\"\n" + objects_pass("show.frag"),
              "#define VALUE texelFetch(never, ivec2(0), 0)\nlayout(binding = 4) uniform sampler2D never;\n");
  EXPECT_NE(unwritten.find("thing_full.toml:6: pass 'draw' reads 'never' before any pass has written it"), std::string::npos)
      << unwritten;
  const std::string member = refusal(
      objects_pass("show.frag"), "#define VALUE vec4(amont)\nlayout(std140, binding = 3) uniform Effect { float amont; };\n");
  EXPECT_NE(member.find("thing_full.toml:4"), std::string::npos) << member;
  EXPECT_NE(member.find("did you mean 'amount'?"), std::string::npos) << member;
  const std::string frame = refusal(objects_pass("show.frag"),
                                    "#define VALUE texelFetch(frame, ivec2(0), 0)\nlayout(binding = 4) "
                                    "uniform sampler2D frame;\n");
  EXPECT_NE(frame.find("say reads_frame = true"), std::string::npos) << frame;
}

const std::string pyramid_target = "[targets.pyramid]\nsize = [8, 8]\nformat = \"r32_float\"\nmips = true\n";
const std::string row_shader =  // 0 to 7 along x
    "layout(location = 0) out vec4 value;\nvoid main() { value = vec4(floor(gl_FragCoord.x), 0, 0, 1); }\n";

// A pyramid of the greatest: each level from the one above, 8 to 1 texels; the last holds the greatest of all, 7.
TEST_P(Passes, APyramidIsWrittenLevelByLevel) {
  write_effect("top", "key = \"top\"");
  write_variant("top", "top_full",
                pyramid_target + fullscreen_pass("base", "row.frag", "pyramid") +
                    fullscreen_pass("down", "greatest.frag", "pyramid", "levels = \"down\"\n") + objects_pass("show.frag"));
  write("top/row.frag", row_shader);
  write("top/greatest.frag",
        "layout(binding = 4) uniform sampler2D pyramid;\nlayout(location = 0) out vec4 value;\nvoid main() {\n"
        "  ivec2 at = ivec2(gl_FragCoord.xy) * 2;\n"
        "  value = vec4(max(texelFetch(pyramid, at, 0).r, texelFetch(pyramid, at + ivec2(1, 0), 0).r), 0, 0, 1);\n}\n");
  write("top/show.frag",
        "layout(binding = 4) uniform sampler2D pyramid;\nlayout(location = 0) out vec4 color;\n"
        "void main() { color = vec4(texelFetch(pyramid, ivec2(0), 3).r, texelFetch(pyramid, ivec2(0), 2).r, "
        "textureSize(pyramid, 0).x, 1); }\n");
  const Library library = made();
  const Image picture = drawn(library, squares({square("a", 0, {"top"})}))->picture();
  EXPECT_EQ(pixel(picture, 8, 8), glm::vec3(7, 3, 8)) << "the last level; the left texel of two; the base's width";
}

// Up again: each level adds one to what the level below it holds there, so the base has as many more as there are steps.
TEST_P(Passes, APyramidIsWalkedUpToo) {
  write_effect("top", "key = \"top\"");
  write_variant("top", "top_full",
                pyramid_target + fullscreen_pass("base", "row.frag", "pyramid") +
                    pass_text("mips", "draw = \"mips\"\nwrite = [\"pyramid\"]\n") +
                    fullscreen_pass("up", "add.frag", "pyramid", "levels = \"up\"\n") + objects_pass("show.frag"));
  write("top/row.frag", row_shader);
  write("top/add.frag",
        "layout(binding = 4) uniform sampler2D pyramid;\nlayout(location = 0) out vec4 value;\nvoid main() {\n"
        "  value = vec4(texelFetch(pyramid, ivec2(gl_FragCoord.xy) / 2, 0).r + 1.0, 0, 0, 1);\n}\n");
  write("top/show.frag",
        "layout(binding = 4) uniform sampler2D pyramid;\nlayout(location = 0) out vec4 color;\n"
        "void main() { color = vec4(texelFetch(pyramid, ivec2(5, 5), 0).r, texelFetch(pyramid, ivec2(0), 2).r, 0, 1); }\n");
  const Library library = made();
  const Image picture = drawn(library, squares({square("a", 0, {"top"})}))->picture();
  EXPECT_EQ(pixel(picture, 8, 8), glm::vec3(3.5f + 3, 3.5f + 1, 0)) << "the mean of 0 to 7, and three steps, or one";
}

// Depth peeling: squares one behind the other, front to back. Each repetition draws the nearest that lies behind what the one
// before drew, and adds its red; it ends after the repetition that finds none.
TEST_P(Passes, PeelingAlternatesDepthAndEndsWhereNothingIsLeft) {
  write_effect("peel", "key = \"peel\"");
  write_variant("peel", "peel_full",
                "[targets.sum]\nformat = \"rgba32_float\"\n[targets.layer]\nformat = \"d32_float\"\nbuffers = 2\n" +
                    pass_text("layers",
                              "draw = \"objects\"\nrepeat = 9\nuntil_empty = true\nvertex = \"common/object.vert\"\nfragment = "
                              "\"peel.frag\"\nwrite = [\"sum\"]\nblend = \"additive\"\ndepth = \"read_write\"\ndepth_target = "
                              "\"layer\"\nread = { before = \"layer\" }\n") +
                    fullscreen_pass("show", "show.frag", "frame"));
  write("peel/peel.frag",
        "layout(binding = 4) uniform sampler2D before;\nlayout(location = 0) out vec4 sum;\nvoid main() {\n"
        "  if (gl_FragCoord.z <= texelFetch(before, ivec2(gl_FragCoord.xy), 0).r) discard;\n  sum = vec4(1, 0, 0, 1);\n}\n");
  write("peel/show.frag",
        "layout(binding = 4) uniform sampler2D sum;\nlayout(location = 0) out vec4 color;\n"
        "void main() { color = texelFetch(sum, ivec2(gl_FragCoord.xy), 0); }\n");
  const Library library = made();
  for (const size_t layers : {1u, 2u, 3u, 5u}) {
    std::vector<Object> objects;
    for (size_t i = 0; i < layers; ++i) objects.push_back(square("s" + std::to_string(i), float(i) * -0.5f, {"peel"}));
    const Scene scene = squares(objects);
    const auto made_frame = drawn(library, scene);
    EXPECT_EQ(pixel(made_frame->picture(), 8, 8).r, float(layers));
    const size_t drawn_passes = made_frame->frame.slices(0, std::vector<uint32_t>(2, 1)).size();
    // Clears the first buffer, then a repetition a layer, rounded up to two, and the picture.
    EXPECT_EQ(drawn_passes, 1 + (layers + 1) / 2 * 2 + 1) << layers;
  }
}

// Each of two targets by its own blending: one adds, the other multiplies.
TEST_P(Passes, TargetsBlendEachInItsOwnWay) {
  write_effect("mix", "key = \"mix\"");
  write_variant("mix", "mix_full",
                "[targets.sum]\nformat = \"r32_float\"\n[targets.product]\nformat = \"rgba16_float\"\n" +
                    pass_text("blend",
                              "draw = \"objects\"\nvertex = \"common/object.vert\"\nfragment = \"two.frag\"\nwrite = [\"sum\", "
                              "\"product\"]\nblend = [\"additive\", \"multiplied\"]\nclear = [0.5, 0.5, 0.5, 0.5]\n") +
                    fullscreen_pass("show", "show.frag", "frame"));
  write("mix/two.frag",
        "layout(location = 0) out vec4 a;\nlayout(location = 1) out vec4 b;\nvoid main() { a = b = vec4(0.25); }\n");
  write("mix/show.frag",
        "layout(binding = 4) uniform sampler2D sum;\nlayout(binding = 5) uniform sampler2D product;\nlayout(location = 0) out "
        "vec4 "
        "color;\nvoid main() { color = vec4(texelFetch(sum, ivec2(3), 0).r, texelFetch(product, ivec2(3), 0).r, 0, 1); }\n");
  const Library library = made();
  const Image picture = drawn(library, squares({square("a", 0, {"mix"}), square("b", 1, {"mix"})}))->picture();
  EXPECT_NEAR(pixel(picture, 8, 8).r, 1.0f, half_precision) << "0.5 + 0.25 + 0.25";
  EXPECT_NEAR(pixel(picture, 8, 8).g, 0.03125f, half_precision) << "0.5 * 0.25 * 0.25";
}

// The nearest square's depth is drawn first; equal shows it alone, greater what lies behind it.
TEST_P(Passes, DepthMayBeTestedForEqualAndGreater) {
  for (const std::string test : {"equal", "greater"}) {
    write_effect("depths", "key = \"depths\"");
    write_variant("depths", "depths_full",
                  pass_text("first",
                            "draw = \"objects\"\nvertex = \"common/object.vert\"\nfragment = \"count.frag\"\nwrite = "
                            "[\"frame\"]\ndepth = \"read_write\"\n") +
                      pass_text("second",
                                "draw = \"objects\"\nvertex = \"common/object.vert\"\nfragment = \"count.frag\"\nwrite "
                                "= [\"frame\"]\ndepth = \"read\"\ndepth_test = \"" +
                                    test + "\"\nclear = [0, 0, 0, 0]\nblend = \"additive\"\n"));
    write("depths/count.frag",
          "layout(location = 0) out vec4 color;\nvoid main() { color = vec4(1, gl_FragCoord.z, 0, 1); }\n");
    const Library library = made();
    const Image picture =
        drawn(library, squares({square("a", 0, {"depths"}), square("b", 1, {"depths"}), square("c", 2, {"depths"})}))
            ->picture();
    EXPECT_EQ(pixel(picture, 8, 8).r, test == "equal" ? 1 : 2) << test;
  }
}

// Each pass counts what it draws: an object of the effect, one that reads the frame, and one that is no solid thing.
TEST_P(Passes, OwnAllAndOpaqueObjectsAreTold) {
  write_effect("map", "key = \"map\"");
  std::string targets, passes;
  for (const std::string of : {"own", "all", "opaque"}) {
    targets += "[targets.seen_" + of + "]\nformat = \"r32_float\"\n";
    passes += pass_text(of, "draw = \"objects\"\nof = \"" + of +
                                "\"\nvertex = \"common/object.vert\"\nfragment = \"one.frag\"\nwrite = [\"seen_" + of +
                                "\"]\nblend = \"additive\"\n");
  }
  write_variant("map", "map_full", targets + passes + fullscreen_pass("show", "show.frag", "frame"));
  write("map/one.frag", "layout(location = 0) out vec4 count;\nvoid main() { count = vec4(1); }\n");
  write("map/show.frag",
        "layout(binding = 4) uniform sampler2D seen_own;\nlayout(binding = 5) uniform sampler2D seen_all;\n"
        "layout(binding = 6) uniform sampler2D seen_opaque;\nlayout(location = 0) out vec4 color;\nvoid main() {\n"
        "  ivec2 at = ivec2(gl_FragCoord.xy);\n  color = vec4(texelFetch(seen_own, at, 0).r, texelFetch(seen_all, at, 0).r, "
        "texelFetch(seen_opaque, at, 0).r, 1);\n}\n");
  write_effect("glass", "key = \"glass\"\nreads_frame = true");
  write_variant("glass", "clear", objects_pass("clear.frag"));
  write("glass/clear.frag",
        "layout(binding = 4) uniform sampler2D frame;\nlayout(location = 0) out vec4 color;\n"
        "void main() { color = texelFetch(frame, ivec2(gl_FragCoord.xy), 0); }\n");
  write_effect("mist", "key = \"mist\"");
  write_variant("mist", "thin", objects_pass("thin.frag"));
  write("mist/thin.frag", "layout(location = 0) out vec4 color;\nvoid main() { discard; }\n");
  const Library library = made();
  Scene scene = squares({square("a", 0, {"map"}), square("b", 1, {"glass"}), square("c", 2, {"mist"})});
  scene.objects[2].solid = false;
  EXPECT_EQ(pixel(drawn(library, scene)->picture(), 8, 8), glm::vec3(1, 2, 1)) << "own, all, opaque";
}

// A parameter sets a definition, how often a pass is repeated, a target's size and its format.
TEST_P(Passes, ParametersSetDefinitionsRepetitionsSizesAndFormats) {
  write_effect("knobs", "key = \"knobs\"");
  write_variant(
      "knobs", "knobs_full",
      "[parameters.add]\nvalue = 2\nmin = 1\nmax = 9\nwhole = true\n[parameters.times]\nvalue = 3\nmin = 0\nmax = 9\nwhole "
      "= true\n[parameters.side]\nvalue = 4\nmin = 1\nmax = 64\n[parameters.kind]\nvalue = \"r32_float\"\nof = "
      "[\"r32_float\", \"r8_unorm\"]\n[targets.sum]\nsize = [\"$side\", \"$side\"]\nformat = \"$kind\"\n" +
          fullscreen_pass("base", "zero.frag", "sum") +
          fullscreen_pass("add", "add.frag", "sum",
                          "repeat = \"$times\"\nblend = \"additive\"\ndefine = { ADD = \"$add\" }\n") +
          objects_pass("show.frag"));
  write("knobs/zero.frag", "layout(location = 0) out vec4 value;\nvoid main() { value = vec4(0); }\n");
  write("knobs/add.frag", "layout(location = 0) out vec4 value;\nvoid main() { value = vec4(ADD); }\n");
  write("knobs/show.frag",
        "layout(binding = 4) uniform sampler2D sum;\nlayout(location = 0) out vec4 color;\n"
        "void main() { color = vec4(texelFetch(sum, ivec2(0), 0).r, textureSize(sum, 0).x, 0, 1); }\n");
  const Library library = made();
  const Scene scene = squares({square("a", 0, {"knobs"})});
  EXPECT_EQ(pixel(drawn(library, scene)->picture(), 8, 8), glm::vec3(6, 4, 0));
  EXPECT_EQ(pixel(drawn(library, scene, {{"knobs_full.add", 5}, {"knobs_full.side", 7}})->picture(), 8, 8),
            glm::vec3(15, 7, 0));
  const auto none = drawn(library, scene, {{"knobs_full.times", 0}});
  EXPECT_EQ(pixel(none->picture(), 8, 8), glm::vec3(0, 4, 0));
  EXPECT_EQ(none->frame.frame_names(), (std::vector<std::string>{"base", "draw"})) << "left out";
  EXPECT_EQ(pixel(drawn(library, scene, {{"knobs_full.kind", 1}})->picture(), 8, 8), glm::vec3(1, 4, 0)) << "8 bits end at 1";
}

// One thread a texel writes its own number into a storage image, and counts itself in a storage buffer; two fetches each.
TEST_P(Passes, ComputeWritesImagesAndBuffersAndIsCounted) {
  write_effect("work", "key = \"work\"");
  write("work/row.frag", row_shader);
  write("work/work.comp",
        "layout(local_size_x = 8, local_size_y = 8) in;\nlayout(binding = 4) uniform sampler2D source_row;\n"
        "layout(binding = 5, r32f) uniform writeonly image2D result;\nlayout(std430, binding = 6) buffer Tally { uint threads; "
        "};\n"
        "void main() {\n  ivec2 at = ivec2(gl_GlobalInvocationID.xy);\n  if (any(greaterThanEqual(at, imageSize(result)))) "
        "return;\n"
        "  atomicAdd(threads, 1u);\n"
        "  imageStore(result, at, vec4(texelFetch(source_row, at, 0).r + 100.0 * texelFetch(source_row, at.yx, 0).r));\n}\n");
  write("work/show.frag",
        "layout(binding = 4) uniform sampler2D result;\nlayout(std430, binding = 6) readonly buffer Tally { uint threads; };\n"
        "layout(location = 0) out vec4 color;\nvoid main() { color = vec4(texelFetch(result, ivec2(5, 3), 0).r, threads, 0, "
        "1); }\n");
  write_variant(
      "work", "work_full",
      "[targets.source_row]\nsize = [13, 9]\nformat = \"r32_float\"\n[targets.result]\nsize = [13, 9]\nformat = "
      "\"r32_float\"\n[buffers.Tally]\nbytes = 4\n" +
          fullscreen_pass("base", "row.frag", "source_row") +
          pass_text("work", "draw = \"compute\"\ncompute = \"work.comp\"\nwrite = [\"result\"]\nthreads_over = \"result\"\n") +
          objects_pass("show.frag"));
  const Library library = made();
  const Scene scene = squares({square("a", 0, {"work"})});
  EXPECT_EQ(pixel(drawn(library, scene)->picture(), 8, 8), glm::vec3(5 + 100 * 3, 13 * 9, 0));
  const auto counted = drawn(library, scene, {}, Build::counting);
  const PassCounts counts = counted->frame.frame_counts()[1];
  EXPECT_EQ(counts.fragments, 16u * 16u) << "two by two groups of 64";
  EXPECT_EQ(counts.fetches(), 2u * 13u * 9u) << "threads beyond the image return first";
}

TEST_P(Passes, OperationsOfAllObjectsAndStagesAddUp) {
  write_effect("rooted", "key = \"rooted\"");
  write("rooted/draw.frag", "layout(location = 0) out vec4 color;\nvoid main() { color = vec4(sqrt(gl_FragCoord.xyz), 1); }\n");
  write_variant("rooted", "rooted_full", objects_pass("draw.frag"));
  const Library library = made();
  const Scene scene = squares({square("a", 0, {"rooted"}), square("b", 0, {"rooted"})});
  const auto counted = drawn(library, scene, {}, Build::counting);
  const PassCounts counts = counted->frame.frame_counts().at(0);
  EXPECT_EQ(counts.fragments, 2u * 16u * 16u);
  EXPECT_EQ(counts.operations.at("root"), 3 * counts.fragments);
  EXPECT_EQ(counts.operations.at("input"), (3u + 3u + 4u + 1u + 2u) * counts.vertices)
      << "as common/object.vert reads them: the w of the tangent by itself";
}

}  // namespace
}  // namespace lamina
