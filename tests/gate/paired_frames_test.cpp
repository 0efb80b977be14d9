// SPDX-License-Identifier: Apache-2.0
// Frames in pieces, on every backend: the pieces make the frame's picture, and paired rounds hold every piece of every frame.
#include "harness/gate/paired_frames.h"

#include <map>
#include <numeric>
#include <set>

#include "harness/gate/identity.h"
#include "harness/gate/slowdown.h"
#include "tests/graph/each_backend.h"
#include "tests/graph/quad_scene.h"

namespace lamina {
namespace {

class Pieces : public EachBackend {
 protected:
  // A frame of the variant that has run once, for a quad with both layers.
  struct Ready {
    Graph graph;
    std::unique_ptr<Frame> frame;
  };
  void SetUp() override {
    EachBackend::SetUp();
    if (!backend_) return;
    scene_.mesh_moves = true;  // so that the light is drawn every frame
    plan_ = make_plan(library(), scene_);
    shaders_ = std::make_unique<ShaderCache>(backend_->info().api, library().shaders);
    resources_ = std::make_unique<SceneResources>(*backend_, scene_, library(), 96, 80);
  }
  void TearDown() override {
    ready_.clear();
    resources_.reset();
    EachBackend::TearDown();
  }
  Frame& ready(std::string_view name, const Frame* like = nullptr) {
    Ready& ready = *ready_.emplace_back(std::make_unique<Ready>());
    ready.graph = make_graph(plan_, configuration_with(plan_, variant(name)), scene_, *shaders_);
    ready.frame = std::make_unique<Frame>(*resources_, ready.graph, Build::timed, TargetSharing::on, like);
    ready.frame->run_once(Timing::off);
    ready.frame->run(0, Timing::off);
    return *ready.frame;
  }
  static PairedFrame timed(Frame& frame, size_t same_passes = 0) {
    return {&frame, same_passes, frame.run(0, Timing::bracketed).pass_ms};
  }
  Scene scene_ = quad_scene({4, 0.5f, glm::vec3(0.5f), glm::vec3(0.25f)});
  Plan plan_;
  std::unique_ptr<ShaderCache> shaders_;
  std::unique_ptr<SceneResources> resources_;
  std::vector<std::unique_ptr<Ready>> ready_;
};
INSTANTIATE_TEST_SUITE_P(Backends, Pieces, backend_parameters, backend_test_name);

TEST_P(Pieces, StripsMakeThePictureOfTheFrame) {
  for (const char* name : {"light_map", "vertex_normal"}) {
    Frame& frame = ready(name);
    const Image whole = frame.picture();
    for (const uint32_t parts : {1u, 3u, 7u, 80u, 1000u}) {
      std::vector<Pass> passes;
      std::set<size_t> steps;
      for (const Frame::Slice& slice : frame.slices(0, std::vector<uint32_t>(frame.frame_names().size(), parts))) {
        passes.push_back(slice.piece);
        steps.insert(slice.pass);
      }
      EXPECT_EQ(steps.size(), frame.frame_names().size()) << "every pass has its pieces";
      backend_->run(passes, Timing::off);
      EXPECT_EQ(frame.picture().rgba, whole.rgba) << name << " in " << parts;
    }
  }
}

// What one of two frames with the same targets draws, the other holds; both draw their own picture as if they were alone. A
// frame with other targets keeps its own.
TEST_P(Pieces, FramesWithTheSameTargetsDrawIntoOne) {
  Frame& first = ready("light_map");
  const Image alone = first.picture();
  Frame& alike = ready("light_map", &first);
  EXPECT_EQ(alike.picture().rgba, alone.rgba);
  alike.set_background({1, 0, 0});
  alike.run(0, Timing::off);
  const Image on_red = alike.picture();
  EXPECT_NE(on_red.rgba, alone.rgba);
  EXPECT_EQ(first.picture().rgba, on_red.rgba);
  first.run(0, Timing::off);
  EXPECT_EQ(first.picture().rgba, alone.rgba);

  Frame& other = ready("vertex_normal", &first);
  other.set_background({1, 0, 0});
  other.run(0, Timing::off);
  EXPECT_NE(other.picture().rgba, alone.rgba);
  EXPECT_EQ(first.picture().rgba, alone.rgba);
}

// One strip alone changes its rows and no others.
TEST_P(Pieces, AStripLeavesTheOtherRowsAlone) {
  Frame& frame = ready("vertex_normal");
  const Image whole = frame.picture();
  std::vector<Frame::Slice> strips = frame.slices(0, std::vector<uint32_t>{4});
  ASSERT_EQ(strips.size(), 4u);
  Pass strip = strips[1].piece;
  EXPECT_EQ(strip.area->y, 20u);
  EXPECT_EQ(strip.area->height, 20u);
  for (Attachment& color : strip.colors) color.clear = {9, 9, 9, 9};
  strip.draws.clear();  // the clear alone
  backend_->run(std::vector<Pass>{strip}, Timing::off);
  const Image changed = frame.picture();
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 96; x += 5) {
      const size_t at = (size_t(y) * 96 + size_t(x)) * 4;
      ASSERT_EQ(changed.rgba[at], y >= 20 && y < 40 ? 9.0f : whole.rgba[at]) << x << "," << y;
    }
}

TEST_P(Pieces, AnAreaOutsideTheTargetsIsRefused) {
  Frame& frame = ready("vertex_normal");
  Pass pass = frame.slices(0, std::vector<uint32_t>{1}).front().piece;
  for (const Area bad :
       {Area{0, 0, 0, 4}, Area{0, 0, 97, 4}, Area{90, 0, 7, 4}, Area{0, 80, 4, 1}, Area{0, 0xffffffff, 4, 2}}) {
    pass.area = bad;
    EXPECT_THROW(backend_->run(std::vector<Pass>{pass}, Timing::off), Error);
  }
}

TEST_P(Pieces, RoundsHoldASampleOfEveryPassOfEveryFrame) {
  Frame &a = ready("light_map"), &b = ready("light_map");
  PairedFrames paired(*backend_, {timed(a), timed(b)}, 0, {.piece_ms = 1e-4, .max_strips = 8, .max_repeats = 1});
  std::mt19937_64 random(1);
  for (int round = 0; round < 8; ++round) paired.run_round(random);
  EXPECT_EQ(paired.rounds(), 8u);
  ASSERT_EQ(paired.passes().size(), a.frame_names().size());
  for (const PairedPass& pass : paired.passes()) {
    EXPECT_EQ(pass.cut, pass.name != "light_mips") << pass.name << ": a mip chain is one piece";
    for (const std::vector<double>& ms : pass.ms) {
      ASSERT_EQ(ms.size(), 8u) << pass.name;
      for (const double sample : ms) EXPECT_GT(sample, 0) << pass.name;
    }
  }
  for (const PairedPass& pass : paired.passes()) {
    EXPECT_TRUE(pass.strips[0].empty()) << pass.name;
    EXPECT_EQ(pass.strips[1].size(), pass.cut ? 16u : 8u) << pass.name << ": two strips of eight a round, or all of it";
    double before = 0, after = 0;
    size_t first = 0;
    for (const StripPair& strip : pass.strips[1]) before += strip.before, after += strip.after, first += strip.after_first;
    const auto sum = [](const std::vector<double>& ms) { return std::accumulate(ms.begin(), ms.end(), 0.0); };
    EXPECT_NEAR(before, sum(pass.ms[0]), 1e-9 * before) << "no strip is left out";
    EXPECT_NEAR(after, sum(pass.ms[1]), 1e-9 * after);
    EXPECT_TRUE(!pass.cut || (first > 0 && first < pass.strips[1].size())) << "orders are shuffled";
  }
  EXPECT_GT(*whole_ms(paired.passes().front(), 0), 0);
  paired.start_again();
  EXPECT_EQ(paired.rounds(), 0u);
  for (int round = 0; round < 4; ++round) paired.run_round(random);
  for (const PairedPass& pass : paired.passes()) {
    for (const std::vector<double>& ms : pass.ms) EXPECT_EQ(ms.size(), 4u) << pass.name << ": the rounds before are forgotten";
    EXPECT_EQ(pass.strips[1].size(), pass.cut ? 8u : 4u) << pass.name;
  }
}

// 12 ms are four strips of 5 ms at least, 100 ms with compiling in them would be sixteen.
TEST_P(Pieces, APassIsCutByTheFrameInWhichItLastedLeast) {
  Frame &a = ready("vertex_normal"), &b = ready("vertex_normal");
  for (const auto& [of_a, of_b] : {std::pair(100.0, 12.0), std::pair(12.0, 100.0)}) {
    PairedFrames paired(*backend_, {{&a, 0, {of_a}}, {&b, 0, {of_b}}}, 0, {.max_repeats = 1});
    std::mt19937_64 random(1);
    for (size_t round = 0; round < rounds_a_frame; ++round) paired.run_round(random);
    EXPECT_EQ(paired.passes().front().strips[1].size(), 4u) << of_a;
  }
}

// Sixteen strips of a whole frame, however short the pass: of 2 ms whole, of 12 ms in four, of 40 ms in eight.
TEST_P(Pieces, AShortPassIsRepeated) {
  Frame &a = ready("vertex_normal"), &b = ready("vertex_normal");
  for (const double ms : {2.0, 12.0, 40.0, 200.0}) {
    PairedFrames paired(*backend_, {{&a, 0, {ms}}, {&b, 0, {ms}}}, 0);
    std::mt19937_64 random(1);
    for (size_t round = 0; round < rounds_a_frame; ++round) paired.run_round(random);
    EXPECT_EQ(paired.passes().front().strips[1].size(), 16u) << ms;
    EXPECT_EQ(paired.passes().front().ms[1].size(), 4u) << ms;
  }
}

TEST_P(Pieces, FramesOfDifferentPassesArePairedByName) {
  Frame &a = ready("light_map"), &b = ready("vertex_normal");
  PairedFrames paired(*backend_, {timed(a), timed(b)}, 0);
  std::mt19937_64 random(1);
  paired.run_round(random);
  for (const PairedPass& pass : paired.passes()) {
    EXPECT_EQ(pass.ms[0].size(), 1u) << pass.name;
    EXPECT_EQ(pass.ms[1].size(), pass.name == "composite" ? 1u : 0u) << pass.name;
  }
}

// What is known to be the same is run for no other frame, and for the first only until it is known how long it lasts, or while
// a third frame is compared with it.
TEST_P(Pieces, PassesThatAreTheSameAreNotRunAgain) {
  Frame &a = ready("light_map"), &b = ready("light_map"), &c = ready("light_map");
  const size_t passes = a.frame_names().size();
  ASSERT_GE(passes, 3u);
  const PieceOptions pieces{.piece_ms = 1e-4, .max_strips = 8, .max_repeats = 1};
  PairedFrames two(*backend_, {timed(a), timed(b, passes - 1)}, 0, pieces),
      three(*backend_, {timed(a), timed(b, passes - 1), timed(c)}, 0, pieces);
  std::mt19937_64 random(1);
  for (int round = 0; round < 8; ++round) two.run_round(random), three.run_round(random);
  for (size_t i = 0; i < passes; ++i) {
    const bool same = i + 1 < passes;
    EXPECT_EQ(two.passes()[i].same, (std::vector<bool>{false, same}));
    EXPECT_EQ(two.passes()[i].ms[0].size(), same ? rounds_a_frame : 8u);
    EXPECT_EQ(two.passes()[i].ms[1].size(), same ? 0u : 8u);
    EXPECT_EQ(two.passes()[i].strips[1].empty(), same);
    EXPECT_TRUE(whole_ms(two.passes()[i], 0));
    EXPECT_EQ(three.passes()[i].ms[0].size(), 8u);
    EXPECT_EQ(three.passes()[i].ms[1].size(), same ? 0u : 8u);
    EXPECT_EQ(three.passes()[i].ms[2].size(), 8u);
  }
}

// A changed library: every variant draws the same picture, with so many more fetches a pixel.
class ChangedLibrary : public Pieces {
 protected:
  static inline const std::set<std::string> looked_at = {"light_map", "normal_map_taps", "vertex_normal"};  // of many
  void expect_same_pictures(const Library& changed, const std::map<std::string, uint64_t>& more_fetches) {
    const Plan plan = make_plan(changed, scene_);
    ShaderCache shaders(backend_->info().api, changed.shaders);
    for (const VariantManifest& variant : plan.of("layered_material")->effect->variants) {
      if (!looked_at.contains(variant.name)) continue;
      const Graph graph = make_graph(plan, configuration_with(plan, variant), scene_, shaders);
      Frame frame(*resources_, graph, Build::counting);
      Frame& original = ready(variant.name);
      Frame counting(*resources_, ready_.back()->graph, Build::counting);
      for (Frame* each : {&frame, &counting}) {
        each->run_once(Timing::off);
        each->run(0, Timing::off);
      }
      EXPECT_EQ(frame.picture().rgba, original.picture().rgba);
      const PassCounts now = frame.frame_counts().back(), was = counting.frame_counts().back();
      const auto more = more_fetches.find(variant.name);
      EXPECT_EQ(now.fetches(), was.fetches() + (more == more_fetches.end() ? 0 : more->second * was.fragments)) << variant.name;
      const Api api = backend_->info().api;
      CodeHashes hashes;
      identities_[variant.name] = {identity_of(variant, graph, nullptr, api, hashes),
                                   identity_of(this->variant(variant.name), ready_.back()->graph, nullptr, api, hashes)};
    }
  }
  std::map<std::string, std::pair<Identity, Identity>> identities_;  // of each variant, here and in the product
};
INSTANTIATE_TEST_SUITE_P(Backends, ChangedLibrary, backend_parameters, backend_test_name);

TEST_P(ChangedLibrary, ExtraFetchesAreCountedAndChangeNoPicture) {
  expect_same_pictures(with_extra_fetches(library(), variant("light_map"), "composite", 5), {{"light_map", 5}});
  for (const auto& [name, identities] : identities_)
    EXPECT_EQ(identities.first == identities.second, name != "light_map") << name;
}

TEST_P(ChangedLibrary, OtherCodeIsOtherCodeInEveryVariant) {
  Library changed = library();
  for (const VariantManifest& variant : library().effect("layered_material").variants)
    changed = with_extra_fetches(std::move(changed), variant, "composite", 0);
  expect_same_pictures(changed, {});
  EXPECT_EQ(identities_.size(), 3u);
  for (const auto& [name, identities] : identities_) {
    const auto& [here, before] = identities;
    EXPECT_FALSE(here == before) << name;
    ASSERT_GE(here.frame_passes.size(), 1u);
    EXPECT_EQ(same_passes(here, before), here.frame_passes.size() - 1) << "all but the last, composite";
    EXPECT_EQ(same_passes(here, here), here.frame_passes.size());
  }
}

// As calibration asks of every effect with variants to compare.
TEST(ExtraFetches, ChangeTheCodeOfEachBaseline) {
  const Library& library = builtin_library();
  const auto expect_changed = [&](const Scene& scene, const VariantManifest& variant, const std::string& pass) {
    const auto code = [&](const Library& of) {
      const Plan plan = make_plan(of, scene);
      const VariantManifest& baseline = of.effect(variant.effect).baseline();
      ShaderCache shaders(Api::vulkan, of.shaders);
      CodeHashes hashes;
      return identity_of(baseline, make_graph(plan, configuration_with(plan, baseline), scene, shaders), nullptr, Api::vulkan,
                         hashes)
          .frame_passes;
    };
    EXPECT_NE(code(with_extra_fetches(library, variant, pass, 1)), code(library)) << variant.effect;
  };
  expect_changed(quad_scene({}), library.effect("layered_material").baseline(), "composite");
  expect_changed(load_scene("open_plane", library), library.effect("aperture_lighting").baseline(), "light");
}

}  // namespace
}  // namespace lamina
