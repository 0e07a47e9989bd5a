// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/run_record.h"

#include <gtest/gtest.h>

namespace etendue::run_record_test {
namespace {

using std::chrono::seconds;
using std::chrono::sys_days;

TEST(RunRecord, HasDatesInUtc) {
  // 2000-01-01T00:00:00Z is 946684800 s after the epoch (POSIX.1).
  EXPECT_EQ(iso_date(std::chrono::sys_seconds(seconds(946684800))), "2000-01-01T00:00:00Z");
  EXPECT_EQ(iso_date(sys_days(std::chrono::year(2024) / 2 / 29) + seconds(86399)), "2024-02-29T23:59:59Z");
}

TEST(RunRecord, QuotesWhatAShellWouldTakeApart) {
  EXPECT_EQ(shell_line("etendue", {"run", "a.toml", "--set", "solve.tolerance=1e-8"}),
            "etendue run a.toml --set solve.tolerance=1e-8");
  EXPECT_EQ(shell_line("etendue", {"my case.toml", "it's", "", "$HOME"}),
            R"(etendue 'my case.toml' 'it'\''s' '' '$HOME')");
}

}  // namespace
}  // namespace etendue::run_record_test
