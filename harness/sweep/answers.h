// SPDX-License-Identifier: Apache-2.0
// The answers of a sweep: up to where each variant keeps an error within a limit, and from where on one variant is better or
// cheaper than another, or both. Found on the record's curves by interpolation.
#pragma once

#include "harness/record/sweep_rows.h"
#include "harness/sweep/curves.h"

namespace lamina {

using Limit = SweepRow::Limit;  // on a metric of curves.h, but for "ratio"
// "ssim=0.98". Throws Error(bad_input) with the nearest metric.
Limit parse_limit(const std::string& stage, const std::string& text);

// How every claim of a curve ends: ", at elevation 20 degrees", "" where no other parameter is held.
std::string place_words(const Curve& curve);

// Rows in the order of the curves: for each variant each limit; then each pair of variants, by the first limit's metric and by
// time where both have been timed.
std::vector<CrossoverRow> answers(const std::vector<Curve>& curves, const std::vector<Limit>& limits);

// The record's own. Those of before rows said what is held get it from the answers found again on its curves, where these say
// the same.
std::vector<CrossoverRow> crossovers_of(const Record& record);

}  // namespace lamina
