// SPDX-License-Identifier: Apache-2.0
// A graph made ready on a backend: targets, pipelines and the list of passes of every view. Either the timed build, or the
// counting build of the same shaders; never both in one frame.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/graph/counted_texture.h"
#include "harness/graph/counts.h"
#include "harness/graph/graph.h"
#include "harness/graph/scene_resources.h"

namespace lamina {

struct FrameTimes {
  std::vector<double> pass_ms;  // one a logical pass; empty where timing was off
  double wall_ms = 0;
};

enum class Build : uint8_t { timed, counting };

// Whether targets that are needed at different times share memory. Either way draws the same.
enum class TargetSharing : uint8_t { on, off };

class Frame {
 public:
  // Everything given must outlive the frame. Throws Error(failed) where the device refuses. Where it has the same targets as
  // `like`, a frame on the same backend, it draws into that frame's: what one leaves there the other reads.
  Frame(SceneResources& resources, const Graph& graph, Build build, TargetSharing sharing = TargetSharing::on,
        const Frame* like = nullptr);
  ~Frame();
  Frame(const Frame&) = delete;
  Frame& operator=(const Frame&) = delete;

  // The logical passes in order, as the graph names them; those done once, and those of every frame.
  const std::vector<std::string>& once_names() const { return once_.names; }
  const std::vector<std::string>& frame_names() const { return frame_.names; }

  // The colour that the frame is cleared to where a manifest names none; at first the scene's when the frame was made.
  void set_background(glm::vec3 linear);
  // The passes done once; before the first run().
  FrameTimes run_once(Timing timing);
  // One frame of scene.views[view]. Without timing, what depends on meshes and lights alone runs once for each state of the
  // scene: its targets, and in the counting build its counts, stay for the other views.
  FrameTimes run(size_t view, Timing timing);

  // What its targets and storage buffers would take each alone, as their formats say: a driver may pad them.
  uint64_t target_bytes() const { return made_.bytes; }
  // What they take of the device's memory, as it was asked for, and what they would if each target had memory of its own.
  uint64_t memory_bytes() const { return made_.memory_bytes; }
  uint64_t memory_bytes_alone() const { return made_.memory_bytes_alone; }

  // A frame in small pieces, for comparing two frames piece by piece: raster passes are cut into at most `parts[pass]` strips
  // of whole rows, as equal as they get; what cannot be cut (compute, mip chains, shaders with storage) is one piece. Running
  // all of them in order makes the picture of run(). `parts` is beside frame_names().
  struct Slice {
    size_t pass = 0;  // index into frame_names()
    Pass piece;
  };
  std::vector<Slice> slices(size_t view, std::span<const uint32_t> parts);

  // Passes with until_empty whose last repetition still drew something when view `view` was run: there may be more to draw.
  std::vector<const GraphPass*> unfinished(size_t view) const;

  // The picture of the last run(): linear light; alpha as the passes left it.
  Image picture();

  // A variant's target as large as the frame after the last run(), as floats: rgba16_float or rgba32_float. Throws
  // Error(failed) for any other, and for one that shares its memory.
  Image target(const VariantManifest& variant, const std::string& name);
  // All of them, by name.
  std::map<std::string, Image> targets_of(const VariantManifest& variant);

  // Counting build only: what the last run_once() and run() executed, in the order of the names; and the pixels of the frame in
  // which the passes of `effect` shaded at least one fragment.
  std::vector<PassCounts> once_counts() { return counts(once_); }
  std::vector<PassCounts> frame_counts() { return counts(frame_); }
  Mask coverage(std::string_view effect);

 private:
  // A counting build's bookkeeping for one counted stage of draws that share their counters.
  struct Counted {
    Stage stage;
    uint32_t first_word;
    std::map<uint32_t, CountedTexture> textures;  // by binding
    BlockWork work;
    bool early_tests;
  };
  struct Step {
    const GraphPass* pass;
    BufferId counters;  // counting build
    uint32_t coverage_word = 0;
    bool turns = false;             // each repetition reads what the one before wrote
    std::vector<uint32_t> cleared;  // what the counters hold before a run
    std::vector<Counted> counted;
    std::optional<uint64_t> issued_fragments;  // of the last run, where the device tells
  };
  // A list of logical passes; each is one or more backend passes (per object, per repetition).
  struct Sequence {
    std::vector<std::string> names;
    std::vector<Step> steps;                        // beside names
    std::vector<size_t> step_of_pass;               // beside every list of passes
    std::vector<uint32_t> repetition_of_pass;       // likewise
    std::vector<std::vector<Pass>> passes_by_view;  // [view]; passes done once: one list
    // [view]: which of them run, where a pass stops repeating when it has drawn nothing; and for which state of the scene.
    struct Running {
      uint64_t of_update = 0;
      std::vector<size_t> passes;      // by index
      std::vector<size_t> unfinished;  // steps that drew to the last repetition
    };
    std::vector<Running> running;
    std::vector<size_t> ran;  // the passes of a frame as last run, those too that an earlier view's run stands for; by index
    size_t ran_view = 0;
    bool stops_early = false;
    std::optional<uint64_t> complete_at;  // the state of the scene that all of its passes have run for
  };
  // What was made, for whoever gives it back.
  struct Made {
    std::vector<TransientDesc> asked;  // all targets
    PlacedTextures placed;             // beside them
    std::vector<TextureId> textures;   // each once; none where another frame has made them
    std::vector<BufferId> buffers;
    std::map<TextureId, TextureDesc> targets;
    std::map<std::pair<const VariantManifest*, std::string>, TextureId> frame_sized;  // of those that share no memory
    uint64_t bytes = 0, memory_bytes = 0, memory_bytes_alone = 0;
  };
  friend class FrameBuilder;

  void release();
  const std::vector<size_t>& running(Sequence& sequence, size_t view);
  FrameTimes run_sequence(Sequence& sequence, size_t view, Timing timing);
  static void take_issued(Sequence& sequence, const std::vector<size_t>& which, const RunTimes& times);
  std::vector<PassCounts> counts(Sequence& sequence);
  void add_counted(PassCounts& pass, const Step& step);

  SceneResources& resources_;
  Backend& backend_;
  Build build_;
  Sequence once_, frame_;
  TextureId picture_;
  std::array<TextureId, 2> frame_buffers_;
  Made made_;
  std::vector<PipelineId> pipelines_;
};

// Half-precision floats to single.
Image image_from_rgba16(uint32_t width, uint32_t height, std::span<const std::byte> halves);

}  // namespace lamina
