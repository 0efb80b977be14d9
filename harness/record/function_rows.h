// SPDX-License-Identifier: Apache-2.0
// Lines of the record about a shader's functions: what each variant of one errs by and costs a call.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "harness/measure/statistics.h"

namespace lamina {

// Which variant of which function, and where it ran.
struct FunctionSubject {
  std::string function, title;  // "cap_intersection", "the area that two spherical caps share"
  std::string variant, backend, device;
  bool baseline = false;
};

// What a variant claims of its errors on a set of inputs, in the figures of a FunctionRow.
struct FunctionBounds {
  double over = 0, under = 0;       // max_over at most, max_under at least
  std::optional<double> eps_kappa;  // max_eps_kappa at most
};

// One set of inputs. Errors are (value - truth) / scale.
struct FunctionRow {
  FunctionSubject subject;
  std::string scale;      // "the smaller cap's area"
  std::string set, what;  // the set's name, and what is in it
  uint64_t points = 0;
  // Over the values that are finite; absent where none is.
  std::optional<double> max_over, max_under;  // greatest and least error, so 0 or more and 0 or less
  std::optional<double> mean_absolute, rms;
  std::optional<double> max_eps;         // greatest |error| in units of 2^-23
  std::optional<double> max_eps_kappa;   // greatest |value - truth| / truth in units of 2^-23 max(1, condition number)
  uint64_t negative = 0, nonfinite = 0;  // of the points; negative where the truth is not
  uint64_t not_zero = 0;                 // points whose truth is 0, but whose value is not
  // The inputs of max_over and max_under, in the function's order; empty where no value errs that way.
  std::vector<double> worst_over, worst_under;
  // The first inputs whose value is not finite, is negative, or is not 0 where 0 is right; empty where there are none.
  std::vector<double> first_fault{};
  std::optional<FunctionBounds> bounds{};  // absent where the variant claims none on this set
};

struct FunctionTimeRow {
  FunctionSubject subject;
  std::optional<Interval> ns_per_call;  // absent where the timer was not certified
  std::vector<double> ns{};             // of a call in each of the interval's rounds
  std::string reason;                   // why the interval is absent
  std::string commit, build;            // of the program that timed; only "release" counts
};

// A picture of the error over a slice of the inputs: red too much, blue too little, white none, black not finite.
struct FunctionPictureRow {
  FunctionSubject subject;
  std::string slice, axes;  // "r1 = 0.5"; what runs to the right and what upwards
  std::string image;        // path relative to the run's folder
  double full_error = 0;    // the error, in the unit above, that has full colour
};

// One line of the record each; samples to six digits, more than any timer resolves. Errors of a row without a finite value, and
// inputs of the worst where no value errs that way, are left absent. Throws Error(failed) for a number that is not finite.
nlohmann::ordered_json to_json(const FunctionRow& row);
nlohmann::ordered_json to_json(const FunctionTimeRow& row);
nlohmann::ordered_json to_json(const FunctionPictureRow& row);

// Puts `lines` at the end of the record in `file` and takes those on `function` out that were there, atomically; every other
// line stays byte for byte, but for one cut short at the end, which goes, and the run line then says so. Where there is no
// file, one that begins with `run_line` is made. Throws as read_record() and write_file_atomically() do.
void replace_function_lines(const std::filesystem::path& file, const std::string& function,
                            const nlohmann::ordered_json& run_line, const std::vector<nlohmann::ordered_json>& lines);

}  // namespace lamina
