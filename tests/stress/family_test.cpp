// SPDX-License-Identifier: Apache-2.0
// family.toml: what is read from it, and what is refused, with file and line.
#include "harness/stress/family.h"

#include "harness/core/error.h"
#include "harness/core/image.h"
#include "tests/stress/family_folder.h"

namespace lamina {
namespace {

TextureImage no_image() { return {}; }

const std::string good = R"([family]
name = "sums"
function = "sum"
title = "a sum"
definition = "SUM"
shader = "family.comp"
oracle = "weighted"
scale = "two"
value = "total"
tables = ["ramp"]
[inputs.x0]
unit = "m"
from = -1.5
to = "pi"
open = "low"
[inputs.x1]
unit = "s"
from = "-pi/2"
to = 2
[inputs.x2]
unit = "kg"
from = 0
to = 1
open = "both"
[sets]
steps.what = "counted"
rest.what = "shifted"
[functions.fast]
claims = [{ over = 1, under = -2, sets = ["rest"] }, { over = 3, under = 0, eps_kappa = 4, sets = ["rest", "steps"] }]
[functions.right]
baseline = true
claims = [{ over = 0.5, under = -0.25 }]
[functions.wild]
[[slices]]
right = "x2"
up = "x0"
at = [{ x1 = 0.5 }, { x1 = 1 }]
full_error = 0.125
)";

class FamilyFile : public FamilyFolder {
 protected:
  FamilyFile() {
    code_.oracles = {{"weighted", &three_}, {"other", &three_}};
    code_.tables = {{"ramp", no_image}};
    write("family.comp", "");
  }
  // `good`, with one line (or a part of it) changed.
  std::string changed(const std::string& from, const std::string& to) {
    const size_t at = good.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return std::string(good).replace(at, from.size(), to);
  }
  void refused(const std::string& text, int line, const std::string& words) {
    const std::filesystem::path file = write("family.toml", text);
    try {
      load_family(file, code_);
      ADD_FAILURE() << "accepted, though: " << words;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_EQ(error.subject(), file.string() + ":" + std::to_string(line)) << error.message();
      EXPECT_NE(error.message().find(words), std::string::npos) << error.message() << "\nlacks: " << words;
    }
  }
  WeightedSum three_{3};
  EffectCode code_;
};

TEST_F(FamilyFile, IsReadAsItIsWritten) {
  const Family family = load_family(write("family.toml", good), code_);
  EXPECT_EQ(family.name, "sums");
  EXPECT_EQ(family.function, "sum");
  EXPECT_EQ(family.title, "a sum");
  EXPECT_EQ(family.definition, "SUM");
  EXPECT_EQ(family.shader, folder_ / "family.comp");
  EXPECT_EQ(family.scale, "two");
  EXPECT_EQ(family.value, "total");
  EXPECT_EQ(family.oracle, &three_);
  ASSERT_EQ(family.tables.size(), 1u);
  EXPECT_EQ(family.tables[0].name, "ramp");
  EXPECT_EQ(family.tables[0].make, no_image);

  ASSERT_EQ(family.input_names(), (std::vector<std::string>{"x0", "x1", "x2"}));
  EXPECT_EQ(family.inputs[0].unit, "m");
  EXPECT_EQ(family.inputs[0].from, -1.5);
  EXPECT_EQ(family.inputs[0].from_words, "-1.5");
  EXPECT_EQ(family.inputs[0].to, 3.141592653589793);
  EXPECT_EQ(family.inputs[0].to_words, "pi");
  EXPECT_EQ(family.inputs[1].from, -3.141592653589793 / 2);
  EXPECT_TRUE(family.inputs[0].low_open);
  EXPECT_FALSE(family.inputs[0].high_open);
  EXPECT_FALSE(family.inputs[1].low_open || family.inputs[1].high_open);
  EXPECT_TRUE(family.inputs[2].low_open && family.inputs[2].high_open);

  ASSERT_EQ(family.sets.size(), 2u);
  EXPECT_EQ(family.sets[0].name, "steps") << "in the order of the file, not of the alphabet";
  EXPECT_EQ(family.sets[1].what, "shifted");

  EXPECT_EQ(family.function_names(), (std::vector<std::string>{"right", "fast", "wild"})) << "the baseline first";
  EXPECT_TRUE(family.functions[0].baseline);
  EXPECT_EQ(family.functions[0].claim("steps")->over, 0.5);
  EXPECT_EQ(family.functions[0].claim("grid")->under, -0.25) << "a claim without sets is one on whatever is given";
  EXPECT_FALSE(family.functions[0].claim("steps")->eps_kappa);
  EXPECT_EQ(family.functions[1].claim("rest")->over, 1) << "the first";
  EXPECT_EQ(*family.functions[1].claim("steps")->eps_kappa, 4);
  EXPECT_EQ(family.functions[1].claim("grid"), nullptr);
  EXPECT_EQ(family.functions[2].claim("steps"), nullptr);

  ASSERT_EQ(family.slices.size(), 2u);
  EXPECT_EQ(family.slices[1].right, 2u);
  EXPECT_EQ(family.slices[1].up, 0u);
  EXPECT_EQ(family.slices[1].at[1], 1);
  EXPECT_EQ(family.slices[1].full_error, 0.125);
}

TEST_F(FamilyFile, TwoInputsNeedNoPlaceForTheirSlice) {
  WeightedSum two(2);
  code_.oracles["weighted"] = &two;
  const size_t third = good.find("[inputs.x2]"), sets = good.find("[sets]"), slices = good.find("[[slices]]");
  const std::string text =
      good.substr(0, third) + good.substr(sets, slices - sets) + "[[slices]]\nright = \"x0\"\nup = \"x1\"\nfull_error = 1\n";
  EXPECT_EQ(load_family(write("family.toml", text), code_).slices.size(), 1u);
}

TEST_F(FamilyFile, BadHeads) {
  refused("x = 1\n", 1, "has no [family]");
  refused(changed("title = \"a sum\"", "titel = \"a sum\""), 1, "'title' is missing");
  refused(changed("title = \"a sum\"", "title = \"\""), 4, "'title' must not be empty");
  refused(changed("title = \"a sum\"", "title = \"a sum\"\ncolour = 1"), 5, "unknown key 'colour'");
  refused(changed("name = \"sums\"", "name = \"my sums\""), 2, "'my sums' must be letters, digits and '_'");
  refused(changed("function = \"sum\"", "function = \"2sum\""), 3, "'2sum' must be letters");
  refused(changed("definition = \"SUM\"", "definition = \"S-M\""), 5, "'S-M' must be letters");
  refused(changed("family.comp", "famly.comp"), 6, "famly.comp is no file");
  refused(changed("\"weighted\"", "\"weihgted\""), 7, "unknown oracle 'weihgted' (did you mean 'weighted'?)");
  refused(changed("\"ramp\"", "\"romp\""), 10, "unknown table 'romp' (did you mean 'ramp'?)");
  refused(changed("value = \"total\"", "value = 3"), 9, "'value' must be a string");
  refused(changed("scale = \"two\"", "scale = two"), 8, "");
  refused(good + "[family_of]\nx = 1\n", 39, "unknown key 'family_of' (did you mean 'family'?)");
}

TEST_F(FamilyFile, BadInputs) {
  refused(changed("[inputs.x2]", "[inputs.x3]"), 20, "unknown input 'x3' (did you mean 'x0'?)");
  refused(changed("[inputs.x2]\nunit = \"kg\"\nfrom = 0\nto = 1\nopen = \"both\"\n", ""), 11,
          "the oracle's input 'x2' is missing: give it a table [inputs.x2]");
  refused(changed("[inputs.x2]\nunit = \"kg\"\nfrom = 0\nto = 1\nopen = \"both\"\n", "") +
              "[inputs.x2]\nunit = \"kg\"\nfrom = 0\nto = 1\n[sets.other]\nwhat = \"x\"\n",
          38, "unknown set 'other'");
  refused(changed("unit = \"m\"\n", ""), 11, "'unit' is missing");
  refused(changed("from = -1.5\n", ""), 11, "'from' is missing");
  refused(changed("to = \"pi\"", "to = \"pie\""), 14, "unknown constant 'pie' (did you mean 'pi'?)");
  refused(changed("to = 2\n", "to = -2\n"), 19, "'to' (-2) must be above 'from' (-pi/2)");
  refused(changed("to = 2\n", "to = inf\n"), 19, "'to' must be a number");
  refused(changed("open = \"low\"", "open = \"lo\""), 15, "unknown end 'lo' (did you mean 'low'?)");
  refused(changed("open = \"low\"", "closed = \"low\""), 15, "unknown key 'closed'");
  std::string turned = good;
  turned.replace(turned.find("[inputs.x0]"), 11, "[inputs.y]");
  turned.replace(turned.find("[inputs.x1]"), 11, "[inputs.x0]");
  turned.replace(turned.find("[inputs.y]"), 10, "[inputs.x1]");
  refused(turned, 11, "the oracle takes them in the order x0, x1, x2");
}

TEST_F(FamilyFile, BadSets) {
  refused(changed("rest.what", "rost.what"), 27, "unknown set 'rost' (did you mean 'rest'?)");
  refused(changed("rest.what = \"shifted\"\n", ""), 25, "the oracle's set 'rest' is missing: give it a table [sets.rest]");
  refused(changed("rest.what", "grid.what"), 27, "a set cannot be called 'grid'");
  refused(changed("rest.what", "rest.waht"), 27, "'what' is missing");
  refused(changed("rest.what = \"shifted\"", "rest = { what = \"shifted\", count = 1 }"), 27, "unknown key 'count'");
}

TEST_F(FamilyFile, BadFunctions) {
  refused(changed("[functions.wild]", "[functions.wi-ld]"), 33, "'wi-ld' must be letters");
  refused(changed("baseline = true\n", ""), 28, "none of the functions has baseline = true");
  refused(changed("[functions.wild]", "[functions.wild]\nbaseline = true"), 34, "'right' is the baseline already");
  refused(changed("[functions.wild]", "[functions.wild]\nclaim = []"), 34, "unknown key 'claim' (did you mean 'claims'?)");
  refused(changed("claims = [{ over = 0.5, under = -0.25 }]", "claims = [{ over = 0.5 }]"), 32, "'under' is missing");
  refused(changed("over = 0.5", "over = -0.5"), 32, "'over' must be a number from 0");
  refused(changed("under = -0.25", "under = 0.25"), 32, "'under' must be a number from -inf to 0");
  refused(changed("under = -0.25", "under = -0.25, ever = 1"), 32, "unknown key 'ever' (did you mean 'over'?)");
  refused(changed("sets = [\"rest\"]", "sets = [\"rust\"]"), 29, "unknown set 'rust' (did you mean 'rest'?)");
  refused(changed("sets = [\"rest\"]", "sets = []"), 29, "'sets' is empty");
  refused(changed("claims = [{ over = 0.5, under = -0.25 }]", "claims = 1"), 32, "'claims' must be a list of tables");
}

TEST_F(FamilyFile, BadSlices) {
  refused(changed("right = \"x2\"", "right = \"y2\""), 35, "unknown input 'y2' (did you mean 'x2'?)");
  refused(changed("up = \"x0\"", "up = \"x2\""), 36, "'right' and 'up' must be two inputs");
  refused(changed("{ x1 = 0.5 }", "{ x2 = 0.5 }"), 37, "'x2' runs over this slice");
  refused(changed("{ x1 = 0.5 }", "{ x4 = 0.5 }"), 37, "unknown input 'x4'");
  refused(changed("{ x1 = 0.5 }", "{ x1 = 2.5 }"), 37, "'x1' must be a number from -1.57");
  refused(changed("{ x1 = 0.5 }", "{}"), 37, "needs x1 = NUMBER");
  refused(changed("{ x1 = 0.5 }", "{ x1 = 1 }"), 37, "this slice is there already");
  refused(changed("at = [{ x1 = 0.5 }, { x1 = 1 }]\n", ""), 34, "'at' is missing");
  refused(changed("full_error = 0.125", "full_error = 0"), 38, "'full_error' must be a number from");
  refused(changed("full_error = 0.125", "full_error = 1\nsize = 2"), 39, "unknown key 'size'");
}

TEST_F(FamilyFile, FamiliesOfAFolderHaveNamesOfTheirOwn) {
  const auto family = [&](const std::string& folder, const std::string& name, const std::string& function,
                          const std::string& prefix) {
    std::string text = good;
    text.replace(text.find("\"sums\""), 6, "\"" + name + "\"");
    text.replace(text.find("\"sum\""), 5, "\"" + function + "\"");
    for (size_t at = 0; (at = text.find("[functions.", at)) != std::string::npos; at += 11) text.insert(at + 11, prefix);
    write(folder + "/family.comp", "");
    write(folder + "/family.toml", text);
  };
  write("none/shader.glsl", "");
  family("b", "second", "two", "q_");
  family("a", "first", "one", "p_");
  const std::vector<Family> families = load_families(folder_, code_);
  ASSERT_EQ(families.size(), 2u);
  EXPECT_EQ(families[0].name, "first");
  EXPECT_EQ(families[1].name, "second");
  const auto clash = [&](const std::string& words) {
    try {
      load_families(folder_, code_);
      ADD_FAILURE() << "accepted, though: " << words;
    } catch (const Error& error) {
      EXPECT_EQ(error.subject(), (folder_ / "b/family.toml").string());
      EXPECT_EQ(error.message().find(words + " is declared by " + (folder_ / "a/family.toml").string()), 0u) << error.message();
    }
  };
  family("b", "first", "two", "q_");
  clash("family first");
  family("b", "second", "one", "q_");
  clash("GLSL function one");
  family("b", "second", "two", "p_");
  clash("function p_right");
}

}  // namespace
}  // namespace lamina
