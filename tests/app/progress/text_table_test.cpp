// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/progress/text_table.h"

#include <gtest/gtest.h>

namespace etendue::text_table_test {
namespace {

TEST(TextTable, AlignsItsColumns) {
  TextTable table({"name", "value"}, {Align::left, Align::right});
  table.add_row({"a", "1"});
  table.add_row({"longer", "123456"});
  EXPECT_EQ(table.text(),
            "  name     value\n"
            "  a            1\n"
            "  longer  123456\n");
}

TEST(TextTable, CountsCharactersRatherThanBytes) {
  TextTable table({"n", "v"}, {Align::left, Align::right});
  table.add_row({"\xC3\xA9t", "1"});
  EXPECT_EQ(table.text(), "  n   v\n  \xC3\xA9t  1\n");
}

TEST(TextTable, LeavesNoBlanksAtTheEndOfALine) {
  TextTable table({"n", ""}, {Align::left, Align::left});
  table.add_row({"a", ""});
  EXPECT_EQ(table.text(), "  n\n  a\n");
}

TEST(TextTable, NumbersHaveSixDigits) { EXPECT_EQ(number(3.14159265), "3.14159"); }

TEST(TextTable, NumbersWithAnErrorHaveTheDigitsThatItLeaves) {
  EXPECT_EQ(number(3.14159265, 0.0123), "3.142");
  EXPECT_EQ(number(0.0364, 0.0003), "0.03640") << "zeros that are known stand";
  EXPECT_EQ(number(123.456, 7), "123.5");
  EXPECT_EQ(number(1.5, 4), "1.5");
  EXPECT_EQ(number(0.2, 40), "0.2") << "one digit where nothing is known";
  EXPECT_EQ(number(3.14159265, 1e-12), "3.14159") << "six at most";
  EXPECT_EQ(number(3.14159265, 0), "3.14159");
  EXPECT_EQ(number(0, 0.1), "0");
}

}  // namespace
}  // namespace etendue::text_table_test
