// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/paired_frames.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "harness/measure/statistics.h"

namespace lamina {
namespace {

// A multiple of rounds_a_frame, so that all rounds take as many strips; 1 where there is no use in cutting.
uint32_t strips_for(double ms, const PieceOptions& options) {
  const double wanted = std::min(ms / options.piece_ms, static_cast<double>(options.max_strips)) / rounds_a_frame;
  return wanted < 0.5 ? 1 : static_cast<uint32_t>(std::round(wanted)) * static_cast<uint32_t>(rounds_a_frame);
}

// Repeats of a short pass, so that it has as many strips in a whole frame as the longest one: it costs little and is judged
// alike.
uint32_t repeats_for(uint32_t strips, const PieceOptions& options) {
  const uint32_t once = std::max(strips, static_cast<uint32_t>(rounds_a_frame));  // what is not cut runs in every round
  return std::clamp(options.max_strips / once, 1u, options.max_repeats);
}

}  // namespace

PairedFrames::PairedFrames(Backend& backend, const std::vector<PairedFrame>& frames, size_t view, const PieceOptions& options)
    : backend_(backend) {
  for (const PairedFrame& each : frames) frames_.push_back(each.frame);
  std::vector<std::vector<size_t>> passes;  // [frame]
  std::vector<double> min_ms;               // beside passes_
  for (size_t frame = 0; frame < frames.size(); ++frame) {
    passes.push_back(passes_of(frame));
    min_ms.resize(passes_.size(), std::numeric_limits<double>::infinity());
    for (size_t i = 0; i < passes[frame].size(); ++i)
      min_ms[passes[frame][i]] = std::min(min_ms[passes[frame][i]], frames[frame].pass_ms.at(i));
  }
  for (size_t pass = 0; pass < passes_.size(); ++pass)
    cuts_[pass].strips = strips_for(min_ms[pass], options), cuts_[pass].repeats = repeats_for(cuts_[pass].strips, options);
  for (size_t frame = 0; frame < frames.size(); ++frame) {
    for (size_t i = 0; i < std::min(frames[frame].same_passes, passes[frame].size()); ++i)
      passes_[passes[frame][i]].same[frame] = true;
    std::vector<uint32_t> parts;
    for (const size_t pass : passes[frame]) parts.push_back(cuts_[pass].strips);
    for (Frame::Slice& slice : frames_[frame]->slices(view, parts))
      cuts_[passes[frame][slice.pass]].pieces[frame].push_back(std::move(slice.piece));
  }
  for (size_t pass = 0; pass < passes_.size(); ++pass)
    passes_[pass].cut = cuts_[pass].strips > 1 &&
                        std::all_of(cuts_[pass].pieces.begin(), cuts_[pass].pieces.end(), [](const std::vector<Pass>& pieces) {
                          return pieces.empty() || pieces.size() >= rounds_a_frame;
                        });
}

size_t PairedFrames::pass_named(const std::string& name, size_t occurrence) {
  for (size_t i = 0; i < passes_.size(); ++i)
    if (passes_[i].name == name && cuts_[i].occurrence == occurrence) return i;
  passes_.push_back({name, false, std::vector<bool>(frames_.size()), std::vector<std::vector<double>>(frames_.size()),
                     std::vector<std::vector<StripPair>>(frames_.size())});
  cuts_.push_back({occurrence, 1, 1, std::vector<std::vector<Pass>>(frames_.size())});
  return passes_.size() - 1;
}

std::vector<size_t> PairedFrames::passes_of(size_t frame) {
  const std::vector<std::string>& names = frames_[frame]->frame_names();
  std::vector<size_t> passes;
  for (size_t i = 0; i < names.size(); ++i) {
    const auto here = names.begin() + static_cast<std::ptrdiff_t>(i);
    passes.push_back(pass_named(names[i], static_cast<size_t>(std::count(names.begin(), here, names[i]))));
  }
  return passes;
}

void PairedFrames::start_again() {
  for (PairedPass& pass : passes_) {
    for (std::vector<double>& of_frame : pass.ms) of_frame.clear();
    for (std::vector<StripPair>& of_frame : pass.strips) of_frame.clear();
  }
  rounds_ = 0;
}

bool PairedFrames::runs(size_t pass, size_t frame) const {
  if (frame > 0) return !passes_[pass].same[frame];
  const std::vector<bool>& same = passes_[pass].same;
  return rounds_ < rounds_a_frame || std::find(same.begin() + 1, same.end(), false) != same.end();
}

void PairedFrames::run_round(std::mt19937_64& random) {
  struct Owner {
    size_t pass, frame, turn;
  };
  std::vector<Pass> pieces;
  std::vector<Owner> owners;
  std::vector<size_t> order(frames_.size());
  std::iota(order.begin(), order.end(), size_t{0});
  for (size_t pass = 0; pass < passes_.size(); ++pass) {
    const Cut& how = cuts_[pass];
    const size_t step = passes_[pass].cut ? rounds_a_frame : 1, begin = rounds_ % step;
    size_t end = 0;
    for (const std::vector<Pass>& of_frame : how.pieces) end = std::max(end, of_frame.size());
    for (uint32_t repeat = 0; repeat < how.repeats; ++repeat)
      for (size_t piece = begin; piece < end; piece += step) {
        for (size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);  // Fisher and Yates
        for (size_t turn = 0; turn < order.size(); ++turn) {
          const size_t frame = order[turn];
          if (piece >= how.pieces[frame].size() || !runs(pass, frame)) continue;
          pieces.push_back(how.pieces[frame][piece]);
          owners.push_back({pass, frame, turn});
        }
      }
  }
  const RunTimes times = backend_.run(pieces, Timing::bracketed);
  std::vector<std::vector<std::vector<Timed>>> strips(passes_.size(), std::vector<std::vector<Timed>>(frames_.size()));
  for (size_t i = 0; i < owners.size(); ++i) {
    if (!(times.pass_ms[i] > 0))
      throw Error(ErrorKind::failed, "gate", passes_[owners[i].pass].name,
                  fmt::format("a strip took {} ms: a time must be positive and finite", times.pass_ms[i]));
    strips[owners[i].pass][owners[i].frame].push_back({times.pass_ms[i], owners[i].turn});
  }
  for (size_t pass = 0; pass < passes_.size(); ++pass) add_round(passes_[pass], strips[pass], cuts_[pass].repeats);
  ++rounds_;
}

// Frames are paired strip by strip; where one has more pieces than the other (a pass that is run twice) by their sums.
void PairedFrames::add_round(PairedPass& pass, const std::vector<std::vector<Timed>>& strips, uint32_t repeats) {
  const auto sum = [](const std::vector<Timed>& timed) {
    return std::accumulate(timed.begin(), timed.end(), 0.0, [](double ms, const Timed& each) { return ms + each.ms; });
  };
  for (size_t frame = 0; frame < strips.size(); ++frame) {
    if (strips[frame].empty()) continue;
    pass.ms[frame].push_back(sum(strips[frame]) / repeats);
    if (frame == 0 || strips[0].empty()) continue;
    const std::vector<Timed>& before = strips[0];
    const std::vector<Timed>& after = strips[frame];
    if (after.size() == before.size())
      for (size_t i = 0; i < before.size(); ++i)
        pass.strips[frame].push_back({before[i].ms, after[i].ms, after[i].turn < before[i].turn});
    else
      pass.strips[frame].push_back({sum(before), sum(after), false});
  }
}

std::optional<double> whole_ms(const PairedPass& pass, size_t frame) {
  const std::vector<double>& ms = pass.ms[frame];
  if (ms.size() < rounds_a_frame) return std::nullopt;
  if (!pass.cut) return median(ms);
  double sum = 0;
  for (size_t kind = 0; kind < rounds_a_frame; ++kind) {
    std::vector<double> of_kind;
    for (size_t round = kind; round < ms.size(); round += rounds_a_frame) of_kind.push_back(ms[round]);
    sum += median(of_kind);
  }
  return sum;
}

}  // namespace lamina
