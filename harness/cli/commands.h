// SPDX-License-Identifier: Apache-2.0
// The commands, each in a file of its own, beside its options.
#pragma once

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace lamina {

struct Command {
  CLI::App* options = nullptr;  // within the program's
  // Once they are read: does the work and returns the exit status. `typed`: the command line, for the record. Throws Error.
  std::function<int(const std::string& typed)> run;
};

// Each adds a command to the program's, in the order in which the help shows them.
Command add_compare(CLI::App& program);
Command add_gate(CLI::App& program);
Command add_sweep(CLI::App& program);
Command add_merge(CLI::App& program);
Command add_stress(CLI::App& program);
Command add_choose(CLI::App& program);
Command add_calibrate(CLI::App& program);
Command add_diff(CLI::App& program);
Command add_plan(CLI::App& program);
Command add_list(CLI::App& program);
Command add_report(CLI::App& program);
Command add_history(CLI::App& program);
Command add_schema(CLI::App& program);
// These two look at all the others, once the command line is parsed.
Command add_man(CLI::App& program);
Command add_complete(CLI::App& program);

}  // namespace lamina
