// SPDX-License-Identifier: Apache-2.0
// The files that a gate leaves in its run's folder.
#include "harness/core/text.h"
#include "reports/gate/gate.h"

namespace lamina {

void write_gate_reports(const Record& record, const std::filesystem::path& folder) {
  write_file_atomically(folder / "gate.md", gate_markdown(record));
  write_file_atomically(folder / "junit.xml", gate_junit(record));
  write_file_atomically(folder / "gate.json", gate_json(record));
}

}  // namespace lamina
