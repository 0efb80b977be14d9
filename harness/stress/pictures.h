// SPDX-License-Identifier: Apache-2.0
// Pictures of a function's error over slices of its inputs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/stress/function_runner.h"
#include "harness/stress/judge.h"

namespace lamina {

// A slice: two inputs run over their ranges, to the right and upwards; the others are fixed.
struct Slice {
  std::string name;  // "r1 = 0.5", "" where none is fixed
  std::string axes;  // "r0 from 0 to pi to the right, d from 0 to pi upwards"
  std::string file;  // "-r1-0.5.png": the end of its pictures' names
  double full_error = 0;
  Points points;  // a pixel each, row 0 on top
  PointTruth truth;
};
std::vector<Slice> make_slices(const Family& family);

// Writes FOLDER/NAME-r1-0.5.png for each slice and returns these files' names, beside the slices. Red is a value too large,
// blue too small, white none; full colour at the slice's full_error; black is not finite, grey where the oracle knows no value.
std::vector<std::string> write_pictures(FunctionRunner& runner, const std::vector<Slice>& slices,
                                        const std::filesystem::path& folder, const std::string& name);

}  // namespace lamina
