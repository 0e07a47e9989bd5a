// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/compare/compare_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/app/run/small_case.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"

namespace etendue::compare_test {
namespace {

using test::CaseFolder;
using test::etendue_says;
using test::has;
using test::Outcome;
using test::ScratchFolder;
using test::text_of;

TEST(Compare, CountsDifferencesInErrorsOfBoth) {
  EXPECT_DOUBLE_EQ(in_errors(10, 3, 4), 2);
  EXPECT_EQ(in_errors(0, 0, 0), 0);
  EXPECT_EQ(in_errors(-1, 0, 0), -std::numeric_limits<double>::infinity());
}

TEST(Compare, CountsTheCellsThatAgree) {
  const TetrahedralMesh mesh(kuhn_cube_raw());
  Comparison comparison;
  comparison.first = {"a", {}, {1, 1, 1, 1, 1, 1}, {0.3, 0.3, 0.3, 0.3, 0.3, 0.3}, 0, {}, true};
  comparison.second = {"b", {}, {2, 1, 1, 1, 1, 3}, {0.4, 0.4, 0.4, 0.4, 0.4, 0.4}, 0, {}, true};
  const CellAgreement found = cell_agreement(comparison, mesh, 1)[0];
  EXPECT_NEAR(found.within, 5. / 6, 1e-15);  // 2 and 4 errors off
  EXPECT_NEAR(found.root_mean_square, std::sqrt((4. + 16.) / 6), 1e-14);
  EXPECT_NEAR(found.difference, std::sqrt(5. / 6), 1e-14);
  EXPECT_DOUBLE_EQ(found.median_first, 0.3);
}

// Two methods that share nothing but the problem agree on it.
TEST(Compare, OrdinatesAndPhotonsAgree) {
  const CaseFolder folder;
  const Outcome outcome = etendue_says({"compare", folder.file(), "--methods", "ordinates,photons", "--set",
                                        "solve.photons=20000", "--set", "solve.probe_photons=2000", "--set",
                                        "directions.order=4"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  for (const char* name : {"comparison.csv", "comparison.html", "difference.vtu", "ordinates", "photons"})
    EXPECT_EQ(std::ranges::count(ScratchFolder::names_in(folder.results()), name), 1) << name;
  EXPECT_TRUE(has(outcome.out, "within 3 errors")) << outcome.out;
  EXPECT_TRUE(has(outcome.out, "results: difference.vtu comparison.csv comparison.html\n")) << outcome.out;
  EXPECT_TRUE(has(text_of(folder.path() / "results/comparison.html"), "data:image/png;base64,iVBOR"));
  const std::string table = text_of(folder.path() / "results/comparison.csv");
  EXPECT_TRUE(has(table, "\"wall floor\",\"red\",incoming,")) << table;
}

}  // namespace
}  // namespace etendue::compare_test
