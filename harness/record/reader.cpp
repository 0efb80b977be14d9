// SPDX-License-Identifier: Apache-2.0
// Reads a record and checks every line, so that what makes reports of it can trust each field.
#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/record/kinds.h"
#include "harness/record/record.h"

namespace lamina {
namespace {

using namespace lines;

void check_run(const Json& line, const At& at) { row_of<RunRow>(line, std::string(at.subject)); }

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
template <auto rows>
nlohmann::ordered_json schema_of_rows() {
  return schema_of<typename std::remove_reference_t<decltype(std::declval<Record>().*rows)>::value_type>();
}

// The kinds of lines after the first.
struct KnownKind {
  const char* name;
  void (*add)(Record&, const Json&, const At&);
  nlohmann::ordered_json (*schema)();
};
template <auto rows>
constexpr KnownKind known_kind(const char* name) {
  return {name, add_row<rows>, schema_of_rows<rows>};
}
constexpr KnownKind kinds[] = {known_kind<&Record::timers>("timer"),
                               known_kind<&Record::plans>("plan"),
                               known_kind<&Record::bakes>("bake"),
                               known_kind<&Record::phases>("phase"),
                               known_kind<&Record::cells>("cell"),
                               known_kind<&Record::savings>("saving"),
                               known_kind<&Record::functions>("function"),
                               known_kind<&Record::function_times>("function_time"),
                               known_kind<&Record::function_timers>("function_timer"),
                               known_kind<&Record::function_pictures>("function_picture"),
                               known_kind<&Record::gates>("gate"),
                               known_kind<&Record::aas>("aa"),
                               known_kind<&Record::verdicts>("verdict"),
                               known_kind<&Record::pairs>("pairs"),
                               known_kind<&Record::sweeps>("sweep"),
                               known_kind<&Record::crossovers>("crossover")};

void add_line(Record& record, const Json& line, const At& at) {
  const std::string kind = kind_of(line, at);
  if (kind == "run") refuse(at, "a second line of kind 'run'; one record holds one run, so split the file before this line");
  std::vector<std::string> known = {"run"};
  for (const auto& [name, add, schema] : kinds) {
    if (kind == name) return add(record, line, at);
    known.push_back(name);
  }
  refuse(at, unknown_name("kind of line", kind, known));
}

}  // namespace

nlohmann::ordered_json record_line_schema() {
  using Schema = nlohmann::ordered_json;
  Schema names = Schema::array({"run"}), all = Schema::array(), definitions = {{"run", schema_of<RunRow>()}};
  for (const KnownKind& kind : kinds) names.push_back(kind.name), definitions[kind.name] = kind.schema();
  for (const Schema& name : names)
    all.push_back({{"if", {{"properties", {{"kind", {{"const", name}}}}}}},
                   {"then", {{"$ref", "#/definitions/" + name.get<std::string>()}}}});
  return {{"type", "object"},
          {"properties", {{"kind", {{"enum", names}}}}},
          {"required", {"kind"}},
          {"allOf", all},
          {"definitions", definitions}};
}

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
