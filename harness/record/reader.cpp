// SPDX-License-Identifier: Apache-2.0
// Reads a record and checks every line, so that what makes reports of it can trust each field.
#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/record/kinds.h"
#include "harness/record/record.h"

namespace lamina {
namespace {

using namespace lines;

bool is_moment(const Json& value) {
  if (!value.is_string()) return false;
  constexpr std::string_view pattern = "dddd-dd-ddTdd:dd:ddZ";
  const auto& words = value.get_ref<const std::string&>();
  if (words.size() != pattern.size()) return false;
  for (size_t i = 0; i < words.size(); ++i)
    if (pattern[i] == 'd' ? words[i] < '0' || words[i] > '9' : words[i] != pattern[i]) return false;
  return true;
}

// UTC, in the order of its characters.
struct Moment {
  static std::string words() { return "a moment in UTC like \"2026-01-31T23:59:59Z\""; }
  static bool fits(const Json& value) { return is_moment(value); }
};
struct MomentOrNull {
  static std::string words() { return Moment::words() + " or null"; }
  static bool fits(const Json& value) { return value.is_null() || is_moment(value); }
};

void check_run(const Json& line, const At& at) {
  if (const Json& schema = value_of<Kind<uint64_t>>(line, "schema", at); schema != record_schema)
    refuse(at, fmt::format("the record's schema is {}, this program reads schema {}; use the program that wrote it",
                           schema.dump(), record_schema));
  if (line.contains("date")) value_of<Moment>(line, "date", at);
  if (line.contains("commit_date")) value_of<MomentOrNull>(line, "commit_date", at);
}

// The kind of a line; checks that it is an object with one.
std::string kind_of(const Json& line, const At& at) {
  if (!line.is_object()) refuse(at, "the line is not an object");
  return value_of<Kind<std::string>>(line, "kind", at);
}

template <auto rows>
void add_row(Record& record, const Json& line, const At& at) {
  auto& all = record.*rows;
  using Row = typename std::remove_reference_t<decltype(all)>::value_type;
  all.push_back(row_of<Row>(line, std::string(at.subject)));
}
void add_line(Record& record, const Json& line, const At& at) {
  const std::string kind = kind_of(line, at);
  if (kind == "run") refuse(at, "a second line of kind 'run'; one record holds one run, so split the file before this line");
  struct KnownKind {
    const char* name;
    void (*add)(Record&, const Json&, const At&);
  };
  constexpr KnownKind kinds[] = {{"timer", add_row<&Record::timers>},
                                 {"plan", add_row<&Record::plans>},
                                 {"bake", add_row<&Record::bakes>},
                                 {"phase", add_row<&Record::phases>},
                                 {"cell", add_row<&Record::cells>},
                                 {"function", add_row<&Record::functions>},
                                 {"function_time", add_row<&Record::function_times>},
                                 {"function_timer", add_row<&Record::function_timers>},
                                 {"function_picture", add_row<&Record::function_pictures>},
                                 {"gate", add_row<&Record::gates>},
                                 {"aa", add_row<&Record::aas>},
                                 {"verdict", add_row<&Record::verdicts>},
                                 {"pairs", add_row<&Record::pairs>},
                                 {"sweep", add_row<&Record::sweeps>},
                                 {"crossover", add_row<&Record::crossovers>}};
  std::vector<std::string> known = {"run"};
  for (const auto& [name, add] : kinds) {
    if (kind == name) return add(record, line, at);
    known.push_back(name);
  }
  refuse(at, unknown_name("kind of line", kind, known));
}

}  // namespace

Record read_record(const std::filesystem::path& file, std::vector<Json>* all_lines) {
  const std::string content = read_file(file, "record");
  Record record;
  size_t number_of_line = 0;
  for (size_t begin = 0; begin < content.size();) {
    const size_t newline = content.find('\n', begin);
    const bool ended = newline != std::string::npos;
    const std::string_view words = std::string_view(content).substr(begin, ended ? newline - begin : std::string::npos);
    begin = ended ? newline + 1 : content.size();
    const std::string where = fmt::format("{}:{}", file.string(), ++number_of_line);
    const At at{where};

    Json line;
    try {
      line = Json::parse(words);
    } catch (const Json::out_of_range&) {
      refuse(at, "holds a number too large for a double");
    } catch (const Json::parse_error& error) {
      if (!ended && number_of_line > 1) {  // what a crash or a full disk leaves; a whole line ends in a newline
        record.run["truncated"] = fmt::format("line {} is cut short and left out: the run did not end well", number_of_line);
        break;
      }
      refuse(at, fmt::format("is not JSON from byte {} of the line on; mend or remove the line, or run again", error.byte));
    }
    if (all_lines) all_lines->push_back(line);
    if (number_of_line > 1) {
      add_line(record, line, at);
      continue;
    }
    if (kind_of(line, at) != "run") refuse(at, "the first line is not of kind 'run'; this is no record, or its start is lost");
    check_run(line, at);
    record.run = std::move(line);
  }
  if (number_of_line == 0) refuse({file.string() + ":1"}, "the file is empty; a record begins with a line of kind 'run'");
  return record;
}

}  // namespace lamina
