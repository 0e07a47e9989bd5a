// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/exact_family.h"
#include "app/case/keys/case_tables.h"
#include "solver/angular/sets/direction_set.h"

namespace etendue {

using enum KeyType;
using namespace key_range;

namespace {

KeyTable refinement_keys() {
  KeyTable t("directions.refine");
  t.key("direction", point, {.need = required}, "Axis of the cone, of any length.");
  t.key(
      "angle", number,
      {.unit = "degrees", .range = {.lowest = 0, .highest = 90, .lowest_excluded = false}, .need = required},
      "Between axis and surface; quadrilaterals that the cone meets are split.");
  t.key("levels", integer, {.range = {.lowest = 1, .highest = 8}, .need = required},
        "How often they are split in four.");
  return t;
}

KeyTable first_collided_keys() {
  KeyTable t("directions.first_collided");
  std::vector<std::string> sets = direction_set_names();
  sets.emplace_back("none");
  t.key(
      "set", text, {.default_value = "\"ldfe-sq\"", .choices = std::move(sets)},
      "As of [directions]; turned with it. none: light that has collided once stays on the directions of the "
      "rest. Without this table a spot in a medium that scatters into a lobe narrower than the directions "
      "are "
      "apart has the set ldfe-sq of order 4, and the run says so.");
  t.key("order", integer, {.range = {.lowest = 1, .highest = 1e4}},
        "What it means depends on the set; needed but for none.");
  return t;
}

KeyTable probe_keys() {
  KeyTable t("probe");
  t.key("name", text, {.need = required}, "Names the rows in `probes.csv`.");
  t.key("points", points, {.unit = "length"}, "Where; or `line`.");
  t.key("normal", point, {},
        "Also the irradiance of light that falls on the side it points to; of any length.");
  return t;
}

KeyTable line_keys() {
  KeyTable t("probe.line");
  t.key("from", point, {.unit = "length", .need = required}, "First point.");
  t.key("to", point, {.unit = "length", .need = required}, "Last point.");
  t.key("count", integer, {.range = {.lowest = 2, .highest = 1e7}, .need = required}, "How many points.");
  return t;
}

}  // namespace

const BoundTable<Case>& direction_table() {
  static const BoundTable<Case> table = [] {
    BoundTable<Case> t("directions");
    t.key("set", &Case::direction_set, {.choices = direction_set_names()},
          "`etendue directions` lists the sets and their sizes.");
    t.key("order", &Case::direction_order, {.range = {.lowest = 1, .highest = 1e4}},
          "What it means depends on the set.");
    t.key("rotation", rotation, {.unit = "degrees"},
          "Turns the set about an axis, or at random; a mirror must still take ordinates to ordinates.");
    t.key("seed", integer, {.default_value = "1", .range = {.lowest = 0, .highest = largest_count}},
          "Chooses the random rotations.");
    t.key("rotations", &Case::rotations, {.range = {.lowest = 1, .highest = 1000}},
          "Solves on so many copies of the set, each turned at random but the first, and takes their mean: "
          "less of ray effects, and `fluence_direction_error` in fields.vtu, its standard error.");
    return t;
  }();
  return table;
}

const BoundTable<SolveOptions>& space_table() {
  static const BoundTable<SolveOptions> table = [] {
    BoundTable<SolveOptions> t("space");
    t.key("order", integer, {.default_value = "1", .choices = {"0", "1"}, .later = {"2", "3"}},
          "Polynomial degree of the discontinuous Galerkin space.");
    t.choice("lumping", &SolveOptions::lumping,
             {{"none", Lumping::none}, {"mass", Lumping::mass}, {"auto", Lumping::automatic}}, {},
             "Of the mass; auto: where extinction times cell size exceeds 2.");
    t.choice(
        "positivity", &SolveOptions::positivity,
        {{"none", Positivity::none}, {"rescale", Positivity::rescale}, {"quadratic", Positivity::quadratic}},
        {},
        "Takes negative radiance out of every cell after the linear solution: to zero with the rest "
        "rescaled, or by the nearest values that balance.");
    return t;
  }();
  return table;
}

const BoundTable<Case>& solve_table() {
  static const BoundTable<Case> table = [] {
    BoundTable<Case> t("solve");
    t.choice("method", member_of(&Case::solve, &SolveOptions::method),
             {{"auto", Method::automatic},
              {"gmres", Method::gmres},
              {"source-iteration", Method::source_iteration},
              {"photons", Method::automatic},
              {"radiosity", Method::automatic}},
             {},
             "auto: the best that this version has, which is gmres. photons: Monte Carlo; radiosity: form "
             "factors between walls with nothing between them; directions, space and most other keys of the "
             "iteration then do not count.");
    t.choice("precision", member_of(&Case::solve, &SolveOptions::precision),
             {{"auto", Precision::automatic}, {"double", Precision::full}, {"mixed", Precision::mixed}}, {},
             "Of the sweeps. mixed: single within the cycles of gmres, whose residual and solution stay "
             "double; it saves a third to a half of the time, and takes half as much memory again for what a "
             "sweep works on. auto: mixed where tolerance is at least 1e-10 and light does not return "
             "more than some 300 times.");
    t.choice("angular_multigrid", member_of(&Case::solve, &SolveOptions::angular_multigrid),
             {{"auto", AngularMultigrid::automatic}, {"none", AngularMultigrid::none}}, {},
             "Whether gmres corrects its vectors on fewer directions, which leaves fewer sweeps on all of "
             "them. auto: with 768 directions and more, as long as that pays.");
    t.choice("acceleration", member_of(&Case::solve, &SolveOptions::acceleration),
             {{"auto", Acceleration::automatic},
              {"diffusion", Acceleration::diffusion},
              {"none", Acceleration::none}},
             {}, "Of the iteration. auto: diffusion with gmres where it pays; the reason is printed.");
    t.choice("diffusion_coefficient", member_of(&Case::solve, &SolveOptions::diffusion_length),
             {{"auto", DiffusionLength::automatic},
              {"local", DiffusionLength::local},
              {"non-local", DiffusionLength::nonlocal}},
             {},
             "Of the acceleration: 1/(3 extinction), or the mean flight length, which costs a sweep. auto: "
             "non-local where a void is present or extinctions differ by more than 100 times.");
    t.key("tolerance", member_of(&Case::solve, &SolveOptions::tolerance), {.range = open_fraction},
          "Estimated relative error of the iteration, per band.");
    t.key("balance_tolerance", &Case::balance_tolerance, {.range = positive},
          "Part of the emitted power that may be missing from, or too much in, the balance of a band, with "
          "any method; of photons beside three standard errors. A run beyond it is marked \"balanced\": "
          "false in `summary.json` and ends with exit code 1.");
    t.key("max_sweeps", member_of(&Case::solve, &SolveOptions::max_sweeps),
          {.range = {.lowest = 1, .highest = largest_count}}, "Every transport sweep counts.");
    t.key("threads", member_of(&Case::solve, &SolveOptions::threads),
          {.range = {.lowest = 0, .highest = 4096}}, "0: all cores.");
    t.key("initial", text, {},
          "A `solution.vtu` of the same mesh and case to start from; what is solved and written may differ.");
    return t;
  }();
  return table;
}

const BoundTable<PhotonCase>& photon_table() {
  static const BoundTable<PhotonCase> table = [] {
    BoundTable<PhotonCase> t("solve");
    t.key("photons", &PhotonCase::photons, {.range = {.lowest = 1, .highest = largest_histories}},
          "Histories in each band that this run adds; with `until` at most. Only of photons, as the next "
          "three.");
    t.key("until", &PhotonCase::until, {.default_note = "none: all histories", .range = open_fraction},
          "Relative standard error of the fluence at which to stop: volume-weighted root mean square over "
          "the cells.");
    t.key("probe_photons", &PhotonCase::probe_photons,
          {.range = {.lowest = 64, .highest = largest_histories}},
          "Histories in each band that are walked back from each probe point.");
    t.key("seed", &PhotonCase::seed, {.range = {.lowest = 0, .highest = largest_count}},
          "Chooses the random numbers.");
    return t;
  }();
  return table;
}

const BoundTable<PhotonCase>& photon_map_table() {
  static const BoundTable<PhotonCase> table = [] {
    BoundTable<PhotonCase> t("photon_map");
    t.key("hits", &PhotonCase::map_hits, {.range = {.lowest = 1, .highest = largest_count}},
          "Kept in each band on walls, and as many where light is scattered, at most; `solve.photons` "
          "histories are walked for them at most. A hit takes 108 bytes at most.");
    t.key("neighbours", &PhotonCase::map_neighbours, {.range = {.lowest = 2, .highest = 100000}},
          "Nearest hits that are a place's light: its error is 1/sqrt(neighbours), and it is blurred over "
          "what they take.");
    return t;
  }();
  return table;
}

const BoundTable<RadiosityCase>& radiosity_table() {
  static const BoundTable<RadiosityCase> table = [] {
    BoundTable<RadiosityCase> t("radiosity");
    t.key("patch_size", &RadiosityCase::patch_size,
          {.unit = "length", .default_note = "the faces of the mesh", .range = positive},
          "Faces with longer sides are cut into patches, smaller ones joined where they lie in one plane and "
          "square.");
    t.key("refine_change", &RadiosityCase::refine_change, {.default_note = "none is cut", .range = positive},
          "Patches are cut in four, again and again, where their irradiance differs by more than this part "
          "of its mean over all walls from that of a neighbour in their plane.");
    t.key("smallest_patch", &RadiosityCase::smallest_patch,
          {.unit = "length", .default_note = "an eighth of patch_size", .range = positive},
          "Of this size and below they are not cut further.");
    t.choice("solution", &RadiosityCase::solution,
             {{"gathering", RadiosityMethod::gathering},
              {"shooting", RadiosityMethod::shooting},
              {"direct", RadiosityMethod::direct},
              {"hierarchical", RadiosityMethod::hierarchical}},
             {},
             "Pass by pass from all patches to all; from the brightest patch first; by elimination; or pass "
             "by pass along links between groups of patches, for tens of thousands of them.");
    t.key("rays", &RadiosityCase::rays, {.range = {.lowest = 1, .highest = 1e6}},
          "Between two patches that an obstacle may separate; eight times as many where some are "
          "blocked.");
    t.key("link_tolerance", &RadiosityCase::link_tolerance, {.range = open_fraction},
          "Of the hierarchical solution: what a link may bring too much or too little to a place, of the "
          "mean irradiance of all walls. The irradiance is off by some ten times that.");
    t.key("path_rays", &RadiosityCase::path_rays, {.range = {.lowest = 1, .highest = 1e6}},
          "From each patch and each of four points of a cell, followed over mirrors and glossy walls where "
          "there are any; sixteen times as many from a probe. More take longer, the field in the cells most "
          "of all.");
    t.key("passes", &RadiosityCase::passes, {.range = {.lowest = 0, .highest = 1000}},
          "So many first passes are written as `walls_passK.vtp`, with a series to play.");
    return t;
  }();
  return table;
}

const BoundTable<ExactFamily>& exact_family_table() {
  static const BoundTable<ExactFamily> table = [] {
    BoundTable<ExactFamily> t("exact");
    t.key("radiance", text, {.unit = "power/(length^2 sr)"},
          "A formula in x, y, z and the direction of travel wx, wy, wz; the same in all bands.");
    t.key("family", text, {.choices = exact_family_names()},
          "In place of a formula one whose errors are known beforehand (docs/user/studies.md).");
    t.key("degree", &ExactFamily::degree, {.range = {.lowest = 0, .highest = 10}},
          "Of the polynomial, in space.");
    t.key("center", &ExactFamily::center, {.unit = "length"}, "Where a family has its origin.");
    t.key("length", &ExactFamily::length, {.unit = "length", .range = positive},
          "What a family measures lengths in: about the size of the domain.");
    return t;
  }();
  return table;
}

const BoundTable<AccuracyCase>& accuracy_table() {
  static const BoundTable<AccuracyCase> table = [] {
    BoundTable<AccuracyCase> t("accuracy");
    t.key("relative", &AccuracyCase::relative, {.range = open_fraction},
          "Largest error of each quantity, as a part of it. `run` refines cells and directions until its "
          "estimates are below, from those of the case on.");
    t.key("absolute", &AccuracyCase::absolute, {.range = positive},
          "Largest error of each quantity, in its unit. One of the two.");
    t.key("of", texts, {.default_note = "all probes, sensors, powers of walls and regions"},
          "The quantities: \"probe:NAME\", \"probe:NAME:INDEX\", \"sensor:NAME\", \"wall:NAME\" (power that "
          "arrives), \"region:NAME\" (power absorbed).");
    return t;
  }();
  return table;
}

const BoundTable<AccuracyCase>& budget_table() {
  static const BoundTable<AccuracyCase> table = [] {
    BoundTable<AccuracyCase> t("accuracy.budget");
    t.key("minutes", &AccuracyCase::minutes, {.range = positive},
          "For all runs together: one that would last longer by its forecast is not begun.");
    t.key("memory_gb", &AccuracyCase::memory_gb, {.unit = "1e9 bytes", .range = positive},
          "Of a run, by its forecast; without it what the machine has.");
    return t;
  }();
  return table;
}

const BoundTable<TimeCase>& time_table() {
  static const BoundTable<TimeCase> table = [] {
    BoundTable<TimeCase> t("time");
    t.key(
        "speed", &TimeCase::speed, {.unit = "length/time", .default_note = "none", .range = positive},
        "Of light in vacuum, in the case's unit of length: 299792458 for metres and seconds. Not given where "
        "temperatures change with time: light then arrives at once.");
    t.key("unit", &TimeCase::unit, {}, "Of time; a label.");
    t.key(
        "in_time", text, {.default_value = "\"pulse\""},
        "When sources emit that have no `in_time` themselves. pulse: all at t = 0, of an energy that is the "
        "power of the case times one unit of time; step: from t = 0 on; a formula in t, or the name of a CSV "
        "file of t and factor: the part of the power at times t > 0. `times` needs pulse or step, the same "
        "for all sources.");
    t.key(
        "modulation", numbers, {.unit = "1/time", .range = positive},
        "Frequencies: amplitude and phase of all that is read go into `frequency.csv`, where everything that "
        "emits changes as cos(2 pi f t) about its mean.");
    t.key(
        "times", numbers, {.unit = "time", .range = positive},
        "Rising: what is read at these times goes into `times.csv`, by inversion of its Laplace transform.");
    t.key("flight_times", &TimeCase::flight_times, {},
          "Mean and standard deviation of the time that light is under way until it is read, in "
          "`flight_times.csv`.");
    t.key("window", &TimeCase::window, {.range = open_fraction},
          "After a pulse each of `times` is the middle of a window of this width, as a part of the time: "
          "values of "
          "photons, and of light before its first collision, are means over it.");
    t.key("until", &TimeCase::until, {.unit = "time", .range = positive},
          "Steps in time, from darkness or initial temperatures at t = 0 to here: what is read at their ends "
          "goes into `steps.csv`.");
    t.key("step", &TimeCase::step,
          {.unit = "time", .default_note = "a hundredth of until", .range = positive},
          "Length of steps, at most.");
    t.key(
        "tolerance", &TimeCase::tolerance, {.default_note = "none: even steps", .range = open_fraction},
        "Steps become as short as the error of a step in the fluence asks for, relative to its largest value "
        "so far and to that of the steady light.");
    t.choice(
        "method", &TimeCase::method, {{"sdirk2", StepMethod::sdirk2}, {"bdf2", StepMethod::bdf2}}, {},
        "Of steps, both of second order. sdirk2: two solutions a step, the more accurate; bdf2: one, for "
        "even steps.");
    t.key(
        "frames", &TimeCase::frames, {.range = {.lowest = 0, .highest = 10000}},
        "Evenly spaced times up to `until` of which the fluence is written, `fluence_0001.vtu` and so on, "
        "and `fluence.pvd` that has them all; of temperatures that change with time `temperature_0001.vtu`.");
    return t;
  }();
  return table;
}

const BoundTable<OutputCase>& output_table() {
  static const BoundTable<OutputCase> table = [] {
    BoundTable<OutputCase> t("output");
    t.key("directory", text, {.default_note = "the case's name, in the working directory"},
          "Made with its parents; an earlier result there is replaced.");
    t.key("fields", texts, {.default_value = "[\"fluence\", \"net_flux\"]"},
          "\"fluence\", \"net_flux\", \"media\", \"radiance:K\" for the ordinate K (from 0).");
    t.key("checkpoint_every", &OutputCase::checkpoint_every,
          {.range = {.lowest = 0, .highest = largest_count}},
          "Sweeps after which `solution.vtu` is written during the run; 0: only at its end.");
    t.choice("encoding", &OutputCase::encoding,
             {{"inline", VtkEncoding::inline_base64}, {"appended", VtkEncoding::appended_raw}}, {},
             "Of the numbers in VTK files. inline: base64 text, which every ParaView reads; appended: raw "
             "bytes behind the XML, a quarter shorter, which Debian 12's own ParaView refuses.");
    return t;
  }();
  return table;
}

std::vector<KeyDeclaration> run_keys() {
  return declarations_of({direction_table(), refinement_keys(), first_collided_keys(), space_table(),
                          solve_table(), photon_table(), photon_map_table(), radiosity_table(),
                          exact_family_table(), accuracy_table(), budget_table(), time_table(), probe_keys(),
                          line_keys(), output_table()});
}

}  // namespace etendue
