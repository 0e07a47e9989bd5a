// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/app/case/case_text.h"

namespace etendue::case_faults_test {
namespace {

struct Check {
  const char* name;
  const char* text;  ///< from line 7
  const char* message;
};

class CaseFault : public testing::TestWithParam<Check> {};

TEST_P(CaseFault, IsReportedWithFileLineAndKey) {
  EXPECT_EQ(faults_of(cube + GetParam().text), GetParam().message);
}

const Check keys[] = {
    {"Misspelt", "[media.smoke]\nscatering = 2.0\n",
     "slab.toml:8: media.smoke.scatering = 2.0: unknown key; did you mean \"scattering\"?"},
    {"MisspeltTable", "[direction]\nset = \"product\"\n",
     "slab.toml:7: direction: misplaced key; \"direction\" belongs in [walls.NAME.beam] (NAME: a wall or "
     "\"*\"), [[light]], [directions.refine] or [[sensor]] (or did you mean \"directions\"?)"},
    {"Misplaced", "[solve]\nscattering = 2.0\n",
     "slab.toml:8: solve.scattering = 2.0: misplaced key; \"scattering\" belongs in [media.NAME] (NAME: a "
     "region or "
     "\"*\")"},
    {"MisplacedInMedia", "[media]\nabsorption = 2.0\n",
     "slab.toml:8: media.absorption = 2.0: misplaced key; \"absorption\" belongs in [media.NAME] (NAME: a "
     "region or "
     "\"*\")"},
    {"MisplacedTable", "[space.box]\n",
     "slab.toml:7: space.box: misplaced key; \"box\" belongs in [[mesh.box]]"},
    {"MisplacedOrMisspelt", "[output]\nfield = 1\nfile = \"a\"\n",
     "slab.toml:8: output.field = 1: unknown key; did you mean \"fields\"?\n"
     "slab.toml:9: output.file = \"a\": misplaced key; \"file\" belongs in [mesh], [mesh.labels], "
     "[media.NAME.COEFFICIENT] (NAME: a region or \"*\"), [media.NAME.phase] (NAME: a region or \"*\"), "
     "[[media.NAME.phase.mix]] (NAME: a region or \"*\") or "
     "[walls.NAME.glossy] (NAME: a wall or \"*\")"},
    {"MisspeltAndMisplaced", "[space]\nabsorbtion = 1\n",
     "slab.toml:8: space.absorbtion = 1: unknown key; did you mean \"absorption\", which belongs in "
     "[media.NAME] (NAME: a "
     "region or \"*\")?"},
    {"Unlike", "[space]\nflux_capacitor = 1\n",
     "slab.toml:8: space.flux_capacitor = 1: unknown key; [space] takes order, lumping or positivity"},
    {"MediumIsANumber", "[media]\nsmoke = 1\n",
     "slab.toml:8: media.smoke = 1: must not be an integer; [media.NAME] is a table"},
    {"TableIsANumber", "[[space]]\norder = 1\n", "slab.toml:7: space: must not be a list; write [space]"},
};

const Check later[] = {
    {"DirectionInFormula", "[media.air]\nscattering = \"1 + wx\"\n",
     "slab.toml:8: media.air.scattering = \"1 + wx\": uses the direction of travel wx, wy, wz (absorption, "
     "extinction, emission and a wall's radiance may, this may not); use x, y, z"},
    {"UncollidedRadianceFormula", "[walls.xmin]\nradiance = \"x\"\nuncollided = true\n",
     "slab.toml:9: walls.xmin.uncollided = true: not for emission that depends on the direction, nor for "
     "radiance by a formula, as that of a hot wall is where bands.molar_ratio is one (not in this version); "
     "use "
     "\"auto\" or false"},
    {"SpaceOrder", "[space]\norder = 2\n", "slab.toml:8: space.order = 2: not in this version; use 0 or 1"},
    {"DirectionErrorOfOneSet", "[output]\nfields = [\"direction_error\"]\n",
     "slab.toml:8: output.fields = [\"direction_error\"]: \"direction_error\" is the spread over rotated "
     "sets; "
     "use directions.rotations, at least 4"},
    {"RadianceOfRotations", "[directions]\nrotations = 4\n[output]\nfields = [\"radiance:3\"]\n",
     "slab.toml:8: directions.rotations = 4: there is no radiance of one ordinate in a mean over rotated "
     "sets; "
     "use 1, or no output field \"radiance:K\""},
    {"RadianceOfLightThatCollidedOnce",
     "[directions]\nfirst_collided = { order = 2 }\n[output]\nfields = [\"radiance:3\"]\n",
     "slab.toml:8: directions.first_collided: light on a set of its own has no radiance "
     "along "
     "the ordinates of the other; use no output field \"radiance:K\", or no first_collided"},
    {"FirstCollidedWithoutOrder", "[directions]\nfirst_collided = { set = \"product\" }\n",
     "slab.toml:8: directions.first_collided.order: missing; an integer from 1 to 10000"},
    {"FirstCollidedOfNoneWithOrder", "[directions]\nfirst_collided = { set = \"none\", order = 4 }\n",
     "slab.toml:8: directions.first_collided.order = 4: unused (there is no set of directions of its own); "
     "remove "
     "it"},
    {"FirstCollidedOfOddOrder", "[directions]\nfirst_collided = { set = \"product\", order = 3 }\n",
     "slab.toml:8: directions.first_collided.order = 3: must be even (the levels of a product set lie in "
     "pairs above and below the equator); use 2, 4, 6 … 222"},
    {"FirstCollidedInThePlane", "[directions]\nfirst_collided = { set = \"flatland\", order = 8 }\n",
     "slab.toml:8: directions.first_collided: no light is followed along "
     "rays in flatland; use sets on the sphere"},
};

const Check values[] = {
    {"TitleIsANumber", "[units]\nlength = 1\n",
     "slab.toml:8: units.length = 1: must not be an integer; use text"},
    {"UnitIsEmpty", "[units]\npower = \"\"\n", "slab.toml:8: units.power = \"\": must not be empty"},
    {"BandTwice", "[bands]\nnames = [\"red\", \"red\"]\n",
     "slab.toml:8: bands.names = [\"red\", \"red\"]: has a name twice; give each band its own"},
    {"NoBand", "[bands]\nnames = []\n", "slab.toml:8: bands.names = []: is empty; use a list of text"},
    {"BandIsANumber", "[bands]\nnames = [\"red\", 3]\n",
     "slab.toml:8: bands.names[1] = 3: must not be an integer; use a list of text"},
    {"TooFewEdges", "[bands]\nnames = [\"red\", \"blue\"]\nedges = [700, 400]\n",
     "slab.toml:9: bands.edges = [700, 400]: has 2 entries for 2 bands; use one more than names"},
    {"TooManyEdgesOfOneBand", "[bands]\nedges = [700, 500, 400]\n",
     "slab.toml:8: bands.edges = [700, 500, 400]: has 3 entries for 1 band; use one more than names"},
    {"EdgesWithoutOrder", "[bands]\nnames = [\"red\", \"blue\"]\nedges = [700, 400, 500]\n",
     "slab.toml:9: bands.edges = [700, 400, 500]: must rise or fall throughout; use wavelengths in order"},
    {"WrongBandCount", "[bands]\nnames = [\"red\", \"blue\"]\n[media.air]\nabsorption = [1, 2, 3]\n",
     "slab.toml:10: media.air.absorption = [1, 2, 3]: has 3 entries for 2 bands (red, blue); use one value, "
     "or a list "
     "with one for each band"},
    {"WrongPhaseCount",
     "[bands]\nnames = [\"red\", \"blue\"]\n[media.air]\nscattering = 1\nphase = [{ model = \"isotropic\" "
     "}]\n",
     "slab.toml:11: media.air.phase: has 1 entry for 2 bands (red, blue); use "
     "one value, or "
     "a list with one for each band"},
    {"NegativeAbsorption", "[media.air]\nabsorption = -0.1\n",
     "slab.toml:8: media.air.absorption = -0.1: out of range; use a number, a formula in x, y, z or { file, "
     "array }, or a "
     "list with one "
     "for each band, each at least 0"},
    {"NegativeScattering", "[media.air]\nscattering = [-1]\n",
     "slab.toml:8: media.air.scattering[0] = -1: out of range; use a number, a formula in x, y, z or { file, "
     "array }, or a "
     "list with one "
     "for each band, each at least 0"},
    {"EmissionIsNan", "[media.air]\nemission = nan\n",
     "slab.toml:8: media.air.emission = nan: must be a finite number; use a number, a formula in x, y, z or "
     "{ file, array }, "
     "or a list "
     "with one for each band, each at least 0"},
    {"AbsorptionIsTrue", "[media.air]\nabsorption = true\n",
     "slab.toml:8: media.air.absorption = true: must not be true or false; use a number, a formula in x, y, "
     "z or { file, array }"
     ", or a "
     "list with one for each band, each at least 0"},
    {"AlbedoAboveOne", "[media.air]\nextinction = 1\nalbedo = 1.1\n",
     "slab.toml:9: media.air.albedo = 1.1: out of range; use a number, a formula in x, y, z or { file, array "
     "}, or a list "
     "with one for "
     "each band, each from 0 to 1"},
    {"AlbedoAlone", "[media.air]\nalbedo = 0.5\n",
     "slab.toml:7: media.air: albedo without extinction (it does not say how far light goes); add "
     "extinction"},
    {"ExtinctionDisagrees", "[media.air]\nextinction = 1\nabsorption = 0.5\nscattering = 0.6\n",
     "slab.toml:7: media.air: coefficients disagree (extinction = 1, but absorption + scattering = 1.1); "
     "leave one "
     "out"},
    {"ExtinctionBelowScattering", "[media.air]\nextinction = 1\nscattering = 2\n",
     "slab.toml:7: media.air: coefficients disagree (extinction = 1 is less than scattering); extinction = "
     "absorption + "
     "scattering"},
    {"AlbedoDisagrees", "[media.air]\nextinction = 1\nalbedo = 0.5\nscattering = 0.6\n",
     "slab.toml:7: media.air: coefficients disagree (scattering = 0.6, but albedo * extinction = 0.5); leave "
     "one out"},
    {"EmissionTwice", "[media.air]\nemission = 1\npower_density = 1\n",
     "slab.toml:7: media.air: coefficients disagree (power_density = 1, but 4 pi emission = "
     "12.566370614359172); leave "
     "one out"},
    {"PowerBesideEmission", "[media.air]\nemission = 1\npower = 1\n",
     "slab.toml:7: media.air: emission is given twice (power is that of the whole region); use one of "
     "emission, "
     "power_density, power"},
    {"UnknownPhase", "[media.air]\nscattering = 1\nphase = { model = \"henyey-greenstien\", g = 0.5 }\n",
     "slab.toml:9: media.air.phase.model = \"henyey-greenstien\": is not known (did you mean "
     "\"henyey-greenstein\"?); use \"isotropic\", \"rayleigh\", \"henyey-greenstein\", "
     "\"double-henyey-greenstein\", \"cornette-shanks\", \"legendre\", \"table\", \"mie\" or \"mixture\""},
    {"AsymmetryIsOne", "[media.air]\nscattering = 1\nphase = { model = \"henyey-greenstein\", g = 1.0 }\n",
     "slab.toml:9: media.air.phase.g = 1.0: out of range; use a number above -1 and below 1"},
    {"NoAsymmetry", "[media.air]\nscattering = 1\nphase = { model = \"henyey-greenstein\" }\n",
     "slab.toml:9: media.air.phase.g: missing; use a number above -1 and below 1"},
    {"NoModel", "[media.air]\nscattering = 1\nphase = { g = 0.5 }\n",
     "slab.toml:9: media.air.phase.model: missing; \"isotropic\", \"rayleigh\", \"henyey-greenstein\", "
     "\"double-henyey-greenstein\", \"cornette-shanks\", \"legendre\", \"table\", \"mie\" or \"mixture\""},
    {"IsotropicWithAsymmetry", "[media.air]\nscattering = 1\nphase = { model = \"isotropic\", g = 0.5 }\n",
     "slab.toml:9: media.air.phase.g = 0.5: unused (it is no key of the model isotropic); remove it"},
    {"PhaseWithoutScattering", "[media.air]\nabsorption = 1\nphase = { model = \"isotropic\" }\n",
     "slab.toml:9: media.air.phase: unused (nothing scatters in this region); "
     "remove it"},
    {"ReflectanceAboveOne", "[walls.xmin]\ndiffuse = 1.5\n",
     "slab.toml:8: walls.xmin.diffuse = 1.5: out of range; use a number, or a list with one for each band, "
     "each from 0 to "
     "1"},
    {"ReflectancesAboveOne",
     "[bands]\nnames = [\"red\", \"blue\"]\n[walls.xmin]\ndiffuse = [0.5, 0.75]\nspecular = 0.5\n",
     "slab.toml:9: walls.xmin: band blue: diffuse + specular = 1.25 (more light would leave than arrives); "
     "use at most "
     "1"},
    {"NegativeRadiance", "[walls.xmin]\nradiance = -1\n",
     "slab.toml:8: walls.xmin.radiance = -1: out of range; use a number, a formula in x, y, z or { file, "
     "array }, or a list "
     "with one for each band, each at least 0"},
    {"ReflectanceIsText", "[walls.xmin]\nspecular = \"much\"\n",
     "slab.toml:8: walls.xmin.specular = \"much\": must not be text; use a number, or a list with one for "
     "each band, each "
     "from 0 to 1"},
    {"OddOrder", "[directions]\nset = \"product\"\norder = 3\n",
     "slab.toml:9: directions.order = 3: must be even (the levels of a product set lie in pairs above and "
     "below the equator); use 2, 4, 6 … 222"},
    {"UnknownSet", "[directions]\nset = \"lfde-sq\"\n",
     "slab.toml:8: directions.set = \"lfde-sq\": is not known (did you mean \"ldfe-sq\"?); use \"product\", "
     "\"triangular\", \"double-gauss\", \"ldfe-sq\", \"level-symmetric\", \"thurgood\", \"lebedev\" or "
     "\"flatland\""},
    {"LebedevOfNegativeWeights", "[directions]\nset = \"lebedev\"\norder = 13\n",
     "slab.toml:9: directions.order = 13: no rule of this degree has positive weights; use 3, 5, 7, 9, 11, "
     "15, "
     "17, 19, 21, 23, 29, 31, 35, 41, 47, 53, 59, 65, 71, 77, 83, 89, 95, 101, 107, 113, 119, 125, 131"},
    {"LevelSymmetricTooFine", "[directions]\nset = \"level-symmetric\"\norder = 18\n",
     "slab.toml:9: directions.order = 18: too large (level-symmetric sets of higher order lose their "
     "positive "
     "weights); use 2, 4, 6 … 16"},
    {"UnknownRotation", "[directions]\nrotation = \"any\"\n",
     "slab.toml:8: directions.rotation = \"any\": is no rotation; use \"random\" or { axis = [x, y, z], "
     "angle = "
     "degrees }"},
    {"RotationWithoutAngle", "[directions]\nrotation = { axis = [1, 0, 0] }\n",
     "slab.toml:8: directions.rotation: is no rotation; use \"random\" or { axis = [x, y, z], angle = "
     "degrees }"},
    {"RotationAboutNothing", "[directions]\nrotation = { axis = [0, 0, 0], angle = 10 }\n",
     "slab.toml:8: directions.rotation: its axis has no direction; use a vector that is not zero"},
    {"RotationAboutAPlane", "[directions]\nrotation = { axis = [1, 0], angle = 10 }\n",
     "slab.toml:8: directions.rotation.axis = [1, 0]: has 2 entries; use a list of three numbers"},
    {"RotationOutOfThePlane",
     "[directions]\nset = \"flatland\"\norder = 8\nrotation = { axis = [1, 0, 0], angle = 10 }\n",
     "slab.toml:10: directions.rotation: turns directions out of the plane z = const; use axis = [0, 0, 1]"},
    {"RefinedSetOfOtherKind",
     "[directions]\nset = \"product\"\norder = 4\nrefine = { direction = [0, 0, 1], angle = 10, levels = 1 "
     "}\n",
     "slab.toml:10: directions.refine: only ldfe-sq can be refined (its quadrilaterals are split); use set = "
     "\"ldfe-sq\", or a higher order"},
    {"RefinedTooFar", "[directions]\norder = 8\nrefine = { direction = [0, 0, 1], angle = 90, levels = 6 }\n",
     "slab.toml:9: directions.refine: splits quadrilaterals beyond those of order 32, which rounding spoils; "
     "use "
     "fewer levels, a smaller angle or a lower order"},
    {"SeedOfNothing", "[directions]\nseed = 3\n",
     "slab.toml:8: directions.seed = 3: unused (only random rotations are drawn); remove it"},
    {"OrderIsAFloat", "[directions]\norder = 1.0\n",
     "slab.toml:8: directions.order = 1.0: must not be a number; use an integer from 1 to 10000 without a "
     "decimal point"},
    {"OrderIsHuge", "[directions]\norder = 9223372036854775807\n",
     "slab.toml:8: directions.order = 9223372036854775807: out of range; use an integer from 1 to 10000"},
    {"Lumping", "[space]\nlumping = \"all\"\n",
     "slab.toml:8: space.lumping = \"all\": is not known; use \"none\", \"mass\" or \"auto\""},
    {"ToleranceIsZero", "[solve]\ntolerance = 0\n",
     "slab.toml:8: solve.tolerance = 0: out of range; use a number above 0 and below 1"},
    {"MixedSourceIteration", "[solve]\nmethod = \"source-iteration\"\nprecision = \"mixed\"\n",
     "slab.toml:9: solve.precision = \"mixed\": source iteration has no cycles that double precision "
     "corrects; use gmres"},
    {"NoSweeps", "[solve]\nmax_sweeps = 0\n",
     "slab.toml:8: solve.max_sweeps = 0: out of range; use an integer from 1 to 1000000000"},
    {"NegativeThreads", "[solve]\nthreads = -1\n",
     "slab.toml:8: solve.threads = -1: out of range; use an integer from 0 to 4096"},
    {"ToleranceIsADate", "[solve]\ntolerance = 1979-05-27\n",
     "slab.toml:8: solve.tolerance = 1979-05-27: must not be a date or time; use a number above 0 and below "
     "1"},
    {"NamelessProbe", "[[probe]]\npoints = [[0, 0, 0]]\n", "slab.toml:7: probe[0].name: missing; text"},
    {"ProbeTwice",
     "[[probe]]\nname = \"a\"\npoints = [[0, 0, 0]]\n[[probe]]\nname = \"a\"\npoints = [[0, 0, 0]]\n",
     "slab.toml:11: probe[1].name = \"a\": another probe has this name; give each its own"},
    {"ProbeWithoutPoints", "[[probe]]\nname = \"a\"\n",
     "slab.toml:7: probe[0]: no points; use points or line"},
    {"ProbeWithBoth",
     "[[probe]]\nname = \"a\"\npoints = [[0, 0, 0]]\nline = { from = [0, 0, 0], to = [1, 0, 0], count = 2 "
     "}\n",
     "slab.toml:7: probe[0]: given by points and by a line; use one of points or line"},
    {"ProbePointIsFlat", "[[probe]]\nname = \"a\"\npoints = [0, 0, 0]\n",
     "slab.toml:9: probe[0].points[0] = 0: must not be an integer; use a list of points [x, y, z]\n"
     "slab.toml:9: probe[0].points[1] = 0: must not be an integer; use a list of points [x, y, z]\n"
     "slab.toml:9: probe[0].points[2] = 0: must not be an integer; use a list of points [x, y, z]"},
    {"LineOfOnePoint", "[[probe]]\nname = \"a\"\nline = { from = [0, 0, 0], to = [1, 0, 0], count = 1 }\n",
     "slab.toml:9: probe[0].line.count = 1: out of range; use an integer from 2 to 10000000"},
    {"NormalIsZero", "[[probe]]\nname = \"a\"\npoints = [[0, 0, 0]]\nnormal = [0, 0, 0]\n",
     "slab.toml:10: probe[0].normal = [0, 0, 0]: has no direction; use a vector that is not zero"},
    {"UnknownField", "[output]\nfields = [\"fluense\"]\n",
     "slab.toml:8: output.fields[0] = \"fluense\": is not known (did you mean \"fluence\"?); use "
     "\"fluence\", "
     "\"net_flux\", \"media\", \"direction_error\" or \"radiance:K\" for the ordinate K"},
    {"FieldTwice", "[output]\nfields = [\"media\", \"media\"]\n",
     "slab.toml:8: output.fields[1] = \"media\": named twice; remove one"},
    {"OrdinateTwice", "[output]\nfields = [\"radiance:01\", \"radiance:1\"]\n",
     "slab.toml:8: output.fields[1] = \"radiance:1\": names the ordinate 1 twice; remove one"},
    {"FieldWithoutOrdinate", "[output]\nfields = [\"radiance:x\"]\n",
     "slab.toml:8: output.fields[0] = \"radiance:x\": no ordinate after the colon; use \"fluence\", "
     "\"net_flux\", "
     "\"media\", \"direction_error\" or \"radiance:K\" for the ordinate K"},
    {"NoSuchOrdinate", "[output]\nfields = [\"radiance:96\"]\n",
     "slab.toml:8: output.fields[0] = \"radiance:96\": no such ordinate (ldfe-sq of order 1 has 96); use 0 "
     "to 95"},
    {"DirectoryIsEmpty", "[output]\ndirectory = \"\"\n",
     "slab.toml:8: output.directory = \"\": must not be empty"},
};

std::string name_of(const testing::TestParamInfo<Check>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(Keys, CaseFault, testing::ValuesIn(keys), name_of);
INSTANTIATE_TEST_SUITE_P(NotInThisVersion, CaseFault, testing::ValuesIn(later), name_of);
INSTANTIATE_TEST_SUITE_P(Values, CaseFault, testing::ValuesIn(values), name_of);

TEST(CaseFaults, OfAWholeFileComeAtOnceSortedByLine) {
  const std::string text = R"(titel = "a"
[walls.floor]
diffuse = 2
[solve]
tolerance = -1
[[mesh.box]]
region = "air"
min = [0, 0, 0]
max = [0, 1, 1]
[media]
)";
  EXPECT_EQ(faults_of(text),
            "slab.toml:1: titel = \"a\": unknown key; did you mean \"title\"?\n"
            "slab.toml:3: walls.floor.diffuse = 2: out of range; use a number, or a list with one for each "
            "band, each "
            "from 0 to 1\n"
            "slab.toml:5: solve.tolerance = -1: out of range; use a number above 0 and below 1\n"
            "slab.toml:9: mesh.box[0].max = [0, 1, 1]: not above min in x (0 <= 0); a box needs min < max\n"
            "slab.toml:10: media: no entry; add one for each region, or \"*\" for all");
}

TEST(CaseFaults, OfAnotherKeyHideNoContradiction) {
  EXPECT_EQ(faults_of(cube + "[walls.xmin]\ndiffuse = 0.7\nspecular = 0.7\nradiance = -1\n"),
            "slab.toml:7: walls.xmin: diffuse + specular = 1.4 (more light would leave than arrives); use at "
            "most 1\n"
            "slab.toml:10: walls.xmin.radiance = -1: out of range; use a number, a formula in x, y, z or { "
            "file, array }, or a "
            "list with one for each band, each at least 0");
  EXPECT_EQ(faults_of(cube + "[media.air]\nalbedo = 0.5\nemission = -1\n"),
            "slab.toml:7: media.air: albedo without extinction (it does not say how far light goes); add "
            "extinction\n"
            "slab.toml:9: media.air.emission = -1: out of range; use a number, a formula in x, y, z or { "
            "file, array }, or a "
            "list with "
            "one for each band, each at least 0");
}

TEST(CaseFaults, OfNamesThatThePrimitivesCannotGiveListThosePossible) {
  EXPECT_EQ(faults_of(cube + R"([media.b]
[walls.zmim]
[walls."crate.ymax"]
[mesh]
max_volume = { nope = 1, air = 2 }
[[mesh.box]]
hole = true
name = "crate"
min = [0.4, 0.4, 0.4]
max = [0.6, 0.6, 0.6]
)"),
            "slab.toml:7: media.b: no region can be called \"b\"; there can be air\n"
            "slab.toml:8: walls.zmim: no wall can be called \"zmim\" (did you mean \"zmin\"?); there can be "
            "crate.xmax, crate.xmin, crate.ymax, crate.ymin, crate.zmax, crate.zmin, xmax, xmin, ymax, ymin, "
            "zmax, zmin\n"
            "slab.toml:11: mesh.max_volume.nope: no region can be called \"nope\"; there can be air");
}

TEST(CaseFaults, OfNamesWaitForAGeometryThatIsRead) {
  EXPECT_EQ(faults_of(no_geometry + "[mesh]\nsurface = \"a.stl\"\n[media.b]\n[walls.lamp]\n"), "");
}

TEST(CaseFaults, OfAnEmptyFileNameWhatACaseNeeds) {
  EXPECT_EQ(faults_of(""),
            "slab.toml: mesh: no geometry; use exactly one of file, surface, labels or primitives (box, "
            "sphere, cylinder)\n"
            "slab.toml: media: no entry; add one for each region, or \"*\" for all\n"
            "slab.toml: walls: no entry; add one for each wall, or \"*\" for all, as [walls.\"*\"] with "
            "diffuse = 0.5");
}

TEST(CaseFaults, OfAFormulaQuoteTheParser) {
  const std::string fault = faults_of(cube + "[media.air]\nabsorption = \"0.1 + sin(\"\n");
  EXPECT_TRUE(fault.starts_with("slab.toml:8: media.air.absorption = \"0.1 + sin(\": is not a formula ("))
      << fault;
  EXPECT_TRUE(fault.ends_with("); use a number or a formula in x, y, z, wx, wy, wz")) << fault;
}

TEST(CaseFaults, OfAFormulaWithAUnitSayThatItIsNone) {
  const std::string fault = faults_of(cube + "[media.air]\nabsorption = \"0.1 1/m\"\n");
  EXPECT_TRUE(fault.starts_with("slab.toml:8: media.air.absorption = \"0.1 1/m\": is not a formula ("))
      << fault;
}

}  // namespace
}  // namespace etendue::case_faults_test
