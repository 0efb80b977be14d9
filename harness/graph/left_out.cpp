// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/left_out.h"

#include <algorithm>

namespace lamina {
namespace {

void drop(Graph& graph, GraphPass pass, const std::string& reason) {
  pass.draws.clear();
  pass.reason = reason;
  graph.dropped.push_back(std::move(pass));
}

// Storage buffers that the draw's shaders touch are read and written alike.
std::vector<Resource> touched_buffers(const GraphPass& pass, const GraphDraw& draw) {
  std::vector<Resource> touched;
  for (const ResolvedBuffer& buffer : draw.buffers)
    for (const BufferManifest& known : pass.variant->buffers)
      if (buffer.source.kind == Source::Kind::buffer && known.name == buffer.source.name)
        touched.push_back({pass.variant, known.name, known.scope == Scope::object ? draw.object : std::nullopt, std::nullopt});
  return touched;
}

std::vector<Resource> read_targets(const GraphPass& pass, const GraphDraw& draw) {
  std::vector<Resource> read;
  for (const ResolvedRead& from : draw.reads)
    if (from.source.kind == Source::Kind::target)
      read.push_back(target_of(*pass.variant, from.source.name, draw, from.source.light));
  return read;
}

bool same_target(const TargetManifest& a, const TargetManifest& b) {
  const auto size = [](const TargetManifest& t) {
    return std::tuple(t.size.kind, t.size.width.value, t.size.height.value, t.size.scale.value);
  };
  return a.scope == b.scope && a.format == b.format && a.mips == b.mips && size(a) == size(b);
}

}  // namespace

void leave_out_repeated(Graph& graph) {
  std::map<std::string, const GraphPass*> writer;  // of shared targets, by name
  std::vector<GraphPass> kept;
  kept.reserve(graph.passes.size());
  for (GraphPass& pass : graph.passes) {
    const std::vector<std::string> names = pass.pass->written();
    const auto written_by_another = [&](const std::string& name) {
      const TargetManifest* target = pass.variant->target(name);
      if (!target || !target->shared) return false;
      const auto other = writer.find(name);
      if (other == writer.end() || other->second->variant == pass.variant) return false;
      if (!same_target(*target, *other->second->variant->target(name)))
        throw Error(ErrorKind::bad_input, "variants", pass.pass->where,
                    fmt::format("shares '{}' with {}, which declares another scope, size or format: declare both alike", name,
                                other->second->pass->where));
      return true;
    };
    if (!names.empty() && std::all_of(names.begin(), names.end(), written_by_another)) {
      const std::string by = writer.at(names.front())->effect->name;
      drop(graph, std::move(pass), "left out: " + by + " has drawn the same");
      continue;
    }
    kept.push_back(std::move(pass));
    for (const std::string& name : names)
      if (const TargetManifest* target = kept.back().variant->target(name); target && target->shared)
        writer.try_emplace(name, &kept.back());
  }
  graph.passes = std::move(kept);
}

// Backwards from the frame: a draw is needed when it draws into the frame or into something that a needed draw reads.
void leave_out_unread(Graph& graph) {
  std::set<Resource> needed;
  std::vector<GraphPass> kept, dropped;
  for (auto pass = graph.passes.rbegin(); pass != graph.passes.rend(); ++pass) {
    std::vector<GraphDraw> draws;
    std::set<Resource> needed_before = needed;
    for (const GraphDraw& draw : pass->draws) {
      const std::vector<Resource> buffers = touched_buffers(*pass, draw);
      bool wanted = pass->pass->when == Frequency::truth ||
                    std::any_of(buffers.begin(), buffers.end(), [&](const Resource& r) { return needed.contains(r); });
      for (const std::string& name : pass->pass->written())
        wanted = wanted || name == "frame" || needed.contains(target_of(*pass->variant, name, draw));
      if (!wanted) continue;
      draws.push_back(draw);
      needed_before.insert(buffers.begin(), buffers.end());
      for (const Resource& read : read_targets(*pass, draw)) needed_before.insert(read);
    }
    needed = std::move(needed_before);
    if (draws.empty()) {
      pass->draws.clear();
      pass->reason = "left out: nothing reads what it writes";
      dropped.insert(dropped.begin(), std::move(*pass));
    } else {
      pass->draws = std::move(draws);
      kept.insert(kept.begin(), std::move(*pass));
    }
  }
  graph.passes = std::move(kept);
  graph.dropped.insert(graph.dropped.begin(), dropped.begin(), dropped.end());
}

void check_written_before_read(const Graph& graph) {
  std::set<Resource> written;
  for (const bool once : {true, false})  // what is done once comes before any frame
    for (const GraphPass& pass : graph.passes) {
      if (pass.once != once) continue;
      for (const GraphDraw& draw : pass.draws)
        for (const ResolvedRead& read : draw.reads) {
          if (read.source.kind != Source::Kind::target) continue;
          const std::vector<std::string> own = pass.pass->written();
          const bool reads_back =
              pass.pass->levels == LevelWalk::none && std::find(own.begin(), own.end(), read.source.name) != own.end();
          if (!reads_back && !written.contains(target_of(*pass.variant, read.source.name, draw, read.source.light)))
            throw Error(ErrorKind::bad_input, "variants", pass.pass->where,
                        fmt::format("pass '{}' reads '{}' before any pass has written it", pass.pass->name, read.source.name));
        }
      for (const GraphDraw& draw : pass.draws)
        for (const std::string& name : pass.pass->written()) written.insert(target_of(*pass.variant, name, draw));
    }
}

}  // namespace lamina
