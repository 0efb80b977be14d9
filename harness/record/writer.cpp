// SPDX-License-Identifier: Apache-2.0
// Appends a record's lines, each flushed before the run goes on.
#include <cerrno>
#include <system_error>

#include "harness/core/error.h"
#include "harness/record/record.h"

namespace lamina {
namespace {

std::string system_words() { return errno ? std::generic_category().message(errno) : std::string("unknown reason"); }

}  // namespace

RecordWriter::RecordWriter(const std::filesystem::path& file, bool go_on) : file_(file) {
  errno = 0;
  stream_.open(file_, std::ios::binary | (go_on ? std::ios::app : std::ios::trunc));
  if (!stream_)
    throw Error(ErrorKind::bad_input, "record", file_.string(),
                fmt::format("cannot be opened for writing: {}; choose another folder with --out", system_words()));
}

void RecordWriter::append(const nlohmann::ordered_json& line) {
  // Drivers and file names may hold bytes that are not UTF-8; replacing them loses less than refusing the line.
  const std::string text = line.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
  errno = 0;
  stream_.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream_.flush();
  if (!stream_)
    throw Error(ErrorKind::failed, "record", file_.string(),
                fmt::format("cannot be written: {}; the lines before are kept, free some space and run again", system_words()));
}

}  // namespace lamina
