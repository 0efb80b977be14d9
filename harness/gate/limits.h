// SPDX-License-Identifier: Apache-2.0
// What a gate allows. The limits of one cell come from a gate file (TOML): [default] holds for every cell, each [[limit]] for
// the cells that its effect, variant and backend name (each may be left out: all). A later entry overrides an earlier one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/core/toml_form.h"

namespace lamina {

// Least or greatest values of one kind of error: worst view, pixels that the effect covers. Absent: no bound of its own.
struct ErrorLimits {
  std::optional<double> min_psnr_db, min_ssim, max_flip, max_rmse_linear, max_max_linear;
  bool operator==(const ErrorLimits&) const = default;
};

// How much worse a figure may read before it counts as worse: device rounding, not taste.
struct ErrorTolerance {
  double psnr_db = 0.05, ssim = 0.0001, flip = 0.0001, rmse_linear = 0.0001, max_linear = 0.002;
};

struct Limits {
  double max_slowdown = 0.015;  // of a pass or a frame, as a share: the margin inside which times are the same
  // A pass that takes less of its frame than this is judged within the frame alone. Measured on the heart (2 cores, lavapipe):
  // two equal passes of 20 ms in 390 that do little but read and write memory differ by 3 to 6% from process to process.
  double min_pass_share = 0.1;
  // Against a stored record, where nothing is paired: of a frame's time on the same machine, and of its ratio to the baseline.
  double max_drift = 0.25, max_ratio_drift = 0.05;
  double max_extra_fetches = 0;     // of a pass by texture, as a share
  double max_extra_operations = 0;  // of a pass by class, as a share
  // Of a frame: absent, no bound. A frame's time is judged where it is measured.
  std::optional<double> max_frame_ms, max_frame_fetches, max_frame_operations, max_target_bytes;
  // Whether a time that may be slower makes the gate ambiguous though every count is equal or fewer and the picture holds.
  bool times_must_decide = false;
  // Greatest difference of a picture from the one before, linear light: two steps of a half float just under 1. A picture may
  // change further where an error got better and none got worse. A baseline without a truth has no errors, so it may not.
  double max_picture_change = 0.002;
  uint64_t max_nonfinite_pixels = 0;
  bool same_image = false;  // every picture must keep its hash
  ErrorLimits baseline, truth;
  ErrorTolerance tolerance;
};

// The names that a gate file may use.
struct GateNames {
  std::vector<std::string> effects, variants, backends;
};

// What a gate file may hold.
TomlFormPtr limits_form(const GateNames& names);

class LimitsFile {
 public:
  LimitsFile() = default;  // the defaults for every cell
  // Throws Error(bad_input, "gate", "FILE:LINE", ...) for what is no TOML, names that there are not, values out of range, and
  // two [[limit]] entries for the same cells that set one key to two values.
  LimitsFile(const std::filesystem::path& file, const GateNames& names);

  Limits of(std::string_view effect, std::string_view variant, std::string_view backend) const;

 private:
  struct Entry {
    std::string effect, variant, backend;  // "": all
    std::vector<std::pair<std::string, double>> values;
  };
  std::vector<Entry> entries_;
};

}  // namespace lamina
