// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/calibration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>

#include "harness/gate/verdict.h"

namespace lamina {
namespace {

constexpr std::array outcomes = {Verdict::same, Verdict::faster, Verdict::slower, Verdict::ambiguous};

[[noreturn]] void refuse(const std::filesystem::path& file, size_t line, const std::string& what) {
  throw Error(ErrorKind::bad_input, "gate", fmt::format("{}:{}", file.string(), line),
              what + "; remove the file, or choose another folder with --out");
}

// How the gates of one slow-down ended.
struct Tally {
  size_t gates = 0;
  std::map<Verdict, size_t> ended;
  double ratio_sum = 0;
  size_t ratios = 0;
};

}  // namespace

CalibratedGate judge_calibrated(double slow_down, const std::vector<PairsRow>& pairs, double family_error,
                                const std::string& pass) {
  const TimeReport report = judge_pairs(pairs, {}, family_error);
  const Verdict verdict = outcome_of(report.rows).verdict;
  CalibratedGate gate{slow_down, verdict == Verdict::failed ? Verdict::slower : verdict, {}};
  for (const VerdictRow& row : report.rows)
    if (row.pass == pass) gate.ratios.push_back(row.ratio->median);
  return gate;
}

nlohmann::ordered_json to_json(const CalibratedGate& gate) {
  return {{"slow_down", gate.slow_down}, {"verdict", name_of(gate.verdict)}, {"ratios", gate.ratios}};
}

CalibratedGate calibrated_from_json(const nlohmann::json& line) {
  const std::string verdict = line.at("verdict");
  for (const Verdict outcome : outcomes)
    if (name_of(outcome) == verdict) return {line.at("slow_down"), outcome, line.at("ratios").get<std::vector<double>>()};
  throw Error(ErrorKind::bad_input, "gate", "calibration", fmt::format("'{}' is no verdict of a gate on times", verdict));
}

std::vector<nlohmann::json> read_calibration(const std::filesystem::path& file) {
  std::vector<nlohmann::json> lines;
  std::ifstream stream(file, std::ios::binary);
  for (std::string text; std::getline(stream, text);) {
    if (stream.eof()) break;  // no newline: cut short
    nlohmann::json line = nlohmann::json::parse(text, nullptr, false);
    if (line.is_discarded()) refuse(file, lines.size() + 1, "is no JSON");
    if (lines.empty() && !(line.is_object() && line.contains("kind") && line["kind"] == "calibration"))
      refuse(file, 1, "is no calibration of lamina gate");
    if (!lines.empty()) try {
        calibrated_from_json(line);
      } catch (const std::exception& error) {
        refuse(file, lines.size() + 1, fmt::format("is no gate of a calibration ({})", error.what()));
      }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::pair<double, double> share_interval(size_t hits, size_t of) {
  constexpr double z = 1.959964;
  const double n = static_cast<double>(of), p = static_cast<double>(hits) / n, scale = 1 / (1 + z * z / n);
  const double center = (p + z * z / (2 * n)) * scale;
  const double half = z * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n)) * scale;
  return {std::max(0.0, center - half), std::min(1.0, center + half)};
}

std::string calibration_table(std::span<const CalibratedGate> gates) {
  std::map<double, Tally> tallies;
  for (const CalibratedGate& gate : gates) {
    Tally& tally = tallies[gate.slow_down];
    ++tally.gates, ++tally.ended[gate.verdict];
    for (const double ratio : gate.ratios) tally.ratio_sum += ratio, ++tally.ratios;
  }
  std::string text =
      "| slow-down of one pass | gates | found slower (95% interval) | ambiguous | the same | ratio measured |\n"
      "|---|---:|---:|---:|---:|---:|\n";
  for (auto& [slow_down, tally] : tallies) {
    const bool equal = slow_down == 0;
    const auto percent = [&, of = static_cast<double>(tally.gates)](size_t count) {
      return 100 * static_cast<double>(count) / of;
    };
    const size_t found = tally.ended[Verdict::slower] + (equal ? tally.ended[Verdict::faster] : 0);
    const size_t same = tally.ended[Verdict::same] + (equal ? 0 : tally.ended[Verdict::faster]);
    const auto [low, high] = share_interval(found, tally.gates);
    text += fmt::format("| {} | {} | {:.1f}% ({:.1f} to {:.1f}) | {:.1f}% | {:.1f}% | {} |\n",
                        equal ? "none: false alarms" : fmt::format("{:.0f}%", slow_down * 100), tally.gates, percent(found),
                        low * 100, high * 100, percent(tally.ended[Verdict::ambiguous]), percent(same),
                        tally.ratios > 0 ? fmt::format("{:.4f}", tally.ratio_sum / static_cast<double>(tally.ratios)) : "-");
  }
  return text;
}

}  // namespace lamina
