// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace lamina {

// One line on standard error that is written over, with the fraction done and the time left; silent where no person watches.
class Progress {
 public:
  explicit Progress(std::string title);
  ~Progress();
  void show(double fraction, const std::string& what);

 private:
  std::string title_;
  bool watched_;
  double start_s_;
};

}  // namespace lamina
