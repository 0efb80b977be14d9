// SPDX-License-Identifier: Apache-2.0
// The floor under recommendations: what is beyond a run's limits is shown, and not recommended.
#include <fmt/format.h>

#include <algorithm>

#include "reports/words.h"

namespace lamina {
namespace {

struct ReportLimit {
  const ErrorMetric* metric;
  double value;
};

std::vector<ReportLimit> limits_of(const Record& record) {
  std::vector<ReportLimit> limits;
  const auto settings = record.run.find("settings");
  if (settings == record.run.end() || !settings->is_object()) return limits;
  const auto given = settings->find("limits");
  if (given == settings->end() || !given->is_object()) return limits;
  for (const auto& [name, value] : given->items()) {
    if (const ErrorMetric* metric = error_metric(name); metric && value.is_number())
      limits.push_back({metric, value.get<double>()});
  }
  return limits;
}

}  // namespace

std::vector<std::string> limit_words(const Record& record) {
  std::vector<std::string> words;
  for (const ReportLimit& limit : limits_of(record))
    words.push_back(
        fmt::format("{} of at {} {:.6g}", limit.metric->words, limit.metric->more_is_closer ? "least" : "most", limit.value));
  return words;
}

std::string beyond_limit(const Record& record, const ErrorFigures& to_baseline) {
  for (const ReportLimit& limit : limits_of(record)) {
    const double figure = to_baseline.*limit.metric->figure;
    if (limit.metric->more_is_closer ? figure < limit.value : figure > limit.value)
      return fmt::format("{} {:.4f}, limit {:.6g}", limit.metric->words, figure, limit.value);
  }
  return "";
}

}  // namespace lamina
