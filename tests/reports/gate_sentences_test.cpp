// SPDX-License-Identifier: Apache-2.0
// Sentences of verdicts from the facts in their rows: every figure that a row holds is in its sentence.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "reports/gate/sentences.h"
#include "tests/reports/example_gate.h"

namespace lamina {
namespace {

// Holds each of these, in this order.
void expect_says(const VerdictRow& row, const std::vector<std::string>& parts) {
  const std::string sentence = sentence_of(row);
  size_t from = 0;
  for (const std::string& part : parts) {
    const size_t at = sentence.find(part, from);
    ASSERT_NE(at, std::string::npos) << "'" << part << "' in: " << sentence;
    from = at + part.size();
  }
}

VerdictRow row(Cause cause, const std::string& what, Verdict verdict, std::vector<std::string> details = {}) {
  VerdictRow made = example_verdict(verdict, what, "");
  made.cause = cause, made.details = std::move(details);
  return made;
}

VerdictRow time(Verdict verdict, Cause cause = Cause::figures) {
  VerdictRow made = row(cause, "time", verdict);
  made.limit = 0.03, made.ratio = example_interval(1.1, 1.08, 1.12);
  return made;
}

TEST(GateSentences, OfATimeSayWhichPassByHowMuchAndAgainstWhatMargin) {
  VerdictRow slower = time(Verdict::slower);
  expect_says(slower, {"vertex_normal on vulkan", "the frame", "slower", "+10.0%", "+8.0%", "+12.0%", "margin 3.0%"});
  EXPECT_FALSE(has(sentence_of(slower), "every count"));
  slower.pass = "composite", slower.counts_hold = true;
  expect_says(slower, {"pass composite", "slower", "+10.0%", "every count is equal or fewer", "access to memory"});
  expect_says(time(Verdict::same), {"as long as before"});
  expect_says(time(Verdict::faster), {"faster"});
}

TEST(GateSentences, OfATimeThatIsNotBelievedSayWhatItsFiguresAre) {
  VerdictRow doubted = time(Verdict::ambiguous, Cause::arm_differs);
  doubted.details = {"slower"};
  expect_says(doubted, {"is slower", "+10.0%", "A/A arm", "no time is believed"});
  doubted.verdict = Verdict::time_open, doubted.counts_hold = true;
  expect_says(doubted, {"is slower", "no time is believed", "every count is equal or fewer", "stays open"});
}

TEST(GateSentences, AgainstARecordAnOpenTimeIsAmbiguousByItself) {
  VerdictRow open = time(Verdict::time_open, Cause::against_record);
  open.counts_hold = true;
  expect_says(open, {"time ambiguous against the record", "+10.0%", "+8.0%", "+12.0%", "margin 3.0%", "stays open"});
}

TEST(GateSentences, OfCountsSayHowManyOfWhat) {
  VerdictRow fetches = example_fetches();
  fetches.cause = Cause::figures;
  expect_says(fetches, {"vertex_normal on vulkan, view front", "pass composite", "1400 fetches of light_map_texture", "1300"});
  fetches.what = "vertices", fetches.texture = "";
  expect_says(fetches, {"1400 invocations of its vertices", "1300"});
  VerdictRow operations = row(Cause::figures, "operations", Verdict::not_compared);
  operations.pass = "composite", operations.operations = {{"exp", 7, 0}, {"float_add", 100, 101}};
  expect_says(operations, {"pass composite", "other operations", "exp 0, was 7", "float_add 101, was 100", "for times to say"});
  operations.operations.pop_back(), operations.verdict = Verdict::better;
  expect_says(operations, {"fewer operations", "exp 0, was 7"});
  operations.operations = {{"exp", 7, 8}}, operations.verdict = Verdict::worse;
  expect_says(operations, {"more operations", "exp 8, was 7"});
}

TEST(GateSentences, OfErrorsSayFromWhatToWhat) {
  VerdictRow worse = row(Cause::figures, "psnr_db", Verdict::worse);
  worse.after = 43.25;
  expect_says(worse, {"psnr_db", "from inf to 43.25"});  // a record has null for infinity
  worse.cause = Cause::beyond_bound, worse.limit = 45;
  expect_says(worse, {"psnr_db is 43.25", "at least 45"});
  worse.what = "flip", worse.after = 0.5, worse.limit = 0.25;
  expect_says(worse, {"flip is 0.5", "at most 0.25"});
  worse.what = "frame_ms", worse.after = 12.5, worse.limit = 10;
  expect_says(worse, {"12.5 ms", "allows 10"});
  worse.what = "target_bytes", worse.after = 4097, worse.limit = 4096;
  expect_says(worse, {"4097 bytes", "allows 4096"});
}

TEST(GateSentences, OfEveryCauseAreTheirOwnAndHoldItsDetails) {
  std::set<std::string> sentences;
  for (int cause = 0; cause <= static_cast<int>(Cause::arm_differs); ++cause) {
    VerdictRow each = row(static_cast<Cause>(cause), "ssim", Verdict::worse, {"detail_0", "detail_1", "detail_2"});
    each.view = "front";
    EXPECT_TRUE(sentences.insert(sentence_of(each)).second) << sentence_of(each);
    EXPECT_GT(sentence_of(each).size(), 20u) << cause;
    EXPECT_EQ(row_of<VerdictRow>(nlohmann::json(to_json(each)), "line").cause, each.cause) << "the record has a word for it";
    each.details.clear();
    EXPECT_NE(sentence_of(each), "") << "of a record that was changed by hand";
  }
  for (const Cause cause : {Cause::cannot_be_measured, Cause::cannot_be_run, Cause::process_failed, Cause::api_message,
                            Cause::certificate_failed, Cause::error_lost, Cause::covers_nothing, Cause::another_machine})
    EXPECT_TRUE(has(sentence_of(row(cause, "cell", Verdict::failed, {"detail_0"})), "detail_0"));
  expect_says(row(Cause::one_picture, "stale", Verdict::failed, {"up", "down"}), {"up", "down"});
  for (const auto& [side, words] : {std::pair("before", "only the record"), {"after", "only this run"}})
    expect_says(row(Cause::timed_once, "time", Verdict::ambiguous, {side}), {words});
}

TEST(GateSentences, OfRecordsOfBeforeAreTheirOwn) {
  VerdictRow old = time(Verdict::slower);
  old.cause.reset(), old.sentence = "it is slower";
  EXPECT_EQ(sentence_of(old), "it is slower");
}

}  // namespace
}  // namespace lamina
