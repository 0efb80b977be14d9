// SPDX-License-Identifier: Apache-2.0
// What a record says of functions, summed up: the same for the page and for Markdown. Strings are not yet escaped.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/words.h"

namespace lamina {

// A variant of a function on a backend. What is pointed to lives in the record.
struct FunctionSummary {
  std::string variant;
  bool baseline = false;
  std::optional<Interval> ns;             // of a call
  std::vector<double> samples;            // of each round, ns; none in a record of before they were kept
  std::string reason;                     // why there is no time
  std::optional<double> ratio;            // median over the baseline's median
  std::optional<double> error;            // the greatest |error| over the main set; absent where a value was not finite
  Standing standing = Standing::unknown;  // by time and greatest error; its rounds are paired with the others'
  std::string by;                         // what dominates it, or what it is not told from; "" else
  bool frontier() const { return standing == Standing::on_frontier; }
  const FunctionRow* main_set = nullptr;  // may be absent in a record put together by hand
  std::vector<const FunctionRow*> sets;   // every set, the main one included
  std::vector<const FunctionPictureRow*> pictures;
};

struct FunctionBackend {
  std::string backend, device;
  std::vector<FunctionSummary> variants;  // the baseline first
};

struct FunctionReport {
  std::string function, title, baseline;
  std::string scale;                // errors are of this
  std::string main_set, main_what;  // the set that comes first
  std::vector<FunctionBackend> backends;
};

// By function, backend and variant in order of appearance, a baseline before the others.
std::vector<FunctionReport> summarize_functions(const Record& record);

// One paragraph a variant: whether it is worth having, by what it costs and errs by on each backend; else what beats it.
std::vector<Headline> function_headlines(const FunctionReport& report);

// The table over the main set, a row a variant.
Table function_table(const FunctionReport& report, const FunctionBackend& backend);
std::vector<std::string> function_cells(const FunctionSummary& row);
// Nanoseconds of a call, no unit.
std::string words_for_ns(double ns);
std::string words_for_ns(const Interval& ns);  // with a * where it covers less than 95%
// A figure of a function's row, to so many digits; "-" where it is absent.
std::string words_for_error(const std::optional<double>& figure, int digits);

// The table of a backend's rows of every set, set by set, so that the variants stand under each other.
Table function_sets_table(const FunctionBackend& backend);
std::vector<std::string> function_set_cells(const FunctionRow& row);

// Whether a row keeps what its variant claims: every value finite, none negative, 0 where 0 is right, and the errors within its
// bounds where it claims any.
enum class Keeps { yes, no, claims_none };
Keeps keeps_bounds(const FunctionRow& row);
// A sentence a variant: on how many sets its bounds hold, and on each where they do not by how much and at which input.
std::vector<Headline> hard_case_headlines(const FunctionBackend& backend);
// How to read the tables, one sentence each.
std::vector<std::string> function_notes(const FunctionReport& report);

// The section of the page: words, chart, tables, pictures. "" where the record has no functions. `name` parts the record from
// the others on the page; "" where there is one.
std::string html_functions(const Record& record, const std::string& name, const PictureUrl& url);
// The chart of error over time of a report, as the data that reports/page/functions.js draws; "" where nothing was timed.
std::string html_function_chart(const FunctionReport& report, const std::string& name = "");

}  // namespace lamina
