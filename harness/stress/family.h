// SPDX-License-Identifier: Apache-2.0
// A family of functions: several ways to compute one value, all of the same inputs. shaders/NAME/family.toml declares it:
//
//   [family]
//   name = "caps"                    # `lamina stress caps`
//   function = "cap_intersection"    # the GLSL function that is called, with all inputs; and the name in records
//   title = "the area that two spherical caps share"
//   definition = "CAP_INTERSECTION"  # is defined as the name of one of the functions below, which selects it
//   shader = "family.comp"           # beside this file: includes the functions, then "stress/function.glsl"
//   oracle = "cap_intersection"      # harness/effects/, by name
//   scale = "the smaller cap's area" # what errors are divided by, in words
//   value = "area"                   # the column of a file of points that brings right values
//   tables = ["cap_table"]           # optional, EffectCode's: CAP_TABLE_BINDING is defined as the binding of its sampler
//   grid = "radii in (0, pi)"        # optional: what a grid is of, in words
//   [inputs.r0]                      # 1 to 8, in the order of the arguments: the oracle's
//   unit = "radians"
//   from = 0                         # where grids run, and slices: a number, or a word such as "pi"
//   to = "pi"
//   open = "both"                    # optional, or "low" or "high": that end itself is no input
//   [sets.tiny]                      # the oracle's, in the order in which they are shown; the first is the one that is timed
//   what = "radii of 1e-6 to 1e-3"
//   [functions.exact_cap]            # in the order in which they are shown
//   baseline = true                  # of one of them
//   claims = [{ over = 1e-6, under = -1e-6, eps_kappa = 4 }]  # optional; with `sets = ["tiny", ...]` on those alone
//   [[slices]]                       # optional: pictures of the error, for each point of `at` one
//   right = "r0"
//   up = "d"
//   at = [{ r1 = 0.5 }]              # the other inputs
//   full_error = 0.16                # which has full colour
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/core/toml_form.h"
#include "harness/manifest/effect_code.h"
#include "harness/stress/oracle.h"

namespace lamina {

struct FamilyInput {
  std::string name, unit;
  double from = 0, to = 0;
  std::string from_words, to_words;  // as they are written: "pi"
  bool low_open = false, high_open = false;
};

struct FamilySet {
  std::string name, what;
};

// What a function errs by at most, (value - truth) / scale, on these sets; on any where none is named.
struct FamilyClaim {
  double over = 0, under = 0;
  std::optional<double> eps_kappa;  // of |value - truth| / truth in units of 2^-23 max(1, condition number)
  std::vector<std::string> sets;
};

struct FamilyFunction {
  std::string name;
  bool baseline = false;
  std::vector<FamilyClaim> claims;
  // The first claim on this set, null where there is none.
  const FamilyClaim* claim(const std::string& set) const;
};

struct FamilySlice {
  size_t right = 0, up = 0;  // places of inputs
  std::vector<float> at;     // of every input; those two do not count
  double full_error = 0;
};

struct FamilyTable {
  std::string name;
  TextureImage (*make)() = nullptr;
};

struct Family {
  std::filesystem::path file, shader;
  std::string name, function, title, definition, scale, value, grid;
  const Oracle* oracle = nullptr;
  std::vector<FamilyTable> tables;
  std::vector<FamilyInput> inputs;
  std::vector<FamilySet> sets;
  std::vector<FamilyFunction> functions;  // the baseline first
  std::vector<FamilySlice> slices;

  std::vector<std::string> input_names() const;
  std::vector<std::string> function_names() const;
};

// What a family.toml may hold.
TomlFormPtr family_form(const EffectCode& code);
// Throws Error(bad_input, "family", "FILE:LINE", ...) for what is missing, unknown, or not as above.
Family load_family(const std::filesystem::path& file, const EffectCode& code);

// Of every folder of `shaders` that has a family.toml, by its path. No two have a name in common: their records and pictures
// lie in one folder.
std::vector<Family> load_families(const std::filesystem::path& shaders, const EffectCode& code);

}  // namespace lamina
