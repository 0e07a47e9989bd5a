// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/write/result/run_result.h"
#include "mesh/files/mesh_file.h"
#include "solver/angular/sets/direction_set.h"

namespace etendue {

/// fields.vtu: every cell with four points of its own, so that jumps between cells are seen. Point 4 c + i is
/// vertex i of cell c. `path` is written, `shown` is named in a FileError.
void write_fields(const RunResult& result, const std::filesystem::path& path,
                  const std::filesystem::path& shown);

/// cells.vtu, of a mesh that was cut from another program's: the cells of that mesh, with the means of the
/// arrays of fields.vtu over their volumes.
void write_parents(const RunResult& result, const std::filesystem::path& path,
                   const std::filesystem::path& shown);

/// walls.vtp: every boundary triangle with three points of its own, 3 f + i, seen from outside; where there
/// are patches that are finer than faces, the same of their triangles, with the patch of each.
void write_walls(const RunResult& result, const std::filesystem::path& path,
                 const std::filesystem::path& shown);

/// modulation.vtu, of a case with frequencies: every cell with four points of its own, and for each frequency
/// f `amplitude_f` and `phase_f`, by how much light comes later [degree], of the fluence [band].
void write_modulation(const RunResult& result, const std::filesystem::path& path,
                      const std::filesystem::path& shown);

/// Name of the file of a frame.
std::string frame_name(const StepsInTime& steps, std::size_t frame);

/// A frame of steps in time: every cell with four points of its own, and the fluence [band] or temperature.
void write_frame(const RunResult& result, const FrameInTime& frame, const std::filesystem::path& path,
                 const std::filesystem::path& shown);

/// A collection of all frames beside it, with their times.
std::string frames_pvd(const StepsInTime& steps);

/// Encoding, title, program and units of the mesh file of a case.
MeshFileOptions mesh_file_options(const Case& input);

/// A direction set: its directions as points of the unit sphere, each with its ordinate and weight. Title and
/// encoding are those of the case.
void write_directions(const DirectionSet& set, const Case& input, const std::filesystem::path& path);

}  // namespace etendue
