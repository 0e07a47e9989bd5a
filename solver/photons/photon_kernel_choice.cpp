// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cstdlib>
#include <string_view>

#include "solver/photons/photon_kernel.h"

namespace etendue {

PhotonKernels photon_kernels_baseline();
#ifdef ETENDUE_X86_KERNELS
PhotonKernels photon_kernels_avx2();
#endif

PhotonKernels choose_photon_kernels() {
#ifdef ETENDUE_X86_KERNELS
  const char* wanted = std::getenv("ETENDUE_ISA");
  const bool narrow = wanted != nullptr && std::string_view(wanted) == "baseline";
  if (!narrow && __builtin_cpu_supports("avx2")) return photon_kernels_avx2();
#endif
  return photon_kernels_baseline();
}

}  // namespace etendue
