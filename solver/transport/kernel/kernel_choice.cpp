// SPDX-License-Identifier: AGPL-3.0-or-later
#include <array>
#include <string_view>

#include "base/parallel/instruction_set.h"
#include "solver/transport/kernel/sweep_kernel.h"

namespace etendue {

void choose_baseline(Basis basis, int stride, SweepKernelsOf<double>& kernels);
void choose_baseline(Basis basis, int stride, SweepKernelsOf<float>& kernels);
#ifdef ETENDUE_X86_KERNELS
void choose_avx2(Basis basis, int stride, SweepKernelsOf<double>& kernels);
void choose_avx2(Basis basis, int stride, SweepKernelsOf<float>& kernels);
void choose_avx512(Basis basis, int stride, SweepKernelsOf<double>& kernels);
void choose_avx512(Basis basis, int stride, SweepKernelsOf<float>& kernels);
#endif

// On every machine alike: the order of visits decides the order of sums. With eight bands one cell fills the
// widest packet; with four only those of AVX2, which gain a sixth, while the wider ones do not mind.
bool skips_faces(int stride) { return stride >= 4; }

template <class Real>
SweepKernelsOf<Real> choose_kernels(Basis basis, int stride) {
  using Choose = void (*)(Basis, int, SweepKernelsOf<Real>&);
#ifdef ETENDUE_X86_KERNELS
  constexpr std::array<std::string_view, 3> built = {"avx512", "avx2", "baseline"};
  constexpr std::array<Choose, 3> choose = {choose_avx512, choose_avx2, choose_baseline};
#else
  constexpr std::array<std::string_view, 1> built = {"baseline"};
  constexpr std::array<Choose, 1> choose = {choose_baseline};
#endif
  SweepKernelsOf<Real> kernels;
  choose[choose_instruction_set(built)](basis, stride, kernels);
  return kernels;
}

template SweepKernelsOf<double> choose_kernels(Basis, int);
template SweepKernelsOf<float> choose_kernels(Basis, int);

}  // namespace etendue
