// SPDX-License-Identifier: Apache-2.0
// The record of a run: one JSON object a line, appended and flushed as each is known, so that a run that dies leaves all it had
// measured. Field names are fixed by tests/record; schema 1.
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/graph/counts.h"
#include "harness/measure/statistics.h"
#include "harness/measure/timer_certificate.h"
#include "harness/quality/quality.h"

namespace lamina {

inline constexpr int record_schema = 1;  // of the run line; a reader refuses any other

struct PassRow {
  std::string name;
  bool once = false;       // done once, apart from the frame: its time is not in the cell's median_ms
  std::vector<double> ms;  // one sample a round (once: one a repetition)
  uint64_t fragments = 0;  // shader invocations of the fragment (or compute) stage, hidden fragments excluded
  uint64_t vertices = 0;   // invocations of the vertex stage
  uint64_t fetches = 0;
  bool early_tests = true;  // false: fragments hidden later are counted too, since the shader discards or writes depth
  std::vector<TextureFetches> by_texture;
};

// The frame's time of each round in ms: the sum over the passes that are not done once. Empty where nothing was timed. Throws
// Error(failed) where the passes differ in their numbers of samples, for then there is no pairing by round.
std::vector<double> frame_samples_ms(std::span<const PassRow> passes);

// What one assumption costs by itself: the picture made with it against the picture made without it, all else alike.
struct AssumptionRow {
  std::string name, title;  // "intersection", "approximate against exact intersection"
  ErrorFigures error;       // over the pixels that the effect covers
  std::string image;        // the difference picture's path, relative to the run's folder; "" where there is none
};

struct CellRow {
  std::string scene, effect, variant, backend, device, view;
  bool baseline = false;
  int width = 0, height = 0;
  std::map<std::string, double> params;      // by path; "scene.time" is always there; a word of a sweep by its place
  std::map<std::string, std::string> words;  // by path, of parameters that take words
  bool failed = false;
  std::string reason;   // of the failure
  bool timed = true;    // false: the timer's certificate failed, or a sweep did not ask: no time is given
  bool counted = true;  // false: a sweep did not ask: fetches and invocations are not known
  std::vector<PassRow> passes;
  double cold_ms = 0;  // the first frame, shader compilation included, host clock
  std::optional<Interval> ratio_to_baseline;
  uint64_t fetches = 0;          // of the frame: sum over passes that are not done once
  double fetches_per_pixel = 0;  // fetches / covered_pixels
  std::optional<ErrorFigures> error_covered,
      error_frame;                          // against the baseline; absent for the baseline itself and failed cells
  std::optional<ErrorFigures> error_truth;  // against the truth, covered pixels; absent where there is no truth, or a failure
  std::vector<AssumptionRow> assumptions;   // none where there is no truth
  uint64_t nonfinite_pixels = 0;
  uint64_t covered_pixels = 0;          // pixels in which the effect's final pass shaded at least once
  std::optional<double> range_linear;   // range_linear() over these pixels (quality.h); absent where there are none, or a
                                        // pixel is not finite
  std::string image, difference, flip;  // paths relative to the run's folder, "" where there is none
  std::string truth_image;              // the truth of the same view, likewise
  std::optional<WorstTile> worst_tile;  // against the baseline; absent where there is no FLIP map
  std::string image_hash;               // of the linear picture's bytes
  std::vector<std::string> shader_hashes;
};

// Work that is done before the first frame, for one object, and whose result may be kept between runs.
struct BakeRow {
  std::string effect, object, what;  // what: the baker
  uint64_t points = 0;               // that were baked
  uint64_t rays = 0;                 // that were cast, or were once for what came from the cache
  double seconds = 0;                // wall clock of this run: casting, or reading the cache
  bool from_cache = false;
};

// One line of the record. A figure that is not known is null, never 0: figures of a failed cell, times of a cell that is not
// timed, fetches a pixel where no pixel is covered. PSNR of equal pictures is null with "identical": true.
// "range_linear", "truth_image", "worst_tile" and "assumptions" are left out where there are none. Throws Error(failed) for a
// number that is not finite, and as frame_samples_ms() does.
nlohmann::ordered_json to_json(const CellRow& cell);
// one_ms, additivity and attribution are null where linearity is empty, which is a certificate that never got to measure.
nlohmann::ordered_json to_json(const TimerRow& timer);
// Its fields, or null. Throws Error(failed) for a number that is not finite, naming `owner` and `what`.
nlohmann::ordered_json interval_to_json(const std::optional<Interval>& interval, const std::string& owner,
                                        std::string_view what);
// And back; none for null.
std::optional<Interval> interval_of(const nlohmann::json& interval);
// rays_per_second is null where the result came from the cache or took no time that could be measured.
nlohmann::ordered_json to_json(const BakeRow& bake);

// Opens a record, afresh or to go on behind its last line, and appends lines; its folder must exist. Throws Error(bad_input)
// where the folder cannot be written.
class RecordWriter {
 public:
  explicit RecordWriter(const std::filesystem::path& file, bool go_on = false);
  // Appends one line and flushes it. Throws Error(failed) when the disk is full, and at every call after that, so that a line
  // cut short is the last one. Bytes that are not UTF-8 become U+FFFD.
  void append(const nlohmann::ordered_json& line);

 private:
  std::filesystem::path file_;
  std::ofstream stream_;
};

// A record as read back: what reports are made of.
struct Record {
  nlohmann::json run;
  std::vector<nlohmann::json> timers, plans, cells, bakes;
  std::vector<nlohmann::json> phases;  // wall time of the rounds, and the device time that they measured
  std::vector<nlohmann::json> functions, function_times, function_timers, function_pictures;  // see function_rows.h
  std::vector<nlohmann::json> pairs;                 // the samples behind a gate's verdicts on times
  std::vector<nlohmann::json> gates, aas, verdicts;  // a gate's answer, its A/A arms, each figure's verdict: gate_lines.h
  std::vector<nlohmann::json> sweeps, crossovers;    // see sweep_rows.h; at most one sweep
};
// Throws Error(bad_input, "record", "FILE:LINE", ...) for a line that is not JSON, another schema, no first line of kind "run",
// an unknown kind, or a field missing or of the wrong type; what it returns has every field that to_json() writes. A last line
// cut short by a crash (it has no newline) is dropped, and said so in `run["truncated"]`, a sentence.
Record read_record(const std::filesystem::path& file);

// The passes of a cell that was read back.
std::vector<PassRow> passes_of(const nlohmann::json& cell);

}  // namespace lamina
