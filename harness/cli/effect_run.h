// SPDX-License-Identifier: Apache-2.0
// All variants of one effect on one backend, at one state of the scene after another: rendered, counted, scored against the
// baseline and the truth, timed. What fails becomes a failed row; the rest goes on. What a state does not touch stays as it
// was: pipelines, work done once, counted coverage.
#pragma once

#include <list>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "harness/cli/cell.h"
#include "harness/cli/progress.h"
#include "harness/cli/ready_frame.h"
#include "harness/cli/scene_on_device.h"
#include "harness/cli/truth_run.h"
#include "harness/cost/cost_model.h"
#include "harness/measure/rounds.h"
#include "harness/quality/judged_picture.h"

namespace lamina {

// A state of the scene, and which measurements its cells get.
struct MeasuredPoint {
  std::map<std::string, double> params;      // what a sweep has set, by path, in the scene and in variants; empty: no sweep
  std::map<std::string, std::string> words;  // of these, those that take words
  bool timed = true, counted = true, pictured = true;
  bool judged = true;          // whether a frame that is no picture fails its cell; a gate goes by its own limits
  std::string picture_suffix;  // tells the names of its pictures from those of other points
};

// Where the time goes, ms by the host's clock.
struct Spent {
  double device = 0, read_back = 0, metrics = 0;
  double sum() const { return device + read_back + metrics; }
};

// Of a cell that has its picture and counts when a signal ends the run.
inline constexpr const char* stopped_note = "stopped before it was timed";

class EffectRun {
 public:
  // Everything but the options must outlive this. `images` is the folder of the pictures within options.out; their paths in
  // rows begin with it.
  EffectRun(Backend& backend, const EffectManifest& effect, ShaderCache& shaders, const CellOptions& options,
            const std::string& images, const Tell& tell);

  // Keeps the baseline's pictures, for start_again().
  void keep_baseline() { keeps_pictures_ = true; }

  // What is known of a variant: all that prepare() and count() put into its rows, and what each view shows.
  struct Drawn {
    Image picture;
    Mask covered;
  };
  struct Known {
    std::vector<CellRow> rows;  // [view]
    std::vector<Drawn> drawn;   // [view]
  };
  // The variant executes the same as in another run, which has made this: it is scored, and neither prepared nor counted nor
  // drawn. After start().
  void take(const std::string& variant, Known known);

  // Begins a state of the scene with blank rows. `failure`: why there is no such state; all its cells have failed.
  void start(const SceneOnDevice& scene, const MeasuredPoint& point = {}, const std::string& failure = "");
  // Makes these variants anew, whose shaders have changed: all that follows is about them alone, and what the others have
  // stays, the baseline's pictures too, against which errors are taken. After start() and score().
  void start_again(const std::set<std::string>& variants);
  // Lets go of all that binds the scene's resources, which are about to be made anew.
  void release();

  void prepare();  // pipelines and targets, the first view; what is done once
  void count();    // by the counting build: covered pixels where they may have changed, and the counts that are asked for
  // Interleaved rounds, where the point is timed; after count(). `model`, which may be null, tells how far the first round is.
  RoundsResult time(const RoundOptions& rounds, const CostModel* model = nullptr);
  // The timer has turned out not to be trusted: no row keeps what time() measured.
  void forget_times();

  // A picture as it is scored, the baseline's before the others of its view.
  struct Scored {
    const VariantManifest& variant;
    size_t view;
    const Image& picture;
    const Mask& covered;
  };
  struct Scoring {
    std::function<bool(const std::string& variant, const std::string& view)> wanted;  // empty: all cells
    // Told of each; gives a row whose errors to the baseline are known to be this one's, or null.
    std::function<const CellRow*(const Scored&)> known;
    std::function<bool(const CellRow& row)> done;  // a cell whose pictures are kept; returns whether to go on
  };
  // Pictures, and their errors, view by view; after count(). Returns false where `done` did. A picture that cannot be written
  // fails its variant; with `done`, it throws Error instead, so that a sweep stops and makes the cell again when it goes on.
  bool score(const Scoring& scoring = {});

  // One row a variant and view, the baseline's first.
  std::vector<CellRow> rows() const;
  // The variant's frame; null where it failed or is not compared.
  ReadyFrame* frame(std::string_view variant);
  const Spent& spent() const { return spent_; }

 private:
  // A variant's passes as the features and parameters of some point want them; kept, for points may share them.
  struct Prepared {
    std::string key;
    std::unique_ptr<ReadyFrame> ready;
    std::unique_ptr<Frame> counting;
    std::string once, counted_once, coverage;  // what these were made from: harness/graph/inputs.h
    std::vector<PassCounts> once_counts;
    std::vector<Mask> covered;  // [view]
    bool early_tests = true;
  };
  struct Variant {
    const VariantManifest* manifest = nullptr;
    std::list<Prepared> prepared;              // the last used first
    bool first_is_drawn = false;               // the frame holds the first view, of this state
    std::vector<std::vector<double>> once_ms;  // [pass][repetition]
    std::vector<CellRow> rows;                 // [view]
    std::vector<Drawn> known;                  // [view], of take(); empty: it is drawn
    std::string failure;
  };

  void blank_rows(Variant& variant);
  bool is_at_work(const Variant& variant) const { return again_.empty() || again_.contains(variant.manifest->name); }
  void attempt(Variant& variant, const std::function<void()>& work);
  void each(const std::string& doing, void (EffectRun::*step)(Variant&));
  void prepare(Variant& variant);
  void count(Variant& variant);
  Drawn draw(Variant& variant, size_t view);
  bool note_nothing_covered();
  std::string why_no_picture_of(const CellRow& row, const JudgedFrame& frame, const Drawn* baseline) const;
  void score(Variant& variant, size_t view, const Drawn* baseline, const Scoring& scoring);

  Backend& backend_;
  const EffectManifest& effect_;
  ShaderCache& shaders_;
  const CellOptions options_;
  const std::string images_;
  const Tell tell_;
  SceneOnDevice scene_;
  MeasuredPoint point_;
  std::string plan_key_;
  std::unique_ptr<TruthRun> truth_;
  std::vector<Variant> variants_;  // the baseline first
  std::set<std::string> again_;    // of start_again(); empty: all
  bool keeps_pictures_ = false;
  std::map<size_t, Drawn> drawn_;  // of the baseline, by view, where they are kept
  Spent spent_;
};

}  // namespace lamina
