// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/vtk/solution_bytes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>

#include "base/array_bytes.h"

namespace etendue::solution_bytes_test {
namespace {

/// A solution of two cells and two bands, as the process that reads its file leaves it.
std::string bytes_of(const std::string& format, const std::string& names, std::size_t errors) {
  std::FILE* file = std::tmpfile();
  for (const std::string& text : {format, std::string("1a2b\n"), std::string("media 3c4d\n"), names})
    write_array(file, std::vector<char>(text.begin(), text.end()));
  write_array(file, std::vector<std::int64_t>{2});
  write_array(file, std::vector<double>(16, 0.5));
  for (std::size_t part = 0; part < state_parts.size(); ++part) write_array(file, std::vector<double>());
  write_array(file, std::vector<double>(errors, 0.1));
  write_array(file, std::vector<double>());
  std::string bytes(static_cast<std::size_t>(std::ftell(file)), '\0');
  std::rewind(file);
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file));
  std::fclose(file);
  return bytes;
}

const std::string format_line = std::string(solution_format) + "\n";

TEST(SolutionBytes, AreTakenWithWhatTheySayOfTheirCase) {
  const auto saved = take_solution(bytes_of(format_line, "red\ngreen\n", 4));
  ASSERT_TRUE(saved.has_value());
  EXPECT_EQ(saved->mesh, "1a2b");
  EXPECT_EQ(saved->case_parts, (std::vector<CasePart>{{"media", "3c4d"}}));
  EXPECT_EQ(saved->result.state.bands, 2);
  EXPECT_EQ(saved->result.state.fluence.size(), 16u);
  EXPECT_EQ(saved->result.direction_error.size(), 4u);
}

TEST(SolutionBytes, OfAnotherFormatOrWithoutALineEndAreNone) {
  EXPECT_FALSE(take_solution(bytes_of("etendue solution 1\n", "red\n", 0)).has_value());
  const auto saved = take_solution(bytes_of(format_line, "red\ngreen", 0));
  ASSERT_TRUE(saved.has_value());
  EXPECT_EQ(saved->result.state.bands, 2);
}

TEST(SolutionBytes, WithErrorsThatAreNotOfTheirCellsAreNone) {
  for (const std::size_t errors : {1u, 2u, 5u})
    EXPECT_FALSE(take_solution(bytes_of(format_line, "red\ngreen\n", errors)).has_value()) << errors;
}

TEST(SolutionBytes, ThatAreCutShortAreRefused) {
  const std::string bytes = bytes_of(format_line, "red\n", 2);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THROW(take_solution(std::string_view(bytes).substr(0, size)), std::runtime_error) << size;
}

}  // namespace
}  // namespace etendue::solution_bytes_test
