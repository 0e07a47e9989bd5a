// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/results.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "base/errors.h"
#include "tests/app/write/sample_run.h"

namespace etendue::results_test {
namespace {

using test::SampleRun;
using test::ScratchFolder;
using test::text_of;
using test::write_text;
using Names = std::vector<std::string>;

const Names all_files = {"fields.vtu",   "history.csv", "probes.csv", "regions.csv",
                         "summary.json", "walls.csv",   "walls.vtp"};

/// No file may grow beyond this while it lives: what a full disk does, for one process.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST(Results, AreAllWritten) {
  const ScratchFolder scratch;
  SampleRun run({"grey"});
  run.input.output.directory = scratch.path() / "deep" / "results";
  const WrittenResults written = write_results(run.result());
  EXPECT_EQ(ScratchFolder::names_in(run.input.output.directory), all_files);
  EXPECT_EQ(written.files.size(), all_files.size());
}

TEST(Results, ReplaceThoseOfAnEarlierRunWhole) {
  const ScratchFolder scratch;
  SampleRun run({"grey"});
  run.input.output.directory = scratch.path();
  write_results(run.result());
  write_text(scratch.path() / "notes.txt", "mine");
  run.probes.clear();
  write_results(run.result());
  EXPECT_EQ(ScratchFolder::names_in(scratch.path()),
            (Names{"fields.vtu", "history.csv", "notes.txt", "regions.csv", "summary.json", "walls.csv",
                   "walls.vtp"}));
}

TEST(Results, HaveTheSameBytesEachTimeButForTheSummary) {
  const ScratchFolder scratch;
  SampleRun run({"red", "green", "blue"});
  for (const char* name : {"first", "second"}) {
    run.input.output.directory = scratch.path() / name;
    write_results(run.result());
  }
  for (const std::string& name : all_files)
    if (name != "summary.json") {
      EXPECT_EQ(text_of(scratch.path() / "first" / name), text_of(scratch.path() / "second" / name)) << name;
    }
}

TEST(Results, ThatDoNotFitOnTheDiskLeaveTheEarlierOnesAsTheyWere) {
  const ScratchFolder scratch;
  SampleRun run({"grey"});
  run.input.output.directory = scratch.path();
  write_results(run.result());
  const std::string before = text_of(scratch.path() / "fields.vtu");
  run.solution.fluence.front() = 1e9;
  const rlim_t length = before.size();
  for (const rlim_t bytes : {rlim_t{0}, rlim_t{600}, rlim_t{2000}, length / 2, length - 20}) {
    const FileSizeLimit limit(bytes);
    EXPECT_THROW(write_results(run.result()), FileError) << bytes;
  }
  EXPECT_EQ(ScratchFolder::names_in(scratch.path()), all_files);
  EXPECT_EQ(text_of(scratch.path() / "fields.vtu"), before);
}

TEST(Results, InAPlaceThatIsAFileAreRefused) {
  const ScratchFolder scratch;
  SampleRun run({"grey"});
  run.input.output.directory = scratch.path() / "file";
  write_text(run.input.output.directory, "mine");
  EXPECT_THROW(write_results(run.result()), FileError);
  EXPECT_EQ(text_of(run.input.output.directory), "mine");
}

}  // namespace
}  // namespace etendue::results_test
