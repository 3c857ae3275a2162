/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Points of the C interface as points of a CGAL kernel: small integers as doubles, larger ones as
 * exact numbers. */

#ifndef TP_GEOM_RINGS_HPP
#define TP_GEOM_RINGS_HPP

#include "geom/geom.h"
#include "geom/guard.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

#if __has_include(<execinfo.h>)
#include <execinfo.h>
#endif

namespace tp {

/* Integers of at most 53 bits are doubles: filtered predicates decide them exactly. */
using Small = CGAL::Exact_predicates_inexact_constructions_kernel;
/* Larger ones go as exact numbers with an interval in front. */
using Large = CGAL::Exact_predicates_exact_constructions_kernel;

/* What is thrown through a std::call_once, as CGAL's lazy numbers use, is unwound by glibc itself,
 * which loads its unwinder at the first need, and ends the process where memory has run out: it is
 * loaded beforehand, by who makes such numbers. */
inline void load_unwinder() {
#if __has_include(<execinfo.h>)
  void *frame = nullptr;
  static const int loaded = backtrace(&frame, 1);
  static_cast<void>(loaded);
#endif
}

inline Large::FT exact_integer(const fmpz *value) {
  load_unwinder();
  CGAL::Gmpz integer;
  fmpz_get_mpz(integer.mpz(), value);
  return Large::FT(Large::Exact_kernel::FT(CGAL::Gmpq(integer).mpq()));
}

template <class Kernel> typename Kernel::Point_2 point(const tp_geom_rings &rings, size_t k);

template <> inline Small::Point_2 point<Small>(const tp_geom_rings &rings, size_t k) {
  return Small::Point_2(rings.u[k], rings.v[k]);
}

template <> inline Large::Point_2 point<Large>(const tp_geom_rings &rings, size_t k) {
  return Large::Point_2(exact_integer(rings.x + k), exact_integer(rings.y + k));
}

template <class Kernel>
std::vector<typename Kernel::Point_2> points(const tp_geom_rings &rings, size_t from, size_t to) {
  std::vector<typename Kernel::Point_2> result;
  result.reserve(to - from);
  for (size_t k = from; k < to; k++) result.push_back(point<Kernel>(rings, k));
  return result;
}

inline size_t vertex_count(const tp_geom_rings &rings) {
  return rings.start[rings.count];
}

} // namespace tp

#endif
