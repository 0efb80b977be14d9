// SPDX-License-Identifier: Apache-2.0
// Reads a record and checks every line, so that what makes reports of it can trust each field.
#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/record/gate_lines.h"
#include "harness/record/line_checks.h"
#include "harness/record/record.h"

namespace lamina {
namespace {

using Json = nlohmann::json;
using namespace line_checks;

void check_figures(const Json& figures, const std::string& where, const std::string& inside) {
  check(figures,
        {{"psnr_db", number_or_null},
         {"identical", boolean},
         {"ssim", number},
         {"flip", number},
         {"rmse_linear", number},
         {"max_linear", number}},
        where, inside);
  if (figures["psnr_db"].is_null() != figures["identical"].get<bool>())
    refuse(where, fmt::format("'{}psnr_db' must be null for identical pictures and for no others", inside));
}

void check_worst_tile(const Json& line, const std::string& where) {
  if (!line.contains("worst_tile")) return;
  check(line, {{"worst_tile", object}}, where);
  check(line["worst_tile"], {{"x", count}, {"y", count}, {"size", count}, {"flip", number}}, where, "worst_tile.");
}

// What a cell has only where there is a truth.
void check_truth(const Json& line, const std::string& where) {
  if (line.contains("truth_image")) check(line, {{"truth_image", text}}, where);
  if (!line.contains("assumptions")) return;
  check(line, {{"assumptions", array}}, where);
  for (const Json& assumption : line["assumptions"]) {
    check(assumption, {{"name", text}, {"title", text}, {"error", object}, {"image", text}}, where, "assumptions.");
    check_figures(assumption["error"], where, "assumptions.error.");
  }
}

void check_cell(const Json& line, const std::string& where) {
  check(line,
        {{"scene", text},
         {"effect", text},
         {"variant", text},
         {"baseline", boolean},
         {"backend", text},
         {"device", text},
         {"width", count},
         {"height", count},
         {"view", text},
         {"params", numbers_by_name},
         {"status", status},
         {"reason", text},
         {"timed", boolean},
         {"passes", array},
         {"median_ms", number_or_null},
         {"once_ms", number_or_null},
         {"cold_ms", number_or_null},
         {"ratio_to_baseline", object_or_null},
         {"fetches", count_or_null},
         {"fetches_per_pixel", number_or_null},
         {"error", object},
         {"nonfinite_pixels", count_or_null},
         {"covered_pixels", count_or_null},
         {"image", text},
         {"difference", text},
         {"flip", text},
         {"image_hash", text},
         {"shader_hashes", texts}},
        where);
  for (const Json& pass : line["passes"]) {
    check(pass,
          {{"name", text},
           {"once", boolean},
           {"ms", numbers},
           {"median_ms", number_or_null},
           {"fragments", count_or_null},
           {"vertices", count_or_null},
           {"fetches", count_or_null},
           {"early_tests", boolean},
           {"by_texture", array}},
          where, "passes.");
    for (const Json& fetched : pass["by_texture"])
      check(fetched, {{"texture", text}, {"format", text}, {"filter", text}, {"fetches", count}}, where, "passes.by_texture.");
  }
  check_interval(line["ratio_to_baseline"], where, "ratio_to_baseline.");
  check(line["error"], {{"baseline", object_or_null}, {"frame", object_or_null}, {"truth", object_or_null}}, where, "error.");
  for (const char* against : {"baseline", "frame", "truth"})
    if (const Json& figures = line["error"][against]; !figures.is_null())
      check_figures(figures, where, fmt::format("error.{}.", against));
  check_truth(line, where);
  if (line.contains("range_linear")) check(line, {{"range_linear", number}}, where);
  if (line.contains("before_image")) check(line, {{"before_image", text}}, where);  // of a gate over two trees
  check_worst_tile(line, where);
  if (line["status"] == "ok") {
    try {
      frame_samples_ms(passes_of(line));
    } catch (const Error& error) {
      refuse(where, fmt::format("{} {}", error.subject(), error.message()));
    }
  }
}

void check_timer(const Json& line, const std::string& where) {
  check(line,
        {{"backend", text},
         {"ok", boolean},
         {"linearity", numbers},
         {"additivity", number_or_null},
         {"one_ms", number_or_null},
         {"attribution", number_or_null},
         {"reason", text}},
        where);
}

void check_plan(const Json& line, const std::string& where) {
  check(line, {{"effects", array}}, where);
  for (const Json& effect : line["effects"])
    check(effect, {{"effect", text}, {"called_for", boolean}, {"reason", text}}, where, "effects.");
}

void check_phase(const Json& line, const std::string& where) {
  check(line, {{"backend", text}, {"effect", text}, {"rounds", count}, {"wall_ms", number}, {"device_ms", number}}, where);
}

void check_bake(const Json& line, const std::string& where) {
  check(line,
        {{"effect", text},
         {"object", text},
         {"what", text},
         {"points", count},
         {"rays", count},
         {"seconds", number},
         {"rays_per_second", number_or_null},
         {"from_cache", boolean}},
        where);
}

void check_function_subject(const Json& line, const std::string& where) {
  check(line,
        {{"function", text}, {"title", text}, {"variant", text}, {"baseline", boolean}, {"backend", text}, {"device", text}},
        where);
}

void check_function(const Json& line, const std::string& where) {
  check_function_subject(line, where);
  check(line,
        {{"scale", text},
         {"set", text},
         {"what", text},
         {"points", count},
         {"max_over", number_or_null},
         {"max_under", number_or_null},
         {"mean_absolute", number_or_null},
         {"rms", number_or_null},
         {"most_eps", number_or_null},
         {"most_eps_kappa", number_or_null},
         {"negative", count},
         {"nonfinite", count},
         {"not_zero", count},
         {"worst_over", point_or_null},
         {"worst_under", point_or_null}},
        where);
  if (line.contains("first_fault")) check(line, {{"first_fault", point_or_null}}, where);
  if (line.contains("bounds")) {
    check(line, {{"bounds", object}}, where);
    check(line["bounds"], {{"over", number}, {"under", number}, {"eps_kappa", number_or_null}}, where, "bounds.");
  }
  const bool none = line["points"] == line["nonfinite"];
  for (const char* name : {"max_over", "max_under", "mean_absolute", "rms", "most_eps", "most_eps_kappa"})
    if (line[name].is_null() != none)
      refuse(where, fmt::format("'{}' must be null where no value is finite and nowhere else", name));
}

void check_function_time(const Json& line, const std::string& where) {
  check_function_subject(line, where);
  check(line, {{"ns_per_call", object_or_null}, {"reason", text}, {"commit", text}, {"build", text}}, where);
  check_interval(line["ns_per_call"], where, "ns_per_call.");
  if (!line.contains("ns")) return;  // as records had none before
  check(line, {{"ns", numbers}}, where);
  if (line["ns_per_call"].is_null() || line["ns"].size() != line["ns_per_call"]["rounds"])
    refuse(where, "'ns' must hold a number for each round of 'ns_per_call'");
}

void check_function_timer(const Json& line, const std::string& where) {
  check(line, {{"function", text}}, where);
  check_timer(line, where);
}

void check_function_picture(const Json& line, const std::string& where) {
  check_function_subject(line, where);
  check(line, {{"slice", text}, {"axes", text}, {"image", text}, {"full_error", number}}, where);
}

void check_sweep(const Json& line, const std::string& where) {
  check(line, {{"parameters", array}, {"zip", boolean}, {"points", count}, {"shard", object}, {"limits", array}}, where);
  for (const Json& parameter : line["parameters"])
    check(parameter, {{"path", text}, {"unit", text}, {"values", numbers}}, where, "parameters.");
  check(line["shard"], {{"index", count}, {"count", count}}, where, "shard.");
  for (const Json& limit : line["limits"]) check(limit, {{"metric", text}, {"limit", number}}, where, "limits.");
}

void check_crossover(const Json& line, const std::string& where) {
  check(line,
        {{"parameter", text},
         {"backend", text},
         {"effect", text},
         {"variant", text},
         {"other", text},
         {"metric", text},
         {"limit", number_or_null},
         {"at", number_or_null},
         {"tolerance", number},
         {"sentence", text}},
        where);
}

void check_run(const Json& line, const std::string& where) {
  check(line, {{"schema", count}}, where);
  if (line["schema"] != record_schema)
    refuse(where, fmt::format("the record's schema is {}, this program reads schema {}; use the program that wrote it",
                              line["schema"].dump(), record_schema));
  if (line.contains("date")) check(line, {{"date", moment}}, where);
  if (line.contains("commit_date")) check(line, {{"commit_date", moment_or_null}}, where);
}

// The kind of a line; checks that it is an object with one.
std::string kind_of(const Json& line, const std::string& where) {
  check(line, {{"kind", text}}, where);
  return line["kind"];
}

void add_line(Record& record, Json line, const std::string& where) {
  const std::string kind = kind_of(line, where);
  if (kind == "run") refuse(where, "a second line of kind 'run'; one record holds one run, so split the file before this line");
  struct Kind {
    const char* name;
    void (*check)(const Json&, const std::string&);
    std::vector<Json>* lines;
  };
  const Kind kinds[] = {{"timer", check_timer, &record.timers},
                        {"plan", check_plan, &record.plans},
                        {"bake", check_bake, &record.bakes},
                        {"phase", check_phase, &record.phases},
                        {"cell", check_cell, &record.cells},
                        {"function", check_function, &record.functions},
                        {"function_time", check_function_time, &record.function_times},
                        {"function_timer", check_function_timer, &record.function_timers},
                        {"function_picture", check_function_picture, &record.function_pictures},
                        {"gate", check_gate, &record.gates},
                        {"aa", check_aa, &record.aas},
                        {"verdict", check_verdict, &record.verdicts},
                        {"pairs", check_pairs, &record.pairs},
                        {"sweep", check_sweep, &record.sweeps},
                        {"crossover", check_crossover, &record.crossovers}};
  std::vector<std::string> known = {"run"};
  for (const auto& [name, check_line, lines] : kinds) {
    known.push_back(name);
    if (kind != name) continue;
    check_line(line, where);
    lines->push_back(std::move(line));
    return;
  }
  refuse(where, unknown_name("kind of line", kind, known));
}

}  // namespace

Record read_record(const std::filesystem::path& file) {
  const std::string content = read_file(file, "record");
  Record record;
  size_t number_of_line = 0;
  for (size_t begin = 0; begin < content.size();) {
    const size_t newline = content.find('\n', begin);
    const bool ended = newline != std::string::npos;
    const std::string_view words = std::string_view(content).substr(begin, ended ? newline - begin : std::string::npos);
    begin = ended ? newline + 1 : content.size();
    const std::string where = fmt::format("{}:{}", file.string(), ++number_of_line);

    Json line;
    try {
      line = Json::parse(words);
    } catch (const Json::out_of_range&) {
      refuse(where, "holds a number too large for a double");
    } catch (const Json::parse_error& error) {
      if (!ended && number_of_line > 1) {  // what a crash or a full disk leaves; a whole line ends in a newline
        record.run["truncated"] = fmt::format("line {} is cut short and left out: the run did not end well", number_of_line);
        break;
      }
      refuse(where, fmt::format("is not JSON from byte {} of the line on; mend or remove the line, or run again", error.byte));
    }
    if (number_of_line > 1) {
      add_line(record, std::move(line), where);
      continue;
    }
    if (kind_of(line, where) != "run")
      refuse(where, "the first line is not of kind 'run'; this is no record, or its start is lost");
    check_run(line, where);
    record.run = std::move(line);
  }
  if (number_of_line == 0)
    refuse(fmt::format("{}:1", file.string()), "the file is empty; a record begins with a line of kind 'run'");
  return record;
}

}  // namespace lamina
