// SPDX-License-Identifier: Apache-2.0
// What the reports share: the same words and the same rounding whether a terminal, Markdown or a page shows them. All strings
// are plain text, not yet escaped for where they go.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/frontier.h"
#include "reports/reports.h"
#include "reports/tables/table.h"

namespace lamina {

// The median with its 95% interval, or the whole range below min_rounds_for_95 samples, whose coverage says so.
Interval interval_or_range(std::vector<double> samples);

// ---- Numbers -------------------------------------------------------------------------------------------------------------

std::string words_for_ms(double ms);                 // three significant digits or more, no unit
std::string words_for_ms(const Interval& ms);        // "12.31 [12.10, 12.52]", with a * where it covers less than 95%
std::string words_for_ratio(const Interval& ratio);  // "0.476 [0.470, 0.483]", likewise
std::string words_for_psnr(double psnr_db);          // "34.2", or "inf"
inline constexpr double report_confidence = 0.95;    // an interval that covers less is marked

// ---- Paragraphs and tables -----------------------------------------------------------------------------------------------

// "heart, 512x512, 3 views" and what else a title should say.
std::string title_of(const Record& record);
// What makes the figures worth less, one sentence each: a build that is not release, a record cut short, a timer that cannot be
// believed, the run's own warnings.
std::vector<std::string> warnings_of(const Record& record);
struct Headline {
  std::string variant, words;
};
// What failed, and why, a sentence a variant.
std::vector<Headline> failure_headlines(const std::vector<SummaryRow>& rows);
// The variants worth having as worth_having() finds them, from the closest to the cheapest, with what each costs and loses: a
// table an effect and reference, grouped by backend. None for an effect with fewer than two on every backend.
std::vector<Table> choices_tables(const std::vector<SummaryRow>& rows);
// A paragraph an effect and reference (baseline, truth): the variants worth having, the dominated ones, those not told apart
// and those beyond a limit, by time (by fetches where nothing is timed) and mean SSIM; `variant` holds the effect's name. None
// for an effect with nothing to weigh.
std::vector<Headline> worth_having(const std::vector<SummaryRow>& rows);
// "not a picture" where the first failure says so, else "failed".
std::string words_for_failure(const SummaryRow& row);
// The run's limits, in words: "SSIM of at least 0.7"; none in a record of before.
std::vector<std::string> limit_words(const Record& record);
// "SSIM 0.3004, limit 0.7": the first limit that these figures to the baseline do not keep; "" where they keep all.
std::string beyond_limit(const Record& record, const ErrorFigures& to_baseline);
// A row as the frontier weighs it; a baseline without trouble has no error against itself, a row with failed views none at all.
CostAndErrors figures_of(const SummaryRow& row);

// What was swept, a parameter a line.
std::vector<std::string> sweep_lines(const Record& record);
// Where curves meet a limit or each other, a sentence each; `variant` holds the effect's name where the record has several.
// What is the same on several backends, figure by figure as printed, is said once for all of them.
enum class Crossovers { all, about_limits, of_pairs };
std::vector<Headline> crossover_headlines(const Record& record, Crossovers which = Crossovers::all);

// The summary, a table an effect; a row's note is its trouble. `truth`: with columns against the truth, for effects of which
// some row has any.
std::vector<Table> summary_tables(const std::vector<SummaryRow>& rows, bool truth);
// What a row cannot show in figures: failed views with the first reason, non-finite pixels. "" for most.
std::string trouble_of(const SummaryRow& row);
// How to read the table, one sentence each.
std::vector<std::string> summary_notes(const std::vector<SummaryRow>& rows);

// Which of a cell's assumptions costs the most, by RMSE in linear light, as a sentence.
std::string costliest_assumption(const CellRow& cell);

// A pass of a variant on a backend, over the views that have it.
struct PassSummary {
  struct Share {
    std::string texture, format, filter;
    bool is_3d = false;
    uint64_t fetches = 0;          // over all views
    double per_pixel = 0;          // fetches / covered pixels
    std::vector<uint64_t> levels;  // how often each was read, over all views; empty where some view's are not known
  };
  struct Line {
    std::string file;
    uint64_t line = 0;
    double fetches = 0, operations = 0;  // executed / covered pixels
  };
  std::string effect, variant, backend, name;
  bool once = false;
  bool early_tests = true;  // false in some view: fragments hidden later are counted too
  size_t views = 0;
  std::optional<double> ms;  // mean over views of the median over rounds
  double fragments = 0;      // mean over views
  std::optional<double> fetches_per_pixel;
  std::optional<double> ns_per_fetch;  // the pass's time over its fetches; absent where it is not timed or fetches nothing
  std::vector<Share> shares;
  std::map<std::string, double> operations;  // by class (harness/shader/operations.h): executed / covered pixels
  double operations_per_pixel() const;
  std::vector<Line> lines;  // the five dearest, as in LineRow
};
std::vector<PassSummary> summarize_passes(const Record& record);
Table passes_table(const std::vector<PassSummary>& passes);
std::string words_for_fragments(const PassSummary& pass);      // "5210", or "5210, hidden ones too"
std::string words_for_share(const PassSummary::Share& share);  // "light_map (rgba16_float, linear) 13.0/px, level 1.5"
std::string words_for_line(const PassSummary::Line& line);     // "fog/sum.frag:12 8.0 operations/px, 1.0 fetches/px"
// The kind of work that a class of operations belongs to, as charts group them: "add" is "add, multiply".
std::string_view operation_group(std::string_view operation);

// What each effect costs in the frame of what the scene calls for and in the frame of everything, means over views, a table a
// backend; no times where its timer is not good. None where the record holds no such frames.
std::vector<Table> saving_tables(const Record& record);
// The answer of each backend in a sentence, and what is wrong: pictures that differ, effects that have no part and why.
std::vector<Headline> saving_headlines(const Record& record);
struct SavingBar {
  std::string effect;
  bool called_for = false;
  double culled = 0, all = 0;  // ms where the backend's times are shown, else operations
};
struct SavingBars {
  std::string backend;
  bool timed = false;
  std::vector<SavingBar> bars;  // the greatest saving first; without effects that cost nothing in both
};
std::vector<SavingBars> saving_bars(const Record& record);

struct Certificate {
  std::string backend;
  bool ok = false;
  std::string words;
};
std::vector<Certificate> certificates(const Record& record);
// "layered_material: called for: the reason"; its features with or without, and the passes that this left out, with theirs.
std::vector<std::string> plan_lines(const Record& record);
// What was done before the first frame: "apertures of ground (aperture_lighting): ..."; no rays a second from the cache.
std::vector<std::string> bake_lines(const Record& record);
// How long the timed rounds took by the wall clock, over the device time that they measured.
std::vector<std::string> phase_lines(const Record& record);
// Every failed cell: what it is, and why it failed.
std::vector<std::pair<std::string, std::string>> failures(const Record& record);
// Which shaders and pictures they were: a line a variant and backend, a line a picture.
std::vector<std::string> hash_lines(const Record& record);
// What parts a record from the others on a page: "A: abc1234" (letter and commit), or "" where there is one record.
std::string record_name(const std::vector<Record>& records, size_t index);
// Label and value: machine, devices, threads, commit, settings, command.
std::vector<std::pair<std::string, std::string>> run_facts(const Record& record);

// The text with each control character (newlines included) as a space.
std::string one_line(std::string_view text);
// The text as one field of a CSV line: quoted where it must be.
std::string csv_field(const std::string& text);

}  // namespace lamina
