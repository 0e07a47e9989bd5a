// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cstdlib>
#include <string_view>

#include "mesh/base/errors.h"
#include "solver/ordinates/sweep_kernel.h"

namespace etendue {

void choose_baseline(Basis basis, int stride, SweepKernelsOf<double>& kernels);
void choose_baseline(Basis basis, int stride, SweepKernelsOf<float>& kernels);
#ifdef ETENDUE_X86_KERNELS
void choose_avx2(Basis basis, int stride, SweepKernelsOf<double>& kernels);
void choose_avx2(Basis basis, int stride, SweepKernelsOf<float>& kernels);
void choose_avx512(Basis basis, int stride, SweepKernelsOf<double>& kernels);
void choose_avx512(Basis basis, int stride, SweepKernelsOf<float>& kernels);
#endif

namespace {

template <class Real>
struct Choice {
  std::string_view name;
  bool available;
  void (*choose)(Basis, int, SweepKernelsOf<Real>&);
};

#ifdef ETENDUE_X86_KERNELS
bool has_avx2() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
bool has_avx512() {
  return has_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
         __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512cd");
}
#endif

}  // namespace

int lane_stride(int bands) {
  if (bands <= 2) return bands;
  if (bands <= 4) return 4;
  return (bands + 7) / 8 * 8;
}

// On every machine alike: the order of visits decides the order of sums. With eight bands one cell fills the
// widest packet; with four only those of AVX2, which gain a sixth, while the wider ones do not mind.
bool skips_faces(int stride) { return stride >= 4; }

template <class Real>
SweepKernelsOf<Real> choose_kernels(Basis basis, int stride) {
  const Choice<Real> choices[] = {
#ifdef ETENDUE_X86_KERNELS
      {"avx512", has_avx512(), choose_avx512},
      {"avx2", has_avx2(), choose_avx2},
#endif
      {"baseline", true, choose_baseline},
  };
  const char* wanted = std::getenv("ETENDUE_ISA");
  for (const Choice<Real>& choice : choices) {
    if (wanted != nullptr && choice.name != wanted) continue;
    if (choice.available) {
      SweepKernelsOf<Real> kernels;
      choice.choose(basis, stride, kernels);
      return kernels;
    }
    if (wanted != nullptr)
      throw InputError(std::string("ETENDUE_ISA = ") + wanted + ": this machine does not have it");
  }
  throw InputError(std::string("ETENDUE_ISA = ") + wanted + ": unknown; use baseline, avx2 or avx512");
}

template SweepKernelsOf<double> choose_kernels(Basis, int);
template SweepKernelsOf<float> choose_kernels(Basis, int);

}  // namespace etendue
