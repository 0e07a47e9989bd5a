// SPDX-License-Identifier: AGPL-3.0-or-later
#include <array>
#include <cstdlib>

#include "app/ranks/rank_session.h"

namespace etendue {

// Open MPI, MPICH and its kin, Slurm's PMI2: each tells the number of processes.
bool is_one_of_several() {
  for (const char* name : std::array{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MPI_LOCALNRANKS"})
    if (const char* count = std::getenv(name)) return std::atoi(count) > 1;
  // Under srun with PMIx the number is that of Slurm's tasks; without PMI a process cannot find the others.
  const char* tasks = std::getenv("SLURM_NTASKS");
  return std::getenv("PMIX_RANK") != nullptr && tasks != nullptr && std::atoi(tasks) > 1;
}

}  // namespace etendue
