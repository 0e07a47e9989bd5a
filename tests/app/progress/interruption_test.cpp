// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/app/run/small_case.h"
#include "tests/support/checkout.h"

namespace etendue::interruption_test {
namespace {

using nlohmann::json;
using test::CaseFolder;
using test::ScratchFolder;
using test::text_of;

/// The program as a process of its own; what it says goes to the file `said`.
class Process {
 public:
  Process(const std::vector<std::string>& arguments, const std::filesystem::path& said) : said_(said) {
    id_ = fork();
    if (id_ == 0) become(arguments);
  }
  ~Process() {
    if (!ended_) kill(id_, SIGKILL), wait();
  }

  void send(int signal) const { kill(id_, signal); }

  /// The exit code; minus the signal where one killed it.
  int wait() {
    int status = 0;
    waitpid(id_, &status, 0);
    ended_ = true;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  /// Waits until the program has said this. Instrumented code on a busy machine takes a minute for a sweep of
  /// seconds.
  bool says(const std::string& part) const {
    for (int i = 0; i < 20000; ++i) {
      if (text_of(said_).find(part) != std::string::npos) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

 private:
  void become(const std::vector<std::string>& arguments) const {
    const int file = open(said_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    std::vector<std::string> words = {ETENDUE_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    execv(ETENDUE_PROGRAM, pointers.data());
    _exit(127);
  }

  std::filesystem::path said_;
  pid_t id_ = 0;
  bool ended_ = false;
};

/// A case whose iteration does not end within the test.
std::vector<std::string> endless_run(const CaseFolder& folder) {
  return {"run",        folder.file(),
          "--progress", "plain",
          "--set",      "solve.tolerance=1e-15",
          "--set",      "solve.max_sweeps=100000000",
          "--set",      "media.smoke.absorption=0.0001",
          "--set",      "media.smoke.scattering=3000",
          "--set",      "walls.'*'.diffuse=1"};
}

std::filesystem::path said_in(const CaseFolder& folder) { return folder.path() / "said"; }

TEST(Interruption, WhileSolvingLeavesWholeResultsThatAreMarked) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const CaseFolder folder;
    Process run(endless_run(folder), said_in(folder));
    ASSERT_TRUE(run.says("sweep    1")) << text_of(said_in(folder));
    run.send(signal);
    EXPECT_EQ(run.wait(), 130) << text_of(said_in(folder));
    EXPECT_EQ(ScratchFolder::names_in(folder.results()),
              (std::vector<std::string>{"fields.vtu", "history.csv", "log.txt", "probes.csv", "regions.csv",
                                        "solution.vtu", "summary.json", "walls.csv", "walls.vtp"}));
    const json summary = json::parse(text_of(std::filesystem::path(folder.results()) / "summary.json"));
    EXPECT_EQ(summary["converged"], false);
    EXPECT_EQ(summary["interrupted"], true);
  }
}

/// A case of sweeps that take seconds, on one thread: 2,048 directions, 16 bands, 36 moments.
constexpr const char* long_sweeps = R"([mesh]
max_volume = 1.2e-3
[[mesh.box]]
region = "smoke"
min = [0, 0, 0]
max = [1, 1, 1]
[bands]
names = ["a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m", "n", "o", "p"]
[media.smoke]
absorption = 0.1
scattering = 5
phase = { model = "henyey-greenstein", g = 0.6 }
[walls."*"]
radiance = 1
diffuse = 0.5
[directions]
set = "product"
order = 32
[solve]
threads = 1
method = "source-iteration"
tolerance = 1e-12
[output]
directory = "results"
)";

// All results would take the sweep to its end, and another one.
TEST(Interruption, WithinALongSweepLeavesTheStateToGoOnFrom) {
  const CaseFolder folder(long_sweeps);
  Process run({"run", folder.file(), "--progress", "plain"}, said_in(folder));
  ASSERT_TRUE(run.says("sweep    1")) << text_of(said_in(folder));
  run.send(SIGINT);
  EXPECT_EQ(run.wait(), 130) << text_of(said_in(folder));
  EXPECT_EQ(ScratchFolder::names_in(folder.results()), (std::vector<std::string>{"log.txt", "solution.vtu"}));
  const std::string state = (std::filesystem::path(folder.results()) / "solution.vtu").string();
  EXPECT_NE(text_of(said_in(folder)).find("--set 'solve.initial=\"" + state + "\"'"), std::string::npos)
      << text_of(said_in(folder));
}

TEST(Interruption, BeforeTheFirstSweepIsDoneLeavesNothing) {
  const CaseFolder folder(long_sweeps);
  Process run({"run", folder.file(), "--progress", "plain"}, said_in(folder));
  ASSERT_TRUE(run.says("first sweep:")) << text_of(said_in(folder));  // it has taken a second
  run.send(SIGTERM);
  EXPECT_EQ(run.wait(), 130) << text_of(said_in(folder));
  EXPECT_NE(text_of(said_in(folder)).find("nothing was written"), std::string::npos);
  EXPECT_EQ(ScratchFolder::names_in(folder.path()), (std::vector<std::string>{"case.toml", "said"}));
}

TEST(Interruption, WhileEstimatingErrorsLeavesTheResultsOfTheRun) {
  const CaseFolder folder;
  Process run({"run", folder.file(), "--progress", "plain", "--estimate", "--set", "directions.order=64"},
              said_in(folder));
  ASSERT_TRUE(run.says("open with: paraview")) << text_of(said_in(folder));
  run.send(SIGINT);
  const int code = run.wait();
  // On a fast machine it may have ended before.
  EXPECT_TRUE(code == 130 || code == 0) << text_of(said_in(folder));
  const json summary = json::parse(text_of(std::filesystem::path(folder.results()) / "summary.json"));
  EXPECT_EQ(summary["converged"], true);
  EXPECT_EQ(summary["interrupted"], false);
  if (code == 130) {
    EXPECT_NE(text_of(said_in(folder)).find("but for the estimate of their errors"), std::string::npos)
        << text_of(said_in(folder));
  }
}

// The accuracy is never reached: round after round leaves its files.
TEST(Interruption, OnTheWayToAnAccuracyLeavesTheLastWholeRound) {
  const CaseFolder folder;
  Process run({"run", folder.file(), "--progress", "plain", "--set", "accuracy.relative=1e-6"},
              said_in(folder));
  ASSERT_TRUE(run.says("\n      6  ")) << text_of(said_in(folder));
  run.send(SIGINT);
  EXPECT_EQ(run.wait(), 130) << text_of(said_in(folder));
  EXPECT_NE(text_of(said_in(folder)).find("interrupted: the results are"), std::string::npos)
      << text_of(said_in(folder));
  const json summary = json::parse(text_of(std::filesystem::path(folder.results()) / "summary.json"));
  EXPECT_EQ(summary["converged"], true);
  EXPECT_EQ(summary["interrupted"], false);
  EXPECT_EQ(summary["accuracy"]["reached"], false);
  EXPECT_GE(summary["accuracy"]["rounds"].size(), 5U);
  EXPECT_EQ(summary["accuracy"]["rounds"].back()["cells"], summary["cells"]);
  for (const json& file : summary["files"])
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(folder.results()) / file.get<std::string>()))
        << file;
}

/// The last line of what the program said.
std::string last_line_of(const std::string& said) {
  const std::size_t before = said.rfind('\n', said.size() - 2);
  return said.substr(before + 1);
}

// The third level of eight times the cells takes minutes to mesh.
TEST(Interruption, OfAStudyLeavesAndShowsTheLevelsThatAreDone) {
  const CaseFolder folder;
  Process study({"study", folder.file(), "--levels", "3", "--progress", "plain", "--set",
                 "mesh.max_volume=2e-4", "--no-plot", "--refine", "mesh"},
                said_in(folder));
  ASSERT_TRUE(study.says("level 3 of 3")) << text_of(said_in(folder));
  study.send(SIGINT);
  EXPECT_EQ(study.wait(), 130) << text_of(said_in(folder));
  const std::string said = text_of(said_in(folder));
  EXPECT_EQ(last_line_of(said), "interrupted: of 3 levels level-1, level-2 are done, in " +
                                    std::filesystem::path(folder.results()).string() +
                                    " with study.csv and study.json; to go on: the same command with "
                                    "--resume\n");
  EXPECT_NE(said.find("how far to trust level 2"), std::string::npos) << said;
  EXPECT_EQ(said.find("nothing was written"), std::string::npos) << said;
}

TEST(Interruption, WhileMeshingLeavesNothing) {
  const CaseFolder folder;
  std::vector<std::string> arguments = endless_run(folder);
  arguments.insert(arguments.end(), {"--set", "mesh.max_volume=1e-7"});  // some minutes of meshing
  Process run(arguments, said_in(folder));
  ASSERT_TRUE(run.says("Small")) << text_of(said_in(folder));
  run.send(SIGINT);
  EXPECT_EQ(run.wait(), 130) << text_of(said_in(folder));
  EXPECT_EQ(ScratchFolder::names_in(folder.path()), (std::vector<std::string>{"case.toml", "said"}));
}

/// A sensor that takes minutes: 40,000 points with 20,000 rays each.
constexpr const char* long_sensor = R"(
[[sensor]]
kind = "grid"
name = "desk"
position = [0.1, 0.1, 0.2]
along = [0.8, 0, 0]
across = [0, 0.8, 0]
parts = [200, 200]
rays = 20000
)";

TEST(Interruption, WhileReadingSensorsLeavesWholeResultsWithoutThem) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const CaseFolder folder(test::small_case() + long_sensor);
    Process run({"run", folder.file(), "--progress", "plain"}, said_in(folder));
    ASSERT_TRUE(run.says("sensors: ")) << text_of(said_in(folder));
    const auto sent = std::chrono::steady_clock::now();
    run.send(signal);
    EXPECT_EQ(run.wait(), 130) << text_of(said_in(folder));
    EXPECT_LT(std::chrono::steady_clock::now() - sent, std::chrono::seconds(2));
    EXPECT_EQ(ScratchFolder::names_in(folder.results()),
              (std::vector<std::string>{"fields.vtu", "history.csv", "log.txt", "probes.csv", "regions.csv",
                                        "solution.vtu", "summary.json", "walls.csv", "walls.vtp"}));
    const json summary = json::parse(text_of(std::filesystem::path(folder.results()) / "summary.json"));
    EXPECT_EQ(summary["converged"], true);
    EXPECT_EQ(summary["interrupted"], true);
    EXPECT_EQ(summary["left_out"], json{"1 of 1 sensors"});
    EXPECT_NE(text_of(said_in(folder)).find("but for 1 of 1 sensors"), std::string::npos);
  }
}

std::vector<std::string> by_photons(const CaseFolder& folder, const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"run",   folder.file(), "--progress",
                                        "plain", "--set",       "solve.method='photons'"};
  for (const std::string& setting : more) arguments.insert(arguments.end(), {"--set", setting});
  return arguments;
}

// Nothing but the walk back gives the values of these probes.
TEST(Interruption, WhilePhotonProbesAreWalkedBackLeavesThemOut) {
  const CaseFolder folder;
  Process run(by_photons(folder, {"solve.photons=3000", "solve.probe_photons=1e9"}), said_in(folder));
  ASSERT_TRUE(run.says("probes: ")) << text_of(said_in(folder));
  const auto sent = std::chrono::steady_clock::now();
  run.send(SIGINT);
  EXPECT_EQ(run.wait(), 130) << text_of(said_in(folder));
  EXPECT_LT(std::chrono::steady_clock::now() - sent, std::chrono::seconds(2));
  const json summary = json::parse(text_of(std::filesystem::path(folder.results()) / "summary.json"));
  EXPECT_EQ(summary["interrupted"], true);
  EXPECT_EQ(summary["left_out"], json{"1 of 1 points of probes"});
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::path(folder.results()) / "probes.csv"));
  EXPECT_NE(text_of(said_in(folder)).find("but for 1 of 1 points of probes"), std::string::npos);
}

TEST(Interruption, WithinABatchOfHistoriesLeavesTheWholeOnes) {
  const CaseFolder folder;
  Process run(by_photons(folder, {"solve.photons=1e9", "solve.probe_photons=500"}), said_in(folder));
  ASSERT_TRUE(run.says("error")) << text_of(said_in(folder));
  run.send(SIGINT);
  EXPECT_EQ(run.wait(), 130) << text_of(said_in(folder));
  const json summary = json::parse(text_of(std::filesystem::path(folder.results()) / "summary.json"));
  EXPECT_EQ(summary["interrupted"], true);
  EXPECT_GE(summary["photons"]["histories"], 2e5);
  EXPECT_NE(text_of(said_in(folder)).find("histories in each band; to go on from there"), std::string::npos)
      << text_of(said_in(folder));
}

TEST(Interruption, BeforeABatchOfHistoriesIsWholeLeavesNothing) {
  const CaseFolder folder;
  Process run(by_photons(folder, {"solve.photons=1e9", "media.smoke.absorption=1e-9",
                                  "media.smoke.scattering=1e6", "walls.'*'.diffuse=1"}),
              said_in(folder));
  ASSERT_TRUE(run.says(" of 1e+09")) << text_of(said_in(folder));  // it has taken a second
  run.send(SIGINT);
  EXPECT_EQ(run.wait(), 130) << text_of(said_in(folder));
  EXPECT_NE(text_of(said_in(folder)).find("nothing was written"), std::string::npos);
  EXPECT_EQ(ScratchFolder::names_in(folder.path()), (std::vector<std::string>{"case.toml", "said"}));
}

// Rays may take long, and before the first sweep there is nothing to keep.
TEST(Interruption, WhileFollowingLightsLeavesNothing) {
  const ScratchFolder folder;
  const std::filesystem::path said = folder.path() / "said";
  Process run({"run", test::checkout("cases/kobayashi-3/uncollided.toml"), "--output",
               (folder.path() / "results").string(), "--set",
               R"(mesh.max_volume={ "*" = 400, void = 2, source = 0.1 })"},
              said);
  ASSERT_TRUE(run.says("memory:")) << text_of(said);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  run.send(SIGINT);
  EXPECT_EQ(run.wait(), 130) << text_of(said);
  EXPECT_NE(text_of(said).find("interrupted: nothing was written"), std::string::npos) << text_of(said);
  EXPECT_EQ(ScratchFolder::names_in(folder.path()), (std::vector<std::string>{"said"}));
}

TEST(Interruption, KilledRunLeavesNoFileUnderItsName) {
  const CaseFolder folder;
  Process run(endless_run(folder), said_in(folder));
  ASSERT_TRUE(run.says("sweep    1")) << text_of(said_in(folder));
  run.send(SIGKILL);
  EXPECT_EQ(run.wait(), -SIGKILL);
  EXPECT_EQ(ScratchFolder::names_in(folder.path()), (std::vector<std::string>{"case.toml", "said"}));
}

/// Waits until the file is there.
bool appears(const std::filesystem::path& file) {
  for (int i = 0; i < 3000 && !std::filesystem::exists(file); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return std::filesystem::exists(file);
}

TEST(Interruption, KilledRunLeavesItsLastWholeCheckpoint) {
  const CaseFolder folder;
  const std::filesystem::path results = folder.results();
  std::vector<std::string> arguments = endless_run(folder);
  arguments.insert(arguments.end(), {"--set", "output.checkpoint_every=1"});
  Process run(arguments, said_in(folder));
  ASSERT_TRUE(appears(results / "solution.vtu")) << text_of(said_in(folder));
  // Some checkpoints later, wherever in the writing of one.
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  run.send(SIGKILL);
  EXPECT_EQ(run.wait(), -SIGKILL);
  EXPECT_FALSE(std::filesystem::exists(results / "summary.json"));
  arguments.insert(arguments.end(), {"--set", "solve.max_sweeps=1", "--set",
                                     "solve.initial='" + (results / "solution.vtu").string() + "'"});
  Process continued(arguments, said_in(folder));
  EXPECT_EQ(continued.wait(), 1) << text_of(said_in(folder));
  EXPECT_NE(text_of(said_in(folder)).find("starts from"), std::string::npos);
}

}  // namespace
}  // namespace etendue::interruption_test
