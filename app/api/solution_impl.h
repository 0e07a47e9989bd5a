// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>

#include <etendue/solution.h>

#include "app/api/solved_case.h"

namespace etendue::v0 {

struct Solution::Impl {
  std::unique_ptr<SolvedCase> solved;
  Mesh mesh;
  mutable std::mutex changing = {};  ///< held while rays are made and while files are written

  const RunResult& result() const { return *solved->result; }
};

/// The picture of a camera by the case's name of it, by the method of the solution.
Image take_image(const Solution::Impl& impl, const std::string& camera, const std::function<bool()>& stop);

}  // namespace etendue::v0
