/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Constrained Delaunay triangulation of rings, and which ring of each layer a triangle lies in.
 *
 * Starting outside, a walk over the faces enters or leaves a ring at each constrained edge that
 * belongs to it. One ring needs the plain triangulation only; several may share edges, so CGAL's
 * hierarchy is asked which rings an edge belongs to. */

#include "geom/rings.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <deque>
#include <map>
#include <memory>
#include <numeric>

namespace {

using Rings = std::array<int, TP_GEOM_LAYERS>;

struct FaceInfo {
  bool seen = false;
  size_t index = TP_GEOM_NONE; /* among the triangles that are handed out */
  Rings ring_in_layer{};
};

template <class Kernel> struct Types {
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<size_t, Kernel>;
  using Face = CGAL::Constrained_triangulation_face_base_2<
      Kernel, CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel>>;
  using Structure = CGAL::Triangulation_data_structure_2<Vertex, Face>;
  using Plain = CGAL::Constrained_Delaunay_triangulation_2<
      Kernel, Structure, CGAL::No_constraint_intersection_requiring_constructions_tag>;
  using Hierarchy =
      CGAL::Constrained_triangulation_plus_2<CGAL::Constrained_Delaunay_triangulation_2<
          Kernel, Structure, CGAL::No_constraint_intersection_requiring_constructions_tag>>;
};

/* Points one after another are found faster along a rough profile, spatially sorted ones on a
 * closed blob: a ring nearly all of whose edges run one way is a profile. */
template <class Points> bool is_profile(const Points &points) {
  size_t right = 0;
  for (size_t k = 0; k + 1 < points.size(); k++) right += points[k].x() < points[k + 1].x();
  return 10 * right > 9 * points.size() || 10 * right < points.size();
}

/* The order of insertion. */
template <class Kernel>
std::vector<size_t> insertion_order(const std::vector<typename Kernel::Point_2> &points) {
  std::vector<size_t> order(points.size());
  std::iota(order.begin(), order.end(), size_t{0});
  if (!is_profile(points)) {
    const auto map = CGAL::make_property_map(points);
    CGAL::spatial_sort(order.begin(), order.end(),
                       CGAL::Spatial_sort_traits_adapter_2<Kernel, decltype(map)>(map));
  }
  return order;
}

/* Insert the points; the vertex of each. Equal points share a vertex. */
template <class Kernel, class Triangulation>
auto insert(Triangulation &t, const tp_geom_rings &rings) {
  const auto points = tp::points<Kernel>(rings, 0, tp::vertex_count(rings));
  std::vector<typename Triangulation::Vertex_handle> vertex(points.size());
  typename Triangulation::Face_handle hint;
  for (const size_t k : insertion_order<Kernel>(points)) {
    vertex[k] = t.insert(points[k], hint);
    vertex[k]->info() = k;
    hint = vertex[k]->face();
  }
  return vertex;
}

template <class Triangulation> class Walk {
public:
  using Face_handle = typename Triangulation::Face_handle;

  Walk(Triangulation &t, const int *layer_of_ring) : t_(t), layer_(layer_of_ring) {
  }

  /* `cross(face, side, rings, conflict)` updates the rings when the walk leaves `face` by `side`.
   */
  template <class Cross> bool run(Cross cross, size_t conflict[2]) {
    std::deque<Face_handle> queue;
    t_.infinite_face()->info().seen = true;
    queue.push_back(t_.infinite_face());
    while (!queue.empty()) {
      const Face_handle face = queue.front();
      queue.pop_front();
      for (int side = 0; side < 3; side++) {
        const Face_handle neighbour = face->neighbor(side);
        if (neighbour->info().seen) continue;
        Rings rings = face->info().ring_in_layer;
        if (face->is_constrained(side) && !cross(face, side, rings, conflict)) return false;
        neighbour->info().seen = true;
        neighbour->info().ring_in_layer = rings;
        queue.push_back(neighbour);
      }
    }
    return true;
  }

  bool inside(const Rings &rings, size_t ring) const {
    return rings[static_cast<size_t>(layer_[ring])] == static_cast<int>(ring) + 1;
  }

  /* Enter the ring, or leave it; false where another ring of its layer is already entered. */
  bool toggle(Rings &rings, size_t ring, size_t conflict[2]) const {
    int &current = rings[static_cast<size_t>(layer_[ring])];
    if (inside(rings, ring)) {
      current = 0;
    } else if (current == 0) {
      current = static_cast<int>(ring) + 1;
    } else {
      conflict[0] = static_cast<size_t>(current) - 1;
      conflict[1] = ring;
      return false;
    }
    return true;
  }

private:
  Triangulation &t_;
  const int *layer_;
};

template <class Triangulation>
tp_geom_status collect(Triangulation &t, tp_geom_triangulation *result) {
  size_t count = 0;
  for (auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f) {
    if (f->info().ring_in_layer != Rings{}) f->info().index = count++;
  }
  auto *triangles = static_cast<tp_geom_triangle *>(calloc(count + 1, sizeof *result->triangles));
  if (triangles == nullptr) return TP_GEOM_OUT_OF_MEMORY;
  for (auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f) {
    const size_t k = f->info().index;
    if (k == TP_GEOM_NONE) continue;
    for (int c = 0; c < 3; c++) triangles[k].corner[c] = f->vertex(c)->info();
    for (int l = 0; l < TP_GEOM_LAYERS; l++) {
      triangles[k].ring_in_layer[l] = f->info().ring_in_layer[static_cast<size_t>(l)];
    }
  }
  result->count = count;
  result->triangles = triangles;
  return TP_GEOM_OK;
}

/* Which of the collected triangles share their sides. */
template <class Triangulation>
tp_geom_status collect_neighbours(Triangulation &t, tp_geom_triangulation *result) {
  result->across = static_cast<size_t *>(calloc(3 * result->count + 1, sizeof *result->across));
  if (result->across == nullptr) {
    tp_geom_triangulation_clear(result);
    return TP_GEOM_OUT_OF_MEMORY;
  }
  for (auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f) {
    const size_t k = f->info().index;
    if (k == TP_GEOM_NONE) continue;
    for (int c = 0; c < 3; c++) {
      result->across[3 * k + static_cast<size_t>(c)] = f->neighbor(c)->info().index;
    }
  }
  return TP_GEOM_OK;
}

template <class Kernel>
tp_geom_status triangulate_one(tp_geom_triangulation *result, const tp_geom_rings &rings,
                               const int *layer) {
  using Triangulation = typename Types<Kernel>::Plain;
  Triangulation t;
  const auto vertex = insert<Kernel>(t, rings);
  for (size_t k = 0; k < vertex.size(); k++) {
    t.insert_constraint(vertex[k], vertex[(k + 1) % vertex.size()]);
  }
  Walk<Triangulation> walk(t, layer);
  size_t conflict[2] = {0, 0};
  if (t.dimension() < 2) return TP_GEOM_FAILED;
  walk.run([&](auto, int, Rings &in, size_t *c) { return walk.toggle(in, 0, c); }, conflict);
  return collect(t, result);
}

template <class Kernel>
tp_geom_status walk_several(tp_geom_triangulation *result, const tp_geom_rings &rings,
                            const int *layer, typename Types<Kernel>::Hierarchy &t) {
  using Triangulation = typename Types<Kernel>::Hierarchy;
  std::map<typename Triangulation::Constraint_id, size_t> ring_of;
  const auto vertex = insert<Kernel>(t, rings);
  for (size_t r = 0; r < rings.count; r++) {
    if (layer[r] < 0) continue;
    for (size_t k = rings.start[r]; k < rings.start[r + 1]; k++) {
      const size_t next = k + 1 == rings.start[r + 1] ? rings.start[r] : k + 1;
      ring_of[t.insert_constraint(vertex[k], vertex[next])] = r;
    }
  }
  Walk<Triangulation> walk(t, layer);
  const auto cross = [&](auto face, int side, Rings &in, size_t *conflict) {
    std::vector<size_t> entered; /* after all that are left: rings of a layer may share the edge */
    const auto a = face->vertex(t.cw(side)), b = face->vertex(t.ccw(side));
    for (auto c = t.contexts_begin(a, b); c != t.contexts_end(a, b); ++c) {
      const size_t ring = ring_of.at(c->id());
      if (walk.inside(in, ring)) {
        walk.toggle(in, ring, conflict);
      } else {
        entered.push_back(ring);
      }
    }
    return std::all_of(entered.begin(), entered.end(),
                       [&](size_t ring) { return walk.toggle(in, ring, conflict); });
  };
  if (t.dimension() < 2) return TP_GEOM_FAILED;
  result->conflict = false;
  size_t conflict[2] = {0, 0};
  if (!walk.run(cross, conflict)) {
    result->conflict = true;
    result->conflict_a = conflict[0];
    result->conflict_b = conflict[1];
    return TP_GEOM_OK;
  }
  const tp_geom_status status = collect(t, result);
  return status == TP_GEOM_OK ? collect_neighbours(t, result) : status;
}

/* Where memory runs out while CGAL adds a constraint its hierarchy is left such that taking it down
 * crashes (5.5): it is abandoned then. */
template <class Kernel>
tp_geom_status triangulate_several(tp_geom_triangulation *result, const tp_geom_rings &rings,
                                   const int *layer) {
  auto t = std::make_unique<typename Types<Kernel>::Hierarchy>();
  try {
    return walk_several<Kernel>(result, rings, layer, *t);
  } catch (const std::bad_alloc &) {
    static_cast<void>(t.release());
    throw;
  }
}

} // namespace

tp_geom_status tp_geom_triangulate(tp_geom_triangulation *result, const tp_geom_rings *rings,
                                   const int *layer_of_ring) {
  *result = {};
  if (tp::vertex_count(*rings) < 3) return TP_GEOM_FAILED;
  return tp::guard([&] {
    if (rings->count == 1) {
      return rings->small ? triangulate_one<tp::Small>(result, *rings, layer_of_ring)
                          : triangulate_one<tp::Large>(result, *rings, layer_of_ring);
    }
    return rings->small ? triangulate_several<tp::Small>(result, *rings, layer_of_ring)
                        : triangulate_several<tp::Large>(result, *rings, layer_of_ring);
  });
}

void tp_geom_triangulation_clear(tp_geom_triangulation *result) {
  free(result->triangles);
  free(result->across);
  *result = {};
}
