// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/arrangement/plane_arrangement.h"

#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>

#include <algorithm>
#include <optional>

#include "base/position.h"
#include "mesh/geometry/arrangement/plane_sections.h"

namespace etendue {
namespace {

using Traits = CGAL::Arr_segment_traits_2<Exact>;
using Arrangement = CGAL::Arrangement_2<Traits, CGAL::Arr_face_extended_dcel<Traits, int>>;
using ArrangementFace = Arrangement::Face_handle;
using Point2 = Exact::Point_2;

/// What a facet parts, and under which name.
struct FacetKey {
  SpaceLabel below, above;
  int wall;
  int sheet;
  bool operator==(const FacetKey&) const = default;
};

/// Finds the facets of one plane.
class PlaneArrangement {
 public:
  PlaneArrangement(const FacePlane& plane, const BodyScene& scene, WallNames& walls, std::set<int>& used)
      : plane_(plane), scene_(scene), walls_(walls), used_patches_(used) {
    for (int body = 0; body < static_cast<int>(scene.bodies.size()); ++body)
      contacts_.push_back(contact(body));
    for (const SheetTriangle& sheet : scene.sheets)
      sheet_contacts_.push_back(contact_of(plane.plane, sheet.corners));
    const std::array<ExactNumber, 3> normal{plane.plane.a(), plane.plane.b(), plane.plane.c()};
    const std::size_t a = position(plane.axis);
    if (normal[(a + 1) % 3] != 0 || normal[(a + 2) % 3] != 0) return;
    for (const NamedRectangle& rectangle : scene.named)
      if (rectangle.axis == plane.axis && plane.plane.has_on(exact(rectangle.min)))
        named_.push_back(&rectangle);
  }

  std::vector<ExactFacet> facets() {
    if (std::optional<std::vector<ExactFacet>> whole = whole_face()) return *std::move(whole);
    build();
    for (auto face = arrangement_.faces_begin(); face != arrangement_.faces_end(); ++face)
      face->set_data(face->is_unbounded() ? -1 : key_number(key_at(lifted(inside(face)))));
    merge_equal_faces();
    std::vector<ExactFacet> result;
    for (auto face = arrangement_.faces_begin(); face != arrangement_.faces_end(); ++face)
      if (face->data() >= 0) result.push_back(facet(face));
    return result;
  }

 private:
  Point2 flattened(const ExactPoint& p) const { return {p[(plane_.axis + 1) % 3], p[(plane_.axis + 2) % 3]}; }

  ExactPoint lifted(const Point2& p) const {
    const ExactPlane& h = plane_.plane;
    const std::array<ExactNumber, 3> normal{h.a(), h.b(), h.c()};
    const std::size_t a = position(plane_.axis), b = (a + 1) % 3, c = (a + 2) % 3;
    std::array<ExactNumber, 3> x;
    x[b] = p.x();
    x[c] = p.y();
    x[a] = -(normal[b] * x[b] + normal[c] * x[c] + h.d()) / normal[a];
    return {x[0], x[1], x[2]};
  }

  const BodyFace* face_of(int body) const {
    const auto own = std::find_if(plane_.faces.begin(), plane_.faces.end(),
                                  [&](const BodyFace& face) { return face.body == body; });
    return own == plane_.faces.end() ? nullptr : &*own;
  }

  Contact contact(int body) const {
    return face_of(body) ? Contact::kFace : contact_of(plane_.plane, scene_.bodies[position(body)].points);
  }

  /// Whether a body fills the side of the plane at a point of it.
  bool fills(int body, const ExactPoint& point, int side) const {
    const ConvexBody& shape = scene_.bodies[position(body)];
    if (const BodyFace* own = face_of(body)) {
      const Vec3 outward(CGAL::to_double(shape.planes[position(own->face)].a()),
                         CGAL::to_double(shape.planes[position(own->face)].b()),
                         CGAL::to_double(shape.planes[position(own->face)].c()));
      if ((outward[plane_.axis] > 0) == (side > 0)) return false;
    } else if (contacts_[position(body)] != Contact::kCut) {
      return false;
    }
    return contains(shape, point);
  }

  SpaceLabel label_at(const ExactPoint& point, int side) const {
    for (int body = static_cast<int>(scene_.bodies.size()) - 1; body >= 0; --body)
      if (fills(body, point, side)) return scene_.labels[position(body)];
    return kOutside;
  }

  std::optional<FacetKey> key_at(const ExactPoint& point) {
    const SpaceLabel below = label_at(point, -1), above = label_at(point, 1);
    FacetKey key{std::max(below, kOutside), std::max(above, kOutside), -1, -1};
    if (!is_void(above) && !is_void(below)) key.sheet = sheet_at(point);
    if (key.below == key.above && key.sheet < 0) return std::nullopt;
    if (is_void(above)) key.wall = wall_at(point, above, 1);
    if (is_void(below)) key.wall = wall_at(point, below, -1);
    return key;
  }

  /// The last sheet that covers a point of the plane off all edges; -1: none.
  int sheet_at(const ExactPoint& point) const {
    const Point2 p = flattened(point);
    for (std::size_t i = scene_.sheets.size(); i-- > 0;) {
      if (sheet_contacts_[i] != Contact::kFace) continue;
      const auto& [a, b, c] = scene_.sheets[i].corners;
      if (!Exact::Triangle_2(flattened(a), flattened(b), flattened(c)).has_on_unbounded_side(p))
        return scene_.sheets[i].sheet;
    }
    return -1;
  }

  int wall_at(const ExactPoint& point, SpaceLabel beyond, int outward) {
    for (auto candidate = named_.rbegin(); candidate != named_.rend(); ++candidate) {
      const NamedRectangle& rectangle = **candidate;
      if (rectangle.outward == -outward || !may_name(rectangle, beyond)) continue;
      bool covered = true;
      for (int axis = 0; axis < 3; ++axis)
        covered = covered && point[axis] >= rectangle.min[axis] && point[axis] <= rectangle.max[axis];
      if (!covered) continue;
      if (rectangle.patch >= 0) used_patches_.insert(rectangle.patch);
      return walls_.number(rectangle.wall);
    }
    return walls_.number(default_name(scene_.geometry, beyond, plane_.axis, outward));
  }

  int key_number(const std::optional<FacetKey>& key) {
    if (!key) return -1;
    const auto known = std::find(keys_.begin(), keys_.end(), *key);
    const auto number = known - keys_.begin();
    if (known == keys_.end()) keys_.push_back(*key);
    return static_cast<int>(number);
  }

  static bool lies_apart(const std::vector<ExactPoint>& corners, const ConvexBody& body) {
    const CGAL::Bbox_3 around = CGAL::bbox_3(corners.begin(), corners.end());
    for (int axis = 0; axis < 3; ++axis)
      if (around.max(axis) < body.low[axis] || around.min(axis) > body.high[axis]) return true;
    return false;
  }

  /// Whether a face lies in one piece inside or outside a body that has no face in this plane.
  bool is_uncut(const std::vector<ExactPoint>& corners, const ConvexBody& body) const {
    const auto outside = [&](const ExactPlane& plane) {
      return std::none_of(corners.begin(), corners.end(),
                          [&](const ExactPoint& corner) { return plane.has_on_negative_side(corner); });
    };
    return lies_apart(corners, body) || std::any_of(body.planes.begin(), body.planes.end(), outside) ||
           std::all_of(corners.begin(), corners.end(),
                       [&](const ExactPoint& corner) { return contains(body, corner); });
  }

  std::vector<ExactPoint> corners(const BodyFace& face) const {
    const ConvexBody& body = scene_.bodies[position(face.body)];
    std::vector<ExactPoint> points;
    for (const int point : body.faces[position(face.face)]) points.push_back(body.points[position(point)]);
    return points;
  }

  bool is_met_by_sheet(const std::vector<ExactPoint>& ring) const {
    const CGAL::Bbox_3 around = CGAL::bbox_3(ring.begin(), ring.end());
    for (std::size_t i = 0; i < scene_.sheets.size(); ++i) {
      const auto& corners = scene_.sheets[i].corners;
      if (sheet_contacts_[i] != Contact::kNone &&
          CGAL::do_overlap(around, CGAL::bbox_3(corners.begin(), corners.end())))
        return true;
    }
    return false;
  }

  /// The quick way for most faces of a round body: alone in the plane, unnamed and cut by nothing.
  std::optional<std::vector<ExactFacet>> whole_face() {
    if (plane_.faces.size() != 1 || !named_.empty()) return std::nullopt;
    if (std::count(contacts_.begin(), contacts_.end(), Contact::kTouch) > 0) return std::nullopt;
    const BodyFace& own = plane_.faces.front();
    std::vector<ExactPoint> ring = corners(own);
    if (is_met_by_sheet(ring)) return std::nullopt;
    for (int body = 0; body < static_cast<int>(scene_.bodies.size()); ++body)
      if (body != own.body && !is_uncut(ring, scene_.bodies[position(body)])) return std::nullopt;
    const ExactPoint middle = CGAL::centroid(ring[0], ring[1], ring[2]);
    const std::optional<FacetKey> key = key_at(middle);
    if (!key) return std::vector<ExactFacet>{};
    const Exact::Vector_3 turn = CGAL::cross_product(ring[1] - ring[0], ring[2] - ring[0]);
    if (turn[plane_.axis] < 0) std::reverse(ring.begin(), ring.end());
    ExactFacet facet{plane_.plane, plane_.normal, {}, {}, middle, key->below, key->above, key->wall, -1};
    for (std::size_t i = 0; i < ring.size(); ++i)
      facet.edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
    return std::vector<ExactFacet>{facet};
  }

  /// Outlines of the faces in this plane, sections of the bodies it cuts, and outlines of names.
  void build() {
    std::vector<Exact::Segment_2> segments;
    const auto add = [&](const ExactPoint& a, const ExactPoint& b) {
      segments.emplace_back(flattened(a), flattened(b));
    };
    for (const BodyFace& face : plane_.faces) {
      const std::vector<ExactPoint> ring = corners(face);
      for (std::size_t i = 0; i < ring.size(); ++i) add(ring[i], ring[(i + 1) % ring.size()]);
    }
    for (int body = 0; body < static_cast<int>(scene_.bodies.size()); ++body) {
      const std::size_t first = segments.size();
      const Contact contact = contacts_[position(body)];
      if (contact == Contact::kCut || contact == Contact::kTouch)
        add_section(scene_.bodies[position(body)], add);
      if (contact == Contact::kTouch)
        touches_.insert(touches_.end(), segments.begin() + static_cast<std::ptrdiff_t>(first),
                        segments.end());
    }
    add_sheets(segments);
    for (const NamedRectangle* rectangle : named_) {
      const int c = (plane_.axis + 2) % 3;
      Vec3 low_high = rectangle->min, high_low = rectangle->max;
      low_high[c] = rectangle->max[c];
      high_low[c] = rectangle->min[c];
      const std::array<Vec3, 4> ring{rectangle->min, high_low, rectangle->max, low_high};
      for (std::size_t i = 0; i < 4; ++i) add(exact(ring[i]), exact(ring[(i + 1) % 4]));
    }
    CGAL::insert(arrangement_, segments.begin(), segments.end());
  }

  /// Outlines of the sheets in this plane; what others have in common with it stays an edge.
  void add_sheets(std::vector<Exact::Segment_2>& segments) {
    for (std::size_t i = 0; i < scene_.sheets.size(); ++i) {
      const auto& corners = scene_.sheets[i].corners;
      const auto add = [&](const ExactPoint& a, const ExactPoint& b) {
        segments.emplace_back(flattened(a), flattened(b));
        if (sheet_contacts_[i] != Contact::kFace) touches_.push_back(segments.back());
      };
      if (sheet_contacts_[i] == Contact::kFace)
        for (std::size_t k = 0; k < 3; ++k) add(corners[k], corners[(k + 1) % 3]);
      if (sheet_contacts_[i] == Contact::kCut || sheet_contacts_[i] == Contact::kTouch) {
        const std::vector<ExactPoint> ends = section_of(plane_.plane, corners);
        if (ends.size() == 2) add(ends[0], ends[1]);
      }
    }
  }

  /// Where the plane cuts each face of a body there is a segment between two points.
  template <class Add>
  void add_section(const ConvexBody& body, const Add& add) const {
    for (const std::vector<int>& face : body.faces) {
      std::vector<ExactPoint> ring;
      for (const int point : face) ring.push_back(body.points[position(point)]);
      const std::vector<ExactPoint> ends = section_of(plane_.plane, ring);
      if (ends.size() == 2) add(ends[0], ends[1]);
    }
  }

  /// Calls `visit` for each half-edge that has the face on its left.
  template <class Visit>
  static void for_each_edge(ArrangementFace face, const Visit& visit) {
    const auto around = [&](Arrangement::Ccb_halfedge_circulator start) {
      auto edge = start;
      do visit(edge);
      while (++edge != start);
    };
    for (auto ring = face->outer_ccbs_begin(); ring != face->outer_ccbs_end(); ++ring) around(*ring);
    for (auto ring = face->inner_ccbs_begin(); ring != face->inner_ccbs_end(); ++ring) around(*ring);
  }

  /// A point inside a bounded face: half-way from the middle of an edge to what lies opposite.
  static Point2 inside(ArrangementFace face) {
    const auto edge = face->outer_ccb();
    const Point2 middle = CGAL::midpoint(edge->source()->point(), edge->target()->point());
    const Exact::Vector_2 across =
        (edge->target()->point() - edge->source()->point()).perpendicular(CGAL::COUNTERCLOCKWISE);
    std::optional<ExactNumber> nearest;
    const auto meet = [&](const ExactNumber& t) {
      if (t > 0 && (!nearest || t < *nearest)) nearest = t;
    };
    const auto height = [&](const Exact::Vector_2& v) -> ExactNumber { return v * across; };
    const auto offset = [&](const Exact::Vector_2& v) -> ExactNumber {
      return across.x() * v.y() - across.y() * v.x();
    };
    for_each_edge(face, [&](const auto& other) {
      const Exact::Vector_2 p = other->source()->point() - middle, q = other->target()->point() - middle;
      const ExactNumber p_offset = offset(p), q_offset = offset(q);
      if (p_offset == 0) meet(height(p) / across.squared_length());
      if (p_offset * q_offset < 0)
        meet((height(p) * q_offset - height(q) * p_offset) /
             ((q_offset - p_offset) * across.squared_length()));
    });
    return middle + *nearest / 2 * across;
  }

  /// Whether a body touches the plane along an edge: it must stay an edge, also inside a facet.
  bool is_touched(const Arrangement::Halfedge& edge) const {
    const Point2 middle = CGAL::midpoint(edge.source()->point(), edge.target()->point());
    return std::any_of(touches_.begin(), touches_.end(),
                       [&](const Exact::Segment_2& touch) { return touch.has_on(middle); });
  }

  void merge_equal_faces() {
    std::vector<Arrangement::Halfedge_handle> needless;
    for (auto edge = arrangement_.edges_begin(); edge != arrangement_.edges_end(); ++edge)
      if (edge->face()->data() == edge->twin()->face()->data() &&
          (edge->face()->data() < 0 || !is_touched(*edge)))
        needless.push_back(edge);
    for (const Arrangement::Halfedge_handle& edge : needless) arrangement_.remove_edge(edge);
  }

  ExactFacet facet(ArrangementFace face) {
    const FacetKey& key = keys_[position(face->data())];
    ExactFacet result{plane_.plane, plane_.normal, {},       openings(face), lifted(inside(face)),
                      key.below,    key.above,     key.wall, key.sheet};
    const auto add_ring = [&](Arrangement::Ccb_halfedge_circulator start) {
      std::vector<Point2> ring;
      auto edge = start;
      do {
        const Point2& corner = edge->source()->point();
        const bool straight =
            edge->source()->degree() == 2 &&
            CGAL::collinear(edge->prev()->source()->point(), corner, edge->target()->point());
        if (!straight) ring.push_back(corner);
      } while (++edge != start);
      for (std::size_t i = 0; i < ring.size(); ++i)
        result.edges.push_back({lifted(ring[i]), lifted(ring[(i + 1) % ring.size()])});
    };
    for (auto ring = face->outer_ccbs_begin(); ring != face->outer_ccbs_end(); ++ring) add_ring(*ring);
    for (auto ring = face->inner_ccbs_begin(); ring != face->inner_ccbs_end(); ++ring) add_ring(*ring);
    return result;
  }

  /// A point in each neighbour that the facet shuts in.
  std::vector<ExactPoint> openings(ArrangementFace face) {
    std::set<const Arrangement::Face*> open{&*face, &*arrangement_.unbounded_face()};
    std::vector<ArrangementFace> front{arrangement_.unbounded_face()};
    while (!front.empty()) {
      const ArrangementFace next = front.back();
      front.pop_back();
      for_each_edge(next, [&](const auto& edge) {
        const ArrangementFace other = edge->twin()->face();
        if (open.insert(&*other).second) front.push_back(other);
      });
    }
    std::vector<ExactPoint> points;
    for_each_edge(face, [&](const auto& edge) {
      const ArrangementFace other = edge->twin()->face();
      if (open.insert(&*other).second) points.push_back(lifted(inside(other)));
    });
    return points;
  }

  const FacePlane& plane_;
  const BodyScene& scene_;
  WallNames& walls_;
  std::set<int>& used_patches_;
  std::vector<const NamedRectangle*> named_;  ///< in this plane
  std::vector<Contact> contacts_;             ///< [body]
  std::vector<Contact> sheet_contacts_;       ///< [triangle of a sheet]
  std::vector<Exact::Segment_2> touches_;
  std::vector<FacetKey> keys_;
  Arrangement arrangement_;
};

}  // namespace

std::vector<ExactFacet> facets_in_plane(const FacePlane& plane, const BodyScene& scene, WallNames& walls,
                                        std::set<int>& used_patches) {
  return PlaneArrangement(plane, scene, walls, used_patches).facets();
}

}  // namespace etendue
