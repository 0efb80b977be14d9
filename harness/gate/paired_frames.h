// SPDX-License-Identifier: Apache-2.0
// Frames timed against each other, piece by piece. Every pass is cut into strips that last some milliseconds. A strip of one
// frame is timed right beside the same strip of the others, in shuffled order: the speed of a shared machine wanders by tens of
// percent within a second, but hardly within a strip. ratio_estimate.h makes a ratio of the strips.
//
// A strip runs the pass's vertices again. So a change of the fragment work reads smaller than it is for the whole pass, and a
// change of the vertex work larger. On the heart at 512x512, 64 strips would take a fifth off a change of fragment work; 16
// strips take a twentieth off, and are as precise in the same time.
#pragma once

#include <optional>
#include <random>
#include <string>
#include <vector>

#include "harness/graph/frame.h"
#include "harness/record/gate_rows.h"

namespace lamina {

// One round takes every fourth strip of a pass: a fair sample of the picture, and four times the rounds in the same time.
inline constexpr size_t rounds_a_frame = 4;

struct PieceOptions {
  double piece_ms = 5;       // what a strip should last, at least
  uint32_t max_strips = 16;  // of a pass
  uint32_t max_repeats = 4;  // of the strips of a short pass, in each round
};

struct PairedFrame {
  Frame* frame = nullptr;       // must outlive its pairs and have run once
  size_t same_passes = 0;       // from its first on, that are known to be the same as those of the first frame
  std::vector<double> pass_ms;  // what its passes lasted when it ran, beside its frame_names()
};

class PairedFrames {
 public:
  // Passes are paired by name, and by order among those of one name. The frame in which a pass was fastest decides how it is
  // cut: in another frame the time may include compiling.
  PairedFrames(Backend& backend, const std::vector<PairedFrame>& frames, size_t view, const PieceOptions& options = {});

  // Times the round's pieces of every frame; a pass that is repeated counts with the mean. Throws Error(failed) on device loss.
  void run_round(std::mt19937_64& random);

  // Forgets the rounds so far; the cuts stay.
  void start_again();

  const std::vector<PairedPass>& passes() const { return passes_; }
  size_t rounds() const { return rounds_; }

 private:
  struct Cut {
    size_t occurrence = 0;  // among the passes of its name
    uint32_t strips = 1, repeats = 1;
    std::vector<std::vector<Pass>> pieces;  // [frame]
  };
  size_t pass_named(const std::string& name, size_t occurrence);
  std::vector<size_t> passes_of(size_t frame);  // beside its frame_names()
  bool runs(size_t pass, size_t frame) const;   // in the next round
  struct Timed {
    double ms = 0;
    size_t turn = 0;  // among the frames of its strip
  };
  static void add_round(PairedPass& pass, const std::vector<std::vector<Timed>>& strips, uint32_t repeats);

  Backend& backend_;
  std::vector<Frame*> frames_;
  std::vector<PairedPass> passes_;
  std::vector<Cut> cuts_;  // beside passes_
  size_t rounds_ = 0;
};

// What a pass of a frame lasts as a whole: for one that is cut, the sum of the medians of the kinds of rounds. Absent where the
// frame has no such pass, or fewer rounds than make a frame.
std::optional<double> whole_ms(const PairedPass& pass, size_t frame);

}  // namespace lamina
