// SPDX-License-Identifier: Apache-2.0
// lamina gate from end to end: changes of the product that it must catch, each alone, what it must let pass, and bad input.
// Times are left out: they belong to --calibrate.
#include <algorithm>
#include <set>

#include "tests/cli/program.h"

namespace lamina {
namespace {

class Gate : public ProgramTest {
 protected:
  std::filesystem::path tree() const { return folder_ / "tree"; }
  // A copy of the product's variants and shaders, with three of the layered material's many variants.
  void copy_tree() {
    std::filesystem::remove_all(tree());
    std::filesystem::create_directories(tree());
    for (const char* part : {"variants", "shaders"})
      std::filesystem::copy(std::filesystem::path(LAMINA_SOURCE_DIR) / part, tree() / part,
                            std::filesystem::copy_options::recursive);
    const std::set<std::string> kept = {"effect", "light_map", "normal_map_taps", "vertex_normal"};
    std::vector<std::filesystem::path> others;
    for (const auto& entry : std::filesystem::directory_iterator(tree() / "variants/layered_material"))
      if (entry.path().extension() == ".toml" && !kept.contains(entry.path().stem())) others.push_back(entry.path());
    for (const std::filesystem::path& manifest : others) std::filesystem::remove(manifest);
  }
  void replace(const std::string& file, const std::string& from, const std::string& to) {
    std::ifstream in(tree() / file);
    std::string text((std::istreambuf_iterator<char>(in)), {});
    const size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    std::ofstream(tree() / file) << text.replace(at, from.size(), to);
  }
  // The copy against the product as it is. A small frame, without times, of the square where no other scene is given: making
  // the heart takes longer than all else.
  Outcome gate(const std::string& more = "", const std::string& scene = "") {
    ::setenv("LAMINA_HOME", tree().c_str(), 1);
    const Outcome outcome = lamina_program("gate " + (scene.empty() ? square_model() : scene) +
                                           " --against " LAMINA_SOURCE_DIR " --size 64x64 --no-time --cache \"\" --out " +
                                           out().string() + " " + more + unless_said(more));
    ::unsetenv("LAMINA_HOME");
    return outcome;
  }
  // A truth is asked where a test is about it. Of the layered material's many variants one stands for all.
  std::string unless_said(const std::string& more) const {
    const auto says = [&](const char* option) { return more.find(option) != std::string::npos; };
    return std::string(says("--truth-rays") ? "" : " --truth-rays 0") +
           (says("--variant") || all_variants_ ? "" : " --variant vertex_normal");
  }
  Outcome against_record(const std::string& record, const std::string& more = "") {
    return lamina_program("gate " + square_model() + " --baseline " + record +
                          " --size 48x48 --no-time --cache \"\" --backend osmesa --out " + out().string() + " " + more +
                          unless_said(more));
  }
  bool all_variants_ = false;
};

struct Mutation {
  const char *name, *file, *from, *to, *what;  // what: the verdict that says so, or several of which one is enough
};
void PrintTo(const Mutation& mutation, std::ostream* out) { *out << mutation.name; }  // else the bytes, addresses in them
constexpr const char* taps = "shaders/layered_material/poisson_disc.glsl";
constexpr const char* composite = "shaders/layered_material/composite.frag";
constexpr const char* light_map = "variants/layered_material/light_map.toml";
constexpr const char* mip_pass =
    "[[pass]]\nname = \"light_mips\"\ndraw = \"mips\"\nwhen = \"mesh_or_lights_move\"\nwrite = [\"light_map\"]\n";
constexpr Mutation mutations[] = {
    {"one_tap_more", taps, "  return middle + difference / 13.0;",
     "  difference += 1e-9 * textureGrad(source, center, footprint.uv_dx, footprint.uv_dy);\n  return middle + difference "
     "/ 13.0;",
     "fetches"},
    {"one_tap_less", taps, "i < 12", "i < 11", "picture"},
    {"disc_scaled", taps, "disc_taps[i] * radius", "disc_taps[i] * 1.05 * radius", "picture"},
    {"weight_swapped", "shaders/layered_material/layers.glsl", "mix(outer, inner,", "mix(inner, outer,", "picture"},
    {"mip_levels_missing", light_map, mip_pass, "", "picture, nonfinite"},  // whatever the memory holds
    {"target_of_8_bits", light_map, "format = \"rgba16_float\"\nmips", "format = \"rgba8_unorm\"\nmips", "fetches"},
    {"pass_run_twice", light_map, "name = \"dilate\"", "name = \"dilate\"\nrepeat = 2", "fetches"},
    {"blank_frame", composite, "out_color = vec4(color, 1.0)", "discard", "blank"},
    {"one_colour", composite, "out_color = vec4(color, 1.0)", "out_color = vec4(0.0, 0.0, 0.0, 1.0)", "picture"},
    {"not_a_number", composite, "out_color = vec4(color, 1.0)", "out_color = vec4(color * uintBitsToFloat(0x7fc00000u), 1.0)",
     "nonfinite"},
    {"does_not_compile", composite, "out_color = vec4(color, 1.0)", "out_color = vec4(colour, 1.0)", "cell"},
};

class GateMutations : public Gate, public testing::WithParamInterface<Mutation> {};
INSTANTIATE_TEST_SUITE_P(Each, GateMutations, testing::ValuesIn(mutations),
                         [](const testing::TestParamInfo<Mutation>& mutation) { return mutation.param.name; });

TEST_P(GateMutations, IsCaught) {
  copy_tree();
  replace(GetParam().file, GetParam().from, GetParam().to);
  const Outcome outcome = gate();
  EXPECT_EQ(outcome.status, 1) << outcome.output;
  const Record record = this->record();
  for (const char* backend : {"vulkan", "osmesa"})
    EXPECT_TRUE(std::any_of(record.verdicts.begin(), record.verdicts.end(),
                            [&](const VerdictRow& row) {
                              const std::string& what = row.what;
                              return row.backend == backend &&
                                     std::string_view(GetParam().what).find(what) != std::string_view::npos &&
                                     (row.verdict == Verdict::worse || row.verdict == Verdict::failed);
                            }))
        << GetParam().what << " on " << backend << "\n"
        << outcome.output;
}

// Names, comments and layout, of a shader and of a manifest: nothing is drawn or timed again.
TEST_F(Gate, WhatExecutesTheSamePassesUnmeasured) {
  copy_tree();
  replace(composite, "void main() {", "// another comment\nfloat unused(float x) { return 2.0 * x; }\nvoid main() {");
  replace(composite, "vec3 view_tangent", "vec3 eye_tangent");
  replace(composite, ", view_tangent,", ", eye_tangent,");
  replace(composite, "dot(normal_tangent, view_tangent)", "dot(normal_tangent, eye_tangent)");
  replace(light_map, "[[pass]]", "# another comment\n\n[[pass]]");
  const Outcome outcome = gate();
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  const Record record = this->record();
  for (const VerdictRow& row : record.verdicts) EXPECT_EQ(row.what, "code") << row.variant;
  EXPECT_EQ(record.gates.at(0).verdict, Verdict::same);
  EXPECT_TRUE(record.cells.empty());
}

// Other code that draws the same picture with as many fetches: everything is looked at, and passes.
TEST_F(Gate, OtherCodeForTheSamePicturePasses) {
  copy_tree();
  replace(composite, "out_color = vec4(color, 1.0)", "out_color = vec4(color.rg, color.b, 1.0)");
  const Outcome outcome = gate(std::string("--backend osmesa") + few_variants, "heart");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  const Record record = this->record();
  EXPECT_GE(record.cells.size(), 9u) << "three variants in three views";
  for (const CellRow& cell : record.cells) EXPECT_TRUE(std::filesystem::is_regular_file(out() / cell.image)) << cell.image;
}

TEST_F(Gate, AVariantThatVanishedIsNoPass) {
  copy_tree();
  all_variants_ = true;
  std::filesystem::remove(tree() / "variants/layered_material/vertex_normal.toml");
  const Outcome outcome = gate("--backend osmesa");
  EXPECT_EQ(outcome.status, 1) << outcome.output;
  EXPECT_SAYS(outcome.output, "vertex_normal on osmesa is gone");
}

TEST_F(Gate, LimitsOfTheGateFileHold) {
  copy_tree();
  replace(taps, "  return middle + difference / 13.0;",
          "  difference += 1e-9 * textureGrad(source, center, footprint.uv_dx, footprint.uv_dy);\n  return middle + "
          "difference / 13.0;");
  const auto limits = write("gate.toml", "[default]\nmax_extra_fetches = \"10%\"\nmax_extra_operations = \"10%\"\n");
  const Outcome allowed = gate("--backend osmesa --limits " + limits.string());
  EXPECT_EQ(allowed.status, 0) << allowed.output;
  const auto strict = write("strict.toml",
                            "[default]\nmax_extra_fetches = \"10%\"\nmax_extra_operations = \"10%\"\n[[limit]]\nvariant = "
                            "\"vertex_normal\"\nmin_ssim = 0.99999\n");
  const Outcome refused = gate("--backend osmesa --limits " + strict.string());
  EXPECT_EQ(refused.status, 1) << refused.output;
  EXPECT_SAYS(refused.output, "the gate file asks for at least");
}

// Its code is the same, its errors are not.
TEST_F(Gate, AVariantIsDrawnWhereItsBaselineChanged) {
  copy_tree();
  replace(light_map, mip_pass, "");
  const Outcome outcome = gate("--backend osmesa");
  EXPECT_EQ(outcome.status, 1) << outcome.output;
  std::set<std::string> judged;
  for (const VerdictRow& row : record().verdicts)
    if (row.variant == "vertex_normal") judged.insert(row.what);
  EXPECT_TRUE(judged.contains("code"));
  EXPECT_TRUE(judged.contains("psnr_db")) << testing::PrintToString(judged);
  for (const CellRow& cell : record().cells) {  // what was taken from the tree before is as whole as what was drawn
    EXPECT_GT(cell.covered_pixels.value_or(0), 0u) << cell.variant;
    EXPECT_TRUE(cell.fetches.has_value()) << cell.variant;
    EXPECT_FALSE(cell.passes.empty()) << cell.variant;
    EXPECT_FALSE(cell.shader_hashes.empty()) << cell.variant;
    EXPECT_TRUE(std::filesystem::is_regular_file(out() / cell.image)) << cell.image;
  }
}

// Counts and pictures are a gate's least; what is then left of a second is not enough for times, and the gate says so.
TEST_F(Gate, WhatTheBudgetLeavesNoTimeForIsSaid) {
  copy_tree();
  replace(composite, "out_color = vec4(color, 1.0)", "out_color = vec4(color.rg, color.b, 1.0)");
  ::setenv("LAMINA_HOME", tree().c_str(), 1);
  const Outcome outcome = lamina_program("gate " + square_model() +
                                         " --against " LAMINA_SOURCE_DIR
                                         " --size 64x64 --budget 1 --cache \"\" --backend osmesa --truth-rays 0 --variant "
                                         "vertex_normal --out " +
                                         out().string());
  ::unsetenv("LAMINA_HOME");
  EXPECT_EQ(outcome.status, 0) << "counts decide\n" << outcome.output;
  EXPECT_SAYS(outcome.output, "no times were measured");
  EXPECT_SAYS(outcome.output, "s of 1: loading and comparing code");
  const Record record = this->record();
  EXPECT_TRUE(record.pairs.empty());
  EXPECT_TRUE(record.timers.empty());
  EXPECT_TRUE(std::ranges::any_of(record.verdicts, [](const VerdictRow& row) { return row.verdict == Verdict::time_open; }));
}

// The pictures are the same; what the truth is told of them is not.
TEST_F(Gate, ErrorsAreJudgedWhereTheTruthChanged) {
  copy_tree();
  replace("shaders/aperture_lighting/points.frag", "vec4(texture(albedo, in_uv).rgb, 1.0)",
          "vec4(0.5 * texture(albedo, in_uv).rgb, 1.0)");
  const Outcome outcome = gate("--backend osmesa --truth-rays 64 --variant smoothstep_cap", "open_plane");
  EXPECT_EQ(outcome.status, 1) << outcome.output;
  const Record record = this->record();
  EXPECT_TRUE(std::ranges::any_of(record.verdicts, [](const VerdictRow& row) {
    return row.variant == "smoothstep_cap" && row.what == "rmse_linear to truth" && row.verdict == Verdict::worse;
  })) << outcome.output;
}

// Trees in which nothing changed are held to a gate file's bounds.
TEST_F(Gate, BoundsHoldForCodeThatIsTheSame) {
  copy_tree();
  const auto limits = write("gate.toml", "[[limit]]\nvariant = \"vertex_normal\"\nmin_ssim = 0.99999\n");
  const Outcome outcome = gate("--backend osmesa --limits " + limits.string());
  EXPECT_EQ(outcome.status, 1) << outcome.output;
  EXPECT_SAYS(outcome.output, "the gate file asks for at least");
}

// With nothing to compare it with, it must be finite all the same.
TEST_F(Gate, ANewVariantIsNoPassByBeingNew) {
  copy_tree();
  all_variants_ = true;
  std::ofstream(tree() / "shaders/layered_material/new.frag")
      << "#include \"common/frame.glsl\"\n#include \"common/surface.glsl\"\n#include \"common/mesh_in.glsl\"\n"
         "layout(location = 0) out vec4 color;\n"
         "void main() { color = vec4(in_normal * uintBitsToFloat(0x7fc00000u), 1.0); }\n";
  std::ofstream(tree() / "variants/layered_material/new.toml")
      << "[variant]\nname = \"new\"\neffect = \"layered_material\"\n[[pass]]\nname = \"composite\"\ndraw = \"objects\"\n"
         "vertex = \"common/object.vert\"\nfragment = \"layered_material/new.frag\"\nwrite = [\"frame\"]\n"
         "depth = \"read_write\"\n";
  const Outcome outcome = gate("--backend osmesa");
  EXPECT_EQ(outcome.status, 1) << outcome.output;
  EXPECT_SAYS(outcome.output, "new on osmesa is new");
  EXPECT_SAYS(outcome.output, "pixels are infinite or not a number");
}

TEST_F(Gate, BadInputSaysWhatIsWrongAndIsNeverAPass) {
  copy_tree();
  const auto expect_refused = [](const Outcome& outcome, const std::string& words) {
    EXPECT_EQ(outcome.status, 2) << outcome.output;
    EXPECT_SAYS(outcome.output, words);
  };
  expect_refused(lamina_program("gate heart"), "--against DIR");
  expect_refused(lamina_program("gate heart --against " + folder_.string()), "has no folder 'variants'");
  expect_refused(lamina_program("gate heart --against " LAMINA_SOURCE_DIR " --baseline x.jsonl"), "excludes");
  expect_refused(lamina_program("gate heart --update --against " LAMINA_SOURCE_DIR), "--update");
  expect_refused(lamina_program("gate heart --baseline " + (folder_ / "none.jsonl").string()), "no such record");
  expect_refused(gate("--variant vertex_norml"), "did you mean 'vertex_normal'");
  expect_refused(gate("--limits " + write("bad.toml", "[default]\nmin_sim = 0.9\n").string()), "did you mean 'min_ssim'");
  expect_refused(gate("--limits " + (folder_ / "none.toml").string()), "none.toml");
}

// A record is made, passes against itself, and what is wrong with a changed one is said.
TEST_F(Gate, StoredRecordsAreWrittenComparedAndRefused) {
  const std::string baseline = (folder_ / "kept" / "baseline.jsonl").string();
  const Outcome written = against_record(baseline, "--update");
  ASSERT_EQ(written.status, 0) << written.output;
  EXPECT_SAYS(written.output, "there was no record before");
  const Outcome again = against_record(baseline);
  EXPECT_EQ(again.status, 0) << again.output;
  EXPECT_SAYS(against_record(baseline, "--update").output, "nothing changed");

  std::ifstream in(baseline);
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    for (size_t at = 0; (at = other.find(from, at)) != std::string::npos; at += to.size()) other.replace(at, from.size(), to);
    EXPECT_NE(other, text) << from;
    return against_record(write("changed.jsonl", other).string());
  };
  const auto expect = [](const Outcome& outcome, int status, const std::string& words) {
    EXPECT_EQ(outcome.status, status) << outcome.output;
    EXPECT_SAYS(outcome.output, words);
  };
  expect(changed("\"schema\":1", "\"schema\":9"), 2, "schema");
  expect(changed("\"scene\":\"square\"", "\"scene\":\"cube\""), 2, "cube");
  expect(changed("\"width\":48", "\"width\":64"), 2, "width");
  expect(changed("\"backend\":\"osmesa\"", "\"backend\":\"egl\""), 2, "no cell in common");
  expect(changed("\"image_hash\":\"", "\"image_hash\":\"x"), 1, "picture changed");
  expect(against_record(write("cut.jsonl", text.substr(0, text.size() - 40)).string()), 2, "cut short");
  expect(against_record(write("empty.jsonl", "").string()), 2, "empty");
  // Another driver may round otherwise: hashes tell nothing there.
  expect(changed("\"driver\":\"Mesa", "\"driver\":\"Other"), 0, "another machine");
  // But a blank picture is blank anywhere, though all variants agree on it.
  copy_tree();
  replace(composite, "out_color = vec4(color, 1.0)", "out_color = vec4(vec3(0.5), 1.0)");  // the background
  ::setenv("LAMINA_HOME", tree().c_str(), 1);
  expect(changed("\"driver\":\"Mesa", "\"driver\":\"Other"), 1, "the picture is blank");
  ::unsetenv("LAMINA_HOME");
}

// Faults of pictures, of counts and of manifests in the user's own scene; what cannot be put there is said, not passed over.
TEST_F(Gate, SelfTestCatchesEveryFaultThatIsThere) {
  const Outcome outcome =
      lamina_program("gate lattice_plate --self-test --size 32x32 --truth-rays 0 --backend vulkan --out " + out().string());
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(outcome.output.find("MISSED"), std::string::npos) << outcome.output;
  EXPECT_SAYS(outcome.output, "passes     nothing");
  for (const char* fault : {"discard_all", "blank", "nan", "weights_swapped", "disc_scaled", "eight_bits", "tap", "idle",
                            "twice", "times_zero", "times_equal"})
    EXPECT_SAYS(outcome.output, std::string("caught     ") + fault);
  EXPECT_SAYS(outcome.output, "not there  alpha_0");
  EXPECT_EQ(lamina_program("gate lattice_plate --self-test --against .").status, 2) << "two things at once";
}

}  // namespace
}  // namespace lamina
