// SPDX-License-Identifier: Apache-2.0
// Records as the data that the page's charts are drawn from.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <map>

#include "harness/sweep/answers.h"
#include "reports/frontier.h"
#include "reports/gate/strips.h"
#include "reports/html/html.h"

namespace lamina {
namespace {

using Json = nlohmann::json;

// No chart shows more than six digits, and a page of thousands of cells is half as long with them.
Json six_digits(double value) {
  if (!std::isfinite(value)) return nullptr;
  return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr);
}

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(six_digits(*value)) : Json(nullptr);
}

Json interval(const std::optional<Interval>& value) {
  if (!value) return nullptr;
  return {six_digits(value->median), six_digits(value->low), six_digits(value->high), value->rounds,
          six_digits(value->coverage)};
}

// In the order of error_metrics; PSNR of equal pictures is null.
Json figures(const std::optional<ErrorFigures>& error) {
  if (!error) return nullptr;
  Json numbers = Json::array();
  for (const ErrorMetric& metric : error_metrics) numbers.push_back(six_digits(*error.*metric.figure));
  return numbers;
}

Json costs_and_errors(const CostAndErrors& all, const FrontierBits& bits) {
  Json one = {{"ms", interval(all.frame_ms)},
              {"fetches", or_null(all.fetches_per_pixel)},
              {"baseline", figures(all.to_baseline)},
              {"frontier", bits.on_frontier}};
  if (bits.not_told_apart != 0) one["not_told"] = bits.not_told_apart;
  if (all.beyond_limit) one["beyond_limit"] = true;
  if (all.to_truth) one["truth"] = figures(all.to_truth);
  return one;
}

void add_summary_rows(Json& rows, const std::vector<SummaryRow>& summary, size_t record) {
  std::map<std::pair<std::string, std::string>, std::vector<const SummaryRow*>> groups;
  for (const SummaryRow& row : summary) groups[{row.effect, row.backend}].push_back(&row);
  std::map<const SummaryRow*, FrontierBits> bits;
  for (const auto& [unused, group] : groups) {
    std::vector<CostAndErrors> all;
    for (const SummaryRow* row : group) all.push_back(figures_of(*row));
    const std::vector<FrontierBits> of_group = frontier_bits(all);
    for (size_t i = 0; i < group.size(); ++i) bits[group[i]] = of_group[i];
  }
  for (const SummaryRow& row : summary) {
    Json one = costs_and_errors(figures_of(row), bits[&row]);
    one.update({{"record", record},
                {"effect", row.effect},
                {"variant", row.variant},
                {"backend", row.backend},
                {"is_baseline", row.baseline},
                {"ratio", interval(row.ratio)}});
    if (row.failed_views > 0) one["failed"] = row.reason;
    rows.push_back(std::move(one));
  }
}

CostAndErrors figures_of_cell(const Record& record, const CellRow& cell, const std::vector<double>& samples_ms) {
  CostAndErrors all;
  if (cell.failed) return all;
  if (!samples_ms.empty()) all.frame_ms = interval_or_range(samples_ms);
  all.rounds_ms = samples_ms;
  all.baseline = cell.baseline;
  if (cell.error_covered) all.beyond_limit = !beyond_limit(record, *cell.error_covered).empty();
  all.fetches_per_pixel = cell.fetches_per_pixel;
  all.to_baseline = cell.baseline && cell.nonfinite_pixels == 0 ? no_error : cell.error_covered;
  all.to_truth = cell.error_truth;
  return all;
}

// Names that stand for numbers in the cells: each once, by place.
class Names {
 public:
  size_t operator()(const Json& name) {
    const auto [known, added] = places_.try_emplace(name, list.size());
    if (added) list.push_back(name);
    return known->second;
  }
  Json list = Json::array();

 private:
  std::map<Json, size_t> places_;
};

struct NamesOfCells {
  Names effects, variants, backends, views, points;
};

void add_cells(Json& cells, const Record& record, size_t number, NamesOfCells& names) {
  std::map<ShotKey, std::vector<size_t>> shots;
  std::vector<CostAndErrors> all;
  std::vector<std::vector<double>> samples;
  for (size_t i = 0; i < record.cells.size(); ++i) {
    shots[shot_key(record.cells[i])].push_back(i);
    samples.push_back(shown_samples_ms(record, record.cells[i]));
    all.push_back(figures_of_cell(record, record.cells[i], samples[i]));
  }
  std::vector<FrontierBits> bits(all.size());
  for (const auto& [unused, shot] : shots) {
    std::vector<CostAndErrors> group;
    for (const size_t cell : shot) group.push_back(all[cell]);
    const std::vector<FrontierBits> of_group = frontier_bits(group);
    for (size_t i = 0; i < shot.size(); ++i) bits[shot[i]] = of_group[i];
  }
  for (size_t i = 0; i < record.cells.size(); ++i) {
    const CellRow& cell = record.cells[i];
    Json one = costs_and_errors(all[i], bits[i]);
    Json rounded = Json::array();
    for (const double sample_ms : samples[i]) rounded.push_back(six_digits(sample_ms));
    const bool timed = times_shown(record, cell.backend);
    one.update({{"record", number},
                {"effect", names.effects(cell.effect)},
                {"variant", names.variants(cell.variant)},
                {"backend", names.backends(cell.backend)},
                {"view", names.views(cell.view)},
                {"point", names.points(cell.params)},
                {"is_baseline", cell.baseline},
                {"ratio", timed ? interval(cell.ratio_to_baseline) : Json(nullptr)},
                {"samples", rounded},
                {"size", {cell.width, cell.height}}});
    if (cell.failed) one["failed"] = cell.reason;
    const std::pair<const char*, const std::string&> pictures[] = {{"image", cell.image},
                                                                   {"difference", cell.difference},
                                                                   {"flip", cell.flip},
                                                                   {"truth_image", cell.truth_image},
                                                                   {"before_image", cell.before_image}};
    for (const auto& [name, path] : pictures)
      if (!path.empty()) one[name] = path;
    if (const auto& tile = cell.worst_tile)
      one["worst_tile"] = {{"x", tile->x}, {"y", tile->y}, {"size", tile->size}, {"flip", tile->flip}};
    cells.push_back(std::move(one));
  }
}

void add_passes(Json& passes, const Record& record, size_t number) {
  for (const PassSummary& pass : summarize_passes(record)) {
    Json shares = Json::array();
    for (const PassSummary::Share& share : pass.shares)
      shares.push_back({{"texture", share.texture},
                        {"format", share.format},
                        {"filter", share.filter},
                        {"per_pixel", six_digits(share.per_pixel)},
                        {"level", or_null(mean_level(share.levels))}});
    Json operations = Json::array();
    for (const auto& [operation, per_pixel] : pass.operations)
      operations.push_back(
          {{"operation", operation}, {"group", operation_group(operation)}, {"per_pixel", six_digits(per_pixel)}});
    passes.push_back({{"record", number},
                      {"effect", pass.effect},
                      {"variant", pass.variant},
                      {"backend", pass.backend},
                      {"pass", pass.name},
                      {"once", pass.once},
                      {"ms", or_null(pass.ms)},
                      {"per_pixel", or_null(pass.fetches_per_pixel)},
                      {"ns_per_fetch", or_null(pass.ns_per_fetch)},
                      {"shares", shares},
                      {"operations", operations}});
  }
}

void add_strips(Json& all, const Record& record, size_t number) {
  for (const GateStrips& strips : gate_strips(record)) {
    Json processes = Json::array();
    for (const GateStrips::Process& process : strips.processes) {
      Json ratios = Json::array();
      for (const StripPair& pair : process.strips) ratios.push_back(six_digits(pair.after / pair.before));
      processes.push_back({{"number", process.number},
                           {"ratio", six_digits(std::exp(process.estimate.log_ratio))},
                           {"error", six_digits(process.estimate.error)},
                           {"strips", ratios}});
    }
    all.push_back({{"record", number},
                   {"words", words_for_comparison(strips)},
                   {"margin", record.gates.empty() ? Json(nullptr) : Json(record.gates.back().margin)},
                   {"processes", processes}});
    if (!strips.verdict) continue;
    all.back()["verdict"] = name_of(strips.verdict->verdict);
    all.back()["interval"] = interval(strips.verdict->ratio);
    all.back()["margin"] = strips.verdict->limit ? Json(*strips.verdict->limit) : Json(nullptr);
  }
}

}  // namespace

std::string for_script(const Json& data) {
  // A <script> ends at the first "</script", wherever it stands, and has another state from "<!--" on.
  std::string text = data.dump(-1, ' ', false, Json::error_handler_t::replace), out;
  out.reserve(text.size());
  for (const char c : text) c == '<' ? out.append("\\u003c") : out.append(1, c);
  return out;
}

Json page_data(const std::vector<Record>& records) {
  Json rows = Json::array(), cells = Json::array(), passes = Json::array(), sweeps = Json::array(), crossovers = Json::array(),
       strips = Json::array();
  Json errors = Json::array(), about = Json::array();
  for (const ErrorMetric& metric : error_metrics)
    errors.push_back({{"name", metric.name}, {"words", metric.words}, {"more_is_closer", metric.more_is_closer}});
  NamesOfCells names;
  for (size_t i = 0; i < records.size(); ++i) {
    const Record& record = records[i];
    about.push_back({{"name", record_name(records, i)}, {"gain", text_at(record.run, "/settings/difference_gain")}});
    add_summary_rows(rows, summarize(record), i);
    add_cells(cells, record, i, names);
    add_passes(passes, record, i);
    add_strips(strips, record, i);
    for (const SweepRow& sweep : record.sweeps)
      for (const auto& [path, unit, values] : sweep.parameters)
        sweeps.push_back({{"path", path}, {"unit", unit}, {"values", values}, {"record", i}});
    for (const CrossoverRow& row : crossovers_of(record)) {
      Json crossover = to_json(row);
      for (const char* part : {"claim", "remark"}) crossover.erase(part);  // the sentence holds them
      crossover["record"] = i;
      crossover["held"] = row.held;
      crossovers.push_back(std::move(crossover));
    }
  }
  return {{"records", about},
          {"metrics", errors},
          {"effects", names.effects.list},
          {"variants", names.variants.list},
          {"backends", names.backends.list},
          {"views", names.views.list},
          {"points", names.points.list},
          {"rows", rows},
          {"cells", cells},
          {"passes", passes},
          {"sweeps", sweeps},
          {"crossovers", crossovers},
          {"strips", strips}};
}

}  // namespace lamina
