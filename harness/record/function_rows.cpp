// SPDX-License-Identifier: Apache-2.0
#include "harness/record/function_rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/core/text.h"
#include "harness/record/finite.h"
#include "harness/record/record.h"

namespace lamina {
namespace {

using Json = nlohmann::ordered_json;

std::string name_of(const FunctionSubject& subject) {
  return fmt::format("{} as {} on {}", subject.function, subject.variant, subject.backend);
}

Json start(const char* kind, const FunctionSubject& subject) {
  return {{"kind", kind},
          {"function", subject.function},
          {"title", subject.title},
          {"variant", subject.variant},
          {"baseline", subject.baseline},
          {"backend", subject.backend},
          {"device", subject.device}};
}

}  // namespace

Json to_json(const FunctionRow& row) {
  const std::string owner = name_of(row.subject) + ", set " + row.set;
  const bool any = row.points > row.nonfinite;
  const auto error = [&](double value, const char* what) { return any ? finite(value, owner, what) : Json(nullptr); };
  Json line = start("function", row.subject);
  line["scale"] = row.scale;
  line["set"] = row.set;
  line["what"] = row.what;
  line["points"] = row.points;
  line["max_over"] = error(row.max_over, "max_over");
  line["max_under"] = error(row.max_under, "max_under");
  line["mean_absolute"] = error(row.mean_absolute, "mean_absolute");
  line["rms"] = error(row.rms, "rms");
  line["most_eps"] = error(row.most_eps, "most_eps");
  line["most_eps_kappa"] = error(row.most_eps_kappa, "most_eps_kappa");
  line["negative"] = row.negative;
  line["nonfinite"] = row.nonfinite;
  line["not_zero"] = row.not_zero;
  line["worst_over"] = any && row.max_over > 0 ? Json(row.worst_over) : Json(nullptr);
  line["worst_under"] = any && row.max_under < 0 ? Json(row.worst_under) : Json(nullptr);
  if (row.first_fault) line["first_fault"] = *row.first_fault;
  if (row.bounds) {
    line["bounds"] = {{"over", finite(row.bounds->over, owner, "bounds.over")},
                      {"under", finite(row.bounds->under, owner, "bounds.under")},
                      {"eps_kappa", nullptr}};
    if (row.bounds->eps_kappa) line["bounds"]["eps_kappa"] = finite(*row.bounds->eps_kappa, owner, "bounds.eps_kappa");
  }
  return line;
}

Json to_json(const FunctionTimeRow& row) {
  Json line = start("function_time", row.subject);
  line["ns_per_call"] = interval_to_json(row.ns_per_call, name_of(row.subject), "ns_per_call");
  if (!row.ns.empty()) {
    Json samples = Json::array();  // six digits are more than any timer resolves
    for (const double ns : row.ns)
      samples.push_back(std::stod(fmt::format("{:.6g}", finite(ns, name_of(row.subject), "ns").get<double>())));
    line["ns"] = samples;
  }
  line["reason"] = row.reason;
  line["commit"] = row.commit;
  line["build"] = row.build;
  return line;
}

Json to_json(const FunctionPictureRow& row) {
  Json line = start("function_picture", row.subject);
  line["slice"] = row.slice;
  line["axes"] = row.axes;
  line["image"] = row.image;
  line["full_error"] = finite(row.full_error, name_of(row.subject), "full_error");
  return line;
}

Json function_timer_line(const std::string& function, const TimerRow& timer) {
  Json line = to_json(timer);
  line["kind"] = "function_timer";
  line["function"] = function;
  return line;
}

void replace_function_lines(const std::filesystem::path& file, const std::string& function, const Json& run_line,
                            const std::vector<Json>& lines) {
  const auto text_of = [](const auto& line) { return line.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n'; };
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
  for (const Json& line : lines) content += text_of(line);
  write_file_atomically(file, content);
}

}  // namespace lamina
