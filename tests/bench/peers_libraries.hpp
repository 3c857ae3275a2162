// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

// Area and centroid by the other libraries, each from its own container.

#ifndef TP_PEERS_LIBRARIES_HPP
#define TP_PEERS_LIBRARIES_HPP

#include "peers.hpp"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>

#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Simple_cartesian.h>

#ifdef HAVE_GEOS
#include <geos_c.h>
#endif

#include <memory>

namespace peers {

inline Method boost_method(const Polygon &p) {
  using Point = boost::geometry::model::d2::point_xy<double>;
  boost::geometry::model::ring<Point, false, false> ring; // counter-clockwise, not closed by hand
  for (size_t k = 0; k < p.u.size(); k++) ring.push_back(Point(p.u[k], p.v[k]));
  return [ring] {
    Point centroid(0, 0);
    boost::geometry::centroid(ring, centroid);
    return Answer{boost::geometry::area(ring), centroid.x(), centroid.y()};
  };
}

template <class Number> Method cgal_method(const Polygon &p) {
  using Kernel = CGAL::Simple_cartesian<Number>;
  CGAL::Polygon_2<Kernel> polygon;
  for (size_t k = 0; k < p.u.size(); k++) {
    polygon.push_back(typename Kernel::Point_2(Number(p.u[k]), Number(p.v[k])));
  }
  return [polygon] { return Answer{CGAL::to_double(polygon.area()), NONE, NONE}; };
}

#ifdef HAVE_GEOS
inline Method geos_method(const Polygon &p) {
  const std::shared_ptr<GEOSContextHandle_HS> geos(GEOS_init_r(), GEOS_finish_r);
  const GEOSContextHandle_t handle = geos.get();
  const size_t count = p.u.size();
  GEOSCoordSequence *points = GEOSCoordSeq_create_r(handle, unsigned(count + 1), 2);
  for (size_t k = 0; k <= count; k++) {
    GEOSCoordSeq_setXY_r(handle, points, unsigned(k), p.u[k % count], p.v[k % count]);
  }
  GEOSGeometry *ring = GEOSGeom_createLinearRing_r(handle, points);
  const std::shared_ptr<GEOSGeometry> polygon(
      GEOSGeom_createPolygon_r(handle, ring, nullptr, 0),
      [geos](GEOSGeometry *g) { GEOSGeom_destroy_r(geos.get(), g); });
  return [geos, polygon] {
    Answer answer = {NONE, NONE, NONE};
    GEOSArea_r(geos.get(), polygon.get(), &answer.area);
    GEOSGeometry *centroid = GEOSGetCentroid_r(geos.get(), polygon.get());
    GEOSGeomGetX_r(geos.get(), centroid, &answer.x);
    GEOSGeomGetY_r(geos.get(), centroid, &answer.y);
    GEOSGeom_destroy_r(geos.get(), centroid);
    return answer;
  };
}
#endif

} // namespace peers

#endif
