// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"
#include "app/case/keys/bound_table.h"

namespace etendue {

// The tables of the case file whose keys are bound to members.
const BoundTable<Units>& unit_table();
const BoundTable<MeshCase>& mesh_table();
const BoundTable<LabelsCase>& label_table();
const BoundTable<SpherePrimitive>& sphere_table();
const BoundTable<CylinderPrimitive>& cylinder_table();
const BoundTable<Case>& direction_table();
const BoundTable<SolveOptions>& space_table();
const BoundTable<Case>& solve_table();
const BoundTable<PhotonCase>& photon_table();  ///< of [solve]
const BoundTable<PhotonCase>& photon_map_table();
const BoundTable<RadiosityCase>& radiosity_table();
const BoundTable<ExactFamily>& exact_family_table();
const BoundTable<AccuracyCase>& accuracy_table();
const BoundTable<AccuracyCase>& budget_table();  ///< of [accuracy]
const BoundTable<TimeCase>& time_table();
const BoundTable<OutputCase>& output_table();
const BoundTable<CameraCase>& camera_table();
const BoundTable<FalseColor>& false_color_table();

}  // namespace etendue
