// SPDX-License-Identifier: AGPL-3.0-or-later
#include <array>

#include "base/parallel/instruction_set.h"
#include "solver/photons/kernel/photon_kernel.h"

namespace etendue {

PhotonKernels photon_kernels_baseline();
#ifdef ETENDUE_X86_KERNELS
PhotonKernels photon_kernels_avx2();
PhotonKernels photon_kernels_avx512();
#endif

PhotonKernels choose_photon_kernels() {
#ifdef ETENDUE_X86_KERNELS
  constexpr std::array<std::string_view, 3> built = {"avx512", "avx2", "baseline"};
  constexpr std::array make = {photon_kernels_avx512, photon_kernels_avx2, photon_kernels_baseline};
#else
  constexpr std::array<std::string_view, 1> built = {"baseline"};
  constexpr std::array make = {photon_kernels_baseline};
#endif
  return make[choose_instruction_set(built)]();
}

}  // namespace etendue
