// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/command.h"

#include <exception>

#include "app/case/keys/key_help.h"
#include "app/case/keys/key_schema.h"
#include "app/case/keys/keys.h"
#include "app/request/command_line.h"
#include "app/request/commands.h"
#include "app/setup/fault_report.h"
#include "base/errors.h"

namespace etendue {
namespace {

/// Does what was asked.
struct Dispatch {
  std::ostream& out;
  std::ostream& err;
  RankGroup* ranks;

  ExitCode operator()(const RunRequest& request) const {
    if (ranks != nullptr) return run_together(request);
    const bool is_asked_accuracy = read_case(request.file, request.overrides).accuracy.has_value();
    return is_asked_accuracy ? run_to_accuracy(request, out, err) : run_and_estimate(request, out, err);
  }
  ExitCode run_together(RunRequest request) const {
    const Case input = read_case(request.file, request.overrides);
    if (input.accuracy) throw InputError("[accuracy] is for one process; start one");
    if (input.radiosity)
      throw InputError(
          "solve.method: several processes share ordinates or photons, and radiosity is for one; start one");
    request.ranks = ranks;
    return run_and_estimate(request, out, err);
  }
  ExitCode operator()(const RenderRequest& request) const { return render_results(request, out, err); }
  ExitCode operator()(const BakeRequest& request) const { return bake_results(request, out, err); }
  ExitCode operator()(const StudyRequest& request) const { return study_case(request, out, err); }
  ExitCode operator()(const CompareRequest& request) const { return compare_case(request, out, err); }
  ExitCode operator()(const AdjointRequest& request) const { return adjoint_case(request, out, err); }
  ExitCode operator()(const CheckRequest& request) const { return check_case(request, out, err); }
  ExitCode operator()(const MeshRequest& request) const { return mesh_case(request, out, err); }
  ExitCode operator()(const DirectionsRequest& request) const { return show_directions(request, out); }
  ExitCode operator()(const NewRequest& request) const { return new_case(request, out); }
  ExitCode operator()(const KeysRequest& request) const {
    out << (request.schema ? key_schema() : request.path.empty() ? key_reference() : key_help(request.path));
    return ExitCode::done;
  }
  ExitCode operator()(const ShowText& show) const {
    out << show.text;
    return ExitCode::done;
  }
};

/// Results that could not be printed are lost: a full disk or a closed pipe is a fault.
ExitCode checked(ExitCode code, std::ostream& out) {
  out.flush();
  if (!out) throw FileError("standard output", "cannot be written");
  return code;
}

}  // namespace

ExitCode run_command(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err,
                     RankGroup* ranks) {
  try {
    const Request command = parse_command_line(arguments);
    if (ranks != nullptr && !std::holds_alternative<RunRequest>(command) &&
        !std::holds_alternative<ShowText>(command))
      throw InputError("several processes share runs alone: start one process for all other commands");
    const ExitCode code = std::visit(Dispatch{out, err, ranks}, command);
    // What others print is not heard.
    return ranks != nullptr && ranks->rank() > 0 ? code : checked(code, out);
  } catch (const std::exception& fault) {
    const FaultReport report = report_of(fault);
    err << report.text << '\n';
    return report.code;
  }
}

}  // namespace etendue
