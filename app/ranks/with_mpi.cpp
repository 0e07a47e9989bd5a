// SPDX-License-Identifier: AGPL-3.0-or-later
#include <mpi.h>

#include <chrono>
#include <iostream>
#include <sstream>
#include <thread>

#include "app/ranks/mpi_rank_group.h"
#include "app/ranks/rank_session.h"

namespace etendue {
namespace {

/// Where all processes fail alike they do so within this time, and the first one is heard.
constexpr double seconds_to_fail_together = 2;
constexpr std::chrono::milliseconds between_looks(1);

bool is_fault(ExitCode code) { return code != ExitCode::done && code != ExitCode::not_converged; }

/// Waits until all processes are here, without keeping a core busy; at most so many seconds where they are
/// not negative. Returns whether they are.
bool all_arrive(double seconds) {
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibarrier(MPI_COMM_WORLD, &request);
  const double begun = MPI_Wtime();
  for (int here = 0;;) {
    MPI_Test(&request, &here, MPI_STATUS_IGNORE);
    if (here != 0) return true;
    if (seconds >= 0 && MPI_Wtime() - begun > seconds) return false;
    std::this_thread::sleep_for(between_looks);
  }
}

}  // namespace

struct RankSession::Joined {
  Joined() {
    int support = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &support);
    ranks.emplace();
  }

  std::optional<MpiRankGroup> ranks;
};

RankSession::RankSession() : joined_(is_one_of_several() ? std::make_unique<Joined>() : nullptr) {}
RankSession::~RankSession() = default;

ExitCode RankSession::run(const Program& program) {
  if (!joined_) return program(nullptr, std::cout, std::cerr);
  MpiRankGroup& ranks = *joined_->ranks;
  std::ostream nowhere(nullptr);
  std::ostringstream unheard;
  const bool is_first = ranks.rank() == 0;
  const ExitCode code = is_first ? program(&ranks, std::cout, std::cerr) : program(&ranks, nowhere, unheard);
  if (!all_arrive(is_fault(code) ? seconds_to_fail_together : -1)) {
    if (!is_first)
      std::cerr << "process " << ranks.rank() << " of " << ranks.count() << ": " << unheard.str()
                << std::flush;
    MPI_Abort(MPI_COMM_WORLD, static_cast<int>(code));
  }
  MPI_Finalize();
  return code;
}

}  // namespace etendue
