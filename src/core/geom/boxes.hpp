/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Boxes in doubles about edges or triangles, for CGAL's search of those that meet. */

#ifndef TP_GEOM_BOXES_HPP
#define TP_GEOM_BOXES_HPP

#include <CGAL/box_intersection_d.h>

#include <cstddef>

namespace tp {

template <int Axes> struct Box {
  double low[Axes], high[Axes];
  size_t number; /* of what it is about */
};

template <int Axes> struct BoxTraits {
  using NT = double;
  using Box_parameter = const Box<Axes> &;
  using ID = size_t;
  static int dimension() {
    return Axes;
  }
  static double min_coord(const Box<Axes> &box, int axis) {
    return box.low[axis];
  }
  static double max_coord(const Box<Axes> &box, int axis) {
    return box.high[axis];
  }
  static size_t id(const Box<Axes> &box) {
    return box.number;
  }
};

} // namespace tp

#endif
