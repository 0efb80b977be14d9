// SPDX-License-Identifier: Apache-2.0
// The frame in which everything runs that can, on effects made for it: what is in it, what is not and why.
#include <algorithm>

#include "harness/graph/everything_graph.h"
#include "harness/graph/target_uses.h"
#include "tests/graph/made_effects.h"

namespace lamina {
namespace {

class Everything : public MadeEffects {
 protected:
  // Adds `amount` of the scene to the frame, over all of it.
  void write_glow(const std::string& needs = "needs = [\"amount\"]") {
    write_effect("glow", "reads_frame = true\n" + needs, "[scene.numbers.amount]\nvalue = 0.25\nrange = [0, 1]\n");
    write_variant("glow", "glow_full", fullscreen_pass("glow", "glow.frag", "frame", "blend = \"additive\"\n"));
    write("glow/glow.frag",
          "layout(std140, binding = 2) uniform Effect { float amount; };\nlayout(location = 0) out vec4 color;\n"
          "void main() { color = vec4(amount); }\n");
  }
  // Draws its objects, and nothing without them.
  void write_plain() {
    write_effect("plain", "key = \"plain\"");
    write_variant("plain", "plain_full", objects_pass("plain.frag", "depth = \"read_write\"\n"));
    write("plain/plain.frag", "layout(location = 0) out vec4 color;\nvoid main() { color = vec4(0.5); }\n");
  }
  struct Whole {
    Scene scene;
    EverythingPlan plan;
    Graph graph;
    std::vector<std::string> passes() const {
      std::vector<std::string> names;
      for (const GraphPass& pass : graph.passes) names.push_back(pass.pass->name);
      return names;
    }
  };
  Whole whole_of(const Library& library, const Scene& scene) {
    ShaderCache shaders(backend_->info().api, library.shaders);
    const Plan plan = make_plan(library, scene);
    Whole whole{scene_of_everything(scene, library), {}, {}};
    whole.plan = plan_of_everything(plan, whole.scene);
    whole.graph = make_graph_of_everything(whole.plan, plan, whole.scene, shaders);
    return whole;
  }
  Image picture_of(const Library& library, const Whole& whole) {
    Bakes bakes(whole.scene, *library.code, DiskCache(""));
    SceneResources resources(*backend_, whole.scene, library, 16, 16, &bakes);
    Frame frame(resources, whole.graph, Build::timed);
    frame.run(0, Timing::off);
    return frame.picture();
  }
  static size_t count(const std::vector<std::string>& names, const std::string& name) {
    return static_cast<size_t>(std::ranges::count(names, name));
  }
};
INSTANTIATE_TEST_SUITE_P(Backends, Everything, backend_parameters, backend_test_name);

TEST_P(Everything, AnEffectThatTheSceneDoesNotSpeakOfRunsAtZero) {
  write_glow();
  write_plain();
  const Library library = made();
  const Scene scene = squares({square("a", 0, {"plain"})});
  const Whole whole = whole_of(library, scene);
  EXPECT_EQ(count(whole.passes(), "glow"), 1u);
  EXPECT_EQ(whole.scene.effects.at("glow").numbers.at("amount"), 0);
  EXPECT_EQ(drawn(library, scene)->graph.passes.size(), 1u);
  EXPECT_EQ(pixel(picture_of(library, whole), 8, 8), pixel(drawn(library, scene)->picture(), 8, 8));
}

TEST_P(Everything, WhatHasNoPartInItSaysWhy) {
  write_glow("");
  write_plain();
  const Library library = made();
  const Whole whole = whole_of(library, squares({square("a", 0, {})}));
  EXPECT_EQ(whole.plan.cannot.at("plain"), "every pass of it draws its own objects, and there is none (n)");
  EXPECT_NE(whole.plan.cannot.at("glow").find("no number of it takes it away"), std::string::npos);
  EXPECT_EQ(count(whole.passes(), "glow") + count(whole.passes(), "draw"), 0u);
}

// An object that lacks what its effect needs keeps the effect, at 0; what nobody reads is drawn.
TEST_P(Everything, PassesThatNothingReadsRunToo) {
  write_effect("dim", "key = \"dim\"\nneeds = [\"amount\"]", "[numbers.amount]\nvalue = 1\nrange = [0, 1]\n");
  write_variant("dim", "dim_full",
                "[targets.unread]\nformat = \"r32_float\"\n" + fullscreen_pass("unread", "one.frag", "unread") +
                    objects_pass("one.frag", "depth = \"read_write\"\n"));
  write("dim/one.frag", "layout(location = 0) out vec4 color;\nvoid main() { color = vec4(1.0); }\n");
  const Library library = made();
  Scene scene = squares({square("a", 0, {"dim"})});
  scene.objects[0].effects["dim"].numbers["amount"] = 0;
  const Whole whole = whole_of(library, scene);
  EXPECT_EQ(count(whole.passes(), "unread"), 1u);
  EXPECT_EQ(whole.plan.plan.of("dim")->objects, std::vector<size_t>{0});
  EXPECT_TRUE(whole.plan.plan.of("surface")->objects.empty());
  EXPECT_FALSE(make_plan(library, scene).of("dim")->called_for);
  scene.objects[0].effects["dim"].numbers["amount"] = 1;
  EXPECT_EQ(drawn(library, scene)->graph.dropped.size(), 1u) << "the plan leaves it out";
}

// With `vanishes` an object that lacks what its effect needs is nowhere: no surface, and in no pass of all objects.
TEST_P(Everything, AnObjectMayVanish) {
  for (const std::string vanishes : {"", "vanishes = true"}) {
    write_effect("dim", "key = \"dim\"\nneeds = [\"amount\"]\n" + vanishes, "[numbers.amount]\nvalue = 1\nrange = [0, 1]\n");
    write_variant("dim", "dim_full", objects_pass("one.frag", "depth = \"read_write\"\n"));
    write("dim/one.frag", "layout(location = 0) out vec4 color;\nvoid main() { color = vec4(1.0); }\n");
    const Library library = made();
    Scene scene = squares({square("a", 0, {"dim"}), square("b", 0, {})});
    scene.objects[0].effects["dim"].numbers["amount"] = 0;
    const Plan plan = make_plan(library, scene);
    const std::vector<size_t> both = {0, 1}, second = {1};
    EXPECT_EQ(plan.of("surface")->objects, vanishes.empty() ? both : second);
    EXPECT_EQ(plan.all, vanishes.empty() ? both : second);
    EXPECT_EQ(plan.opaque, vanishes.empty() ? both : second);
  }
}

// A frame in which nothing is called for is the background, as the frame of everything is.
TEST_P(Everything, AFrameOfNothingIsTheBackground) {
  write_effect("dim", "key = \"dim\"\nneeds = [\"amount\"]\nvanishes = true", "[numbers.amount]\nvalue = 0\n");
  write_variant("dim", "dim_full", objects_pass("one.frag", "depth = \"read_write\"\n"));
  write("dim/one.frag", "layout(location = 0) out vec4 color;\nvoid main() { discard; }\n");
  const Library library = made();
  Scene scene = squares({square("a", 0, {"dim"})});
  scene.background = {0.25f, 0.5f, 0.75f};
  EXPECT_TRUE(drawn(library, scene)->graph.passes.empty());
  EXPECT_EQ(pixel(drawn(library, scene)->picture(), 3, 8), scene.background);
}

// Features that shaders say to be the same at 0 are compiled in, others are not.
TEST_P(Everything, FeaturesAreOnWhereShadersDrawTheSameAtZero) {
  write_effect("dim", "key = \"dim\"",
               "[numbers.amount]\nvalue = 0\nrange = [0, 1]\n[features.MORE]\nneeds = [\"amount\"]\nbecause = \"b\"\n"
               "not_because = \"n\"\nat_zero = true\n[features.OTHER]\nneeds = [\"amount\"]\nbecause = \"b\"\n"
               "not_because = \"n\"\n");
  write_variant("dim", "dim_full", objects_pass("one.frag", "depth = \"read_write\"\n"));
  write("dim/one.frag",
        "layout(location = 0) out vec4 color;\nvoid main() {\n  color = vec4(0.5);\n#ifdef MORE\n  color.r = 1.0;\n#endif\n"
        "#ifdef OTHER\n  color.g = 1.0;\n#endif\n}\n");
  const Library library = made();
  Scene scene = squares({square("a", 0, {"dim"})});
  scene.objects[0].effects["dim"].numbers["amount"] = 0;
  EXPECT_EQ(pixel(drawn(library, scene)->picture(), 8, 8), glm::vec3(0.5f));
  EXPECT_EQ(pixel(picture_of(library, whole_of(library, scene)), 8, 8), glm::vec3(1, 0.5f, 0.5f));
}

// Of every kind of target and buffer the plan's bytes are those that are made.
TEST_P(Everything, TargetsTakeWhatThePlanSays) {
  write_effect("one", "key = \"one\"");
  write_variant(
      "one", "one_full",
      "[targets.smaller]\nscale = 0.5\nformat = \"rgba16_float\"\nmips = true\n[targets.pair]\nformat = \"r32_float\"\n"
      "buffers = 2\n[targets.own]\nscope = \"object\"\nsize = [8, 4]\nformat = \"rg32_float\"\n"
      "[targets.agreed]\nformat = \"r32_float\"\nshared = true\n" +
          fullscreen_pass("smaller", "fill.frag", "smaller") + fullscreen_pass("pair", "fill.frag", "pair") +
          fullscreen_pass("own", "fill.frag", "own") + fullscreen_pass("agreed", "fill.frag", "agreed") +
          objects_pass("show.frag", "depth = \"read_write\"\n"));
  write("one/fill.frag", "layout(location = 0) out vec4 value;\nvoid main() { value = vec4(0.5); }\n");
  write("one/show.frag",
        "layout(binding = 4) uniform sampler2D smaller;\nlayout(binding = 5) uniform sampler2D pair;\n"
        "layout(binding = 6) uniform sampler2D own;\nlayout(binding = 7) uniform sampler2D agreed;\n"
        "layout(location = 0) out vec4 color;\nvoid main() { color = texelFetch(smaller, ivec2(0), 0) + texelFetch(pair, "
        "ivec2(0), 0) "
        "+ texelFetch(own, ivec2(0), 0) + texelFetch(agreed, ivec2(0), 0); }\n");
  const Library library = made();
  const Scene scene = squares({square("a", 0, {"one"}), square("b", 1, {"one"})});
  const auto frame = drawn(library, scene);
  uint64_t bytes = 0;
  std::map<std::string, TargetUse> uses;
  for (const TargetUse& use : target_uses(frame->graph, scene, 16, 16)) bytes += use.bytes, uses[use.name] = use;
  EXPECT_EQ(bytes, frame->frame.target_bytes());
  EXPECT_EQ(uses.at("smaller").bytes, (8 * 8 + 4 * 4 + 2 * 2 + 1) * 8u);
  EXPECT_EQ(uses.at("pair").bytes, 2 * 16 * 16 * 4u);
  EXPECT_EQ(uses.at("own").bytes, 2 * 8 * 4 * 8u) << "one for each object";
  EXPECT_EQ(uses.at("own").copies, 2u);
  EXPECT_TRUE(uses.at("agreed").shared);
  EXPECT_EQ(uses.at("agreed").writers, std::vector<size_t>{3});
  EXPECT_EQ(uses.at("agreed").readers, std::vector<size_t>{4});
  EXPECT_EQ(uses.at("frame").writers, std::vector<size_t>{4});
}

}  // namespace
}  // namespace lamina
