// SPDX-License-Identifier: Apache-2.0
// The gate's verdicts as JUnit XML. tests/reports/junit.xsd is the structure that is kept to.
#include <fmt/format.h>

#include "reports/gate/gate.h"
#include "reports/gate/reading.h"
#include "reports/gate/sentences.h"
#include "reports/gate/xml.h"
#include "reports/words.h"

namespace lamina {
namespace {

// A failure, error or skip: its first line for lists, and all that is known.
std::string outcome_element(const char* element, const std::string& type, const std::string& message, const std::string& more) {
  return fmt::format("      <{0} type=\"{1}\" message=\"{2}\">{3}</{0}>\n", element, escaped_xml(type), escaped_xml(message),
                     escaped_xml(more));
}

std::string facts_of(const VerdictRow& verdict) {
  std::string words;
  const auto add = [&](const char* label, const std::string& fact) {
    if (!fact.empty()) words += fmt::format("{}: {}\n", label, fact);
  };
  add("where", subject_of(verdict));
  add("before and after", before_and_after(verdict));
  add("change", change_of(verdict));
  add("kind", std::string(kind_of(verdict)));
  add("how sure", certainty_of(verdict));
  add("limit", limit_of(verdict));
  return words;
}

std::string test_case(const std::string& classname, const std::string& name, const std::string& inside) {
  const std::string start =
      fmt::format("    <testcase classname=\"{}\" name=\"{}\"", escaped_xml(classname), escaped_xml(name));
  return inside.empty() ? start + "/>\n" : fmt::format("{}>\n{}    </testcase>\n", start, inside);
}

const char* element_for(Verdict verdict) {
  switch (verdict) {
    case Verdict::slower:
    case Verdict::worse:
    case Verdict::failed:
      return "failure";
    case Verdict::ambiguous:
      return "error";
    case Verdict::time_open:
    case Verdict::not_compared:
      return "skipped";
    default:
      return nullptr;
  }
}

std::string test_case(const VerdictRow& row) {
  const std::string place = place_of(row);
  const char* element = element_for(row.verdict);
  std::string classname;  // a backend's own row, as of its timer, has no effect and no variant
  for (const std::string* part : {&row.backend, &row.effect, &row.variant})
    if (!part->empty()) classname += (classname.empty() ? "" : ".") + *part;
  return test_case(classname.empty() ? "gate" : classname, row.what + (place.empty() ? "" : ", " + place),
                   element ? outcome_element(element, std::string(name_of(row.verdict)), sentence_of(row), facts_of(row)) : "");
}

std::string properties(const Record& record) {
  std::string text = "    <properties>\n";
  const auto add = [&](const std::string& name, const std::string& value) {
    text += fmt::format("      <property name=\"{}\" value=\"{}\"/>\n", escaped_xml(name), escaped_xml(value));
  };
  add("lamina", text_at(record.run, "/lamina"));
  add("commit", text_at(record.run, "/commit"));
  for (const std::string& device : device_lines(record)) add("device", device);
  for (const SameArmRow& aa : record.aas) add("aa", words_for_aa(aa));
  return text + "    </properties>\n";
}

}  // namespace

std::string gate_junit(const Record& record) {
  const GateReading reading = reading_of(record);
  const bool trouble = !reading.trouble.empty();
  const std::string counts = fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\"", record.verdicts.size() + trouble,
                                         reading.regressed.size(), reading.ambiguous.size() + trouble);
  const double wall_s = record.gates.empty() ? 0 : record.gates.back().wall_s;
  const std::string time = record.gates.empty() ? "" : fmt::format(" time=\"{:.3f}\"", wall_s);
  std::string date = text_at(record.run, "/date");
  if (date.ends_with('Z')) date.pop_back();  // the schemas that ask for a timestamp take none with a zone; it is in UTC
  const std::string timestamp = date.empty() ? "" : fmt::format(" timestamp=\"{}\"", escaped_xml(date));

  std::string xml = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"lamina gate\" {0}{1}>\n"
      "  <testsuite name=\"lamina gate\" {0} skipped=\"{2}\"{1}{3}>\n",
      counts, time, reading.not_compared.size() + reading.open.size(), timestamp);
  xml += properties(record);
  if (trouble) xml += test_case("gate", "answer", outcome_element("error", "no answer", reading.trouble, reading.conditions));
  for (const VerdictRow& verdict : record.verdicts) xml += test_case(verdict);
  xml += fmt::format("    <system-out>{}</system-out>\n", escaped_xml(gate_table(record, false)));
  return xml + "  </testsuite>\n</testsuites>\n";
}

}  // namespace lamina
