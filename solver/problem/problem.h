// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/angular_space.h"
#include "base/errors.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/materials/kernels/directional_scattering.h"
#include "solver/materials/media/angular_formula.h"
#include "solver/materials/media/coefficient.h"
#include "solver/materials/phase/phase_function.h"
#include "solver/materials/surfaces/reflectance.h"
#include "solver/problem/bands.h"
#include "solver/problem/cell_emission.h"
#include "solver/problem/following_sources.h"
#include "solver/problem/lights/light.h"
#include "solver/problem/scattering_choice.h"

namespace etendue {

/// The medium in one region, per band.
struct Medium {
  std::string name;                     ///< region
  std::vector<Coefficient> absorption;  ///< [band] sigma_a [1/length]
  std::vector<Coefficient> scattering;  ///< [band] sigma_s [1/length]
  std::vector<Coefficient> emission;    ///< [band] q [power/(length^3 sr)], isotropic
  std::vector<PhaseFunction> phase;     ///< [band]
  Origin origin;
  Uncollided uncollided = Uncollided::automatic;  ///< of the emission
  std::vector<ScatteringChoice> choice = {};      ///< [band]; empty: automatic
  /// [band] in place of a phase function; absorption and scattering are then means over directions. Empty:
  /// none.
  std::vector<DirectionalScattering> directional = {};
  /// [band] sigma_a(x, w), of which `absorption` is the mean over directions; empty: none
  std::vector<std::optional<AngularFormula>> absorption_by_direction = {};
  /// Whether it is the extinction, of which a kernel's scattering is a part.
  bool extinction_by_direction = false;
  /// [band] q(x, w), beside `emission`; empty: none
  std::vector<std::optional<AngularFormula>> emission_by_direction = {};
  /// [band] radiance I_b of a blackbody of the medium's temperature [power/(length^2 sr)]: beside `emission`
  /// the cell's mean absorption times I_b is emitted (Kirchhoff's law); empty: none
  std::vector<Coefficient> blackbody = {};
  /// [band] the part of `scattering` [1/length] that is absorbed and sent out again as heat, of a gray medium
  /// whose temperature follows (radiative equilibrium); empty: none
  std::vector<Coefficient> reradiation = {};

  bool is_directional(int band) const {
    return !directional.empty() && directional[static_cast<std::size_t>(band)].index() != 0;
  }

  bool absorbs_by_direction(int band) const {
    return static_cast<std::size_t>(band) < absorption_by_direction.size() &&
           absorption_by_direction[static_cast<std::size_t>(band)].has_value();
  }

  ScatteringChoice choice_of(int band) const {
    return choice.empty() ? ScatteringChoice{} : choice[static_cast<std::size_t>(band)];
  }
};

/// What one wall does, per band. Of light from any direction
/// diffuse + specular + glossy albedo + transmittance <= 1.
struct Wall {
  std::string name;
  std::vector<double> radiance;  ///< [band] sent into the domain [power/(length^2 sr)], isotropic
  std::vector<double> diffuse;   ///< [band] Lambertian reflectance
  std::vector<double> specular;  ///< [band] mirror reflectance
  Origin origin;
  Uncollided uncollided = Uncollided::automatic;  ///< of the radiance
  /// [band] L(x, w), beside `radiance`; empty: none
  std::vector<std::optional<AngularFormula>> radiance_by_direction = {};
  /// Of the domain over that of what is behind the wall. Other than 1 it mirrors as a smooth surface does
  /// (Fresnel) and sends the rest out, it reflects nothing else, and `radiance` is that of what is behind.
  double refractive_index = 1;
  /// [band] what is reflected beside `diffuse` and `specular`; empty or null: nothing. Shared since walls are
  /// copied.
  std::vector<std::shared_ptr<const Reflectance>> glossy = {};
  /// [band] of a sheet: what arrives here and leaves diffusely on its other side; empty: none
  std::vector<double> transmittance = {};
  /// [band] the part of `diffuse` that is absorbed and sent out again as heat, of a gray wall whose
  /// temperature follows; empty: none
  std::vector<double> reradiation = {};
  /// Whether it emits what Problem::following() says, beside `radiance`.
  bool emission_follows = false;

  const Reflectance* glossy_in(std::size_t band) const {
    return band < glossy.size() ? glossy[band].get() : nullptr;
  }
  double transmitted(std::size_t band) const { return band < transmittance.size() ? transmittance[band] : 0; }
  bool is_glossy() const;
  bool transmits() const;
  /// Part of light that is the same from all directions that the wall absorbs; its emissivity (Kirchhoff's
  /// law). What passes through a smooth surface it does not absorb.
  double absorptivity(std::size_t band) const {
    return refractive_index != 1 ? 0 : 1 - mean_reflectance(band) - transmitted(band);
  }
  /// Of light that is the same from all directions, what comes back to the same side.
  double mean_reflectance(std::size_t band) const {
    const Reflectance* lobe = glossy_in(band);
    return diffuse[band] + specular[band] + (lobe != nullptr ? lobe->albedo().mean() : 0);
  }
};

/// What is asked: the coefficients of the transport equation on every cell and wall. Valid by construction.
///
///     w.grad u + sigma_t u = integral of sigma_s p(w.w') u(w') dw' + q,   sigma_t = sigma_a + sigma_s
class Problem {
 public:
  /// The mesh must outlive the problem. `media` has one entry for each region of the mesh and `walls` one for
  /// each wall, in their order. Throws InputError where a coefficient is negative or not finite in some cell
  /// (naming its coordinates), where reflectances exceed 1, or where a band has no steady state because
  /// something emits while nothing absorbs and every wall reflects fully. In the plane phase functions become
  /// those of the plane, and walls must stand upright or be cold mirrors across z. `threads` sample the
  /// coefficients.
  Problem(const TetrahedralMesh& mesh, Bands bands, std::vector<Medium> media, std::vector<Wall> walls,
          AngularSpace space = AngularSpace::sphere, std::vector<Light> lights = {}, int threads = 1);

  /// The same in some bands alone, in this order. The mesh must outlive that too.
  Problem of_bands(std::span<const int> bands) const;

  const TetrahedralMesh& mesh() const { return mesh_; }
  const Bands& bands() const { return bands_; }
  int band_count() const { return bands_.count(); }
  AngularSpace space() const { return space_; }

  // Cell means, [cell][band].
  std::span<const double> absorption() const { return absorption_; }      ///< [1/length]
  std::span<const double> scattering() const { return scattering_; }      ///< [1/length]
  std::span<const double> emission() const { return emission_.means(); }  ///< [power/(length^3 sr)]
  double absorption(CellIndex c, int band) const { return absorption_[at(c, band)]; }
  double scattering(CellIndex c, int band) const { return scattering_[at(c, band)]; }
  double emission(CellIndex c, int band) const { return emission_.mean(c, static_cast<std::size_t>(band)); }
  /// Emission within the cells, of which emission() is the mean.
  const CellEmission& cell_emission() const { return emission_; }

  /// Beside what media and walls say: of those whose temperature follows from their heat.
  const FollowingSources& following() const { return following_; }
  /// Sets it; cell_emission() is the sum of both from now on.
  void set_following(FollowingSources sources);
  /// What a wall sends beside its own radiance from vertex i of a face [power/(length^2 sr)].
  double following_radiance(FaceIndex face, std::size_t i, int band) const {
    if (following_.radiance.empty()) return 0;
    return following_.radiance[(face.at() * 3 + i) * static_cast<std::size_t>(bands_.count()) +
                               static_cast<std::size_t>(band)];
  }
  /// Its mean over a face.
  double following_radiance(FaceIndex face, int band) const {
    return (following_radiance(face, 0, band) + following_radiance(face, 1, band) +
            following_radiance(face, 2, band)) /
           3;
  }

  const Medium& medium(int region) const { return media_[static_cast<std::size_t>(region)]; }
  const Wall& wall(int wall) const { return walls_[static_cast<std::size_t>(wall)]; }
  std::span<const Medium> media() const { return media_; }
  std::span<const Wall> walls() const { return walls_; }
  /// Beside what media and walls emit.
  std::span<const Light> lights() const { return lights_; }

 private:
  std::size_t at(CellIndex c, int band) const {
    return c.at() * static_cast<std::size_t>(bands_.count()) + static_cast<std::size_t>(band);
  }

  const TetrahedralMesh& mesh_;
  Bands bands_;
  std::vector<Medium> media_;
  std::vector<Wall> walls_;
  AngularSpace space_;
  std::vector<Light> lights_;
  std::vector<double> absorption_;
  std::vector<double> scattering_;
  CellEmission emission_;
  CellEmission own_emission_;  ///< that of media, once another one follows
  FollowingSources following_;
};

}  // namespace etendue
