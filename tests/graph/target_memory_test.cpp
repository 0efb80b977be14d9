// SPDX-License-Identifier: Apache-2.0
// Targets that are needed at different times share memory, which changes no picture; those that are needed always, or that hold
// something before they are filled, keep theirs and say why. LAMINA_ALL_SCENES=1 draws every variant of every built-in scene.
#include <algorithm>
#include <cstdlib>

#include "harness/graph/lifetimes.h"
#include "harness/graph/target_uses.h"
#include "harness/quality/same_bits.h"
#include "tests/graph/layer_stacks.h"
#include "tests/graph/made_effects.h"
#include "tests/graph/small_parameters.h"

namespace lamina {
namespace {

class SharedTargets : public MadeEffects {
 protected:
  static constexpr uint32_t size_px = 16;

  // A full-screen pass that writes `target` from `source`, a colour where that is "".
  void add_step(const std::string& source, const std::string& target, const std::string& rest = "") {
    const std::string file = "to_" + target + ".frag";
    const std::string read =
        source.empty() ? "vec4(0.5, 0.25, 1.0, 1.0)" : "texelFetch(" + source + ", ivec2(gl_FragCoord.xy), 0)";
    write("one/" + file, (source.empty() ? "" : "layout(binding = 4) uniform sampler2D " + source + ";\n") +
                             "layout(location = 0) out vec4 made;\nvoid main() { made = 0.75 * " + read + "; }\n");
    passes_ += fullscreen_pass("to_" + target, file, target, rest);
  }
  Library library_of(const std::string& targets) {
    write_effect("one", "key = \"one\"\norder = 5\nreads_frame = true");
    write_variant("one", "one_full", targets + passes_);
    return made();
  }
  static std::string targets_named(const std::vector<std::string>& names, const std::string& rest = "") {
    std::string text;
    for (const std::string& name : names) text += "[targets." + name + "]\nformat = \"rgba16_float\"\n" + rest;
    return text;
  }
  Scene scene_of() { return squares({square("a", 0, {"one"})}); }

  std::unique_ptr<DrawnFrame> frame_of(const Library& library, const Scene& scene, TargetSharing sharing) {
    return std::make_unique<DrawnFrame>(*backend_, library, scene,
                                        DrawnFrame::Choice{.width = size_px, .height = size_px, .sharing = sharing});
  }
  // By the target's name, "one_full." left out.
  std::map<std::string, TargetLife> lives_of(const DrawnFrame& drawn, const Scene& scene) {
    const FramePasses passes = make_frame_passes(drawn.graph, scene, {size_px, size_px});
    const std::vector<TargetLife> lives = target_lives(passes);
    std::map<std::string, TargetLife> named;
    for (size_t i = 0; i < lives.size(); ++i) {
      const std::string& name = passes.targets.textures[i].name;
      named[name.starts_with("one_full.") ? name.substr(9) : name] = lives[i];
    }
    return named;
  }
  // Both frames' pictures are one; returns the lives.
  std::map<std::string, TargetLife> drawn_alike(const Library& library, const Scene& scene) {
    const auto shared = frame_of(library, scene, TargetSharing::on), alone = frame_of(library, scene, TargetSharing::off);
    EXPECT_EQ(shared->picture().rgba, alone->picture().rgba);
    EXPECT_EQ(shared->frame.memory_bytes_alone(), alone->frame.memory_bytes_alone());
    EXPECT_EQ(alone->frame.memory_bytes(), alone->frame.memory_bytes_alone());
    EXPECT_EQ(shared->frame.target_bytes(), alone->frame.target_bytes());
    saved_ = alone->frame.memory_bytes() - shared->frame.memory_bytes();
    return lives_of(*shared, scene);
  }

  std::string passes_;
  uint64_t saved_ = 0;
};
INSTANTIATE_TEST_SUITE_P(Backends, SharedTargets, backend_parameters, backend_test_name);

constexpr uint64_t target_bytes_of_16 = 16 * 16 * 8;

// a, b, c, d each made of the one before: two are needed at a time.
TEST_P(SharedTargets, AChainNeedsTwoAtATime) {
  add_step("", "a");
  for (const auto& [from, to] : {std::pair("a", "b"), std::pair("b", "c"), std::pair("c", "d"), std::pair("d", "frame")})
    add_step(from, to);
  const Library library = library_of(targets_named({"a", "b", "c", "d"}));
  const Scene scene = scene_of();
  const auto lives = drawn_alike(library, scene);
  uint32_t place = 0;
  for (const char* name : {"a", "b", "c", "d"}) {
    ASSERT_TRUE(lives.at(name).lifetime) << name << ": " << lives.at(name).kept;
    EXPECT_EQ(lives.at(name).lifetime->first, place) << name;
    EXPECT_EQ(lives.at(name).lifetime->last, ++place) << name;
  }
  EXPECT_FALSE(lives.at("frame").lifetime);
  EXPECT_GE(saved_, 2 * target_bytes_of_16);
  const DrawnFrame::Choice choice{.width = size_px, .height = size_px};
  const DrawnFrame drawn(*backend_, library, scene, choice);
  const TargetMemory memory = target_memory(make_frame_passes(drawn.graph, scene, {size_px, size_px}));
  EXPECT_EQ(memory.alone, drawn.frame.target_bytes());
  EXPECT_EQ(memory.alone - memory.aliased, 2 * target_bytes_of_16);
  EXPECT_EQ(memory.reused, memory.aliased) << "all are alike";
  if (backend_->info().api == Api::opengl)
    EXPECT_EQ(drawn.frame.memory_bytes(), memory.reused);
  else
    EXPECT_GE(drawn.frame.memory_bytes(), memory.aliased) << "a driver pads";
}

// What another pass reads later, over the passes between, keeps its memory until then.
TEST_P(SharedTargets, WhatIsReadLaterStaysUntilThen) {
  add_step("", "a");
  add_step("a", "b");
  add_step("b", "c");
  write("one/both.frag",
        "layout(binding = 4) uniform sampler2D a;\nlayout(binding = 5) uniform sampler2D c;\nlayout(location = 0) out vec4 o;\n"
        "void main() { o = texelFetch(a, ivec2(0), 0) + texelFetch(c, ivec2(0), 0); }\n");
  passes_ += fullscreen_pass("both", "both.frag", "frame");
  const auto lives = drawn_alike(library_of(targets_named({"a", "b", "c"})), scene_of());
  EXPECT_EQ(lives.at("a").lifetime, (Lifetime{0, 3}));
  EXPECT_EQ(lives.at("b").lifetime, (Lifetime{1, 2}));
  EXPECT_EQ(saved_, 0u) << "all three are needed when c is made";
}

// What is drawn once for all frames is there in all of them; what it was made of is not.
TEST_P(SharedTargets, WhatIsDoneOnceIsKept) {
  add_step("", "a", "when = \"once\"\n");
  add_step("a", "b", "when = \"once\"\n");
  add_step("", "x");
  add_step("x", "y");
  write("one/both.frag",
        "layout(binding = 4) uniform sampler2D b;\nlayout(binding = 5) uniform sampler2D y;\nlayout(location = 0) out vec4 o;\n"
        "void main() { o = texelFetch(b, ivec2(0), 0) + texelFetch(y, ivec2(0), 0); }\n");
  passes_ += fullscreen_pass("both", "both.frag", "frame");
  const Library library = library_of(targets_named({"a", "b", "x", "y"}));
  const auto lives = drawn_alike(library, scene_of());
  EXPECT_EQ(lives.at("b").kept, "it is drawn once and read in every frame");
  EXPECT_EQ(lives.at("a").lifetime, (Lifetime{0, 1}));
  EXPECT_EQ(lives.at("x").lifetime, (Lifetime{2, 3}));
  const auto shared = frame_of(library, scene_of(), TargetSharing::on);
  const Image first = shared->picture();
  for (int more = 0; more < 2; ++more) shared->frame.run(0, Timing::off);
  EXPECT_EQ(shared->picture().rgba, first.rgba) << "later frames";
}

// Each is read, kept or left as it was somewhere before the frame fills it.
TEST_P(SharedTargets, WhatIsNotFilledFirstIsKept) {
  write("one/holes.frag",
        "layout(location = 0) out vec4 c;\nvoid main() { if (gl_FragCoord.x < -1.0) discard; c = vec4(0.5); }\n");
  write("one/store.comp",
        "layout(local_size_x = 8, local_size_y = 8) in;\nlayout(rgba16f, binding = 4) writeonly uniform image2D t;\n"
        "void main() { imageStore(t, ivec2(gl_GlobalInvocationID.xy), vec4(0.5)); }\n");
  const std::vector<std::pair<std::string, std::string>> cases = {
      {fullscreen_pass("holes", "holes.frag", "t"), "it is read before it is cleared or overwritten"},
      {pass_text("store", "draw = \"compute\"\ncompute = \"store.comp\"\nwrite = [\"t\"]\nthreads_over = \"t\"\n"),
       "it is read before it is cleared or overwritten"},
      {fullscreen_pass("base", "to_t.frag", "t"), ""},
  };
  for (const auto& [pass, kept] : cases) {
    passes_.clear();
    add_step("", "t");
    passes_ = pass;
    add_step("t", "frame");
    const auto lives = drawn_alike(library_of(targets_named({"t"})), scene_of());
    EXPECT_EQ(lives.at("t").kept, kept) << pass;
  }
}

// Blending into a target that nothing has cleared clears it; of a mip chain every level is filled, or it is kept.
TEST_P(SharedTargets, EveryLevelIsFilledOrTheTargetIsKept) {
  for (const bool with_mips : {true, false}) {
    passes_.clear();
    add_step("", "t", "blend = \"additive\"\n");
    if (with_mips) passes_ += pass_text("levels", "draw = \"mips\"\nwrite = [\"t\"]\n");
    add_step("t", "frame");
    const auto lives = drawn_alike(library_of(targets_named({"t"}, "mips = true\n")), scene_of());
    EXPECT_EQ(lives.at("t").kept, with_mips ? "" : "it is read before it is cleared or overwritten");
  }
}

// A pass that stops repeating may not run at all: what it clears may then be what another has left.
TEST_P(SharedTargets, WhatAPassThatMayStopClearsIsKept) {
  const std::string drawn = "draw = \"objects\"\nvertex = \"common/object.vert\"\nfragment = \"to_t.frag\"\nwrite = [\"t\"]\n";
  for (const bool stops : {true, false}) {
    passes_.clear();
    add_step("", "t");
    passes_ = pass_text("layers", drawn + (stops ? "repeat = 2\nuntil_empty = true\n" : "repeat = 2\n"));
    add_step("t", "frame");
    const auto lives = drawn_alike(library_of(targets_named({"t"})), scene_of());
    EXPECT_EQ(lives.at("t").kept, stops ? "the pass that clears it may be left out" : "");
  }
}

// Both buffers of a pair are filled: the one by what clears it before it is read, the other by the copy or the pass.
TEST_P(SharedTargets, BuffersThatTakeTurnsShareToo) {
  write("one/again.frag",
        "layout(binding = 4) uniform sampler2D t;\nlayout(location = 0) out vec4 c;\n"
        "void main() { c = 0.5 * texelFetch(t, ivec2(gl_FragCoord.xy), 0) + vec4(0.25); }\n");
  passes_ = fullscreen_pass("again", "again.frag", "t", "repeat = 3\n");
  add_step("t", "b");
  add_step("b", "c");
  add_step("c", "frame");
  const Library library = library_of(targets_named({"t"}, "buffers = 2\n") + targets_named({"b", "c"}));
  const Scene scene = scene_of();
  const auto lives = drawn_alike(library, scene);
  EXPECT_EQ(lives.at("t").kept, "");
  EXPECT_GE(saved_, target_bytes_of_16) << "of four, three are needed at a time at most";
}

// A truth's targets are read back after the frame.
TEST_P(SharedTargets, AFrameThatTellsATruthSharesNothing) {
  write("one/tell.frag", "layout(location = 0) out vec4 seen;\nvoid main() { seen = vec4(0.625); }\n");
  passes_ = fullscreen_pass("first", "tell.frag", "first", "when = \"truth\"\n") +
            fullscreen_pass("second", "tell.frag", "second", "when = \"truth\"\n");
  add_step("", "frame");
  const Library library =
      library_of("[targets.first]\nformat = \"rgba32_float\"\n[targets.second]\nformat = \"rgba32_float\"\n");
  const VariantManifest& told = library.effect("one").baseline();
  const auto frame = drawn(library, scene_of(), {}, Build::timed, 16, &told);
  EXPECT_EQ(frame->frame.memory_bytes(), frame->frame.memory_bytes_alone());
  EXPECT_EQ(frame->frame.targets_of(told).size(), 2u);
  EXPECT_EQ(frame->frame.target(told, "first").rgba[0], 0.625f);
}

// In a moving scene what hangs on meshes and lights alone is drawn for the first view and left out for the others: it must not
// be lost between them.
TEST_P(SharedTargets, WhatIsDrawnForTheFirstViewIsThereForTheOthers) {
  Scene scene = stack_scene({{0.8f, 0.4f}, {0.3f, 1}}, 0);
  scene.lights = {{"low", Light::Kind::directional, glm::normalize(glm::vec3(-1, 0, -1)), {}, glm::vec3(1)}};
  scene.mesh_moves = true;
  scene.views.push_back(scene.views.front());
  scene.views.back().eye += glm::vec3(0.7f, 0.3f, 0);
  for (const Build build : {Build::timed, Build::counting}) {
    DrawnFrame::Choice choice{.variant = &variant("light_map"), .build = build, .aspect = 1};
    DrawnFrame shared(*backend_, library(), scene, choice);
    choice.sharing = TargetSharing::off;
    DrawnFrame alone(*backend_, library(), scene, choice);
    EXPECT_LE(shared.frame.memory_bytes(), alone.frame.memory_bytes());
    if (backend_->info().api == Api::vulkan) {
      EXPECT_LT(shared.frame.memory_bytes(), alone.frame.memory_bytes());
    }
    for (const size_t view : {1, 0, 1}) {
      shared.frame.run(view, Timing::off);
      alone.frame.run(view, Timing::off);
      EXPECT_EQ(shared.picture().rgba, alone.picture().rgba) << view;
    }
    // A frame in strips, as two are compared piece by piece.
    for (const Frame::Slice& slice : shared.frame.slices(1, std::vector<uint32_t>(shared.frame.frame_names().size(), 3)))
      backend_->run({&slice.piece, 1}, Timing::off);
    EXPECT_EQ(shared.picture().rgba, alone.picture().rgba) << "in strips";
  }
}

class SharedTargetsOfScenes : public EachBackend {};
INSTANTIATE_TEST_SUITE_P(Backends, SharedTargetsOfScenes, backend_parameters, backend_test_name);

bool draws_all_scenes() {
  const char* all = std::getenv("LAMINA_ALL_SCENES");
  return all && *all;
}

TEST_P(SharedTargetsOfScenes, SharingChangesNoPicture) {
  constexpr uint32_t side_px = 40;
  const bool all = draws_all_scenes();
  const std::vector<std::string> some = {"heart", "leaf_pair", "glass_stack", "rough_glass", "pool", "portrait"};
  const Parameters parameters = small_parameters(library());
  ShaderCache shaders(backend_->info().api, library().shaders);
  uint64_t shared_bytes = 0, alone_bytes = 0;
  for (const std::string& name : all ? builtin_scenes() : some) {
    const Scene scene = load_scene(name, library());
    const Plan plan = make_plan(library(), scene, 1);
    Bakes bakes(scene, *library().code, DiskCache(""));
    SceneResources resources(*backend_, scene, library(), side_px, side_px, &bakes);
    std::vector<Configuration> configurations = {configuration_of(plan, {})};
    for (const EffectPlan& entry : plan.effects)
      for (const VariantManifest& variant : entry.effect->variants)
        if (all && entry.called_for && !variant.baseline) configurations.push_back(configuration_with(plan, variant));
    for (const Configuration& configuration : configurations) {
      std::string label = name;
      for (const VariantManifest* variant : configuration) label += " " + variant->name;
      SCOPED_TRACE(label);
      try {
        const Graph graph = make_graph(plan, configuration, scene, shaders, nullptr, parameters);
        Frame shared(resources, graph, Build::timed), alone(resources, graph, Build::timed, TargetSharing::off);
        const TargetMemory told = target_memory(make_frame_passes(graph, scene, {side_px, side_px}));
        EXPECT_LE(told.aliased, told.reused);
        EXPECT_LE(told.reused, told.alone);
        EXPECT_LE(shared.memory_bytes(), alone.memory_bytes());
        shared_bytes += shared.memory_bytes(), alone_bytes += alone.memory_bytes();
        if (all)
          fmt::print("{} on {}: {} of {} bytes (by formats {} or {} of {})\n", label, GetParam(), shared.memory_bytes(),
                     alone.memory_bytes(), told.aliased, told.reused, told.alone);
        for (Frame* frame : {&shared, &alone}) frame->run_once(Timing::off);
        for (size_t view = 0; view < scene.views.size(); ++view) {
          for (Frame* frame : {&shared, &alone}) frame->run(view, Timing::off);
          EXPECT_EQ(bit_difference(shared.picture(), alone.picture()).pixels, 0u) << scene.views[view].name;
        }
      } catch (const Error& error) {
        if (!all) throw;
        fmt::print("not drawn: {}: {}\n", label, error.what());
      }
    }
  }
  EXPECT_LT(shared_bytes, alone_bytes);
}

}  // namespace
}  // namespace lamina
