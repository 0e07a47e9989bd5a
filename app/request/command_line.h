// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/case/case.h"
#include "app/write/result/run_record.h"
#include "base/parallel/rank_group.h"

namespace etendue {

/// How the progress of a solution is shown.
enum class ProgressStyle { automatic, bar, plain, none };

/// A case file and what the command line changes in it.
struct CaseRequest {
  std::filesystem::path file;
  Overrides overrides;
  bool verbose = false;
};

/// Whether a run ends with an estimate of the errors of its numbers; automatic: where that is cheap.
enum class EstimateWish { automatic, always, never };

/// Traces of a run: all that its case asks for; that, but nothing of a solution that a signal ends; or
/// nothing but what its reader takes. A run that leaves nothing takes no pictures and describes only its
/// progress; only one that leaves all starts from an earlier solution.
enum class RunTraces { all, whole, none };

struct RunRequest : CaseRequest {
  ProgressStyle progress = ProgressStyle::automatic;
  RunRecord record = {};
  EstimateWish estimate = EstimateWish::automatic;
  RunTraces traces = RunTraces::all;
  RankGroup* ranks = nullptr;  ///< processes that make this run together; null: this one alone
};

/// Pictures from a saved result. `file` is empty where the case of the result is meant.
struct RenderRequest : CaseRequest {
  std::filesystem::path results;     ///< the directory of a run
  std::vector<std::string> cameras;  ///< empty: all
  std::optional<std::filesystem::path> output;
  std::optional<int> threads;
  ProgressStyle progress = ProgressStyle::automatic;
};

/// What is baked into the walls.
enum class BakedQuantity { irradiance, radiosity, occlusion };

/// Vertex colours of the walls from a saved result; the case is that of the result.
struct BakeRequest : CaseRequest {
  std::filesystem::path results;  ///< the directory of a run
  BakedQuantity quantity = BakedQuantity::irradiance;
  std::vector<std::string>
      sky;          ///< walls that are the sky of an occlusion; empty: all that are black and cold
  int gather = 0;   ///< as of a camera
  int texture = 0;  ///< pixels across and down of a texture that is baked too; 0: none
  std::optional<std::filesystem::path> output;
  std::optional<int> threads;
  ProgressStyle progress = ProgressStyle::automatic;
};

/// What a study refines from level to level; both: on a grid of meshes and direction sets.
enum class Refinement { mesh, directions, both };

/// What the errors of a study are taken against where no exact value is known.
enum class StudyReference { finest, richardson };

struct StudyRequest {
  RunRequest run;
  Refinement refinement = Refinement::mesh;
  StudyReference against = StudyReference::finest;
  int levels = 0;
  bool nested = false;  ///< finer meshes by cutting the cells of the first into eight
  bool resume = false;
  bool plot = true;
};

/// Several methods on one case. The first is what the others are compared with.
struct CompareRequest {
  RunRequest run;
  std::vector<std::string> methods;  ///< "ordinates", "photons", "radiosity"
};

/// The importance of some responses of a case.
struct AdjointRequest {
  RunRequest run;
  std::vector<std::string> responses;  ///< "probe:NAME", …; at least one
  bool gradient = false;               ///< whether derivatives by media and walls are wanted too
};

struct CheckRequest : CaseRequest {
  bool mesh = false;
  bool phase = false;  ///< the values of the phase functions, and nothing else
};

struct MeshRequest : CaseRequest {
  std::filesystem::path output;
};

/// Without a set or a case: all sets.
struct DirectionsRequest {
  std::optional<std::filesystem::path> file;  ///< of the case whose set is meant, turned and refined as it is
  std::optional<std::string> set;
  std::optional<int> order;
  std::optional<std::filesystem::path> output;  ///< of the set, as points
};

struct KeysRequest {
  std::string path;     ///< of one table or key; empty: the whole reference page
  bool schema = false;  ///< all of them as a JSON schema instead
};

struct NewRequest {
  std::string kind;
  std::filesystem::path output;  ///< empty: KIND.toml
};

/// Help or version.
struct ShowText {
  std::string text;
};

using Request =
    std::variant<RunRequest, RenderRequest, BakeRequest, StudyRequest, CompareRequest, AdjointRequest,
                 CheckRequest, MeshRequest, DirectionsRequest, NewRequest, KeysRequest, ShowText>;

/// What the arguments (without the program's name) ask for. Throws InputError.
Request parse_command_line(const std::vector<std::string>& arguments);

}  // namespace etendue
