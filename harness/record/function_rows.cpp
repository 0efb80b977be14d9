// SPDX-License-Identifier: Apache-2.0
#include "harness/record/function_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "harness/core/text.h"
#include "harness/record/fields.h"
#include "harness/record/record.h"

namespace lamina {
namespace {

using namespace lines;

std::string name_of(const FunctionSubject& subject) {
  return fmt::format("{} as {} on {}", subject.function, subject.variant, subject.backend);
}

constexpr std::array errors_of_functions = {std::pair("max_over", &FunctionRow::max_over),
                                            std::pair("max_under", &FunctionRow::max_under),
                                            std::pair("mean_absolute", &FunctionRow::mean_absolute),
                                            std::pair("rms", &FunctionRow::rms),
                                            std::pair("most_eps", &FunctionRow::max_eps),
                                            std::pair("most_eps_kappa", &FunctionRow::max_eps_kappa)};

}  // namespace

constexpr auto fields(const FunctionSubject*) {
  using Row = FunctionSubject;
  return std::tuple(field("function", &Row::function), field("title", &Row::title), field("variant", &Row::variant),
                    field("baseline", &Row::baseline), field("backend", &Row::backend), field("device", &Row::device));
}

constexpr auto fields(const FunctionBounds*) {
  using Row = FunctionBounds;
  return std::tuple(field("over", &Row::over), field("under", &Row::under), field("eps_kappa", &Row::eps_kappa));
}

constexpr auto fields(const FunctionRow*) {
  using Row = FunctionRow;
  return std::tuple(part(&Row::subject), field("scale", &Row::scale), field("set", &Row::set), field("what", &Row::what),
                    field("points", &Row::points), field("max_over", &Row::max_over), field("max_under", &Row::max_under),
                    field("mean_absolute", &Row::mean_absolute), field("rms", &Row::rms), field("most_eps", &Row::max_eps),
                    field("most_eps_kappa", &Row::max_eps_kappa), field("negative", &Row::negative),
                    field("nonfinite", &Row::nonfinite), field("not_zero", &Row::not_zero),
                    field<Point>("worst_over", &Row::worst_over), field<Point>("worst_under", &Row::worst_under),
                    left_out<Point>("first_fault", &Row::first_fault), left_out("bounds", &Row::bounds));
}

void check(const FunctionRow& row, const At& at) {
  for (const auto& [name, error] : errors_of_functions)
    if ((row.*error).has_value() == (row.points == row.nonfinite))
      refuse(at, fmt::format("'{}' must be null where no value is finite and nowhere else", name));
}

constexpr auto fields(const FunctionTimeRow*) {
  using Row = FunctionTimeRow;
  return std::tuple(part(&Row::subject), field("ns_per_call", &Row::ns_per_call),
                    left_out("ns", &Row::ns),  // records had none before
                    field("reason", &Row::reason), field("commit", &Row::commit), field("build", &Row::build));
}

void check(const FunctionTimeRow& row, const At& at) {
  if (!row.ns.empty() && (!row.ns_per_call || row.ns.size() != row.ns_per_call->rounds))
    refuse(at, "'ns' must hold a number for each round of 'ns_per_call'");
}

constexpr auto fields(const FunctionPictureRow*) {
  using Row = FunctionPictureRow;
  return std::tuple(part(&Row::subject), field("slice", &Row::slice), field("axes", &Row::axes), field("image", &Row::image),
                    field("full_error", &Row::full_error));
}

Line to_json(const FunctionRow& judged) {
  FunctionRow row = judged;
  if (row.points <= row.nonfinite)
    for (const auto& [name, error] : errors_of_functions) (row.*error).reset();
  if (!(row.max_over > 0)) row.worst_over.clear();
  if (!(row.max_under && *row.max_under < 0)) row.worst_under.clear();
  return line_of("function", row, name_of(row.subject) + ", set " + row.set);
}

Line to_json(const FunctionTimeRow& timed) {
  FunctionTimeRow row = timed;
  for (double& ns : row.ns)
    if (std::isfinite(ns)) ns = std::stod(fmt::format("{:.6g}", ns));
  return line_of("function_time", row, name_of(row.subject));
}

Line to_json(const FunctionPictureRow& row) { return line_of("function_picture", row, name_of(row.subject)); }

template FunctionRow row_of(const Json& line, const std::string& where);
template nlohmann::ordered_json schema_of<FunctionRow>();
template FunctionTimeRow row_of(const Json& line, const std::string& where);
template nlohmann::ordered_json schema_of<FunctionTimeRow>();
template FunctionPictureRow row_of(const Json& line, const std::string& where);
template nlohmann::ordered_json schema_of<FunctionPictureRow>();

void replace_function_lines(const std::filesystem::path& file, const std::string& function, const Line& run_line,
                            const std::vector<Line>& new_lines) {
  const auto text_of = [](const auto& line) { return line.dump(-1, ' ', false, Line::error_handler_t::replace) + '\n'; };
  std::string content;
  if (!std::filesystem::exists(file)) {
    content = text_of(run_line);
  } else {
    const Record record = read_record(file);
    const std::string old = read_file(file, "record");
    const bool cut = record.run.contains("truncated");
    for (size_t begin = 0; begin < old.size();) {
      const size_t newline = std::min(old.find('\n', begin), old.size());
      const std::string line = old.substr(begin, newline - begin);
      if (begin == 0 && cut) {
        content = text_of(record.run);
      } else if (newline < old.size() || !cut) {
        const Json parsed = Json::parse(line);
        const std::string kind = parsed.at("kind");
        if (!kind.starts_with("function") || parsed.at("function") != function) content += line + '\n';
      }
      begin = newline + 1;
    }
  }
  for (const Line& line : new_lines) content += text_of(line);
  write_file_atomically(file, content);
}

}  // namespace lamina
