// SPDX-License-Identifier: Apache-2.0
// What CI systems read of a gate: JUnit XML against its schema, GitHub's workflow commands and summary, the files in a run's
// folder.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>

#include "harness/core/text.h"
#include "reports/gate/gate.h"
#include "reports/gate/xml.h"
#include "tests/folder.h"
#include "tests/reports/example_gate.h"

namespace lamina {
namespace {

class GateFiles : public InFolder<> {
 protected:
  ~GateFiles() override {
    ::unsetenv("GITHUB_ACTIONS");
    ::unsetenv("GITHUB_STEP_SUMMARY");
  }
  // xmllint's exit status: 0 valid, 3 or 4 invalid against the schema, 1 not well-formed.
  int validate(const std::string& xml) {
    const std::string command = "xmllint --noout --schema '" LAMINA_SOURCE_DIR "/tests/reports/junit.xsd' '" +
                                write("junit.xml", xml).string() + "' >'" + (folder_ / "log").string() + "' 2>&1";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string log() { return read_file(folder_ / "log", "test"); }
};

#define REQUIRE_XMLLINT() \
  if (std::system("command -v xmllint >/dev/null") != 0) GTEST_SKIP() << "xmllint (Debian's libxml2-utils) is not installed"

TEST_F(GateFiles, JunitIsValidWhateverTheGateSays) {
  REQUIRE_XMLLINT();
  Record died = example_failed_gate();
  died.gates.clear();
  for (const Record& record : {example_failed_gate(), example_passed_gate(), died, example_gate(Verdict::same, 0, {}),
                               example_gate(Verdict::ambiguous, 3, {example_verdict(Verdict::ambiguous, "time", "s")})})
    EXPECT_EQ(validate(gate_junit(record)), 0) << log();
}

TEST_F(GateFiles, JunitIsValidWhateverTheRecordHolds) {
  REQUIRE_XMLLINT();
  Record record = example_failed_gate();
  std::string every_byte;
  for (int byte = 1; byte < 256; ++byte) every_byte += static_cast<char>(byte);
  VerdictRow& row = record.verdicts[1];
  for (std::string* text : {&row.sentence, &row.variant, &row.pass}) *text = every_byte + "]]> & <\"'>";
  record.verdicts[2].sentence = "surrogate \xed\xa0\x80, \xef\xbf\xbe, \xef\xbf\xbf, overlong \xc0\xbc, cut \xe2\x82";
  EXPECT_EQ(validate(gate_junit(record)), 0) << log();
}

TEST_F(GateFiles, TheSchemaRefusesWhatIsNotJunit) {  // else the tests above show nothing
  REQUIRE_XMLLINT();
  EXPECT_NE(validate("<testsuites><testsuite name=\"x\" tests=\"1\"/></testsuites>"), 0);
  EXPECT_NE(
      validate("<testsuites><testsuite name=\"x\" tests=\"1\" failures=\"0\" errors=\"0\"><testcase name=\"a\"/></testsuite>"
               "</testsuites>"),
      0);
  std::string xml = gate_junit(example_failed_gate());
  xml.replace(xml.find("<failure type"), 8, "<broken ");
  EXPECT_NE(validate(xml), 0);
}

TEST(GateJunit, HasOneTestCaseAVerdictWithItsOutcome) {
  const std::string xml = gate_junit(example_failed_gate());
  EXPECT_TRUE(has(xml,
                  "<testsuite name=\"lamina gate\" tests=\"6\" failures=\"2\" errors=\"1\" skipped=\"1\" time=\"41.250\" "
                  "timestamp=\"2026-01-31T23:59:59\">"))
      << xml;
  EXPECT_EQ(count_of(xml, "<testcase "), 6u);
  EXPECT_EQ(count_of(xml, "<failure "), 2u);
  EXPECT_EQ(count_of(xml, "<error "), 1u);
  EXPECT_EQ(count_of(xml, "<skipped "), 1u);
  EXPECT_TRUE(has(xml,
                  "<testcase classname=\"vulkan.layered_material.vertex_normal\" name=\"time, pass composite\">\n"
                  "      <failure type=\"slower\" message=\"the composite pass takes 10% longer\">"))
      << xml;
  EXPECT_TRUE(has(xml, "<error type=\"ambiguous\" message=\"the interval reaches over the margin\">"));
  EXPECT_TRUE(has(xml, "<testcase classname=\"vulkan.layered_material.vertex_normal\" name=\"ssim\"/>"));
}

TEST(GateJunit, AMissingAnswerIsAnErrorOfItsOwn) {
  Record record = example_passed_gate();
  record.gates.clear();
  const std::string xml = gate_junit(record);
  EXPECT_TRUE(has(xml, "tests=\"2\" failures=\"0\" errors=\"1\"")) << xml;
  EXPECT_TRUE(has(xml, "<testcase classname=\"gate\" name=\"answer\">\n      <error type=\"no answer\"")) << xml;
}

TEST(GateJunit, ARowOfABackendAloneHasAClassnameAndASubject) {
  VerdictRow timer = example_verdict(Verdict::ambiguous, "timer", "the certificate failed");
  timer.effect = timer.variant = "";
  const Record record = example_gate(Verdict::ambiguous, 3, {timer});
  EXPECT_TRUE(has(gate_junit(record), "<testcase classname=\"vulkan\" name=\"timer\">"));
  EXPECT_EQ(github_annotations(record), "::warning title=ambiguous%3A timer (interval)%3A vulkan::the certificate failed\n");
}

TEST(Xml, EscapesWhatHasAMeaningAndDropsWhatIsNotAllowed) {
  EXPECT_EQ(escaped_xml("a<b>&\"c'"), "a&lt;b&gt;&amp;&quot;c'");
  EXPECT_EQ(escaped_xml("1\t2\n3\r4"), "1&#9;2&#10;3&#13;4");
  EXPECT_EQ(escaped_xml(std::string("a\0b\x01\x1f\x0b", 6)), "ab");
  EXPECT_EQ(escaped_xml("\xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80"), "\xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80");
  EXPECT_EQ(escaped_xml("\xef\xbf\xbd"), "\xef\xbf\xbd");
  EXPECT_EQ(escaped_xml("\xef\xbf\xbe\xef\xbf\xbfx"), "x");              // U+FFFE, U+FFFF
  EXPECT_EQ(escaped_xml("\xed\xa0\x80x"), "x");                          // a surrogate
  EXPECT_EQ(escaped_xml("\xc0\xbcx\xf4\x90\x80\x80y\xff\x80z"), "xyz");  // overlong, beyond U+10FFFF, no UTF-8
  EXPECT_EQ(escaped_xml("cut \xe2\x82"), "cut ");
}

TEST(GithubAnnotations, AreOneLineEachWithTheirEscapes) {
  Record record = example_failed_gate();
  record.verdicts[1].sentence = "100% of a,b: c\r\nd";
  EXPECT_EQ(github_annotations(record),
            "::error title=slower%3A time (interval)%3A vertex_normal on vulkan%2C pass composite::100%25 of a,b: c%0D%0Ad\n"
            "::error title=worse%3A fetches (count)%3A vertex_normal on vulkan%2C view front%2C pass composite%2C texture "
            "light_map_texture::one tap more\n"
            "::warning title=ambiguous%3A time (interval)%3A vertex_normal on vulkan::the interval reaches over the margin\n");
  EXPECT_EQ(github_annotations(example_passed_gate()), "");
}

TEST(GithubAnnotations, AreAtMostTenOfAKindAndSayHowManyMoreThereAre) {
  const auto errors = [](size_t count) {
    return github_annotations(example_gate(Verdict::slower, 1, std::vector<VerdictRow>(count, example_slower())));
  };
  EXPECT_EQ(count_of(errors(10), "::error "), 10u);
  EXPECT_FALSE(has(errors(10), "more are in"));
  EXPECT_EQ(count_of(errors(25), "::error "), 10u);
  EXPECT_TRUE(has(errors(25), "::16 more are in the job's summary"));
}

TEST(GithubAnnotations, WarnOfAnArmThatDiffersFromItself) {
  Record record = example_passed_gate();
  record.aas = {example_aa(Verdict::faster)};
  EXPECT_TRUE(has(github_annotations(record), "::warning title=A variant came out unlike itself::A/A vertex_normal on vulkan"));
}

TEST_F(GateFiles, AreAnnouncedOnGithubAndNowhereElse) {
  const auto summary = write("summary.md", "before\n");
  ::setenv("GITHUB_STEP_SUMMARY", summary.c_str(), 1);
  const auto announced = [] {
    testing::internal::CaptureStdout();
    announce_on_github(example_failed_gate());
    return testing::internal::GetCapturedStdout();
  };
  EXPECT_EQ(announced(), "");
  ::setenv("GITHUB_ACTIONS", "false", 1);
  EXPECT_EQ(announced(), "");
  EXPECT_EQ(read_file(summary, "test"), "before\n");
  ::setenv("GITHUB_ACTIONS", "true", 1);
  EXPECT_EQ(announced(), github_annotations(example_failed_gate()));
  EXPECT_EQ(read_file(summary, "test"), "before\n" + gate_markdown(example_failed_gate()));
  ::setenv("GITHUB_STEP_SUMMARY", (folder_ / "no" / "such").c_str(), 1);
  EXPECT_TRUE(has(announced(), "::warning title=Lamina gate::the summary"));
}

TEST_F(GateFiles, AreWrittenAloneAndWithTheOtherReports) {
  write_gate_reports(example_failed_gate(), folder_);
  for (const char* name : {"gate.md", "junit.xml", "gate.json"}) {
    EXPECT_TRUE(std::filesystem::remove(folder_ / name)) << name;
  }
  const Record record = example_failed_gate();
  std::string lines = record.run.dump() + "\n";
  write("record.jsonl", lines);
  write_reports(folder_);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "junit.xml"));  // no gate's record
  for (const SameArmRow& row : record.aas) lines += to_json(row).dump() + "\n";
  for (const VerdictRow& row : record.verdicts) lines += to_json(row).dump() + "\n";
  for (const GateRow& row : record.gates) lines += to_json(row).dump() + "\n";
  write("record.jsonl", lines);
  write_reports(folder_);
  EXPECT_EQ(read_file(folder_ / "junit.xml", "test"), gate_junit(record));
  EXPECT_EQ(read_file(folder_ / "gate.md", "test"), gate_markdown(record));
  EXPECT_EQ(read_file(folder_ / "gate.json", "test"), gate_json(record));
}

}  // namespace
}  // namespace lamina
