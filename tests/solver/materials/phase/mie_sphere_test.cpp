// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/phase/mie_sphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace etendue::mie_sphere_test {
namespace {

using std::numbers::pi;

struct Published {
  double size_parameter;
  std::complex<double> index;
  double extinction, scattering, asymmetry;
};

// Wiscombe (1979), Mie scattering calculations, NCAR/TN-140+STR: the test cases, six decimals. Imaginary
// parts have the other sign there.
TEST(MieSphere, HasTheEfficienciesOfWiscombesTable) {
  for (const Published& p : {Published{0.099, {0.75, 0}, 0.000007, 0.000007, 0.001448},
                             Published{0.101, {0.75, 0}, 0.000008, 0.000008, 0.001507},
                             Published{10, {0.75, 0}, 2.232265, 2.232265, 0.896473},
                             Published{1000, {0.75, 0}, 1.997908, 1.997908, 0.844944},
                             Published{1, {1.33, 1e-5}, 0.093952, 0.093923, 0.184517},
                             Published{100, {1.33, 1e-5}, 2.101321, 2.096594, 0.868959},
                             Published{10, {1.5, 0}, 2.881999, 2.881999, 0.742913},
                             Published{100, {1.5, 0}, 2.094388, 2.094388, 0.818246},
                             Published{1000, {1.5, 0}, 2.013945, 2.013945, 0.827882},
                             Published{0.055, {1.5, 1}, 0.101491, 0.000011, 0.000491},
                             Published{1, {1.5, 1}, 2.336321, 0.663454, 0.192136},
                             Published{100, {1.5, 1}, 2.097502, 1.283697, 0.850252},
                             Published{1, {10, 10}, 2.532993, 2.049405, -0.110664},
                             Published{100, {10, 10}, 2.071124, 1.836785, 0.556215}}) {
    const MieSphere sphere(p.size_parameter, p.index);
    EXPECT_NEAR(sphere.extinction(), p.extinction, 1e-6) << p.size_parameter << p.index;
    EXPECT_NEAR(sphere.scattering(), p.scattering, 1e-6) << p.size_parameter << p.index;
    EXPECT_NEAR(sphere.asymmetry(), p.asymmetry, 1e-6) << p.size_parameter << p.index;
  }
}

TEST(MieSphere, HasTheEfficienciesOfBohrenAndHuffmansExample) {
  // Appendix A: radius 0.525, wavelength 0.6328, index 1.55.
  const MieSphere sphere(2 * pi * 0.525 / 0.6328, 1.55);
  EXPECT_NEAR(sphere.scattering(), 3.10543, 5e-6);
  EXPECT_NEAR(sphere.extinction(), 3.10543, 5e-6);
  // Q_back = 4 |S(180 degrees)|^2 / x^2 = 2.92534 there, and S_1 = -S_2 backwards.
  const double x = 2 * pi * 0.525 / 0.6328;
  EXPECT_NEAR(4 * sphere.intensity(-1) / 2 / (x * x), 2.92534, 5e-6);
}

TEST(MieSphere, ThatIsSmallScattersAsRayleighSays) {
  const std::complex<double> m(1.4, 0.1), k = (m * m - 1.0) / (m * m + 2.0);
  for (const double x : {1e-4, 1e-3, 1e-2}) {
    const MieSphere sphere(x, m);
    EXPECT_NEAR(sphere.scattering(), 8.0 / 3 * std::pow(x, 4) * std::norm(k),
                2 * x * x * sphere.scattering());
    EXPECT_NEAR(sphere.extinction(), 4 * x * k.imag(), 2 * x * x * sphere.extinction());
    for (const double mu : {-1.0, 0.2, 1.0})
      EXPECT_NEAR(sphere.intensity(mu) / sphere.intensity(0), 1 + mu * mu, 3 * x * x);
  }
}

TEST(MieSphere, ThatDoesNotAbsorbScattersAllThatItTakes) {
  for (const double x : {0.3, 1.0, 7.7, 250.0}) {
    const MieSphere sphere(x, 1.33);
    EXPECT_NEAR(sphere.scattering() / sphere.extinction(), 1, 1e-11);
  }
}

}  // namespace
}  // namespace etendue::mie_sphere_test
