// SPDX-License-Identifier: Apache-2.0
// Passes of objects with or without a feature, depth that is cleared before every repetition, repetitions that were too few,
// and a frame that is read before anything is drawn: each asked of a picture that is known by hand, on every backend.
#include "tests/graph/made_effects.h"

namespace lamina {
namespace {

class ChosenObjects : public MadeEffects {
 protected:
  // An effect whose objects have the feature WHOLE where their number `amount` is at least 1.
  Library with_passes(const std::string& passes) {
    write_effect("part", "key = \"part\"",
                 "[numbers.amount]\nvalue = 0.5\n[features.WHOLE]\nneeds = [\"amount >= 1\"]\nbecause = \"b\"\n"
                 "not_because = \"n\"\n");
    write_variant("part", "part_full", passes);
    write("part/one.frag", "layout(location = 0) out vec4 color;\nvoid main() { color = vec4(0.25, 0.0, 0.0, 1.0); }\n");
    write("part/two.frag", "layout(location = 0) out vec4 color;\nvoid main() { color = vec4(0.0, 0.5, 0.0, 1.0); }\n");
    return made();
  }
  static Object amount(const std::string& name, float z, double value) {
    Object object = square(name, z, {"part"});
    object.effects["part"].numbers["amount"] = value;
    return object;
  }
};
INSTANTIATE_TEST_SUITE_P(Backends, ChosenObjects, backend_parameters, backend_test_name);

const std::string whole_pass =
    "draw = \"objects\"\nwith = \"WHOLE\"\nvertex = \"common/object.vert\"\nfragment = \"one.frag\"\n"
    "write = [\"frame\"]\nblend = \"additive\"\n";
const std::string rest_pass =
    "draw = \"objects\"\nwithout = \"WHOLE\"\nvertex = \"common/object.vert\"\nfragment = "
    "\"two.frag\"\nwrite = [\"frame\"]\nblend = \"additive\"\n";

TEST_P(ChosenObjects, AreThoseWithOrWithoutAFeature) {
  const Library library =
      with_passes(pass_text("whole", whole_pass) + pass_text("rest", rest_pass) +
                  fullscreen_pass("once_more", "two.frag", "frame", "without = \"WHOLE\"\nblend = \"additive\"\n"));
  const auto shown = [&](std::vector<Object> objects, size_t passes) {
    const auto made_frame = drawn(library, squares(std::move(objects)));
    EXPECT_EQ(made_frame->graph.passes.size(), passes);
    return pixel(made_frame->picture(), 8, 8);
  };
  EXPECT_EQ(shown({amount("a", 0, 1), amount("b", 0, 0.99), amount("c", 0, 3)}, 3), glm::vec3(0.5f, 1, 0));
  EXPECT_EQ(shown({amount("a", 0, 1), amount("b", 0, 1)}, 1), glm::vec3(0.5f, 0, 0)) << "no object without, so no such pass";
  EXPECT_EQ(shown({amount("a", 0, 0), amount("b", 0, 0)}, 2), glm::vec3(0, 1.5f, 0));
}

TEST_P(ChosenObjects, AFeatureThatIsNotThereIsNamed) {
  const Library library = with_passes(pass_text("whole",
                                                "draw = \"objects\"\nwith = \"WHOLLE\"\nvertex = \"common/object.vert\"\n"
                                                "fragment = \"one.frag\"\nwrite = [\"frame\"]\n"));
  try {
    drawn(library, squares({amount("a", 0, 1)}));
    ADD_FAILURE() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("unknown feature 'WHOLLE' (did you mean 'WHOLE'?)"), std::string::npos)
        << error.what();
  }
}

// Each of three repetitions lies farther away than the one before: it passes the test where the depth is cleared again.
TEST_P(ChosenObjects, DepthMayBeClearedBeforeEveryRepetition) {
  write("part/farther.frag",
        "layout(std140, binding = 2) uniform Pass { ivec4 iteration; };\nlayout(location = 0) out vec4 color;\n"
        "void main() { gl_FragDepth = 0.2 + 0.2 * float(iteration.x); color = vec4(0.25, 0.0, 0.0, 1.0); }\n");
  for (const bool again : {true, false}) {
    const Library library =
        with_passes("[targets.near]\nformat = \"d32_float\"\n" +
                    pass_text("count",
                              "draw = \"objects\"\nrepeat = 3\nvertex = \"common/object.vert\"\nfragment = \"farther.frag\"\n"
                              "write = [\"frame\"]\nblend = \"additive\"\ndepth = \"read_write\"\ndepth_target = \"near\"\n" +
                                  std::string(again ? "clear_depth_again = true\n" : "")));
    const Image picture = drawn(library, squares({amount("a", 0, 1)}))->picture();
    EXPECT_EQ(pixel(picture, 8, 8).r, again ? 0.75f : 0.25f);
  }
}

// Something is drawn by the first four repetitions.
TEST_P(ChosenObjects, RepetitionsThatWereTooFewAreTold) {
  write("part/until.frag",
        "layout(std140, binding = 2) uniform Pass { ivec4 iteration; };\nlayout(location = 0) out vec4 color;\n"
        "void main() { if (iteration.x > 3) discard; color = vec4(1.0); }\n");
  const Library library =
      with_passes("[parameters.most]\nvalue = 3\nmin = 1\nmax = 9\nwhole = true\n" +
                  pass_text("layers",
                            "draw = \"objects\"\nrepeat = \"$most\"\nuntil_empty = true\nvertex = \"common/object.vert\"\n"
                            "fragment = \"until.frag\"\nwrite = [\"frame\"]\n"));
  const Scene scene = squares({amount("a", 0, 1)});
  const auto few = drawn(library, scene), enough = drawn(library, scene, {{"part_full.most", 5}});
  ASSERT_EQ(few->frame.unfinished(0).size(), 1u);
  EXPECT_EQ(few->frame.unfinished(0)[0]->pass->name, "layers");
  EXPECT_TRUE(enough->frame.unfinished(0).empty());
}

// Nothing else draws: the frame is the background, and its depth is far away.
TEST_P(ChosenObjects, AFrameThatNothingWasDrawnIntoIsEmptyToRead) {
  write_effect("look", "key = \"look\"\nsolid = false\nreads_frame = true");
  write_variant("look", "look_full",
                fullscreen_pass("look", "look.frag", "seen") + fullscreen_pass("show", "show.frag", "frame") +
                    "[targets.seen]\nformat = \"rgba32_float\"\n");
  write("look/look.frag",
        "layout(binding = 4) uniform sampler2D frame;\nlayout(binding = 5) uniform sampler2D depth;\n"
        "layout(location = 0) out vec4 seen;\nvoid main() {\n  ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
        "  seen = vec4(texelFetch(frame, pixel, 0).rg, texelFetch(depth, pixel, 0).r, 1.0);\n}\n");
  write("look/show.frag",
        "layout(binding = 4) uniform sampler2D seen;\nlayout(location = 0) out vec4 color;\n"
        "void main() { color = texelFetch(seen, ivec2(gl_FragCoord.xy), 0); }\n");
  const Library library = made();
  Object object = square("a", 0, {"look"});
  object.solid = false;
  Scene scene = squares({object});
  scene.background = {0.25f, 0.5f, 0.75f};
  EXPECT_EQ(pixel(drawn(library, scene)->picture(), 8, 8), glm::vec3(0.25f, 0.5f, 1));
}

}  // namespace
}  // namespace lamina
