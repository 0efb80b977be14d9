// SPDX-License-Identifier: Apache-2.0
// What a gate says, made from its record alone (the lines of harness/record/gate_rows.h), for people and for CI systems. None
// of these throws for what read_record() lets through. A record without a gate's answer, or one whose answer its figures do not
// bear out, is shown as such and never as a pass.
#pragma once

#include <filesystem>
#include <string>

#include "harness/record/record.h"

namespace lamina {

// For a terminal: the answer in one line, then what regressed, where, by how much and how sure, then what is ambiguous, what
// was not compared, what got better, how many are the same, the A/A arms and the devices. `colours`: with ANSI emphasis.
std::string gate_table(const Record& record, bool colours);
// For a comment on a pull request, GitHub's Markdown: the same, with the whole matrix folded away and cut where the comment
// would pass 60,000 bytes (GitHub takes 65,536 characters).
std::string gate_markdown(const Record& record);
// JUnit XML as Jenkins, GitLab and Surefire's readers take it: one suite, one test case a verdict line. Slower, worse and
// failed are <failure>; ambiguous is <error>, for a test that came to no answer is neither passed nor failed, and must not
// pass; not compared is <skipped>. An answer that is missing or not borne out is an <error> of its own. Characters that XML 1.0
// does not allow are left out.
std::string gate_junit(const Record& record);
// {"gate":{..} or null,"aas":[..],"verdicts":[..]}, the record's own lines.
std::string gate_json(const Record& record);
// Workflow commands of GitHub Actions, a line each: ::error for what regressed, ::warning for what is ambiguous and for an A/A
// arm that differs from itself. GitHub shows ten of a kind; the tenth says how many more there are.
std::string github_annotations(const Record& record);

// Writes gate.md, junit.xml and gate.json into the folder. Throws as write_file_atomically() does.
void write_gate_reports(const Record& record, const std::filesystem::path& folder);
// Where GITHUB_ACTIONS is "true": prints the annotations and appends the Markdown to the file that GITHUB_STEP_SUMMARY names. A
// summary that cannot be written is a warning, for it must not change the gate's answer.
void announce_on_github(const Record& record);

}  // namespace lamina
