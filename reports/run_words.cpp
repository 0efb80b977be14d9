// SPDX-License-Identifier: Apache-2.0
// What was run, on what, by a timer how good, and what failed: the parts of a record that are not figures.
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "harness/core/byte_words.h"
#include "reports/words.h"

namespace lamina {
namespace {

using Json = nlohmann::json;

// `what`: "on vulkan", and what the timer timed where that is not frames; `times`: which then are not shown.
std::string words_of(const TimerRow& timer, const std::string& what, const char* times = "times") {
  std::string measured;
  if (!timer.linearity.empty()) {
    std::vector<std::string> works;
    for (size_t i = 0; i < timer.linearity.size(); ++i) works.push_back(fmt::format("{}x", 1ull << i));
    measured = fmt::format("; {} work took {:.3f} of linear", fmt::join(works, ", "), fmt::join(timer.linearity, ", "));
  }
  if (timer.fixed_share) measured += fmt::format("; {:.1f}% of the 1x pass is a fixed cost", 100 * *timer.fixed_share);
  if (timer.additivity) measured += fmt::format("; the passes add up to {:.3f} of the wall time", *timer.additivity);
  if (timer.attribution)
    measured += fmt::format("; a pass's share is off by at most {:.1f}% in another order", 100 * *timer.attribution);
  if (timer.age_s) measured += fmt::format("; measured {:.1f} hours before", *timer.age_s / 3600);
  if (timer.ok) return fmt::format("the timer's certificate {} holds{}", what, measured);
  return fmt::format("the timer's certificate {} FAILED ({}), so no {} are shown{}", what, timer.reason, times, measured);
}

}  // namespace

std::string title_of(const Record& record) {
  std::set<std::string> scenes, sizes, views;
  for (const CellRow& cell : record.cells) {
    scenes.insert(cell.scene);
    sizes.insert(fmt::format("{}x{}", cell.width, cell.height));
    views.insert(cell.view);
  }
  if (record.cells.empty() && !record.functions.empty()) return "What functions cost and err by";
  if (record.cells.empty() && !record.savings.empty())
    return fmt::format("{}, against every effect", record.savings.front().scene);
  if (record.cells.empty())
    return fmt::format("{}: {}", text_at(record.run, "/scene"), record.gates.empty() ? "no cells" : "gate");
  return fmt::format("{}, {}, {} view{}", fmt::join(scenes, " and "), fmt::join(sizes, " and "), views.size(),
                     views.size() == 1 ? "" : "s");
}

namespace {

// What cells have to say beside their figures, each once, with the variants that say it unless all of the effect do.
std::vector<std::string> cell_notes(const Record& record) {
  struct Note {
    std::string effect, words;
    std::set<std::string> variants;
  };
  std::vector<Note> notes;
  std::map<std::string, std::set<std::string>> all;  // variants by effect
  for (const CellRow& cell : record.cells) {
    all[cell.effect].insert(cell.variant);
    for (const std::string& words : cell.notes) {
      auto known =
          std::ranges::find_if(notes, [&](const Note& note) { return note.effect == cell.effect && note.words == words; });
      if (known == notes.end()) known = notes.insert(known, Note{cell.effect, words, {}});
      known->variants.insert(cell.variant);
    }
  }
  std::vector<std::string> sentences;
  for (const Note& note : notes)
    sentences.push_back(note.variants == all[note.effect] ? note.words
                                                          : fmt::format("{}: {}", fmt::join(note.variants, ", "), note.words));
  return sentences;
}

}  // namespace

std::vector<std::string> warnings_of(const Record& record) {
  std::vector<std::string> warnings;
  if (const std::string build = text_at(record.run, "/build"); build != "release")
    warnings.push_back(
        fmt::format("the build is '{}', not 'release': its times do not count", build.empty() ? "unknown" : build));
  if (const std::string truncated = text_at(record.run, "/truncated"); !truncated.empty())
    warnings.push_back(fmt::format("the record is incomplete: {}", truncated));
  for (const Certificate& certificate : certificates(record))
    if (!certificate.ok) warnings.push_back(certificate.words);
  std::set<std::string> builds;  // functions may have been added by another program than the one that made the record
  for (const FunctionTimeRow& row : record.function_times) builds.insert(row.build);
  for (const std::string& build : builds)
    if (build != "release" && build != text_at(record.run, "/build"))
      warnings.push_back(fmt::format("the functions' build is '{}', not 'release': their times do not count", build));
  if (const auto own = record.run.find("warnings"); own != record.run.end() && own->is_array())
    for (const Json& warning : *own) warnings.push_back(warning.is_string() ? warning.get<std::string>() : warning.dump());
  for (const std::string& note : cell_notes(record)) warnings.push_back(note);
  return warnings;
}

std::vector<Certificate> certificates(const Record& record) {
  std::vector<Certificate> all;
  std::set<std::string> certified;
  for (const TimerRow& timer : record.timers) {
    certified.insert(timer.backend);
    all.push_back({.backend = timer.backend, .ok = timer.ok, .words = words_of(timer, "on " + timer.backend)});
  }
  for (const CellRow& cell : record.cells) {
    const bool timed = std::ranges::any_of(cell.passes, [](const PassRow& pass) { return !pass.ms.empty(); });
    if (!timed || !certified.insert(cell.backend).second) continue;
    all.push_back({.backend = cell.backend,
                   .words = fmt::format("the record holds no timer certificate of {}, so no times are shown", cell.backend)});
  }
  for (const auto& [timer, function] : record.function_timers)
    all.push_back(
        {.backend = timer.backend,
         .ok = timer.ok,
         .words = words_of(timer, fmt::format("on {} for calls of {}", timer.backend, function), "times of calls there")});
  return all;
}

std::vector<std::string> plan_lines(const Record& record) {
  std::vector<std::string> lines;
  for (const PlanRow& plan : record.plans)
    for (const PlanRow::Effect& effect : plan.effects) {
      const std::string& name = effect.effect;
      lines.push_back(fmt::format("{}: {}: {}", name, effect.called_for ? "called for" : "not called for", effect.reason));
      for (const PlanRow::Feature& feature : effect.features)
        lines.push_back(fmt::format("{}: {} {}: {}", name, feature.on ? "with" : "without", feature.feature, feature.reason));
      for (const PlanRow::Variant& variant : effect.variants)
        for (const PlanRow::Pass& pass : variant.passes)
          if (!pass.runs)
            lines.push_back(fmt::format("{}: {} without its pass {}: {}", name, variant.variant, pass.pass, pass.reason));
    }
  return lines;
}

std::vector<std::string> bake_lines(const Record& record) {
  std::vector<std::string> lines;
  for (const BakeRow& bake : record.bakes) {
    std::string words = fmt::format("{:.3g} s", bake.seconds);
    if (bake.from_cache)
      words = "from the cache in " + words;
    else if (bake.rays_per_second)
      words += fmt::format(", {:.3g} million rays a second", *bake.rays_per_second / 1e6);
    lines.push_back(fmt::format("{} of {} ({}): {} points, {} rays, {}", bake.what, bake.object, bake.effect, bake.points,
                                bake.rays, words));
  }
  return lines;
}

std::vector<std::string> memory_lines(const Record& record) {
  std::vector<std::string> lines;
  for (const PlanRow& plan : record.plans) {
    if (!plan.frame || !plan.frame->aliased_bytes || !plan.frame->reused_bytes) continue;
    uint64_t alone = 0;
    for (const PlanRow::Target& target : plan.frame->targets) alone += target.bytes;
    lines.push_back(
        fmt::format("the frame's targets take {} each alone; where those needed at different times share memory, {} "
                    "on Vulkan and {} on OpenGL (as their formats say)",
                    byte_words(alone), byte_words(*plan.frame->aliased_bytes), byte_words(*plan.frame->reused_bytes)));
  }
  std::set<std::string> told;
  for (const CellRow& cell : record.cells) {
    if (!cell.baseline || !cell.memory_bytes || !cell.memory_bytes_alone || !told.insert(cell.backend).second) continue;
    lines.push_back(fmt::format("{}: the targets of the frame of {} take {} of the device's memory, {} if each were alone",
                                cell.backend, cell.variant, byte_words(*cell.memory_bytes),
                                byte_words(*cell.memory_bytes_alone)));
  }
  return lines;
}

std::vector<std::string> phase_lines(const Record& record) {
  std::vector<std::string> lines;
  for (const PhaseRow& phase : record.phases) {
    if (!times_shown(record, phase.backend) || phase.device_ms <= 0) continue;
    lines.push_back(fmt::format("{} rounds of {} on {} took {:.1f} s, {:.2f} times the device time that they measured",
                                phase.rounds, phase.effect, phase.backend, phase.wall_ms / 1000,
                                phase.wall_ms / phase.device_ms));
  }
  return lines;
}

std::vector<std::pair<std::string, std::string>> failures(const Record& record) {
  std::vector<std::pair<std::string, std::string>> all;
  for (const CellRow& cell : record.cells)
    if (cell.failed) all.emplace_back(fmt::format("{} on {}, view {}", cell.variant, cell.backend, cell.view), cell.reason);
  return all;
}

std::vector<std::string> hash_lines(const Record& record) {
  std::vector<std::string> lines;
  std::set<std::string> variants;
  for (const CellRow& cell : record.cells) {
    const std::string of = fmt::format("{} on {}", cell.variant, cell.backend);
    if (!cell.shader_hashes.empty() && variants.insert(of).second)
      lines.push_back(fmt::format("shaders of {}: {}", of, fmt::join(cell.shader_hashes, " ")));
  }
  for (const CellRow& cell : record.cells)
    if (!cell.image_hash.empty() && !cell.image.empty()) lines.push_back(fmt::format("{}: {}", cell.image, cell.image_hash));
  return lines;
}

std::string record_name(const std::vector<Record>& records, size_t index) {
  if (records.size() < 2) return "";
  const std::string letter = index < 26 ? std::string(1, static_cast<char>('A' + index)) : fmt::format("{}", index + 1);
  const std::string commit = text_at(records[index].run, "/commit");
  return commit.empty() ? letter : fmt::format("{}: {}", letter, commit);
}

std::vector<std::pair<std::string, std::string>> run_facts(const Record& record) {
  const Json& run = record.run;
  std::vector<std::pair<std::string, std::string>> facts;
  const auto add = [&](std::string label, std::string value) {
    if (!value.empty()) facts.emplace_back(std::move(label), std::move(value));
  };
  add("Command", text_at(run, "/command"));
  add("Scene", text_at(run, "/scene"));
  add("Swept", fmt::format("{}", fmt::join(sweep_lines(record), "; ")));
  add("Settings", run.contains("settings") ? entries_of(run["settings"]) : "");
  if (const auto devices = run.find("devices"); devices != run.end() && devices->is_array())
    for (const Json& device : *devices) {
      std::string words = text_at(device, "/device");
      for (const char* part : {"/driver", "/api_version"})
        if (const std::string more = text_at(device, part); !more.empty()) words += ", " + more;
      add(fmt::format("Device of {}", text_at(device, "/backend")), words);
    }
  add("Machine", run.contains("machine") ? entries_of(run["machine"]) : "");
  std::set<std::string> commits;
  for (const FunctionTimeRow& row : record.function_times) commits.insert(row.commit);
  commits.erase(text_at(run, "/commit"));
  add("Commit of the functions' run", fmt::format("{}", fmt::join(commits, ", ")));
  add("Lamina", text_at(run, "/lamina"));
  add("Commit", text_at(run, "/commit"));
  add("Build", text_at(run, "/build"));
  return facts;
}

}  // namespace lamina
