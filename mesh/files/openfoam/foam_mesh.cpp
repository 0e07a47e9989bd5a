// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/openfoam/foam_mesh.h"

#include <algorithm>
#include <array>
#include <limits>

#include "base/errors.h"
#include "base/name_table.h"
#include "base/position.h"
#include "base/text/text_lines.h"
#include "mesh/files/openfoam/foam_file.h"

namespace etendue {
namespace {

constexpr std::int64_t most_labels = std::numeric_limits<std::int32_t>::max();

struct FoamPatch {
  std::string name, type;
  std::int64_t first = -1, faces = -1;
};

/// Types of patches that are no walls, by the beginning of their names, and what to do.
struct RefusedType {
  std::string_view type, reason;
};
constexpr std::array<RefusedType, 6> refused_types = {{
    {"empty", "leaves out a dimension; give the case its third dimension, with walls or symmetry planes"},
    {"wedge", "is a sector of a body of revolution; mesh the whole body"},
    {"cyclic", "joins two patches, which is not possible here; use symmetry planes or mesh the whole body"},
    {"nonuniformTransformCyclic", "joins two patches, which is not possible here"},
    {"overset", "is of overlapping meshes, which are not possible here"},
    {"processor", "is a part of a divided mesh; join it with reconstructParMesh"},
}};

std::filesystem::path mesh_folder(const std::filesystem::path& folder) {
  for (const std::filesystem::path& mesh : {folder / "constant" / "polyMesh", folder / "polyMesh"})
    if (std::error_code ignored; std::filesystem::is_directory(mesh, ignored)) return mesh;
  std::error_code ignored;
  const bool is_divided = std::filesystem::exists(folder / "processor0", ignored);
  throw FileError(folder.string(),
                  is_divided ? "holds parts of a mesh; join them with reconstructParMesh -constant"
                             : "is a directory without constant/polyMesh; name a file of a mesh or the "
                               "folder of an OpenFOAM case");
}

class FoamMeshReader {
 public:
  explicit FoamMeshReader(const std::filesystem::path& folder) : folder_(mesh_folder(folder)) {}

  PolyhedralMesh read() {
    mesh_.file = folder_.string();
    mesh_.points = FoamFile(folder_ / "points", {"vectorField"}).vectors("point");
    read_faces();
    read_cells();
    read_patches();
    read_zones();
    return std::move(mesh_);
  }

 private:
  std::int64_t last_point() const { return static_cast<std::int64_t>(mesh_.points.size()) - 1; }

  void read_faces() {
    FoamFile file(folder_ / "faces", {"faceList", "faceCompactList"});
    if (file.class_name() == "faceCompactList" && file.is_binary())
      read_compact_faces(file);
    else
      read_face_list(file);
    check_faces(file);
  }

  void read_face_list(FoamFile& file) {
    const std::size_t faces = file.count("number of faces", 8);
    file.expect("(");
    for (std::size_t f = 0; f < faces; ++f) {
      for (const int point : file.labels("point", 0, last_point(), mesh_.points.size()))
        mesh_.face_points.push_back(point);
      if (mesh_.face_points.size() > position(most_labels)) file.fail("has too many points of faces");
      mesh_.face_ends.push_back(static_cast<int>(mesh_.face_points.size()));
      check_face(file, f);
    }
    file.expect(")");
  }

  /// Where the points of each face begin, with one entry more, then the points.
  void read_compact_faces(FoamFile& file) {
    std::vector<int> begins = file.labels("start of a face", 0, most_labels, file.size());
    mesh_.face_points = file.labels("point", 0, last_point(), file.size());
    if (begins.empty() || begins.front() != 0 || !std::ranges::is_sorted(begins) ||
        position(begins.back()) != mesh_.face_points.size())
      file.fail("the starts of the faces do not fit their points");
    mesh_.face_ends.assign(begins.begin() + 1, begins.end());
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) check_face(file, f);
  }

  void check_face(const FoamFile& file, std::size_t face) const {
    const std::span<const int> points = mesh_.face(face);
    std::vector<int> sorted(points.begin(), points.end());
    std::ranges::sort(sorted);
    const bool repeats = std::ranges::adjacent_find(sorted) != sorted.end();
    if (points.size() < 3 || repeats)
      file.fail("face " + std::to_string(face) + ": has " +
                (repeats ? "a point twice" : std::to_string(points.size()) + " points") +
                "; must have three points or more, all different");
  }

  void check_faces(const FoamFile& file) const {
    if (mesh_.face_count() < 4) file.fail("holds fewer than four faces; mesh the volume");
  }

  void read_cells() {
    // A cell has four faces or more, each in two cells at most.
    const auto most_cells = static_cast<std::int64_t>(mesh_.face_count() / 2);
    FoamFile owners(folder_ / "owner", {"labelList"}), neighbors(folder_ / "neighbour", {"labelList"});
    mesh_.owners = owners.labels("owner", 0, most_cells - 1, mesh_.face_count());
    if (mesh_.owners.size() != mesh_.face_count())
      owners.fail("has " + std::to_string(mesh_.owners.size()) + " entries; must have one for each of the " +
                  std::to_string(mesh_.face_count()) + " faces");
    mesh_.neighbors = neighbors.labels("neighbor", -1, most_cells - 1, mesh_.face_count());
    while (!mesh_.neighbors.empty() && mesh_.neighbors.back() == -1) mesh_.neighbors.pop_back();
    inside_ = mesh_.neighbors.size();
    int last = *std::ranges::max_element(mesh_.owners);
    for (std::size_t f = 0; f < inside_; ++f) {
      last = std::max(last, mesh_.neighbors[f]);
      if (mesh_.neighbors[f] < 0 || mesh_.neighbors[f] == mesh_.owners[f])
        neighbors.fail("face " + std::to_string(f) + ": lies between cells " +
                       std::to_string(mesh_.owners[f]) + " and " + std::to_string(mesh_.neighbors[f]) +
                       "; must be two cells");
    }
    mesh_.neighbors.resize(mesh_.face_count(), -1);
    check_no_gaps(owners, position(last) + 1);
    mesh_.cell_regions.resize(position(last) + 1, 0);
  }

  void check_no_gaps(const FoamFile& owners, std::size_t cells) const {
    std::vector<char> met(cells, 0);
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
      met[position(mesh_.owners[f])] = 1;
      if (mesh_.neighbors[f] >= 0) met[position(mesh_.neighbors[f])] = 1;
    }
    const auto missing = std::ranges::find(met, 0);
    if (missing != met.end())
      owners.fail("cell " + std::to_string(missing - met.begin()) +
                  ": owns no face and has none as neighbor");
  }

  static FoamPatch read_patch(FoamFile& file) {
    FoamPatch patch;
    patch.name = file.token();
    file.expect("{");
    while (file.peek() != "}") {
      const std::string_view key = file.token();
      if (key.empty()) file.fail("the file ends within a patch (is it cut short?)");
      if (key == "type") patch.type = file.token();
      if (key == "nFaces") patch.faces = file.integer("nFaces", 0, most_labels);
      if (key == "startFace") patch.first = file.integer("startFace", 0, most_labels);
      file.skip_entry();
    }
    file.expect("}");
    for (const RefusedType& refused : refused_types)
      if (patch.type.starts_with(refused.type) && patch.faces != 0)
        file.fail("patch " + shown_word(patch.name) + ": type " + shown_word(patch.type) + " " +
                  std::string(refused.reason));
    return patch;
  }

  void read_patches() {
    FoamFile file(folder_ / "boundary", {"polyBoundaryMesh"});
    const std::size_t patches = file.count("number of patches", 2);
    file.expect("(");
    mesh_.face_walls.assign(mesh_.face_count(), -1);
    for (std::size_t p = 0; p < patches; ++p) name_faces(file, read_patch(file));
    file.expect(")");
    for (std::size_t f = inside_; f < mesh_.face_count(); ++f)
      if (mesh_.face_walls[f] < 0)
        file.fail("face " + std::to_string(f) + ": is on the boundary, but in no patch");
  }

  void name_faces(const FoamFile& file, const FoamPatch& patch) {
    const std::string name = "patch " + shown_word(patch.name) + ": ";
    if (patch.faces < 0 || patch.first < 0) file.fail(name + "nFaces or startFace is missing");
    const auto all = static_cast<std::int64_t>(mesh_.face_count());
    if (patch.faces > 0 &&
        (patch.first < static_cast<std::int64_t>(inside_) || patch.first + patch.faces > all))
      file.fail(name + "faces " + std::to_string(patch.first) + " to " +
                std::to_string(patch.first + patch.faces - 1) + " do not exist on the boundary; there are " +
                std::to_string(inside_) + " to " + std::to_string(all - 1));
    if (std::ranges::count(mesh_.wall_names, patch.name) > 0) file.fail(name + "there are two of this name");
    const auto wall = static_cast<int>(mesh_.wall_names.size());
    for (std::int64_t i = 0; i < patch.faces; ++i) {
      int& named = mesh_.face_walls[static_cast<std::size_t>(patch.first + i)];
      if (named >= 0)
        file.fail(name + "face " + std::to_string(patch.first + i) + " is in patch " +
                  shown_word(mesh_.wall_names[position(named)]) + " too");
      named = wall;
    }
    mesh_.wall_names.push_back(patch.name);
    mesh_.patch_types.push_back(patch.type);
  }

  void read_zones() {
    constexpr int none = -1;
    mesh_.cell_regions.assign(mesh_.cell_count(), none);
    NameTable regions;
    const auto path = folder_ / "cellZones";
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored) || std::filesystem::exists(path.string() + ".gz", ignored)) {
      FoamFile file(path, {"regIOobject", "cellZoneList"});
      const std::size_t zones = file.count("number of zones", 2);
      file.expect("(");
      for (std::size_t z = 0; z < zones; ++z) read_zone(file, regions);
      file.expect(")");
    }
    for (int& region : mesh_.cell_regions)
      if (region == none) region = regions.index("domain");
    mesh_.region_names = regions.names();
  }

  void read_zone(FoamFile& file, NameTable& regions) {
    const std::string name(file.token());
    file.expect("{");
    bool has_cells = false;
    while (file.peek() != "}") {
      const std::string_view key = file.token();
      if (key.empty()) file.fail("the file ends within a zone (is it cut short?)");
      if (key == "cellLabels") {
        has_cells = true;
        add_to_zone(file, regions.index(name), regions);
      }
      file.skip_entry();
    }
    if (!has_cells) file.fail("zone " + shown_word(name) + ": has no cellLabels");
    file.expect("}");
  }

  void add_to_zone(FoamFile& file, int zone, const NameTable& regions) {
    const auto last = static_cast<std::int64_t>(mesh_.cell_count()) - 1;
    for (const int cell : file.labels("cell", 0, last, mesh_.cell_count())) {
      int& region = mesh_.cell_regions[position(cell)];
      if (region >= 0 && region != zone)
        file.fail("cell " + std::to_string(cell) + ": is in the zones " +
                  shown_word(regions.names()[position(region)]) + " and " +
                  shown_word(regions.names()[position(zone)]) + "; a cell has one region");
      region = zone;
    }
  }

  std::filesystem::path folder_;
  PolyhedralMesh mesh_;
  std::size_t inside_ = 0;  ///< number of faces between two cells
};

}  // namespace

PolyhedralMesh read_foam_mesh(const std::filesystem::path& folder) { return FoamMeshReader(folder).read(); }

}  // namespace etendue
