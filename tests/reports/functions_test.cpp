// SPDX-License-Identifier: Apache-2.0
// Functions in the reports: which variants nothing beats, what is said of each, and the chart's data.
#include "reports/functions.h"

#include <gtest/gtest.h>

#include "reports/html/html.h"
#include "tests/record/function_rows.h"
#include "tests/reports/example_record.h"

namespace lamina {
namespace {

void add(Record& record, const std::string& variant, double error, std::optional<double> ns,
         const std::string& backend = "vulkan") {
  const FunctionSubject subject = example_subject(variant, backend);
  record.functions.push_back(read_back(example_function(subject, error)));
  FunctionRow hard = example_function(subject, 2 * error, "tiny");
  hard.negative = variant == "naive_cap" ? 41 : 0;
  record.functions.push_back(read_back(hard));
  FunctionTimeRow time = example_time(subject, ns.value_or(1));
  if (!ns) time.ns_per_call.reset(), time.reason = "the machine is busy";
  record.function_times.push_back(read_back(time));
  record.function_pictures.push_back(example_picture(subject));
}

// On paper: exact 1e-6 at 40 ns, fitted 0.02 at 4, linear 0.1 at 2; smoothstep 0.2 at 2.1 and naive 0.3 at 10 are beaten.
Record caps(std::vector<CellRow> cells = {}) {
  Record record = example_record(cells);
  for (const auto& [variant, error, ns] : {std::tuple{"smoothstep_cap", 0.2, 2.1},
                                           {"exact_cap", 1e-6, 40.0},
                                           {"naive_cap", 0.3, 10.0},
                                           {"fitted_cap", 0.02, 4.0},
                                           {"linear_cap", 0.1, 2.0}})
    add(record, variant, error, ns);
  return record;
}

const FunctionSummary& row(const FunctionReport& report, const std::string& variant) {
  for (const FunctionSummary& one : report.backends.at(0).variants)
    if (one.variant == variant) return one;
  throw std::runtime_error("no " + variant);
}

std::string words(const FunctionReport& report, const std::string& variant) {
  for (const Headline& headline : function_headlines(report))
    if (headline.variant == variant) return headline.words;
  return "";
}

TEST(Functions, TheFrontierIsWhatNothingBeatsInBoth) {
  const Record record = caps();
  const auto reports = summarize_functions(record);
  ASSERT_EQ(reports.size(), 1u);
  ASSERT_EQ(reports[0].backends.size(), 1u);
  ASSERT_EQ(reports[0].backends[0].variants.size(), 5u);
  EXPECT_EQ(reports[0].backends[0].variants[0].variant, "exact_cap");
  EXPECT_EQ(reports[0].main_set, "overlaps");
  for (const char* on : {"exact_cap", "fitted_cap", "linear_cap"}) EXPECT_TRUE(row(reports[0], on).frontier()) << on;
  for (const char* off : {"smoothstep_cap", "naive_cap"}) EXPECT_FALSE(row(reports[0], off).frontier()) << off;
  EXPECT_DOUBLE_EQ(*row(reports[0], "fitted_cap").ratio, 0.1);
  EXPECT_DOUBLE_EQ(*row(reports[0], "fitted_cap").error, 0.02);
}

TEST(Functions, EqualInBothBeatsNeither) {
  Record record = example_record({});
  add(record, "a_cap", 0.5, 3), add(record, "b_cap", 0.5, 3), add(record, "c_cap", 0.5, 5);
  const auto reports = summarize_functions(record);
  EXPECT_TRUE(row(reports[0], "a_cap").frontier());
  EXPECT_TRUE(row(reports[0], "b_cap").frontier());
  EXPECT_FALSE(row(reports[0], "c_cap").frontier());
}

TEST(Functions, WhatErrsMoreMustBeFasterBeyondTheNoise) {
  Record record = example_record({});
  add(record, "close_cap", 0.1, 10), add(record, "noisy_cap", 0.2, 8.5), add(record, "fast_cap", 0.3, 8);  // each +-10%
  const auto reports = summarize_functions(record);
  EXPECT_TRUE(row(reports[0], "close_cap").frontier());
  EXPECT_FALSE(row(reports[0], "noisy_cap").frontier()) << "up to 9.35 ns, where close_cap takes 9 to 11";
  EXPECT_FALSE(row(reports[0], "fast_cap").frontier()) << "beaten by noisy_cap: up to 8.8 ns against 7.65 to 9.35";
  record.function_times.back().ns_per_call->high = 7.6;
  EXPECT_TRUE(row(summarize_functions(record)[0], "fast_cap").frontier());
}

TEST(Functions, ErrorsAreTheGreaterOfOverAndUnder) {
  Record record = example_record({});
  add(record, "a_cap", 0.5, 3);
  record.functions[0].max_under = -0.75;
  EXPECT_DOUBLE_EQ(*row(summarize_functions(record)[0], "a_cap").error, 0.75);
}

TEST(Functions, ValuesThatAreNotFiniteHaveNoGreatestErrorAndNoPlaceOnTheFrontier) {
  Record record = caps();
  for (FunctionRow& each : record.functions)
    if (each.subject.variant == "linear_cap" && each.set == "overlaps") each.nonfinite = 1;
  const auto reports = summarize_functions(record);
  EXPECT_FALSE(row(reports[0], "linear_cap").error);
  EXPECT_FALSE(row(reports[0], "linear_cap").frontier());
  EXPECT_TRUE(row(reports[0], "smoothstep_cap").frontier()) << "what beat it counts no more";
  EXPECT_TRUE(has(words(reports[0], "linear_cap"), "gives values that are not finite, so"));
  EXPECT_TRUE(has(html_function_chart(reports[0]), "linear_cap on vulkan."));
}

TEST(Functions, WordsSayWhatIsWorthHavingAndWhatBeatsTheRest) {
  const Record record = caps();
  const auto reports = summarize_functions(record);
  const FunctionReport& report = reports[0];
  EXPECT_EQ(words(report, "fitted_cap"),
            "is worth having: nothing closer is as fast. It errs by up to 0.02 of the smaller cap's area; a call takes 4 "
            "ns (10.0 times faster than exact_cap).");
  EXPECT_TRUE(has(words(report, "naive_cap"), "is beaten by fitted_cap, which errs by up to 0.02 and is no slower."))
      << words(report, "naive_cap");
  EXPECT_TRUE(has(words(report, "naive_cap"), "Over all sets it gives 41 negative and 0 non-finite values."));
  EXPECT_TRUE(has(words(report, "smoothstep_cap"),
                  "is not told apart in time from linear_cap, which errs by up to 0.1; more rounds would tell."))
      << words(report, "smoothstep_cap");
}

TEST(Functions, WordsTellBackendsApartWhereTheyDiffer) {
  Record record = caps();
  add(record, "exact_cap", 1e-6, 50, "osmesa"), add(record, "linear_cap", 0.1, 100, "osmesa");
  add(record, "fitted_cap", 0.02, std::nullopt, "osmesa");
  const auto reports = summarize_functions(record);
  EXPECT_EQ(
      words(reports[0], "linear_cap"),
      "is worth having: nothing closer is as fast on vulkan and is beaten by exact_cap, which errs by up to 1e-06 and is no "
      "slower on osmesa. It errs by up to 0.1 of the smaller cap's area; a call takes 2 ns (20.0 times faster than "
      "exact_cap) on vulkan and 100 ns (2.0 times slower than exact_cap) on osmesa.");
  EXPECT_TRUE(has(words(reports[0], "fitted_cap"), "on vulkan and was not timed on osmesa."))
      << words(reports[0], "fitted_cap");
  EXPECT_TRUE(has(words(reports[0], "fitted_cap"), "a call takes 4 ns (10.0 times faster than exact_cap) on vulkan."))
      << "a time of one backend is not that of both: " << words(reports[0], "fitted_cap");
}

TEST(Functions, WithoutATimerThereAreErrorsButNeitherTimesNorAChart) {
  Record record = example_record({});
  add(record, "exact_cap", 1e-6, std::nullopt), add(record, "linear_cap", 0.1, std::nullopt);
  const std::string page = page_of(record);
  EXPECT_TRUE(has(page, "not timed"));
  EXPECT_TRUE(has(page, "the machine is busy"));
  EXPECT_TRUE(has(page, "errs by up to 0.1"));
  EXPECT_FALSE(has(page, "worth having"));
  EXPECT_FALSE(has(page, "class=\"chart\""));
  EXPECT_FALSE(has(page, "Observable"));
}

TEST(Functions, TablesShowEachFigure) {
  const Record record = caps(example_cells());
  const auto reports = summarize_functions(record);
  const auto cells = function_cells(row(reports[0], "linear_cap"));
  EXPECT_EQ(cells,
            (std::vector<std::string>{"linear_cap", "2 [1.8, 2.2]", "0.050", "0.1", "-0.05", "0.025", "0.033", "0", "0"}));
  EXPECT_EQ(function_set_cells(record.functions[0]).front(), "smoothstep_cap");
  EXPECT_EQ(function_set_cells(record.functions[0])[12], "0.5 0.25 0.125");
  for (const std::string& text : {page_of(record), markdown_summary(record)}) {
    EXPECT_TRUE(has(text, "Functions: the area that two spherical caps share"));
    for (size_t i = 2; i < cells.size(); ++i) EXPECT_TRUE(has(text, cells[i])) << cells[i];
    EXPECT_TRUE(has(text, "1.8, 2.2"));
    EXPECT_TRUE(has(text, "1000 points of"));
    EXPECT_TRUE(has(text, "vertex_normal")) << "cells and functions share one report";
  }
}

// Each way to pass and to fail, on paper: errs by 0.1 and -0.05, eps kappa 7.
FunctionRow case_of(std::optional<FunctionBounds> bounds, uint64_t negative = 0, uint64_t not_zero = 0) {
  FunctionRow row = example_function(example_subject(), 0.1, "tiny");
  row.bounds = bounds, row.negative = negative, row.not_zero = not_zero;
  if (negative + not_zero > 0) row.first_fault = {3, 2, 1};
  return read_back(row);
}

TEST(HardCases, HoldWhereNoErrorIsBeyondItsBoundAndNoValueIsAtFault) {
  EXPECT_EQ(keeps_bounds(case_of({})), Keeps::claims_none);
  EXPECT_EQ(keeps_bounds(case_of(FunctionBounds{0.1, -0.05, {}})), Keeps::yes);
  EXPECT_EQ(keeps_bounds(case_of(FunctionBounds{0.1, -0.05, 7})), Keeps::yes);
  EXPECT_EQ(keeps_bounds(case_of(FunctionBounds{0.1, -0.05, 6.9})), Keeps::no);
  EXPECT_EQ(keeps_bounds(case_of(FunctionBounds{0.099, -0.05, {}})), Keeps::no);
  EXPECT_EQ(keeps_bounds(case_of(FunctionBounds{0.1, -0.049, {}})), Keeps::no);
  EXPECT_EQ(keeps_bounds(case_of(FunctionBounds{0.1, -0.05, {}}, 1)), Keeps::no);
  EXPECT_EQ(keeps_bounds(case_of({}, 0, 1)), Keeps::no);
  FunctionRow none_finite = case_of({});
  none_finite.nonfinite = 1000;
  none_finite = read_back(none_finite);
  EXPECT_FALSE(none_finite.max_over);
  EXPECT_EQ(keeps_bounds(none_finite), Keeps::no);
  EXPECT_EQ(function_set_cells(none_finite)[12], "");
}

TEST(HardCases, PageAndMarkdownSayWhatPassedWhatFailedAndAtWhichInput) {
  Record record = example_record({});
  for (const auto& [set, row] : {std::pair{"box", case_of(FunctionBounds{0.1, -0.05, {}})},
                                 {"tiny", case_of({}, 41)},
                                 {"large", case_of(FunctionBounds{0.01, -0.05, {}})},
                                 {"equal", case_of({})}}) {
    record.functions.push_back(row);
    record.functions.back().set = set;
  }
  for (const std::string& text : {page_of(record), markdown_summary(record)}) {
    EXPECT_TRUE(
        has(text,
            "holds its bounds on 1 of 4 sets; claims nothing on 1, where its values are finite and none is wrongly "
            "negative; FAILS on 2: tiny (41 negative of 1000 values, the first at 3 2 1); large (errs by 0.1 at 0.5 0.25 "
            "0.125, claims -0.05 to 0.01)."))
        << text;
    EXPECT_TRUE(has(text, "Bounds hold where every value is finite"));
  }
  EXPECT_TRUE(has(markdown_summary(record), "| tiny | smoothstep_cap | FAIL | - | 0.1 | -0.05 |"));
  EXPECT_TRUE(has(markdown_summary(record), "| box | smoothstep_cap | hold | -0.05 to 0.1 |"));
  EXPECT_TRUE(has(page_of(record), "<tr class=\"bad\"><th scope=\"row\">smoothstep_cap</th><td>FAIL</td>"));
}

TEST(Functions, ThePageHoldsTheChartItsLibraryAndThePictures) {
  const std::string page = html_report({caps()});
  EXPECT_TRUE(has(page, "<title>Lamina: What functions cost and err by</title>"));
  for (const char* part : {"<figure class=\"chart\">", "<noscript>", "Observable, Inc.", "Mike Bostock", "Permission to use",
                           "src=\"./images/slice.png\"", "r1 = 0.5", "r0 right, d up", "class=\"diverging\"", "-0.16 or less",
                           "<h3>Hard cases on vulkan</h3>", "<summary>Every function and set on vulkan</summary>"})
    EXPECT_TRUE(has(page, part)) << part;
  EXPECT_FALSE(has(page, "<h2>All figures and pictures</h2>"));
  EXPECT_FALSE(has(html_report({example_record({})}), "Observable")) << "no chart, no library";
}

// On paper: the axis runs from 1 to 100 ns, and 10 is in the middle of a logarithmic one; no six rounds, so a range for the
// interval.
TEST(Functions, EveryRoundStandsUnderTheTable) {
  Record record = example_record({});
  for (const auto& [variant, samples] : {std::pair{"exact_cap", std::vector<double>{100, 100}}, {"fitted_cap", {1, 10}}}) {
    add(record, variant, 0.1, 1);
    record.function_times.back().ns = samples;
  }
  const std::string page = page_of(record);
  EXPECT_TRUE(has(page, "<small>every round, 1 to 100 ns a call (log scale)</small>"));
  EXPECT_TRUE(has(page,
                  "<span>fitted_cap</span><svg viewBox=\"0 0 2000 100\" preserveAspectRatio=\"none\" role=\"img\" "
                  "aria-label=\"2 rounds, 1 to 10 ns a call\"><path class=\"interval\" d=\"M0 0H1000V100H0z\"/>"))
      << page.substr(page.find("class=\"rounds\""), 1200);
  EXPECT_TRUE(has(page, "<path class=\"dots\" d=\"m0 70h1m999-40h1\"/>"));
  EXPECT_GT(page.find("class=\"rounds\""), page.find("ns a call [95%]"));
  EXPECT_FALSE(has(page_of(caps()), "class=\"rounds\"")) << "a record of before the rounds were kept";
  EXPECT_EQ(markdown_summary(record).find("every round"), std::string::npos);
  record.function_times.back().ns = {-1, 10};  // noise can make the difference of two runs less than nothing
  EXPECT_TRUE(has(page_of(record), "<small>every round, -1 to 100 ns a call</small>"));
}

TEST(Functions, AReportOfFunctionsAloneDoesNotExplainFramesAndPictures) {
  EXPECT_FALSE(has(page_of(caps()), "Worst view: by FLIP"));
  EXPECT_FALSE(has(markdown_summary(caps()), "Worst view: by FLIP"));
  EXPECT_TRUE(has(page_of(caps(example_cells())), "Worst view: by FLIP"));
}

TEST(Functions, OfSeveralRecordsEachChartNamesItsOwn) {
  std::vector<Record> records = {caps(), caps()};
  records[1].run["commit"] = "def5678";
  const std::string page = html_report(records);
  EXPECT_TRUE(has(page, "\"group\":\"A: abc1234, vulkan\""));
  EXPECT_TRUE(has(page, "\"group\":\"B: def5678, vulkan\""));
}

nlohmann::json chart_data(const std::string& chart) {
  const std::string opening = "<script type=\"application/json\">";
  const size_t begin = chart.find(opening) + opening.size();
  return nlohmann::json::parse(chart.substr(begin, chart.find("</script>", begin) - begin));
}

TEST(FunctionChart, HoldsEveryPointAndEscapesWhatWouldEndTheScript) {
  Record record = caps();
  add(record, "</script><b>\"evil", 0.5, 50);
  add(record, "perfect_cap", 0, 60);
  const std::string chart = html_function_chart(summarize_functions(record)[0]);
  const nlohmann::json data = chart_data(chart);
  ASSERT_EQ(data["points"].size(), 6u) << "an error of 0 has no place on a logarithmic axis";
  EXPECT_TRUE(has(chart, "hides): perfect_cap on vulkan."));
  EXPECT_EQ(data["points"][0]["name"], "exact_cap");
  EXPECT_EQ(data["points"][0]["x"], 40);
  EXPECT_EQ(data["points"][0]["y"], 1e-6);
  EXPECT_EQ(data["points"][0]["low"], 36);
  EXPECT_EQ(data["points"][0]["frontier"], true);
  EXPECT_EQ(data["points"][5]["name"], "</script><b>\"evil");
  EXPECT_FALSE(has(chart, "</script><b>"));
}

TEST(Functions, EveryStringIsEscaped) {
  const std::string evil = "<script>alert(\"1\")</script>&'";
  Record record = example_record({});
  add(record, evil, 0.5, 3, evil);
  const auto make_evil = [&](FunctionSubject& subject) { subject.function = subject.title = subject.device = evil; };
  for (FunctionRow& each : record.functions) make_evil(each.subject), each.scale = each.set = each.what = evil;
  for (FunctionTimeRow& each : record.function_times) make_evil(each.subject), each.build = each.commit = evil;
  for (FunctionPictureRow& each : record.function_pictures) make_evil(each.subject), each.slice = each.axes = each.image = evil;
  const std::string page = page_of(record);
  EXPECT_FALSE(has(page, "alert(\"1"));
  EXPECT_TRUE(has(page, "&lt;script&gt;alert"));
  EXPECT_FALSE(has(markdown_summary(record), "<script>"));
  EXPECT_TRUE(has(page, "not &#39;release&#39;"));
}

TEST(Functions, TheCertificateOfTheirTimerIsTold) {
  Record record = caps();
  record.function_timers.push_back({example_timer("vulkan"), "cap_intersection"});
  EXPECT_TRUE(has(html_run(record),
                  "s certificate on vulkan for calls of cap_intersection holds; 1x, 2x, 4x, 8x "
                  "work took 1.000, 1.010, 0.990, 1.000 of linear"))
      << html_run(record);
  EXPECT_TRUE(warnings_of(record).empty());
  record.function_timers[0] = {example_timer("vulkan", false), "cap_intersection"};
  ASSERT_EQ(warnings_of(record).size(), 1u);
  EXPECT_TRUE(has(warnings_of(record)[0], "on vulkan for calls of cap_intersection FAILED (8x work took 1.4 of linear)"));
}

}  // namespace
}  // namespace lamina
