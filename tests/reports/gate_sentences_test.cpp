// SPDX-License-Identifier: Apache-2.0
// Sentences of verdicts from the facts in their rows: every figure that a row holds is in its sentence.
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "harness/core/error.h"
#include "harness/record/row_of.h"
#include "reports/gate/sentences.h"
#include "tests/reports/example_gate.h"

namespace lamina {
namespace {

bool has(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

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
  EXPECT_EQ(sentence_of(slower), "vertex_normal on vulkan: the frame is slower: +10.0% [+8.0%, +12.0%], margin 3.0%");
  slower.pass = "composite", slower.counts_hold = true;
  EXPECT_EQ(sentence_of(slower),
            "vertex_normal on vulkan: pass composite is slower: +10.0% [+8.0%, +12.0%], margin 3.0%; every count is equal or "
            "fewer, so access to memory, a format or the code's layout costs it");
  EXPECT_TRUE(has(sentence_of(time(Verdict::same)), "takes as long as before"));
  EXPECT_TRUE(has(sentence_of(time(Verdict::time_open)), "may or may not take as long"));
}

TEST(GateSentences, OfATimeThatIsNotBelievedSayWhatItsFiguresAre) {
  VerdictRow doubted = time(Verdict::ambiguous, Cause::arm_differs);
  doubted.details = {"slower"};
  EXPECT_TRUE(has(sentence_of(doubted), "is slower: +10.0%")) << sentence_of(doubted);
  EXPECT_TRUE(sentence_of(doubted).ends_with("no time is believed"));
  doubted.verdict = Verdict::time_open, doubted.counts_hold = true;
  EXPECT_TRUE(sentence_of(doubted).ends_with("so the time stays open")) << sentence_of(doubted);
}

TEST(GateSentences, AgainstARecordAnOpenTimeIsAmbiguousByItself) {
  VerdictRow open = time(Verdict::time_open, Cause::against_record);
  open.counts_hold = true;
  EXPECT_EQ(sentence_of(open),
            "vertex_normal on vulkan: time ambiguous against the record: +10.0% [+8.0%, +12.0%], margin 3.0%; every count is "
            "equal or fewer and the pictures hold, so the time stays open");
}

TEST(GateSentences, OfCountsSayHowManyOfWhat) {
  VerdictRow fetches = example_fetches();
  fetches.sentence = "", fetches.cause = Cause::figures;
  EXPECT_EQ(sentence_of(fetches),
            "vertex_normal on vulkan, view front: pass composite makes 1400 fetches of light_map_texture where it made 1300");
  fetches.what = "vertices", fetches.texture = "";
  EXPECT_TRUE(has(sentence_of(fetches), "makes 1400 invocations of its vertices where"));
  VerdictRow operations = row(Cause::figures, "operations", Verdict::not_compared);
  operations.pass = "composite", operations.operations = {{"exp", 7, 0}, {"float_add", 100, 101}};
  EXPECT_EQ(sentence_of(operations),
            "vertex_normal on vulkan: pass composite executes other operations: exp 0, was 7; float_add 101, was 100; which of "
            "them cost more is for times to say");
  operations.operations.pop_back(), operations.verdict = Verdict::better;
  EXPECT_TRUE(has(sentence_of(operations), "executes fewer operations: exp 0, was 7"));
}

TEST(GateSentences, OfErrorsSayFromWhatToWhat) {
  VerdictRow worse = row(Cause::figures, "psnr_db", Verdict::worse);
  worse.after = 43.25;  // and from infinity, which a record has as null
  EXPECT_EQ(sentence_of(worse), "vertex_normal on vulkan: psnr_db went from inf to 43.25");
  worse.cause = Cause::beyond_bound, worse.limit = 45;
  EXPECT_TRUE(has(sentence_of(worse), "psnr_db is 43.25, the gate file asks for at least 45"));
  worse.what = "flip", worse.after = 0.5, worse.limit = 0.25;
  EXPECT_TRUE(has(sentence_of(worse), "flip is 0.5, the gate file asks for at most 0.25"));
  worse.what = "frame_ms", worse.after = 12.5, worse.limit = 10;
  EXPECT_TRUE(has(sentence_of(worse), "the frame takes 12.5 ms, the gate file allows 10"));
  worse.what = "target_bytes", worse.after = 4097, worse.limit = 4096;
  EXPECT_TRUE(has(sentence_of(worse), "the frame takes 4097 bytes of targets and buffers, the gate file allows 4096"));
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
  EXPECT_TRUE(has(sentence_of(row(Cause::one_picture, "stale", Verdict::failed, {"up", "down"})), "views up and down"));
  for (const auto& [side, words] : {std::pair("before", "only the record has"), {"after", "only this run has"}})
    EXPECT_TRUE(has(sentence_of(row(Cause::timed_once, "time", Verdict::ambiguous, {side})), words));
}

TEST(GateSentences, OfRecordsOfBeforeAreTheirOwn) {
  VerdictRow old = time(Verdict::slower);
  old.cause.reset(), old.sentence = "it is slower";
  EXPECT_EQ(sentence_of(old), "it is slower");
}

}  // namespace
}  // namespace lamina
