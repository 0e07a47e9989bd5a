// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/gmsh_file.h"

#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "base/text/text_lines.h"
#include "mesh/files/gmsh_elements.h"

namespace etendue {
namespace {

constexpr std::int64_t kMostTags = 1000;
constexpr std::int64_t kLargestTag = std::numeric_limits<std::int32_t>::max();

/// 4.1 gives physical groups to entities, and elements to entities.
using PhysicalGroups = std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t>;  // [dimension, tag]

enum class GmshVersion { v2_2, v4_1 };

void expect_end(TextLines& lines, const std::string& section) {
  lines.next("$End" + section);
  const std::string_view word = lines.word();
  if (word != "$End" + section) lines.fail(section + " section", word, "must end with $End" + section);
}

void skip_section(TextLines& lines, const std::string& section) {
  const std::string end = "$End" + section;
  while (true) {
    lines.next(end);
    if (lines.rest() == end) return;
  }
}

GmshVersion read_format(TextLines& lines) {
  lines.next("$MeshFormat");
  if (lines.word() != "$MeshFormat") lines.fail("is not a Gmsh mesh (it must begin with $MeshFormat)");
  lines.next("the version of the format");
  const std::string_view version = lines.word();
  if (version != "2.2" && version != "4.1")
    lines.fail("version", version, "is not read; save the mesh as Gmsh 4.1 or 2.2");
  if (lines.integer("file type", 0, 1) == 1)
    lines.fail("file type = 1: binary meshes are not read; save as ASCII");
  expect_end(lines, "MeshFormat");
  return version == "2.2" ? GmshVersion::v2_2 : GmshVersion::v4_1;
}

void read_nodes_2(TextLines& lines, GmshElements& mesh) {
  lines.next("the number of nodes");
  const std::size_t count = lines.count("number of nodes");
  for (std::size_t i = 0; i < count; ++i) {
    lines.next("node " + std::to_string(i + 1) + " of " + std::to_string(count));
    const std::int64_t tag = lines.integer("node");
    mesh.add_point(lines, tag, lines.point());
  }
}

void read_elements_2(TextLines& lines, GmshElements& mesh) {
  lines.next("the number of elements");
  const std::size_t count = lines.count("number of elements");
  for (std::size_t i = 0; i < count; ++i) {
    lines.next("element " + std::to_string(i + 1) + " of " + std::to_string(count));
    const std::int64_t tag = lines.integer("element");
    const std::int64_t type = lines.integer("element type");
    const std::int64_t tags = lines.integer("number of tags", 0, kMostTags);
    std::int64_t physical = 0;
    for (std::int64_t t = 0; t < tags; ++t) {
      const std::int64_t value = lines.integer("tag", -kLargestTag, kLargestTag);
      if (t == 0) physical = std::abs(value);
    }
    mesh.add_element(lines, tag, type, physical);
  }
}

/// The physical group of an entity from the rest of its line: their number, then their tags, negative
/// where the orientation is reversed.
void read_physical_group(TextLines& lines, int dimension, std::int64_t entity, PhysicalGroups& groups) {
  const std::int64_t count = lines.integer("number of physical tags", 0, kMostTags);
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t physical = std::abs(lines.integer("physical tag", -kLargestTag, kLargestTag));
    const auto [entry, is_new] = groups.emplace(std::make_pair(dimension, entity), physical);
    if (!is_new && entry->second != physical && dimension >= 2)
      lines.fail("physical tag = " + std::to_string(physical) + ": the entity " + std::to_string(entity) +
                 " of dimension " + std::to_string(dimension) + " is already in group " +
                 std::to_string(entry->second) + "; an entity has one name");
  }
}

/// The dimension of the entity that this one is a part of, from what follows its tag in a partitioned mesh:
/// the parent's dimension and tag, the number of its partitions and their tags.
int read_parent(TextLines& lines) {
  const std::int64_t dimension = lines.integer("dimension of the parent", 0, 3);
  lines.integer("parent");
  const std::int64_t partitions = lines.integer("number of partitions", 0, kLargestTag);
  for (std::int64_t i = 0; i < partitions; ++i) lines.integer("partition");
  return static_cast<int>(dimension);
}

/// Whether the entities of a section are parts of those of another.
enum class Partitioned { no, yes };

void read_entities(TextLines& lines, Partitioned partitioned, PhysicalGroups& groups) {
  lines.next("the numbers of entities");
  std::vector<std::size_t> counts;
  for (const char* what : {"number of points", "number of curves", "number of surfaces", "number of volumes"})
    counts.push_back(lines.count(what));
  for (int dimension = 0; dimension < 4; ++dimension)
    for (std::size_t i = 0; i < counts[static_cast<std::size_t>(dimension)]; ++i) {
      lines.next("an entity of dimension " + std::to_string(dimension));
      const std::int64_t entity = lines.integer("entity");
      const int parent = partitioned == Partitioned::yes ? read_parent(lines) : dimension;
      lines.point();                     // its place, or the low corner of its box
      if (dimension > 0) lines.point();  // the high corner
      // A surface between two partitions of a volume has the groups of the volume.
      if (parent == dimension) read_physical_group(lines, dimension, entity, groups);
    }
}

/// The numbers of partitions and of ghost entities, then a line for each of these, before the entities.
void read_partitioned_entities(TextLines& lines, PhysicalGroups& groups) {
  lines.next("the number of partitions");
  lines.count("number of partitions");
  lines.next("the number of ghost entities");
  const std::size_t ghosts = lines.count("number of ghost entities");
  for (std::size_t i = 0; i < ghosts; ++i) lines.next("a ghost entity");
  read_entities(lines, Partitioned::yes, groups);
}

void read_nodes_4(TextLines& lines, GmshElements& mesh) {
  lines.next("the numbers of nodes");
  const std::size_t blocks = lines.count("number of blocks");
  for (std::size_t b = 0; b < blocks; ++b) {
    lines.next("block " + std::to_string(b + 1) + " of " + std::to_string(blocks) + " of nodes");
    lines.integer("dimension", 0, 3);
    lines.integer("entity");
    lines.integer("parametric", 0, 1);
    std::vector<std::int64_t> tags(lines.count("number of nodes"));
    for (std::int64_t& tag : tags) {
      lines.next("the tag of a node");
      tag = lines.integer("node");
    }
    for (const std::int64_t tag : tags) {
      lines.next("the coordinates of node " + std::to_string(tag));
      mesh.add_point(lines, tag, lines.point());
    }
  }
}

void read_elements_4(TextLines& lines, const PhysicalGroups& groups, GmshElements& mesh) {
  lines.next("the numbers of elements");
  const std::size_t blocks = lines.count("number of blocks");
  for (std::size_t b = 0; b < blocks; ++b) {
    lines.next("block " + std::to_string(b + 1) + " of " + std::to_string(blocks) + " of elements");
    const std::int64_t dimension = lines.integer("dimension", 0, 3);
    const std::int64_t entity = lines.integer("entity");
    const std::int64_t type = lines.integer("element type");
    const std::size_t count = lines.count("number of elements");
    const auto group = groups.find({dimension, entity});
    for (std::size_t i = 0; i < count; ++i) {
      lines.next("element " + std::to_string(i + 1) + " of " + std::to_string(count));
      const std::int64_t tag = lines.integer("element");
      mesh.add_element(lines, tag, type, group == groups.end() ? 0 : group->second);
    }
  }
}

}  // namespace

RawMesh read_gmsh_file(const std::filesystem::path& path) {
  TextLines lines(path);
  const GmshVersion version = read_format(lines);
  GmshElements mesh;
  PhysicalGroups groups;
  while (lines.next()) {
    const std::string_view opening = lines.word();
    if (opening.size() < 2 || opening.front() != '$') lines.fail("section", opening, "must begin with $");
    const std::string section(opening.substr(1));
    if (section == "PhysicalNames") {
      mesh.read_physical_names(lines);
    } else if (section == "Entities" && version == GmshVersion::v4_1) {
      read_entities(lines, Partitioned::no, groups);
    } else if (section == "PartitionedEntities" && version == GmshVersion::v4_1) {
      read_partitioned_entities(lines, groups);
    } else if (section == "Nodes") {
      version == GmshVersion::v2_2 ? read_nodes_2(lines, mesh) : read_nodes_4(lines, mesh);
    } else if (section == "Elements") {
      version == GmshVersion::v2_2 ? read_elements_2(lines, mesh) : read_elements_4(lines, groups, mesh);
    } else {
      skip_section(lines, section);
      continue;
    }
    expect_end(lines, section);
  }
  return std::move(mesh).take(lines.file());
}

}  // namespace etendue
