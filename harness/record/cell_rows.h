// SPDX-License-Identifier: Apache-2.0
// Lines of the record about what was measured: cells with their passes, what was baked before them, how long their rounds took.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/graph/counts.h"
#include "harness/measure/statistics.h"
#include "harness/quality/quality.h"

namespace lamina {

// What a line of a shader's source did, in all functions that it stands in.
struct LineRow {
  std::string file;  // relative to the folder of shaders where it lies in it
  uint64_t line = 0, fetches = 0, operations = 0;
};
inline constexpr size_t max_line_rows = 12;  // of a pass

struct PassRow {
  std::string name;
  bool once = false;                            // done once, apart from the frame: its time is not in the cell's median_ms
  std::vector<double> ms;                       // one sample a round (once: one a repetition)
  std::optional<double> median_ms;              // of ms, made when the line is written
  std::optional<uint64_t> fragments, vertices;  // invocations: of the fragment (or compute) stage, hidden fragments excluded;
                                                // of the vertex stage
  std::optional<uint64_t> fetches;
  bool early_tests = true;  // false: fragments hidden later are counted too, since the shader discards or writes depth
  std::vector<TextureFetches> by_texture;
  std::map<std::string, uint64_t> operations;  // by class (shader/operations.h); empty: a record of before has none
  std::map<std::string, uint64_t> issued;      // likewise, the untaken sides of branches too (shader/block_work.h)
  std::vector<LineRow> lines;                  // the dearest, by the sum of their shares of the pass's fetches and operations
  // As in PassCounts. Records of before have none of these.
  std::map<std::string, uint64_t> vertex_issued = {};
  std::optional<uint64_t> runs = {}, triangles = {}, issued_fragments = {};
  std::vector<WrittenTexels> written = {};
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

// A figure that is not known is absent, never 0.
struct CellRow {
  std::string scene, effect, variant, backend, device, view;
  bool baseline = false;
  int width = 0, height = 0;
  std::map<std::string, double> params;      // by path; "scene.time" is always there; a word of a sweep by its place
  std::map<std::string, std::string> words;  // by path, of parameters that take words
  bool failed = false;
  std::string reason;              // of the failure
  std::vector<std::string> notes;  // what the picture may lack, one sentence each
  bool timed = true;               // false: the timer's certificate failed, or a sweep did not ask: no time is given
  std::vector<PassRow> passes;
  std::optional<double> median_ms;  // of frame_samples_ms(), made when the line is written, and so is
  std::optional<double> once_ms;    // the sum of the medians of the passes that are done once
  std::optional<double> cold_ms;    // the first frame, shader compilation included, host clock
  std::optional<Interval> ratio_to_baseline;
  std::optional<uint64_t> fetches;          // of the frame: sum over passes that are not done once; absent: not asked for
  std::optional<double> fetches_per_pixel;  // fetches / covered_pixels
  std::optional<uint64_t> target_bytes;     // of the frame's targets and storage buffers; absent in records of before
  // Against the baseline, over the pixels that the effect covers and over the frame; absent for the baseline itself and failed
  // cells.
  std::optional<ErrorFigures> error_covered, error_frame;
  std::optional<ErrorFigures> error_truth;  // against the truth, covered pixels; absent where there is no truth, or a failure
  std::vector<AssumptionRow> assumptions;   // none where there is no truth
  std::optional<double>
      max_alpha;  // the greatest difference of alpha to the baseline, covered pixels; absent where nobody asks
  std::optional<uint64_t> nonfinite_pixels;
  std::optional<uint64_t> covered_pixels;  // pixels in which the effect's final pass shaded at least once
  std::optional<double> range_linear;      // range_linear() over these pixels (quality.h); absent where there are none, or a
                                           // pixel is not finite
  std::string image, difference, flip;     // paths relative to the run's folder, "" where there is none
  std::string truth_image;                 // the truth of the same view, likewise
  std::string before_image;                // of a gate over two trees: the picture before the change
  std::optional<WorstTile> worst_tile;     // against the baseline; absent where there is no FLIP map
  std::string image_hash;                  // of the linear picture's bytes
  std::vector<std::string> shader_hashes;
};

// Work that is done before the first frame, for one object, and whose result may be kept between runs.
struct BakeRow {
  std::string effect, object, what;         // what: the baker
  uint64_t points = 0;                      // that were baked
  uint64_t rays = 0;                        // that were cast, or were once for what came from the cache
  double seconds = 0;                       // wall clock of this run: casting, or reading the cache
  std::optional<double> rays_per_second{};  // made when the line is written; absent where none were cast, or in no time
  bool from_cache = false;
};

// The rounds of an effect on a backend: by the wall clock, and the device time that they measured.
struct PhaseRow {
  std::string backend, effect;
  uint64_t rounds = 0;
  double wall_ms = 0, device_ms = 0;
};

// One line of the record each. What is made when the line is written is made here, and times of a cell that failed or is not
// timed are left absent, as are counts of 0 of a failed cell. Throws Error(failed) for a number that is not finite, and as
// frame_samples_ms() does.
nlohmann::ordered_json to_json(const CellRow& row);
nlohmann::ordered_json to_json(const BakeRow& row);
nlohmann::ordered_json to_json(const PhaseRow& row);

}  // namespace lamina
