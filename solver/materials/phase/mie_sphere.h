// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <complex>
#include <vector>

namespace etendue {

/// Scattering of a plane wave by a homogeneous sphere (Mie 1908), in the notation of Bohren and Huffman
/// (1983, chapter 4): x = 2 pi radius / wavelength in the surrounding medium, refractive index m = n + i k
/// relative to it, k >= 0 absorbs.
class MieSphere {
 public:
  MieSphere(double size_parameter, std::complex<double> index);

  // Cross sections over pi radius^2.
  double extinction() const { return extinction_; }  ///< Q_ext
  double scattering() const { return scattering_; }  ///< Q_sca
  double asymmetry() const { return asymmetry_; }    ///< mean cosine g
  /// Terms of the series; |S_1|^2 + |S_2|^2 is a polynomial of twice that degree in the cosine.
  int terms() const { return static_cast<int>(electric_.size()); }
  /// |S_1|^2 + |S_2|^2 at a cosine of the angle of deflection; its integral over the sphere is
  /// 2 pi x^2 Q_sca.
  double intensity(double mu) const;

 private:
  void sum_efficiencies(double size_parameter);

  std::vector<std::complex<double>> electric_;  ///< a_n from n = 1
  std::vector<std::complex<double>> magnetic_;  ///< b_n
  double extinction_ = 0, scattering_ = 0, asymmetry_ = 0;
};

}  // namespace etendue
