// SPDX-License-Identifier: Apache-2.0
// Tables by their forms: each kind of mistake is one message with file and line, and a reader cannot ask for what is not
// declared.
#include <gtest/gtest.h>

#include <fstream>

#include "harness/core/toml_table.h"
#include "tests/folder.h"

namespace lamina {
namespace {

class TomlForms : public InFolder<> {
 protected:
  TomlTable read(const std::string& text, TomlFormPtr form) {
    std::ofstream(file_) << text;
    return TomlTable::parse(file_, "test", std::move(form));
  }
  // What the work says; "" where it throws no Error.
  template <class Work>
  static std::string refusal(const Work& work) {
    try {
      work();
      return "";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      return error.what();
    }
  }
  const std::filesystem::path file_ = folder_ / "form.toml";
};

#define EXPECT_SAYS(text, words) EXPECT_NE((text).find(words), std::string::npos) << (text)

TEST_F(TomlForms, KeysThatAreNoneAndKeysThatAreMissing) {
  const TomlFormPtr form = form::make({{"width", "", {form::number(0, 8)}, true}, {"name", "", {form::text()}}});
  EXPECT_EQ(refusal([&] { read("width = 1\n", form).check_keys(); }), "");
  const std::string unknown = refusal([&] { read("width = 1\nnmae = \"a\"\n", form).check_keys(); });
  EXPECT_SAYS(unknown, ".toml:2:");
  EXPECT_SAYS(unknown, "unknown key 'nmae' (did you mean 'name'?)");
  EXPECT_SAYS(refusal([&] { read("name = \"a\"\n", form).check_keys(); }), "'width' is missing: it must be a number");
}

TEST_F(TomlForms, ValuesOutOfTheForm) {
  const TomlFormPtr form = form::make({{"share", "", {form::number(0, 1)}},
                                       {"count", "", {form::whole(1, 9)}},
                                       {"kind", "", {form::word({"point", "line"}, "kind of light")}},
                                       {"place", "", {form::numbers(-1, 1, {2, 3})}},
                                       {"blend", "", {form::texts({"none", "alpha"})}}});
  const auto table = [&](const std::string& text) { return read(text, form); };
  EXPECT_SAYS(refusal([&] { table("share = 2\n").optional_number("share"); }), "'share' must be a number from 0 to 1");
  EXPECT_SAYS(refusal([&] { table("count = 1.5\n").number("count"); }), "'count' must be a whole number from 1 to 9");
  EXPECT_SAYS(refusal([&] { table("kind = \"pint\"\n").string("kind"); }),
              "unknown kind of light 'pint' (did you mean 'point'?)");
  EXPECT_SAYS(refusal([&] { table("place = [0]\n").optional_numbers("place"); }),
              "must be a list of two or three finite numbers");
  EXPECT_SAYS(refusal([&] { table("place = [0, 5]\n").optional_numbers("place"); }), "must hold numbers from -1 to 1");
  EXPECT_SAYS(refusal([&] { table("blend = [\"alhpa\"]\n").optional_strings("blend"); }), "did you mean 'alpha'?");
  EXPECT_EQ(table("place = [0, 1, -1]\n").optional_numbers("place")->size(), 3u);
}

TEST_F(TomlForms, NamesThatAreFreeAndTablesOfTwoForms) {
  const TomlFormPtr line = form::make({{"kind", "", {form::word({"line"})}, true}, {"length", "", {form::number(0, 9)}}});
  const TomlFormPtr point = form::make({{"kind", "", {form::word({"point"})}, true}});
  const TomlFormPtr either = form::one_of({{"kind", "", {form::word({"line", "point"})}, true}}, {line, point});
  const TomlFormPtr root =
      form::make({{"things", "", {form::table(form::make({}, TomlKey{"NAME", "", {form::table(either)}}))}}});
  const auto things =
      read("[things.a]\nkind = \"line\"\nlength = 3\n[things.b]\nkind = \"point\"\nlength = 3\n", root).tables("things");
  ASSERT_EQ(things.size(), 2u);
  EXPECT_EQ(things[0].second.by(line).number("length"), 3);
  things[0].second.by(line).check_keys();
  EXPECT_SAYS(refusal([&] { things[1].second.by(point).check_keys(); }), ".toml:6: unknown key 'length'");
}

TEST_F(TomlForms, AReaderAsksForNothingUndeclared) {
  const TomlFormPtr form = form::make({{"name", "", {form::text()}}});
  const TomlTable table = read("name = \"a\"\n", form);
  EXPECT_THROW(table.has("size"), std::logic_error);
  EXPECT_THROW(table.optional_number("name"), std::logic_error);
}

}  // namespace
}  // namespace lamina
