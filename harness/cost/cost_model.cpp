// SPDX-License-Identifier: Apache-2.0
#include "harness/cost/cost_model.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "harness/core/error.h"
#include "harness/cost/nonnegative_fit.h"
#include "harness/measure/statistics.h"

namespace lamina {
namespace {

constexpr size_t folds = 10, resamples = 200;
constexpr uint64_t seed = 1;  // any: of the folds and of the resamples
constexpr double ns_of_ms = 1e6;

std::vector<std::string> kinds_of(std::span<const TimedFrame> frames, CountedWork counted) {
  std::set<std::string> kinds;
  for (const TimedFrame& frame : frames)
    for (const TimedPass& pass : frame.passes)
      for (const auto& [kind, amount] : pass.of(counted)) kinds.insert(kind);
  return {kinds.begin(), kinds.end()};
}

std::vector<std::string> variants_of(std::span<const TimedFrame> frames) {
  std::set<std::string> variants;
  for (const TimedFrame& frame : frames) variants.insert(frame.variant);
  return {variants.begin(), variants.end()};
}

using Weights = std::map<std::string, double>;  // ms of one

double told(const Weights& weights, const TimedFrame& frame, CountedWork counted) {
  double ms = 0;
  for (const TimedPass& pass : frame.passes)
    for (const auto& [kind, amount] : pass.of(counted))
      if (const auto weight = weights.find(kind); weight != weights.end()) ms += weight->second * amount;
  return ms;
}

// What is fitted to: a row for each frame and one for each of its passes, divided by what they should give. A pass's row counts
// by the square root of its share of the frame, so that a short pass is told too, but no error of it outweighs the frame's.
class FitRows {
 public:
  // `times[i]`: how often frame i counts.
  FitRows(std::span<const TimedFrame> frames, CountedWork counted, std::span<const size_t> times)
      : kinds_(kinds_of(frames, counted)) {
    for (size_t i = 0; i < frames.size(); ++i) {
      const double frame_ms = frames[i].ms();
      if (times[i] == 0 || !(frame_ms > 0)) continue;
      std::vector<double> whole(kinds_.size(), 0);
      for (const TimedPass& pass : frames[i].passes) {
        std::vector<double> row = row_of(pass.of(counted));
        for (size_t k = 0; k < row.size(); ++k) whole[k] += row[k];
        if (pass.ms > 0) add(std::move(row), pass_weight / std::sqrt(pass.ms * frame_ms), pass.ms, times[i]);
      }
      add(std::move(whole), 1 / frame_ms, frame_ms, times[i]);
    }
  }

  Weights fit() const {
    const std::vector<double> fitted = fit_least_absolute(rows_, targets_, small_error, ridge);
    Weights weights;
    for (size_t k = 0; k < kinds_.size(); ++k) weights[kinds_[k]] = fitted[k];
    return weights;
  }

 private:
  static constexpr double pass_weight = 0.2, small_error = 0.03, ridge = 1e-3;  // chosen by frames left out

  std::vector<double> row_of(const PassWork& work) const {
    std::vector<double> row(kinds_.size(), 0);
    for (const auto& [kind, amount] : work)
      row[static_cast<size_t>(std::ranges::lower_bound(kinds_, kind) - kinds_.begin())] = amount;
    return row;
  }
  void add(std::vector<double> row, double weight, double ms, size_t times) {
    for (double& amount : row) amount *= weight;
    rows_.insert(rows_.end(), times, row);
    targets_.insert(targets_.end(), times, ms * weight);
  }

  std::vector<std::string> kinds_;
  std::vector<std::vector<double>> rows_;
  std::vector<double> targets_;
};

Weights fit(std::span<const TimedFrame> frames, CountedWork counted, std::span<const size_t> times) {
  return FitRows(frames, counted, times).fit();
}

std::vector<double> ranks_of(std::span<const double> values) {
  std::vector<size_t> order(values.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::ranges::sort(order, {}, [&](size_t i) { return values[i]; });
  std::vector<double> ranks(values.size());
  for (size_t first = 0, last = 0; first < order.size(); first = last) {
    while (last < order.size() && values[order[last]] == values[order[first]]) ++last;
    for (size_t i = first; i < last; ++i) ranks[order[i]] = static_cast<double>(first + last - 1) / 2;
  }
  return ranks;
}

}  // namespace

double TimedFrame::ms() const {
  return std::accumulate(passes.begin(), passes.end(), 0.0, [](double sum, const TimedPass& pass) { return sum + pass.ms; });
}

std::vector<TimedFrame> timed_frames(std::span<const CellRow> cells) {
  std::vector<TimedFrame> frames;
  for (const CellRow& cell : cells) {
    if (cell.failed || !cell.timed) continue;
    TimedFrame frame{.variant = cell.effect + "/" + cell.variant, .passes = {}};
    bool told = true;
    for (const PassRow& pass : cell.passes) {
      if (pass.once) continue;
      told = told && pass.fragments && !pass.ms.empty() && (pass.operations.empty() == pass.issued.empty());
      if (told)
        frame.passes.push_back({work_of(pass, CountedWork::executed), work_of(pass, CountedWork::issued), median(pass.ms)});
    }
    if (told && frame.ms() > 0) frames.push_back(std::move(frame));
  }
  return frames;
}

CostJudgement judge_cost_model(std::span<const TimedFrame> frames, CountedWork counted) {
  std::vector<std::string> variants = variants_of(frames);
  std::shuffle(variants.begin(), variants.end(), std::mt19937_64(seed));
  std::map<std::string, size_t> fold_of;
  for (size_t i = 0; i < variants.size(); ++i) fold_of[variants[i]] = i % folds;
  std::vector<double> predicted, measured, errors;
  for (size_t fold = 0; fold < folds; ++fold) {
    std::vector<size_t> times;
    for (const TimedFrame& frame : frames) times.push_back(fold_of.at(frame.variant) == fold ? 0 : 1);
    const Weights weights = fit(frames, counted, times);
    for (size_t i = 0; i < frames.size(); ++i) {
      if (times[i] > 0) continue;
      predicted.push_back(told(weights, frames[i], counted));
      measured.push_back(frames[i].ms());
      errors.push_back(std::abs(predicted.back() / measured.back() - 1));
    }
  }
  return {.rank_correlation = rank_correlation(predicted, measured),
          .mean_error = std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size()),
          .median_error = median(errors),
          .frames = frames.size(),
          .variants = variants.size()};
}

CostModel fit_cost_model(std::span<const TimedFrame> frames) {
  const std::vector<std::string> variants = variants_of(frames);
  if (variants.size() < folds)
    throw Error(
        ErrorKind::bad_input, "cost model", "fit",
        fmt::format("needs timed and counted frames of at least {} variants, and has those of {}", folds, variants.size()));
  CostModel model;
  const CostJudgement executed = judge_cost_model(frames, CountedWork::executed);
  const CostJudgement issued = judge_cost_model(frames, CountedWork::issued);
  model.counted = issued.mean_error < executed.mean_error ? CountedWork::issued : CountedWork::executed;
  model.judged = model.counted == CountedWork::issued ? issued : executed;
  for (const auto& [kind, ms] : fit(frames, model.counted, std::vector<size_t>(frames.size(), 1)))
    model.weights[kind].ns = ms * ns_of_ms;

  std::mt19937_64 random(seed);
  std::uniform_int_distribution<size_t> any(0, variants.size() - 1);
  std::map<std::string, std::vector<double>> drawn;
  for (size_t i = 0; i < resamples; ++i) {
    std::map<std::string, size_t> often;
    for (size_t k = 0; k < variants.size(); ++k) ++often[variants[any(random)]];
    std::vector<size_t> times;
    for (const TimedFrame& frame : frames) times.push_back(often.contains(frame.variant) ? often.at(frame.variant) : 0);
    for (const auto& [kind, ms] : fit(frames, model.counted, times)) drawn[kind].push_back(ms * ns_of_ms);
  }
  for (auto& [kind, values] : drawn) {
    std::ranges::sort(values);
    model.weights[kind].low = values[values.size() * 25 / 1000];
    model.weights[kind].high = values[values.size() * 975 / 1000];
  }
  return model;
}

double predicted_ms(const CostModel& model, std::span<const PassRow> passes, std::vector<std::string>* unknown) {
  double ns = 0;
  for (const PassRow& pass : passes) {
    if (pass.once) continue;
    for (const auto& [kind, amount] : work_of(pass, model.counted)) {
      if (const auto weight = model.weights.find(kind); weight != model.weights.end())
        ns += weight->second.ns * amount;
      else if (unknown && amount > 0 && std::ranges::find(*unknown, kind) == unknown->end())
        unknown->push_back(kind);
    }
  }
  return ns / ns_of_ms;
}

double rank_correlation(std::span<const double> a, std::span<const double> b) {
  const std::vector<double> x = ranks_of(a), y = ranks_of(b);
  const double mean = static_cast<double>(x.size() - 1) / 2;
  double xy = 0, xx = 0, yy = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    xy += (x[i] - mean) * (y[i] - mean);
    xx += (x[i] - mean) * (x[i] - mean);
    yy += (y[i] - mean) * (y[i] - mean);
  }
  return xx > 0 && yy > 0 ? xy / std::sqrt(xx * yy) : 0;
}

nlohmann::ordered_json to_json(const CostModel& model) {
  nlohmann::ordered_json weights = nlohmann::ordered_json::object();
  for (const auto& [kind, weight] : model.weights)
    weights[kind] = {{"ns", weight.ns}, {"low", weight.low}, {"high", weight.high}};
  return {{"kind", "cost_model"},
          {"backend", model.backend},
          {"device", model.device},
          {"counted", model.counted == CountedWork::issued ? "issued" : "executed"},
          {"judged",
           {{"rank_correlation", model.judged.rank_correlation},
            {"mean_error", model.judged.mean_error},
            {"median_error", model.judged.median_error},
            {"frames", model.judged.frames},
            {"variants", model.judged.variants}}},
          {"weights", weights}};
}

CostModel cost_model_from_json(const nlohmann::json& json, const std::string& object) {
  try {
    if (json.at("kind") != "cost_model") throw Error(ErrorKind::bad_input, "cost model", object, "is no cost model");
    CostModel model;
    model.backend = json.at("backend");
    model.device = json.at("device");
    model.counted = json.at("counted") == "issued" ? CountedWork::issued : CountedWork::executed;
    const nlohmann::json& judged = json.at("judged");
    model.judged = {.rank_correlation = judged.at("rank_correlation"),
                    .mean_error = judged.at("mean_error"),
                    .median_error = judged.at("median_error"),
                    .frames = judged.at("frames"),
                    .variants = judged.at("variants")};
    for (const auto& [kind, weight] : json.at("weights").items())
      model.weights[kind] = {.ns = weight.at("ns"), .low = weight.at("low"), .high = weight.at("high")};
    return model;
  } catch (const nlohmann::json::exception&) {
    throw Error(ErrorKind::bad_input, "cost model", object, "lacks a field, or has one of another type; calibrate again");
  }
}

}  // namespace lamina
