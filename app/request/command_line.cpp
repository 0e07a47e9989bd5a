// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/request/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/request/command_text.h"
#include "app/write/result/program_version.h"
#include "base/errors.h"
#include "base/text/edit_distance.h"

namespace etendue {
namespace {

const std::map<std::string, ProgressStyle> progress_styles = {
    {"bar", ProgressStyle::bar}, {"plain", ProgressStyle::plain}, {"none", ProgressStyle::none}};

/// The parser and the places that it fills.
class Parser {
 public:
  Parser()
      : app_("Radiative transport by discrete ordinates, photons and radiosity on tetrahedra.", "etendue") {
    app_.set_version_flag("--version", "etendue " + program_version());
    app_.footer(command_examples);
    app_.require_subcommand(1);
    add_run();
    add_render();
    add_bake();
    add_study();
    add_compare();
    add_adjoint();
    add_check();
    add_mesh();
    add_directions();
    add_new();
    add_keys();
    for (CLI::App* command : app_.get_subcommands({})) command->footer(examples_of(command->get_name()));
  }

  Request parse(std::vector<std::string> arguments) {
    refuse_unknown_command(arguments);
    run_.record.command_line = shell_line("etendue", arguments);
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants a vector
    try {
      app_.parse(std::move(arguments));
    } catch (const CLI::ParseError& error) {
      if (error.get_exit_code() != 0) throw InputError(message_of(error));
      std::ostringstream text;
      app_.exit(error, text, text);
      return ShowText{text.str()};
    }
    check_output();
    return request();
  }

 private:
  void refuse_unknown_command(const std::vector<std::string>& arguments) const {
    if (arguments.empty() || arguments.front().starts_with('-')) return;
    const auto named = [&](const CLI::App* command) { return command->get_name() == arguments.front(); };
    if (!app_.get_subcommands(named).empty()) return;
    std::vector<std::string> names;
    for (const CLI::App* command : app_.get_subcommands({})) names.push_back(command->get_name());
    throw InputError(fmt::format("command line: {}: no such command{}; use {} (see etendue --help)",
                                 arguments.front(), suggestion(arguments.front(), names), enumerate(names)));
  }

  void add_new() {
    new_command_ = app_.add_subcommand("new", "Write a commented case to begin with");
    new_command_->add_option("kind", new_.kind, "room, furnace, tissue or shield")
        ->required()
        ->type_name("KIND");
    new_command_->add_option("-o,--output", new_.output, "The file to write; default: KIND.toml")
        ->type_name("FILE");
  }

  void add_keys() {
    CLI::App& keys = *app_.add_subcommand("keys", "Every key of the case file, or those of one table");
    CLI::Option* path =
        keys.add_option(
                "path", keys_.path,
                "A table or a key, e.g. mesh.box, solve.tolerance or diffuse; default: the reference page")
            ->type_name("PATH");
    keys.add_flag("--schema", keys_.schema,
                  "A JSON schema of all keys, by which editors complete and check case files")
        ->excludes(path);
  }

  void add_run() {
    run_command_ = app_.add_subcommand("run", "Solve a case and write its results");
    add_run_options(*run_command_);
    CLI::Option* estimate = run_command_->add_flag_callback(
        "--estimate", [this] { run_.estimate = EstimateWish::always; },
        "Repeat the run on coarser cells and with other directions, and state the errors of its numbers; "
        "default: where that is cheap");
    run_command_
        ->add_flag_callback(
            "--no-estimate", [this] { run_.estimate = EstimateWish::never; }, "Do not repeat it")
        ->excludes(estimate);
  }

  void add_render() {
    render_command_ = app_.add_subcommand("render", "Take pictures of a saved result");
    CLI::App& command = *render_command_;
    command.add_option("results", render_.results, "The directory of a run")
        ->required()
        ->type_name("RESULTS");
    command.add_option("--camera", render_.cameras, "One camera of the case; repeat for more; default: all")
        ->allow_extra_args(false)
        ->type_name("NAME");
    command.add_option("--case", render_.file, "A case file with other cameras, else as that of the run")
        ->type_name("CASE.toml");
    add_set(command, render_);
    command.add_option("--output", output_, "Directory of the pictures, in place of RESULTS")
        ->type_name("DIR");
    add_threads_and_progress(command);
  }

  void add_bake() {
    bake_command_ = app_.add_subcommand(
        "bake", "Colours of the walls from a saved result: vertices and textures, PLY, glTF and VTK");
    CLI::App& command = *bake_command_;
    command.add_option("results", bake_.results, "The directory of a run")->required()->type_name("RESULTS");
    command
        .add_option("--quantity", baked_,
                    "irradiance (default), radiosity, or occlusion: how much of a uniform sky is seen")
        ->check(CLI::IsMember({"irradiance", "radiosity", "occlusion"}))
        ->type_name("WHAT");
    command
        .add_option(
            "--sky", bake_.sky,
            "A wall that is the sky of an occlusion; repeat for more; default: all that are black and cold")
        ->allow_extra_args(false)
        ->type_name("WALL");
    command
        .add_option("--gather", bake_.gather,
                    "Rays from each vertex of walls that reflect, as of a camera; default: 0")
        ->check(CLI::IsMember({0, 64, 144, 256, 576, 1024}))
        ->type_name("N");
    command
        .add_option("--texture", bake_.texture,
                    "Bakes a texture of N x N pixels too, with coordinates for it; default: none")
        ->check(CLI::Range(16, 16384))
        ->type_name("N");
    command.add_flag("--verbose", bake_.verbose, "Show the mesher's log on standard error");
    command.add_option("--output", output_, "Directory of the files, in place of RESULTS")->type_name("DIR");
    add_threads_and_progress(command);
  }

  void add_study() {
    study_command_ = app_.add_subcommand("study", "Run a case on finer and finer levels: observed orders");
    add_run_options(*study_command_);
    study_command_
        ->add_option("--refine", refine_,
                     "mesh (volumes / 8 per level), directions (order doubled) or both (on a grid)")
        ->required()
        ->check(CLI::IsMember({"mesh", "directions", "both"}))
        ->type_name("WHAT");
    study_command_
        ->add_option("--levels", study_.levels,
                     "Number of levels, the case itself the first; of both: of each")
        ->required()
        ->check(CLI::Range(2, 20))
        ->type_name("N");
    study_command_
        ->add_option("--against", against_,
                     "What errors are taken against where nothing is exact: the finest level, or where the "
                     "last three go (richardson)")
        ->check(CLI::IsMember({"finest", "richardson"}))
        ->type_name("WHAT");
    study_command_->add_flag("--nested", study_.nested,
                             "Cut every cell into eight in place of a new mesh; a mesh file always is");
    study_command_->add_flag("!--no-plot", study_.plot, "Draw no study.svg");
    study_command_->add_flag("--resume", study_.resume, "Keep levels that an earlier study has finished");
  }

  void add_run_options(CLI::App& command) {
    add_case(command, run_);
    command.add_option("--output", output_, "Directory of the results, in place of output.directory")
        ->type_name("DIR");
    add_threads_and_progress(command);
  }

  void add_threads_and_progress(CLI::App& command) {
    command.add_option("--threads", threads_, "Number of threads; 0: all cores")
        ->check(whole_number)
        ->type_name("N");
    command.add_option("--progress", progress_, "bar (on a terminal), plain (lines) or none")
        ->check(CLI::IsMember({"bar", "plain", "none"}))
        ->type_name("STYLE");
  }

  void add_check() {
    check_command_ = app_.add_subcommand("check", "Read and validate a case without solving it");
    add_case(*check_command_, check_);
    CLI::Option* mesh =
        check_command_->add_flag("--mesh", check_.mesh, "Also mesh it: quality, areas and volumes");
    check_command_
        ->add_flag("--phase", check_.phase,
                   "Instead list its phase functions, leaves, flakes and kernels by angle, as CSV")
        ->excludes(mesh);
  }

  void add_mesh() {
    mesh_command_ = app_.add_subcommand("mesh", "Mesh a case and write the tetrahedra");
    add_case(*mesh_command_, mesh_);
    mesh_command_->add_option("-o,--output", mesh_.output, "The mesh to write (.vtu)")
        ->required()
        ->type_name("FILE");
  }

  void add_directions() {
    directions_command_ =
        app_.add_subcommand("directions", "The direction sets, their sizes and measured exactness");
    CLI::Option* set = directions_command_->add_option("--set", directions_.set, "One set in full");
    CLI::Option* order = directions_command_->add_option("--order", directions_.order, "Its order");
    set->type_name("NAME")->needs(order);
    order->type_name("N")->needs(set);
    directions_command_->add_option("case", directions_.file, "The set of a case, in full")
        ->type_name("CASE.toml")
        ->excludes(set);
    directions_command_->add_option("-o,--output", directions_.output, "Also write its directions (.vtp)")
        ->type_name("FILE");
  }

  void add_compare() {
    compare_command_ =
        app_.add_subcommand("compare", "Solve a case by several methods and compare their answers");
    add_run_options(*compare_command_);
    compare_command_
        ->add_option("--methods", compare_.methods,
                     "two or three of ordinates, photons and radiosity, with commas between; the first is "
                     "what others are compared with")
        ->required()
        ->delimiter(',')
        ->expected(2, 3)
        ->check(CLI::IsMember({"ordinates", "photons", "radiosity"}))
        ->type_name("METHODS");
  }

  void add_adjoint() {
    adjoint_command_ = app_.add_subcommand(
        "adjoint",
        "What each region, wall and light brings of a quantity, and where light is important for it");
    add_run_options(*adjoint_command_);
    adjoint_command_
        ->add_option(
            "--of", adjoint_.responses,
            "probe:NAME, sensor:NAME, wall:NAME (power that arrives) or region:NAME (power absorbed); "
            "repeat for more")
        ->required()
        ->allow_extra_args(false)
        ->type_name("WHAT");
    adjoint_command_->add_flag(
        "--gradient", adjoint_.gradient,
        "Also solve the case itself, with all light on the directions, for the derivatives by absorption, "
        "scattering, emission and walls");
  }

  static void add_case(CLI::App& command, CaseRequest& request) {
    command.add_option("case", request.file, "The case file")->required()->type_name("CASE.toml");
    add_set(command, request);
  }

  static void add_set(CLI::App& command, CaseRequest& request) {
    command.add_option("--set", request.overrides, "Change a key of the case, e.g. solve.tolerance=1e-8")
        ->allow_extra_args(false)
        ->type_name("KEY=VALUE");
    command.add_flag("--verbose", request.verbose, "Show the mesher's log on standard error");
  }

  /// Of the first word that the command does not know.
  static std::string meant_option(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    const std::vector<std::string> unknown = command.remaining();
    return unknown.empty() ? "" : suggestion(unknown.front().substr(0, unknown.front().find('=')), names);
  }

  /// Throws InputError for an empty name.
  void check_output() const {
    for (const CLI::App* command : app_.get_subcommands())
      if (const CLI::Option* output = command->get_option_no_throw("--output"); output && output->count() > 0)
        if (output->as<std::string>().empty())
          throw InputError("command line: " + command->get_name() +
                           ": --output: is empty; name a directory or a file, or leave it out");
  }

  std::string message_of(const CLI::ParseError& error) const {
    std::string text = error.what();
    std::replace(text.begin(), text.end(), '\n', ' ');
    for (const CLI::App* command : app_.get_subcommands())
      return "command line: " + command->get_name() + ": " + text + meant_option(*command) +
             "; see etendue " + command->get_name() + " --help";
    return "command line: " + text + "; see etendue --help";
  }

  Request request() {
    if (run_command_->parsed()) return finished_run();
    if (render_command_->parsed()) return finished_render();
    if (bake_command_->parsed()) return finished_bake();
    if (study_command_->parsed()) return finished_study();
    if (compare_command_->parsed()) return finished_compare();
    if (adjoint_command_->parsed()) {
      adjoint_.run = finished_run();
      return adjoint_;
    }
    if (check_command_->parsed()) return check_;
    if (mesh_command_->parsed()) return mesh_;
    if (directions_command_->parsed()) return directions_;
    if (new_command_->parsed()) return new_;
    return keys_;
  }

  /// Options that stand for keys become overrides, so that the resolved case holds them too.
  RunRequest finished_run() {
    if (output_) {
      const std::string path = std::filesystem::absolute(*output_).string();
      // A JSON string is a TOML string too.
      run_.overrides.push_back("output.directory=" + nlohmann::json(path).dump());
    }
    if (threads_) run_.overrides.push_back("solve.threads=" + std::to_string(*threads_));
    if (progress_) run_.progress = progress_styles.at(*progress_);
    return run_;
  }

  RenderRequest finished_render() {
    if (output_) render_.output = *output_;
    if (threads_) render_.threads = *threads_;
    if (progress_) render_.progress = progress_styles.at(*progress_);
    return render_;
  }

  BakeRequest finished_bake() {
    if (output_) bake_.output = *output_;
    if (threads_) bake_.threads = *threads_;
    if (progress_) bake_.progress = progress_styles.at(*progress_);
    if (baked_ == "radiosity") bake_.quantity = BakedQuantity::radiosity;
    if (baked_ == "occlusion") bake_.quantity = BakedQuantity::occlusion;
    if (!bake_.sky.empty() && bake_.quantity != BakedQuantity::occlusion)
      throw InputError(
          "command line: bake: --sky: is for an occlusion; use --quantity occlusion, or leave it out");
    return bake_;
  }

  StudyRequest finished_study() {
    study_.refinement = *refine_ == "mesh"         ? Refinement::mesh
                        : *refine_ == "directions" ? Refinement::directions
                                                   : Refinement::both;
    study_.against = against_ == "richardson" ? StudyReference::richardson : StudyReference::finest;
    if (study_.against == StudyReference::richardson && study_.levels < 3)
      throw InputError(
          fmt::format("command line: study: --levels = {}: too few for --against richardson, "
                      "which takes three",
                      study_.levels));
    if (study_.against == StudyReference::richardson && study_.refinement == Refinement::both)
      throw InputError(
          "command line: study: --against = richardson: where both are refined there is no one "
          "size to go by; refine the mesh or the directions");
    study_.run = finished_run();
    return study_;
  }

  CompareRequest finished_compare() {
    compare_.run = finished_run();
    for (auto method = compare_.methods.begin(); method != compare_.methods.end(); ++method)
      if (std::find(compare_.methods.begin(), method, *method) != method)
        throw InputError("command line: compare: --methods = " + CLI::detail::join(compare_.methods, ",") +
                         ": the same method twice; use each once, as in ordinates,photons,radiosity");
    return compare_;
  }

  CLI::App app_;
  CLI::App* run_command_ = nullptr;
  CLI::App* render_command_ = nullptr;
  CLI::App* bake_command_ = nullptr;
  CLI::App* study_command_ = nullptr;
  CLI::App* compare_command_ = nullptr;
  CLI::App* adjoint_command_ = nullptr;
  CLI::App* check_command_ = nullptr;
  CLI::App* mesh_command_ = nullptr;
  CLI::App* directions_command_ = nullptr;
  CLI::App* new_command_ = nullptr;
  RunRequest run_;
  RenderRequest render_;
  BakeRequest bake_;
  StudyRequest study_;
  CompareRequest compare_;
  AdjointRequest adjoint_;
  CheckRequest check_;
  MeshRequest mesh_;
  NewRequest new_;
  KeysRequest keys_;
  DirectionsRequest directions_;
  std::optional<std::string> output_;
  std::optional<int> threads_;
  std::optional<std::string> progress_;
  std::optional<std::string> refine_;
  std::string against_ = "finest";
  std::string baked_ = "irradiance";
};

}  // namespace

Request parse_command_line(const std::vector<std::string>& arguments) { return Parser().parse(arguments); }

}  // namespace etendue
