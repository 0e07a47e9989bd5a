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
constexpr double seconds_to_fail_together = 10;
constexpr std::chrono::milliseconds between_looks(1);

/// A signal is noted by all processes together.
bool is_fault(ExitCode code) {
  return code != ExitCode::done && code != ExitCode::not_converged && code != ExitCode::interrupted;
}

/// Waits until all processes are here, without keeping a core busy; at most so many seconds where they are
/// not negative. Returns whether they are.
bool all_arrive(MPI_Comm group, double seconds) {
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibarrier(group, &request);
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
    MPI_Comm_dup(MPI_COMM_WORLD, &end);
    ranks.emplace();
  }

  std::optional<MpiRankGroup> ranks;
  MPI_Comm end = MPI_COMM_NULL;  ///< where processes meet that have ended, while others may exchange
};

RankSession::RankSession() : joined_(is_one_of_several() ? std::make_unique<Joined>() : nullptr) {}
RankSession::~RankSession() = default;

ExitCode RankSession::run(const Program& program) {
  if (!joined_) return program(nullptr, std::cout, std::cerr);
  MpiRankGroup& ranks = *joined_->ranks;
  if (ranks.count() == 1) {
    std::cerr
        << "several processes were started together, and the MPI of this build finds one: use the launcher "
           "of the same MPI, or start one process\n";
    MPI_Finalize();
    return ExitCode::input_error;
  }
  std::ostream nowhere(nullptr);
  std::ostringstream unheard;
  const bool is_first = ranks.rank() == 0;
  if (is_first && ranks.bound_cores() < ranks.core_share())
    std::cerr << "caution: the launcher binds each process to " << ranks.bound_cores() << " of its "
              << ranks.core_share() << " cores; mpirun --bind-to none gives it all of them\n";
  const ExitCode code = is_first ? program(&ranks, std::cout, std::cerr) : program(&ranks, nowhere, unheard);
  if (!all_arrive(joined_->end, is_fault(code) ? seconds_to_fail_together : -1)) {
    if (!is_first)
      std::cerr << "process " << ranks.rank() << " of " << ranks.count() << ": " << unheard.str()
                << std::flush;
    MPI_Abort(MPI_COMM_WORLD, static_cast<int>(code));
  }
  MPI_Finalize();
  return code;
}

}  // namespace etendue
