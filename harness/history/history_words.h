// SPDX-License-Identifier: Apache-2.0
// The words of a history, the same in the terminal and on the page.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "harness/history/trend.h"

namespace lamina {

std::string words_for(double value, const TrendFigure& figure);  // without its unit
std::string with_unit(const std::string& words, const TrendFigure& figure);
// In percent where the figure has a natural zero, else as a difference.
std::string words_for_change(double before, double after, const TrendFigure& figure);
// "history of 12 records, 0a1b2c (2026-01-31) to 3d4e5f (2026-02-28)".
std::string words_for_span(const History& history);

// What cells and figures are called in this history: the scene is named where there are several, the machine by a letter
// likewise.
class HistoryNames {
 public:
  explicit HistoryNames(const History& history);
  std::string of(const TrendCell& cell) const;
  std::string of(const Trend& trend) const;  // its figure
  // "machine A: ..."; none where there is one.
  std::vector<std::string> machines() const;

 private:
  bool several_scenes_ = false;
  std::map<std::string, std::string> letters_;  // in order of appearance; beyond Z numbers
};

struct StepWords {
  std::string sentence;
  bool worse = false;
};
std::vector<StepWords> words_for_steps(const History& history);

// How high a value stands in a small chart, 0 to 1. Noisy figures span at least 5% of their greatest value, so that noise looks
// like noise; a PSNR of identical pictures stands highest.
class TrendAxis {
 public:
  explicit TrendAxis(const Trend& trend);
  double height(double value) const;

 private:
  double least_, span_;
};
// The trends of one cell: those worth a line and a chart (noisy ones always, others where they have steps), and the figures
// that never changed, in words.
struct CellTrends {
  TrendCell cell;
  std::vector<const Trend*> moving;
  std::vector<std::string> still;
};
// Of every cell, in order.
std::vector<CellTrends> by_cell(const History& history);

}  // namespace lamina
