// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/case/exact_family.h"
#include "app/case/false_color.h"
#include "app/case/in_time.h"
#include "app/case/lamps/light_table.h"
#include "base/angular_space.h"
#include "base/errors.h"
#include "base/expression/formula.h"
#include "base/up_axis.h"
#include "base/vec3.h"
#include "mesh/files/vtk/vtk_encoding.h"
#include "mesh/geometry/primitives/geometry.h"
#include "solver/angular/sets/refinement.h"
#include "solver/angular/sets/rotation.h"
#include "solver/materials/kernels/directional_scattering.h"
#include "solver/materials/phase/phase_function.h"
#include "solver/materials/surfaces/glazing.h"
#include "solver/materials/surfaces/reflectance.h"
#include "solver/observe/camera/camera.h"
#include "solver/observe/color/tone.h"
#include "solver/observe/color/white_balance.h"
#include "solver/observe/sensors/sensor.h"
#include "solver/problem/lights/light.h"
#include "solver/problem/scattering_choice.h"
#include "solver/radiosity/solve/radiosity_method.h"
#include "solver/solution/solve_options.h"
#include "solver/stepping/step_method.h"

namespace etendue {

/// A number or a formula.
using Value = std::variant<double, Formula>;

/// One value for all bands, or one for each.
struct BandValues {
  std::vector<Value> values;
  Origin origin;
};

/// Largest cell: for all regions ("*") or by name.
struct SizeBound {
  std::map<std::string, double> by_region;
  Origin origin;
};

/// A file that the case names, resolved against the case's folder.
struct InputFile {
  std::filesystem::path path;
  Origin origin;
};

/// Voxels with whole numbers that say which region each belongs to.
struct LabelsCase {
  InputFile file;
  std::string array;                  ///< empty: the only one
  std::map<std::string, int> labels;  ///< [region]; voxels with another number are left out
};

struct MeshCase {
  std::optional<InputFile> file;
  std::optional<InputFile> surface;
  std::optional<LabelsCase> labels;
  Geometry geometry;  ///< used when there is neither file nor surface
  std::optional<SizeBound> max_volume;
  std::optional<SizeBound> edge_length;
  double quality = 1.4;
  int max_cells = 0;  ///< 0: by the size of the cells and the details of the geometry
  double scale = 1;
  UpAxis up = UpAxis::z;                ///< of a file or surface
  int refine = 0;                       ///< how often every cell is cut into eight
  std::map<std::string, Vec3> regions;  ///< of a surface: a point inside each
  Origin origin;
};

struct MediumCase {
  std::optional<BandValues> absorption, scattering, extinction, albedo;
  std::optional<BandValues> temperature;   ///< one value [K], from which `blackbody` and `emission` follow
  std::optional<BandValues> gas_pressure;  ///< one value [atm]; `absorption` is that of the gases too
  /// Radiance of a blackbody of this temperature; `emission` is the absorption times it.
  std::optional<BandValues> blackbody;
  std::optional<BandValues> heat_source;          ///< one value [W/m^3]; the temperature follows
  std::optional<BandValues> conductivity;         ///< one value [W/(m K)]; the temperature follows
  std::optional<BandValues> heat_capacity;        ///< one value [J/(m^3 K)]; the temperature follows
  std::optional<BandValues> initial_temperature;  ///< one value [K]
  std::optional<BandValues> emission, power_density;
  Uncollided uncollided = Uncollided::automatic;
  std::vector<std::string> phase_notes;            ///< what was computed on the way to them
  std::optional<BandValues> power;                 ///< of the whole region; numbers [power]
  std::vector<PhaseFunction> phase;                ///< one for all bands or one for each
  std::vector<ScatteringChoice> choice;            ///< [band]; empty: automatic
  std::vector<DirectionalScattering> directional;  ///< [band]; empty: none
  BandValues kernel_extinction;                    ///< beside a kernel, where it is a formula or a list
  bool has_kernel = false;                         ///< whose scattering follows from it when there is a mesh
  Origin origin;
  AngularSpace space = AngularSpace::sphere;  ///< what power is divided by
  double refractive_index = 1;                ///< by which light is slower than in vacuum
  std::optional<InTime> in_time;              ///< of what it emits
  bool reradiates = false;  ///< whether the temperature follows from `heat_source` by scattering alone

  /// Whether the temperature follows, and takes more than one solution of the transport equation.
  bool iterates_temperature() const { return follows_from_heat() && !reradiates; }
  bool follows_from_heat() const { return heat_source || conductivity || heat_capacity; }
};

/// A set of directions by its name.
struct DirectionChoice {
  std::string set;
  int order = 1;
  Origin origin;
  std::string reason = {};  ///< for people, where the case does not choose it; else empty
};

enum class LightKind { point, spot, sun, beam, disc, rectangle, wall, sky };

// What is known of a light, [band]: its power, or its irradiance or radiance per area.
struct PowerOfLight {
  std::vector<double> values;  ///< [power] of a point, a spot or a beam
};
struct IrradianceOfLight {
  std::vector<double> values;  ///< [power/length^2] of a sun across its light, of a sky on a level plane
};
struct RadianceOfLight {
  std::vector<double> values;  ///< [power/(length^2 sr)] of what has an area; of a sky that of its zenith
};
using LightStrength = std::variant<PowerOfLight, IrradianceOfLight, RadianceOfLight>;

/// [band] Whatever the quantity is.
inline const std::vector<double>& values_of(const LightStrength& strength) {
  return std::visit([](const auto& quantity) -> const std::vector<double>& { return quantity.values; },
                    strength);
}

/// A [[light]] or the beam of a wall. What its kind does not use keeps its default.
struct LightCase {
  std::string name;
  LightKind kind = LightKind::point;
  Vec3 position = Vec3::Zero();
  Vec3 direction = -Vec3::UnitZ();  ///< unit
  Vec3 along = Vec3::UnitX();       ///< unit
  double radius = 0;                ///< [length]
  bool gaussian = false;            ///< profile of a beam; else a disc
  double numerical_aperture = 0;    ///< of a beam: sine of the half angle of its cone; 0: collimated
  std::array<double, 2> size{};     ///< [length]
  std::vector<double> angle;        ///< [degree]
  std::vector<double> intensity;    ///< [plane][angle]
  std::vector<double> plane;        ///< [degree]; empty: the same all about the axis
  PhotometricType type = PhotometricType::c;  ///< of angle and plane
  LightStrength strength;
  bool keeps_intensity =
      false;         ///< of a lamp with the light of its file: what it sends at its own wall is lost
  std::string note;  ///< how the sun stands or a lamp is tilted, for people; may be empty
  Uncollided uncollided = Uncollided::automatic;
  std::vector<std::string> walls;
  bool of_wall = false;  ///< walls.NAME.beam, which is no sun
  std::optional<InTime> in_time;
  Origin origin;
};

/// Heat that what flows along a wall carries away, h (T - T_a).
struct Convection {
  double heat_transfer_coefficient = 0;  ///< h [W/(m^2 K)]
  double ambient = 0;                    ///< T_a [K]
};

struct WallCase {
  std::optional<BandValues> temperature;          ///< one value [K], from which `radiance` follows
  std::optional<double> heat_flux;                ///< into the domain [W/m^2]; the temperature follows
  std::optional<Convection> convection;           ///< the temperature follows
  std::optional<BandValues> heat_capacity;        ///< one value [J/(m^2 K)], of a temperature that follows
  std::optional<BandValues> initial_temperature;  ///< one value [K]
  BandValues radiance;                            ///< empty values: 0
  BandValues diffuse, specular;                   ///< numbers; empty values: 0
  BandValues transmittance;                       ///< numbers; empty values: 0
  std::vector<std::shared_ptr<const Reflectance>> glossy;  ///< [band]; empty: none
  double refractive_index = 1;                             ///< of the domain over that of what is behind
  Uncollided uncollided = Uncollided::automatic;
  std::optional<LightCase> beam;
  Origin origin;
  bool reradiates = false;  ///< whether the temperature follows from `heat_flux` by reflection alone
  std::vector<Glazing> glazing = {};   ///< [band] of what light from outside comes in by; empty: an opening
  std::optional<InTime> in_time = {};  ///< of the radiance and the beam

  /// Whether the temperature follows, and takes more than one solution of the transport equation.
  bool iterates_temperature() const { return (heat_flux || convection) && !reradiates; }
};

struct Probe {
  std::string name;
  std::vector<Vec3> points;    ///< those of a line too
  std::optional<Vec3> normal;  ///< unit
  Origin origin;
};

/// A picture that is taken of the solution.
struct CameraCase {
  std::string name;
  Camera camera;
  std::optional<double> exposure;  ///< empty: automatic
  Tone tone = Tone::linear;
  White white;  ///< what is neutral in the PNG
  Origin origin;
  std::optional<FalseColor> false_color = {};  ///< of NAME.false.png; empty: none
};

/// An instrument that reads the solution.
struct SensorCase {
  std::string name;
  Sensor sensor;
  std::string wall;    ///< of intensities; its number is known when there is a mesh
  std::string region;  ///< of an account, or whose surface a flux goes through
  std::string beyond;  ///< of such a flux, the region or wall on the other side; empty: all of the surface
  /// Of the key, where irradiance or a grid is also given relative to that of the unobstructed sky.
  std::optional<Origin> daylight_factor = {};
  Origin origin;
};

/// Of solve.method = "photons".
struct PhotonCase {
  double photons = 1e6;  ///< histories per band that a run adds
  double until = 0;      ///< relative error to reach; 0: all histories
  double probe_photons = 2e4;
  int seed = 1;
  double map_hits = 1e6;     ///< of the photon map, on walls and in media each, at most
  int map_neighbours = 100;  ///< of one of its estimates
};

/// Of solve.method = "radiosity".
struct RadiosityCase {
  double patch_size = 0;      ///< [length]; 0: the faces of the mesh
  double refine_change = 0;   ///< of the irradiance, of its mean; 0: patches stay
  double smallest_patch = 0;  ///< [length]
  RadiosityMethod solution = RadiosityMethod::gathering;
  int rays = 16;                 ///< between two patches
  double link_tolerance = 3e-4;  ///< of the hierarchical solution
  int path_rays = 1024;          ///< from each patch over mirrors and glossy walls
  int passes = 0;                ///< that are written
};

/// A radiance that is meant to be the answer: source and inflow follow from it.
struct ExactCase {
  std::string radiance;               ///< a formula in x, y, z, wx, wy, wz; the same in all bands
  std::optional<ExactFamily> family;  ///< which it is a member of
  Origin origin;
};

/// A quantity that is to be accurate: "probe:NAME", "probe:NAME:INDEX", "sensor:NAME", "wall:NAME",
/// "region:NAME".
struct AskedQuantity {
  std::string name;
  Origin origin;
};

/// How accurate numbers are to be: the run refines cells and directions until they are.
struct AccuracyCase {
  std::optional<double> relative, absolute;  ///< one of the two; an absolute one in the unit of each quantity
  std::vector<AskedQuantity> of;             ///< empty: every number that an estimate of errors covers
  double minutes = 10;                       ///< for all runs together
  std::optional<double> memory_gb;           ///< [1e9 bytes]; empty: what the machine has
  bool sets_tolerance = false;               ///< whether the case leaves solve.tolerance to it
  Origin origin;
};

/// What is asked about light that changes with time.
struct TimeCase {
  std::optional<double> speed;             ///< of light in vacuum [length/time]; none: it arrives at once
  std::string unit = "s";                  ///< of time, a label
  InTime in_time;                          ///< of all sources that say nothing themselves
  std::vector<double> modulation;          ///< frequencies of all that emits [1/time]
  bool flight_times = false;               ///< mean and spread of the time of flight
  std::vector<double> times;               ///< rising, by inversion [time]
  double window = 0.05;                    ///< about each of `times` after a pulse, relative
  std::optional<double> until;             ///< steps to here [time]
  std::optional<double> step;              ///< at most [time]
  std::optional<double> tolerance;         ///< to which steps adapt
  StepMethod method = StepMethod::sdirk2;  ///< of steps
  int frames = 0;                          ///< evenly spaced times of which fields are written
  Origin origin;
};

struct OutputCase {
  std::filesystem::path directory;                            ///< resolved
  std::vector<std::string> fields = {"fluence", "net_flux"};  ///< as written, "radiance:K" too
  std::vector<int> radiance_ordinates;                        ///< of the fields "radiance:K"
  int checkpoint_every = 0;                                   ///< sweeps; 0: never
  VtkEncoding encoding = VtkEncoding::inline_base64;          ///< of all VTK files
  Origin origin;
};

struct Units {
  std::string length = "m";
  std::string power = "W";
  std::string illuminance = "lx";  ///< of what is written
  std::string luminous_exitance = "lm/m^2";
  std::string luminance = "cd/m^2";
  std::string luminous_flux = "lm";
  std::string luminous_intensity = "cd";
  std::string luminous_energy = "lm s";
};

/// A case file as data, every default filled in, every value with its line. Nothing is meshed or solved yet.
struct Case {
  std::filesystem::path file;
  std::string title;
  Units units;
  MeshCase mesh;
  Bands bands;
  /// One value; of gases that are mixed differently from place to place, where it is no number.
  std::optional<BandValues> molar_ratio;
  std::map<std::string, MediumCase> media;  ///< by region; "*" stands for the rest
  std::map<std::string, WallCase> walls;    ///< by wall; "*" stands for the rest
  std::vector<LightCase> lights;            ///< beams of walls too
  std::string direction_set = "ldfe-sq";
  int direction_order = 1;
  std::optional<Rotation> direction_rotation;
  std::optional<ConeRefinement> direction_refinement;
  int rotations = 1;  ///< sets that are averaged over, each turned at random but the first
  std::uint64_t direction_seed = 1;
  std::optional<DirectionChoice> first_collided;  ///< of light that has collided once; empty: as the rest
  AngularSpace angular_space = AngularSpace::sphere;
  Origin directions_origin;
  SolveOptions solve;
  double balance_tolerance = 0.01;         ///< part of the power that may be missing in the balance of a band
  std::optional<PhotonCase> photons;       ///< solve by photons
  std::optional<RadiosityCase> radiosity;  ///< solve by radiosity
  std::optional<InputFile> initial;        ///< a solution to start from
  std::optional<ExactCase> exact;
  std::optional<AccuracyCase> accuracy;
  std::optional<TimeCase> time;
  std::vector<Probe> probes;
  std::vector<CameraCase> cameras;
  std::vector<SensorCase> sensors;
  OutputCase output;
  std::vector<std::string> deprecations;  ///< a line for each key that has its former name in the file
  std::string resolved_toml;  ///< with overrides applied and defaults filled in; reads back the same
};

/// `key=value` of the command line, e.g. "solve.tolerance=1e-8" or "mesh.max_volume={'*'=1}".
using Overrides = std::vector<std::string>;

/// Reads and checks a case file. Throws FileError where it cannot be read, else one InputError with all
/// faults.
Case read_case(const std::filesystem::path& file, const Overrides& overrides = {});

/// The same of a text, as a result holds it; `file` is the case's, for messages and relative paths.
Case read_case_text(std::string_view text, const std::filesystem::path& file,
                    const Overrides& overrides = {});

}  // namespace etendue
