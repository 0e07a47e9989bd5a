// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/materials/read_phase.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <complex>
#include <numeric>

#include "app/case/keys/keys.h"
#include "app/case/keys/resolve_path.h"
#include "base/text/edit_distance.h"
#include "base/text/number_columns.h"
#include "solver/materials/phase/mie_scattering.h"

namespace etendue {
namespace {

/// The keys that a model takes besides its name.
struct ModelKeys {
  std::string_view model;
  std::vector<std::string> keys;
};

const std::array<ModelKeys, 9>& model_keys() {
  static const std::array<ModelKeys, 9> models = {{
      {"isotropic", {}},
      {"rayleigh", {}},
      {"henyey-greenstein", {"g"}},
      {"double-henyey-greenstein", {"g1", "g2", "weight"}},
      {"cornette-shanks", {"g"}},
      {"legendre", {"coefficients", "file"}},
      {"table", {"file"}},
      {"mie", {"radius", "index", "absorption_index", "wavelength", "distribution", "deviation", "variance"}},
      {"mixture", {"mix"}},
  }};
  return models;
}

/// The readers of one table: of a phase function, or of a part of a mixture.
class PhaseReader {
 public:
  PhaseReader(Section& section, std::string_view path, const PhaseContext& context)
      : section_(section), path_(path), context_(context) {}

  PhaseFunction read() {
    const std::string model = section_.text_if("model").value_or("");
    refuse_others(model);
    if (model == "rayleigh") return PhaseRayleigh{};
    if (model == "henyey-greenstein") return PhaseHenyeyGreenstein{number("g")};
    if (model == "double-henyey-greenstein")
      return PhaseDoubleHenyeyGreenstein{number("g1"), number("g2"), number("weight")};
    if (model == "cornette-shanks") return PhaseCornetteShanks{number("g")};
    if (model == "legendre") return series();
    if (model == "table") return table();
    if (model == "mie") return mie();
    if (model == "mixture") return mixture();
    return PhaseIsotropic{};
  }

 private:
  bool declared(std::string_view key) const {
    return find_key(path_, key) != nullptr || find_table(fmt::format("{}.{}", path_, key)) != nullptr;
  }

  /// Keys of other models are faults; where the model is not known, nothing is said about keys.
  void refuse_others(const std::string& model) {
    for (const ModelKeys& other : model_keys())
      for (const std::string& key : other.keys) {
        if (!declared(key) || (in_mixture() && key == "weight")) continue;
        if (model.empty())
          section_.find(key);
        else if (!takes(model, key))
          section_.unused(key, "it is no key of the model " + model);
      }
  }

  bool in_mixture() const { return path_.ends_with(".mix"); }

  static bool takes(std::string_view model, const std::string& key) {
    const auto found = std::ranges::find(model_keys(), model, &ModelKeys::model);
    return found != model_keys().end() && std::ranges::count(found->keys, key) > 0;
  }

  double number(std::string_view key) {
    if (!section_.has(key)) section_.fault(key, "missing; use " + accepted_text(*find_key(path_, key)));
    return section_.number_if(key).value_or(0);
  }

  /// The columns of `file`; none where something is wrong, which is reported.
  std::vector<std::vector<double>> columns(const std::vector<std::string>& names) {
    const TomlNode* file = section_.find("file");
    if (file == nullptr) return {};
    try {
      return read_columns(readable_path(*file, context_.case_folder), names);
    } catch (const InputError& error) {
      const std::vector<Fault>& faults = error.faults();
      section_.faults().insert(section_.faults().end(), faults.begin(), faults.end());
      return {};
    }
  }

  PhaseFunction series() {
    if (section_.has("coefficients") && section_.has("file"))
      section_.fault("given by coefficients and by a file; use one of the two");
    if (!section_.has("coefficients") && !section_.has("file"))
      section_.fault("no moments; use coefficients or file");
    PhaseLegendre phase;
    const char* source = "file";
    if (const TomlNode* list = section_.find("coefficients")) {
      source = "coefficients";
      phase.moments.clear();
      for (const auto& item : list->array()) phase.moments.push_back(item->number());
    } else if (const auto read = columns({"chi"}); !read.empty()) {
      phase.moments = read[0];
    }
    const std::string problem = series_problem(phase.moments, context_.space);
    if (problem.empty()) return phase;
    section_.fault(source, problem);
    return PhaseIsotropic{};
  }

  PhaseFunction table() {
    if (!section_.has("file")) section_.fault("file", "missing; use the name of a CSV file of mu and p");
    const auto read = columns({"mu", "p"});
    if (read.empty()) return PhaseIsotropic{};
    const std::string problem = table_problem(read[0], read[1]);
    if (problem.empty()) return PhaseTable(read[0], read[1]);
    section_.fault("file", problem);
    return PhaseIsotropic{};
  }

  /// As given, or the middle of the band [nm].
  std::optional<double> wavelength() {
    if (section_.has("wavelength")) return section_.number_if("wavelength");
    const std::vector<double>& edges = context_.bands.edges;
    const auto band = static_cast<std::size_t>(context_.band);
    if (edges.size() > band + 1) return (edges[band] + edges[band + 1]) / 2;
    section_.fault("wavelength", "missing; use a wavelength in the unit of radius, or bands.edges in nm");
    return std::nullopt;
  }

  /// The keys of the distributions that were not chosen are faults.
  std::optional<Sizes> sizes(double radius) {
    const std::string distribution = section_.text("distribution");
    const bool normal = distribution == "log-normal", gamma = distribution == "gamma";
    if (!normal) section_.unused("deviation", "it belongs to a log-normal distribution");
    if (!gamma) section_.unused("variance", "it belongs to a gamma distribution");
    const char* key = normal ? "deviation" : "variance";
    if (!normal && !gamma) return OneSize{radius};
    if (!section_.has(key)) section_.fault(key, "missing; use " + accepted_text(*find_key(path_, key)));
    const std::optional<double> width = section_.number_if(key);
    if (!width) return std::nullopt;
    return normal ? Sizes(LogNormalSizes{radius, *width}) : Sizes(GammaSizes{radius, *width});
  }

  PhaseFunction mie() {
    if (!section_.has("radius"))
      section_.fault("radius", "missing; use " + accepted_text(*find_key(path_, "radius")));
    if (!section_.has("index"))
      section_.fault("index", "missing; use " + accepted_text(*find_key(path_, "index")));
    const std::optional<double> radius = section_.number_if("radius"), length = wavelength();
    const std::optional<double> real = section_.number_if("index");
    const double imaginary = section_.number("absorption_index");
    const std::optional<Sizes> spheres = sizes(radius.value_or(1));
    if (context_.space == AngularSpace::plane) {
      section_.fault("model", "spheres scatter out of the plane; use another model in flatland");
      return PhaseIsotropic{};
    }
    if (!radius || !length || !real || !spheres) return PhaseIsotropic{};
    const std::complex<double> index(*real, imaginary);
    if (const std::string problem = mie_problem(*spheres, index, *length); !problem.empty()) {
      section_.fault("radius", problem);
      return PhaseIsotropic{};
    }
    const MieScattering cloud = mie_scattering(*spheres, index, *length);
    if (context_.notes)
      context_.notes->push_back(fmt::format(
          "spheres at wavelength {:g}: Q_ext = {:.6g}, Q_sca = {:.6g}, g = {:.6g}, mean of pi r^2 = {:.6g}",
          *length, cloud.extinction_cross_section / cloud.area, cloud.scattering_cross_section / cloud.area,
          moment_of(cloud.phase, 1), cloud.area));
    return cloud.phase;
  }

  PhaseFunction mixture() {
    PhaseMixture phase;
    for (Section& part : section_.list("mix")) {
      phase.shares.push_back(part.number_if("weight").value_or(1));
      const PhaseFunction read = PhaseReader(part, mix_path, context_).read();
      std::visit(
          [&phase](const auto& model) {
            if constexpr (std::is_constructible_v<PhasePart, decltype(model)>)
              phase.parts.emplace_back(model);
          },
          read);
    }
    if (!section_.has("mix"))
      section_.fault("mix", "missing; use a list of { weight, model, … }");
    else if (phase.parts.empty() && !section_.node().find("mix")->faulty)
      section_.fault("mix", "is empty; use a list of { weight, model, … }");
    if (phase.parts.empty()) return PhaseIsotropic{};
    const double sum = std::accumulate(phase.shares.begin(), phase.shares.end(), 0.0);
    for (double& share : phase.shares) share /= sum;
    return phase;
  }

  static constexpr std::string_view mix_path = "media.NAME.phase.mix";

  Section& section_;
  std::string_view path_;
  const PhaseContext& context_;
};

bool is_mie(Section& table) { return table.has("model") && table.text_if("model").value_or("") == "mie"; }

}  // namespace

bool depends_on_band(Section phase) {
  if (is_mie(phase)) return true;
  if (!phase.has("mix")) return false;
  std::vector<Section> parts = phase.list("mix");
  return std::ranges::any_of(parts, is_mie);
}

PhaseFunction read_phase(Section phase, const PhaseContext& context) {
  return PhaseReader(phase, "media.NAME.phase", context).read();
}

}  // namespace etendue
