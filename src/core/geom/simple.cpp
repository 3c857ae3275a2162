/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Simplicity of a ring by CGAL's sweep (Shamos and Hoey), O(n log n). */

#include "geom/rings.hpp"

#include <CGAL/Polygon_2_algorithms.h>

template <class Kernel> static bool is_simple(const tp_geom_rings &rings, size_t ring) {
  const auto all = tp::points<Kernel>(rings, rings.start[ring], rings.start[ring + 1]);
  return CGAL::is_simple_2(all.begin(), all.end(), Kernel());
}

tp_geom_status tp_geom_is_simple(bool *simple, const tp_geom_rings *rings, size_t ring) {
  return tp::guard([&] {
    *simple =
        rings->small ? is_simple<tp::Small>(*rings, ring) : is_simple<tp::Large>(*rings, ring);
    return TP_GEOM_OK;
  });
}
