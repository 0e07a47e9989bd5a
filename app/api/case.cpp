// SPDX-License-Identifier: AGPL-3.0-or-later
#include <etendue/case.h>

#include <mutex>

#include "app/api/case_impl.h"
#include "app/api/mesh_impl.h"
#include "app/api/translated.h"
#include "app/case/build/build.h"

namespace etendue::v0 {
namespace {

/// TetGen keeps the filters of its exact predicates in globals: one mesh is made at a time.
std::mutex meshing;

}  // namespace

Case Case::from_file(const std::filesystem::path& file, const Overrides& overrides) {
  return translated([&] {
    return Case(std::make_shared<const Impl>(Impl{read_case(file, overrides), std::nullopt}));
  });
}

Case Case::from_text(std::string_view text, const std::filesystem::path& file, const Overrides& overrides) {
  return translated([&] {
    return Case(std::make_shared<const Impl>(Impl{read_case_text(text, file, overrides), std::nullopt}));
  });
}

Case Case::from_text(std::string_view text, const Mesh& mesh, const std::filesystem::path& file,
                     const Overrides& overrides) {
  return translated([&] {
    Overrides changes;
    if (!mesh.impl().source.empty()) changes.push_back("mesh=" + mesh.impl().source);
    changes.insert(changes.end(), overrides.begin(), overrides.end());
    return Case(std::make_shared<const Impl>(Impl{read_case_text(text, file, changes), mesh}));
  });
}

Case::Case(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
Case::~Case() = default;
Case::Case(const Case&) = default;
Case::Case(Case&&) noexcept = default;
Case& Case::operator=(const Case&) = default;
Case& Case::operator=(Case&&) noexcept = default;

const std::string& Case::title() const { return impl_->input.title; }
const std::vector<std::string>& Case::bands() const { return impl_->input.bands.names; }

std::vector<std::string> Case::cameras() const {
  std::vector<std::string> names;
  for (const CameraCase& camera : impl_->input.cameras) names.push_back(camera.name);
  return names;
}

const std::string& Case::length_unit() const { return impl_->input.units.length; }
const std::string& Case::power_unit() const { return impl_->input.units.power; }
const std::string& Case::resolved_toml() const { return impl_->input.resolved_toml; }

Mesh Case::mesh() const {
  if (impl_->mesh) return *impl_->mesh;
  return translated([&] {
    const std::scoped_lock one(meshing);
    return Mesh(std::make_shared<const Mesh::Impl>(
        Mesh::Impl{std::make_shared<const TetrahedralMesh>(build_mesh(impl_->input)), ""}));
  });
}

}  // namespace etendue::v0
