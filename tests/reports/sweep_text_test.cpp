// SPDX-License-Identifier: Apache-2.0
// A sweep's answers in words: told once where backends agree, under the effect's name where there are several, and no more in a
// terminal than can be read.
#include "reports/sweep/sweep_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "harness/record/sweep_rows.h"
#include "reports/words.h"
#include "tests/reports/example_record.h"

namespace lamina {
namespace {

CrossoverRow answer(const std::string& backend, const std::string& sentence, std::optional<double> limit = std::nullopt,
                    const std::string& effect = "layered_material", const std::string& parameter = "scene.time") {
  CrossoverRow row;
  row.parameter = parameter, row.backend = backend, row.effect = effect, row.variant = "v", row.metric = "ssim";
  row.limit = limit, row.sentence = sentence;
  const std::string place = " on " + backend;
  if (const size_t at = sentence.rfind(place); at != std::string::npos)
    row.claim = sentence.substr(0, at), row.remark = sentence.substr(at + place.size());
  return row;
}

Record with_answers(std::vector<CrossoverRow> answers) {
  Record record = example_record(example_cells());
  record.sweeps.emplace_back();
  record.crossovers = std::move(answers);
  return record;
}

std::vector<std::string> words(const Record& record) {
  std::vector<std::string> all;
  for (const auto& [effect, sentence] : crossover_headlines(record))
    all.push_back(effect + (effect.empty() ? "" : ": ") + sentence);
  return all;
}

using Words = std::vector<std::string>;

TEST(SweepWords, WhatBackendsSayAlikeIsToldOnce) {
  EXPECT_EQ(words(with_answers({answer("vulkan", "a keeps it up to time 1 s, at gain 2 on vulkan"),
                                answer("vulkan", "b is cheaper than a on vulkan; at 1 of 5 points they are equal"),
                                answer("osmesa", "a keeps it up to time 1 s, at gain 2 on osmesa"),
                                answer("osmesa", "b is cheaper than a on osmesa; at 1 of 5 points they are equal"),
                                answer("egl", "b is cheaper than a on egl; at 1 of 5 points they are equal")})),
            (Words{"a keeps it up to time 1 s, at gain 2 on vulkan and osmesa",
                   "b is cheaper than a on vulkan, osmesa and egl; at 1 of 5 points they are equal"}));
}

TEST(SweepWords, WhatDiffersIsToldOfEach) {
  const Words apart = {"a keeps it up to time 1 s on vulkan", "a keeps it up to time 1.1 s on osmesa",
                       "b is cheaper on vulkan; at 1 of 5 points they are equal", "b is cheaper on osmesa"};
  EXPECT_EQ(words(with_answers({answer("vulkan", apart[0]), answer("osmesa", apart[1]), answer("vulkan", apart[2]),
                                answer("osmesa", apart[3])})),
            apart);
  // Two parameters may have one short name.
  EXPECT_EQ(words(with_answers({answer("vulkan", "a keeps it on vulkan", {}, "layered_material", "objects.a.thickness"),
                                answer("vulkan", "a keeps it on vulkan", {}, "layered_material", "objects.b.thickness")}))
                .size(),
            2u);
  EXPECT_EQ(words(with_answers({answer("vulkan", "they meet"), answer("", "on its own")})), (Words{"they meet", "on its own"}));
}

TEST(SweepWords, TheEffectIsNamedWhereThereAreSeveral) {
  Record record = with_answers({answer("vulkan", "a keeps it on vulkan")});
  EXPECT_EQ(words(record), Words{"a keeps it on vulkan"});
  EXPECT_TRUE(has(page_of(record), "<li>a keeps it on vulkan</li>"));
  EXPECT_TRUE(has(markdown_summary(record), "\n- a keeps it on vulkan\n"));
  record.crossovers.push_back(answer("vulkan", "b keeps it on vulkan", {}, "aperture_lighting"));
  EXPECT_EQ(words(record), (Words{"layered_material: a keeps it on vulkan", "aperture_lighting: b keeps it on vulkan"}));
  EXPECT_TRUE(has(page_of(record), "<li><strong>aperture_lighting</strong>: b keeps it on vulkan</li>"));
  EXPECT_TRUE(has(markdown_summary(record), "\n- **aperture_lighting**: b keeps it on vulkan\n"));
  EXPECT_TRUE(has(answers_terminal(record, "out/summary.md"), "aperture_lighting: b keeps it on vulkan\n"));
}

TEST(SweepWords, ATerminalGetsLimitsFirstAndNoMoreThanFitsIt) {
  std::vector<CrossoverRow> answers;
  for (int i = 0; i < 30; ++i) {
    answers.push_back(answer("vulkan", fmt::format("a is better than b{} on vulkan", i)));
    answers.push_back(answer("vulkan", fmt::format("b{} keeps it on vulkan", i), 0.98));
  }
  const std::string text = answers_terminal(with_answers(answers), "out/summary.md");
  EXPECT_EQ(std::ranges::count(text, '\n'), 40);
  EXPECT_TRUE(text.starts_with("b0 keeps it on vulkan\nb1 keeps it on vulkan\n"));
  EXPECT_LT(text.find("b29 keeps it"), text.find("a is better than b0"));
  EXPECT_TRUE(text.ends_with("a is better than b8 on vulkan\n21 more answers are in out/summary.md\n")) << text;
  for (const CrossoverRow& row : answers) EXPECT_TRUE(has(markdown_summary(with_answers(answers)), row.sentence));
  const std::string all = answers_terminal(with_answers({answers.begin(), answers.begin() + 40}), "out/summary.md");
  EXPECT_EQ(std::ranges::count(all, '\n'), 40);
  EXPECT_FALSE(has(all, "more answers"));
}

}  // namespace
}  // namespace lamina
