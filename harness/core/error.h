// SPDX-License-Identifier: Apache-2.0
// The one exception type of Lamina. It is thrown for bad input and for what fails at run time, caught once per measured
// cell (which becomes a `failed` row) and once in main() (which turns its kind into the exit status).
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace lamina {

// What went wrong, as the exit status sees it.
enum class ErrorKind {
  failed = 1,     // a cell, a gate or a device operation failed
  bad_input = 2,  // a file, a name, a number or an option from the user is wrong
  no_device = 4,  // no usable device for a backend
};

// `stage` is where it happened ("scene", "shader", "vulkan"), `subject` the file with line, object or option it is about
// ("heart.toml:12", "mesh 'shell', vertex 7"), `message` what is wrong and what to do about it.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, std::string stage, std::string subject, std::string message)
      : std::runtime_error(fmt::format("{}: {}: {}", stage, subject, message)),
        kind_(kind),
        stage_(std::move(stage)),
        subject_(std::move(subject)),
        message_(std::move(message)) {}

  ErrorKind kind() const { return kind_; }
  const std::string& stage() const { return stage_; }
  const std::string& subject() const { return subject_; }
  const std::string& message() const { return message_; }

 private:
  ErrorKind kind_;
  std::string stage_, subject_, message_;
};

}  // namespace lamina
