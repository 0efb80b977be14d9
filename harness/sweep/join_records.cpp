// SPDX-License-Identifier: Apache-2.0
// Records of shards to one. See sweep_record.h.
#include <algorithm>
#include <map>

#include "harness/core/error.h"
#include "harness/record/record.h"
#include "harness/sweep/sweep_record.h"

namespace lamina {
namespace {

using Json = nlohmann::json;
using Ordered = nlohmann::ordered_json;

[[noreturn]] void refuse_to_join(const std::string& where, const std::string& why) {
  throw Error(ErrorKind::bad_input, "merge", where, why);
}

// A cell without its times, which differ from run to run. The device's name differs between machines.
void take_times_off(Json& cell) {
  for (const char* name : {"median_ms", "once_ms", "cold_ms"}) cell[name] = nullptr;
  for (Json& pass : cell["passes"]) pass["ms"] = Json::array(), pass["median_ms"] = nullptr;
}

Json without_times(Json cell) {
  take_times_off(cell);
  cell["ratio_to_baseline"] = nullptr;
  return cell;
}

// A record, and its lines as they are: those go into the join whole, with what this program may not know.
struct Part {
  std::filesystem::path file;
  Record record;
  std::vector<Json> lines;

  std::vector<const Json*> of_kind(std::string_view kind) const {
    std::vector<const Json*> found;
    for (const Json& line : lines)
      if (line.at("kind") == kind) found.push_back(&line);
    return found;
  }
  const SweepRow& sweep() const { return record.sweeps.front(); }
};

struct Found {
  const Json* cell = nullptr;
  const Part* part = nullptr;
};

// The order of one run: by backend and effect as they come, point, view, variant.
struct Place {
  size_t backend, effect, point, view, variant;  // variants are known by effect and name
  auto operator<=>(const Place&) const = default;
};

class Order {
 public:
  size_t of(const std::string& kind, const std::string& name) {
    std::vector<std::string>& known = names_[kind];
    const auto found = std::find(known.begin(), known.end(), name);
    if (found != known.end()) return static_cast<size_t>(found - known.begin());
    known.push_back(name);
    return known.size() - 1;
  }
  const std::vector<std::string>& names(const std::string& kind) { return names_[kind]; }

 private:
  std::map<std::string, std::vector<std::string>> names_;
};

std::vector<std::string> texts(const Json& settings, const char* name) {
  return settings.value(name, std::vector<std::string>{});
}

// "effect/variant on vulkan: 2 of 33 points are missing: objects.heart.thickness 1; ...".
std::string words_of_missing(const std::string& backend, const std::string& variant, const std::vector<size_t>& points,
                             const SweepPoints& all) {
  constexpr size_t max_named = 8;
  std::string text = fmt::format("{} on {}: {} of {} points are missing:", variant, backend, points.size(), all.count());
  for (size_t i = 0; i < std::min(points.size(), max_named); ++i) {
    text += i == 0 ? " " : "; ";
    const std::vector<double> values = all.at(points[i]);
    for (size_t k = 0; k < values.size(); ++k)
      text += fmt::format("{}{} {:.6g}", k == 0 ? "" : ", ", all.parameters[k].path, values[k]);
  }
  return points.size() > max_named ? text + "; ..." : text;
}

}  // namespace

Joined join_records(const std::vector<std::filesystem::path>& files) {
  std::vector<Part> parts;
  for (const std::filesystem::path& file : files) {
    Part& part = parts.emplace_back();
    part.file = file, part.record = read_record(file, &part.lines);
    if (part.record.sweeps.size() != 1) refuse_to_join(file.string(), "is no record of a sweep");
  }
  std::ranges::stable_sort(parts, {}, [](const Part& part) { return part.sweep().shard_index; });
  const auto identity = [](const Part& part) {
    Json fields = Json::object();
    for (const char* name : {"lamina", "commit", "build", "scene", "source", "settings", "inputs"})
      fields[name] = part.record.run.value(name, Json());
    fields["sweep"] = *part.of_kind("sweep").front();
    fields["sweep"].erase("shard");
    return fields;
  };
  const Json settings = parts.front().record.run.at("settings");
  const SweepPoints points = points_of(parts.front().sweep());
  const PointIndex index(points);
  Joined joined;
  Order order;
  for (const char* kind : {"backends", "effects", "views"})
    for (const std::string& name : texts(settings, kind)) order.of(kind, name);
  for (const std::string& name : texts(settings, "variants")) order.of("variants", name);
  std::map<Place, Found> cells;
  for (const Part& part : parts) {
    const Json changes = Json::diff(identity(parts.front()), identity(part));
    if (!changes.empty())
      refuse_to_join(part.file.string(), fmt::format("is of another sweep than {}: '{}' differs", parts.front().file.string(),
                                                     changes.front().at("path").get<std::string>().substr(1)));
    joined.several_machines = joined.several_machines ||
                              part.record.run.at("machine") != parts.front().record.run.at("machine") ||
                              part.record.run.at("devices") != parts.front().record.run.at("devices");
    const std::vector<const Json*> lines = part.of_kind("cell");
    for (size_t i = 0; i < lines.size(); ++i) {
      const auto [backend, effect, variant, view, point] = index.key_of(part.record.cells[i], part.file.string());
      const Place place{order.of("backends", backend), order.of("effects", effect), point, order.of("views", view),
                        order.of("variants", effect + "/" + variant)};
      const auto [known, is_new] = cells.try_emplace(place, Found{lines[i], &part});
      if (is_new) continue;
      ++joined.duplicates;
      const Json first = without_times(*known->second.cell), second = without_times(*lines[i]);
      if (const Json unlike = Json::diff(first, second); !unlike.empty())
        refuse_to_join(part.file.string(),
                       fmt::format("disagrees with {} about {} on {}, view {}, {}: '{}' differs; run one of them again",
                                   known->second.part->file.string(), variant, backend, view, lines[i]->at("params").dump(),
                                   unlike.front().at("path").get<std::string>().substr(1)));
    }
  }

  Json run = parts.front().record.run;
  run["machines"] = Json::array();
  for (const Part& part : parts)
    run["machines"].push_back({{"shard", part.of_kind("sweep").front()->at("shard")},
                               {"machine", part.record.run.at("machine")},
                               {"devices", part.record.run.at("devices")}});
  if (joined.several_machines)
    run["warnings"].push_back(
        "joined from several machines: times are left out, ratios to the baseline are each machine's own");
  Json sweep = *parts.front().of_kind("sweep").front();
  sweep["shard"] = {{"index", 0}, {"count", 1}};
  joined.lines = {run, sweep};
  for (const Json* plan : parts.front().of_kind("plan")) joined.lines.push_back(*plan);
  for (const Part& part : parts)
    for (const Json* timer : part.of_kind("timer")) joined.lines.push_back(*timer);
  for (const auto& [place, found] : cells) {
    Json cell = *found.cell;
    if (joined.several_machines) take_times_off(cell);
    joined.lines.push_back(std::move(cell));
  }
  joined.cells = cells.size();

  for (size_t backend = 0; backend < order.names("backends").size(); ++backend)
    for (size_t variant = 0; variant < order.names("variants").size(); ++variant) {
      const std::string& name = order.names("variants")[variant];
      const size_t effect = order.of("effects", name.substr(0, name.find('/')));
      std::vector<size_t> missing;
      for (size_t point = 0; point < points.count(); ++point)
        for (size_t view = 0; view < order.names("views").size(); ++view)
          if (!cells.contains({backend, effect, point, view, variant}) && (missing.empty() || missing.back() != point))
            missing.push_back(point);
      if (!missing.empty()) joined.missing.push_back(words_of_missing(order.names("backends")[backend], name, missing, points));
    }
  return joined;
}

}  // namespace lamina
