// SPDX-License-Identifier: Apache-2.0
// What a frame saves that runs only what its scene calls for, effect by effect: means over views, paired by round.
#include <fmt/ranges.h>

#include <algorithm>

#include "harness/core/byte_words.h"
#include "reports/words.h"

namespace lamina {
namespace {

using SavingRows = std::vector<const SavingRow*>;
using CostOf = SavingRow::Cost SavingRow::Effect::*;

// The views of each backend that have figures, of one list of effects.
std::vector<std::pair<std::string, SavingRows>> by_backend(const Record& record) {
  std::vector<std::pair<std::string, SavingRows>> all;
  for (const SavingRow& row : record.savings) {
    auto known = std::ranges::find(all, row.backend, &std::pair<std::string, SavingRows>::first);
    if (known == all.end()) known = all.insert(known, {row.backend, {}});
    SavingRows& rows = known->second;
    if (row.failure.empty() && (rows.empty() || rows.front()->effects.size() == row.effects.size())) rows.push_back(&row);
  }
  return all;
}

// Of each round the mean over views; the first rounds that all views have.
std::vector<double> mean_samples(const std::vector<std::vector<double>>& views) {
  if (views.empty()) return {};
  std::vector<double> mean(std::ranges::min(views, {}, &std::vector<double>::size).size(), 0);
  for (const std::vector<double>& view : views)
    for (size_t round = 0; round < mean.size(); ++round) mean[round] += view[round] / static_cast<double>(views.size());
  return mean;
}

struct EffectCost {
  std::vector<double> ms;  // of each round
  double fetches = 0, operations = 0, target_bytes = 0;
};

EffectCost mean_cost(const SavingRows& rows, size_t effect, CostOf side) {
  EffectCost mean;
  std::vector<std::vector<double>> ms;
  const double views = static_cast<double>(rows.size());
  for (const SavingRow* row : rows) {
    const SavingRow::Cost& cost = row->effects[effect].*side;
    if (!cost.ms.empty()) ms.push_back(cost.ms);
    mean.fetches += static_cast<double>(cost.fetches) / views;
    mean.operations += static_cast<double>(cost.operations) / views;
    mean.target_bytes += static_cast<double>(cost.target_bytes) / views;
  }
  mean.ms = mean_samples(ms);
  return mean;
}

std::vector<double> mean_frames(const SavingRows& rows, CostOf side) {
  std::vector<std::vector<double>> ms;
  for (const SavingRow* row : rows) ms.push_back(saving_frame_ms(row->effects, side));
  return mean_samples(ms);
}

std::string words_of_count(double count) {
  if (count >= 1e9) return fmt::format("{:.3g} G", count / 1e9);
  if (count >= 1e6) return fmt::format("{:.3g} M", count / 1e6);
  if (count >= 1e3) return fmt::format("{:.3g} k", count / 1e3);
  return fmt::format("{:.0f}", count);
}

std::string ms_words(const std::vector<double>& samples) {
  return samples.empty() ? "-" : words_for_ms(interval_or_range(samples));
}

// The frames of all effects together.
EffectCost whole_frame(const SavingRows& rows, CostOf side, uint64_t SavingRow::*of_frame) {
  EffectCost sum;
  for (size_t effect = 0; effect < rows.front()->effects.size(); ++effect) {
    const EffectCost cost = mean_cost(rows, effect, side);
    sum.fetches += cost.fetches, sum.operations += cost.operations, sum.target_bytes += cost.target_bytes;
  }
  sum.target_bytes += static_cast<double>(rows.front()->*of_frame);
  sum.ms = mean_frames(rows, side);
  return sum;
}

std::vector<std::string> cells_of(const std::string& name, const std::string& called, const EffectCost& culled,
                                  const EffectCost& all, bool timed) {
  const auto bytes = [](double of) { return byte_words(static_cast<uint64_t>(of)); };
  return {name,
          called,
          timed ? ms_words(culled.ms) : "-",
          timed ? ms_words(all.ms) : "-",
          words_of_count(culled.fetches),
          words_of_count(all.fetches),
          words_of_count(culled.operations),
          words_of_count(all.operations),
          bytes(culled.target_bytes),
          bytes(all.target_bytes)};
}

std::optional<Interval> frame_ratio(const SavingRows& rows) {
  const std::vector<double> culled = mean_frames(rows, &SavingRow::Effect::culled),
                            all = mean_frames(rows, &SavingRow::Effect::all);
  std::vector<double> ratios;
  for (size_t round = 0; round < std::min(culled.size(), all.size()); ++round)
    if (all[round] > 0) ratios.push_back(culled[round] / all[round]);
  return ratios.empty() ? std::nullopt : std::optional(interval_or_range(ratios));
}

}  // namespace

std::vector<Table> saving_tables(const Record& record) {
  std::vector<Table> tables;
  for (const auto& [backend, rows] : by_backend(record)) {
    if (rows.empty()) continue;
    const bool timed = times_shown(record, backend);
    Table& table = tables.emplace_back(Table{
        .caption = fmt::format("{}: each effect in the frame of what the scene calls for (culled), and in the frame in which "
                               "everything runs that can (all); a frame's means over {} view{}",
                               backend, rows.size(), rows.size() == 1 ? "" : "s"),
        .columns = {words_column("effect"), words_column("called for"), figures_column("culled ms"), figures_column("all ms"),
                    number_column("culled fetches"), number_column("all"), number_column("culled operations"),
                    number_column("all"), number_column("culled targets"), number_column("all")}});
    for (size_t effect = 0; effect < rows.front()->effects.size(); ++effect) {
      const SavingRow::Effect& of = rows.front()->effects[effect];
      table.rows.push_back(row_of(cells_of(of.effect,
                                           of.called_for       ? "yes"
                                           : of.cannot.empty() ? "no"
                                                               : "no, and cannot run",
                                           mean_cost(rows, effect, &SavingRow::Effect::culled),
                                           mean_cost(rows, effect, &SavingRow::Effect::all), timed)));
    }
    table.rows.push_back(
        row_of(cells_of("the frame", "", whole_frame(rows, &SavingRow::Effect::culled, &SavingRow::culled_frame_bytes),
                        whole_frame(rows, &SavingRow::Effect::all, &SavingRow::all_frame_bytes), timed),
               Mark::baseline));
  }
  return tables;
}

std::vector<Headline> saving_headlines(const Record& record) {
  std::vector<Headline> lines;
  for (const auto& [backend, rows] : by_backend(record)) {
    for (const SavingRow& row : record.savings)
      if (row.backend == backend && !row.failure.empty())
        lines.push_back({backend, fmt::format("view {}: no figures: {}", row.view, row.failure)});
    if (rows.empty()) continue;
    const EffectCost culled = whole_frame(rows, &SavingRow::Effect::culled, &SavingRow::culled_frame_bytes),
                     all = whole_frame(rows, &SavingRow::Effect::all, &SavingRow::all_frame_bytes);
    std::string words = fmt::format(
        "{} operations in place of {}, {} fetches in place of {}, targets of {} in place of {}, "
        "textures of {} in place of {}",
        words_of_count(culled.operations), words_of_count(all.operations), words_of_count(culled.fetches),
        words_of_count(all.fetches), byte_words(static_cast<uint64_t>(culled.target_bytes)),
        byte_words(static_cast<uint64_t>(all.target_bytes)), byte_words(rows.front()->culled_texture_bytes),
        byte_words(rows.front()->all_texture_bytes));
    if (const SavingRow& first = *rows.front(); first.culled_memory_bytes && first.all_memory_bytes)
      words += fmt::format("; where targets share memory they take {} of the device in place of {}",
                           byte_words(*first.culled_memory_bytes), byte_words(*first.all_memory_bytes));
    if (const auto ratio = frame_ratio(rows); ratio && times_shown(record, backend))
      words = fmt::format("the frame takes {} of the time that everything takes: {}", words_for_ratio(*ratio), words);
    lines.push_back({backend, words});
    size_t same = 0;
    for (const SavingRow* row : rows) {
      same += row->different_pixels == 0 ? 1 : 0;
      if (row->different_pixels > 0)
        lines.push_back({backend, fmt::format("view {}: {} pixels DIFFER between the two frames, by {:.3g} at most, at {}",
                                              row->view, row->different_pixels, row->largest_difference, row->where)});
    }
    if (same == rows.size()) lines.push_back({backend, "the pictures of both frames are the same to the bit in every view"});
    for (const SavingRow::Effect& effect : rows.front()->effects)
      if (!effect.cannot.empty())
        lines.push_back({backend, fmt::format("{} has no part in it: {}", effect.effect, effect.cannot)});
  }
  return lines;
}

std::vector<SavingBars> saving_bars(const Record& record) {
  std::vector<SavingBars> all;
  for (const auto& [backend, rows] : by_backend(record)) {
    if (rows.empty()) continue;
    SavingBars& bars = all.emplace_back(SavingBars{.backend = backend, .timed = times_shown(record, backend), .bars = {}});
    for (size_t effect = 0; effect < rows.front()->effects.size(); ++effect) {
      const EffectCost culled = mean_cost(rows, effect, &SavingRow::Effect::culled),
                       whole = mean_cost(rows, effect, &SavingRow::Effect::all);
      const auto value = [&](const EffectCost& cost) {
        return !bars.timed ? cost.operations : cost.ms.empty() ? 0.0 : median(cost.ms);
      };
      const SavingRow::Effect& of = rows.front()->effects[effect];
      if (value(culled) > 0 || value(whole) > 0) bars.bars.push_back({of.effect, of.called_for, value(culled), value(whole)});
    }
    std::ranges::stable_sort(bars.bars, std::greater{}, [](const SavingBar& bar) { return bar.all - bar.culled; });
  }
  return all;
}

}  // namespace lamina
