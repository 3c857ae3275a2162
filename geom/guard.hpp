/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The guard that no exception passes. */

#ifndef TP_GEOM_GUARD_HPP
#define TP_GEOM_GUARD_HPP

#include "geom.h"

#include <new>

#if __has_include(<execinfo.h>)
#include <execinfo.h>
#endif

namespace tp {

/* What is thrown through a std::call_once, as CGAL's lazy numbers use, is unwound by glibc itself,
 * which loads its unwinder at the first need, and ends the process where memory has run out: it is
 * loaded beforehand. */
inline void load_unwinder() {
#if __has_include(<execinfo.h>)
  void *frame = nullptr;
  static const int loaded = backtrace(&frame, 1);
  static_cast<void>(loaded);
#endif
}

/* Run `body`, turning whatever it throws into a status. */
template <class Body> tp_geom_status guard(Body body) {
  load_unwinder();
  try {
    return body();
  } catch (const std::bad_alloc &) {
    return TP_GEOM_OUT_OF_MEMORY;
  } catch (...) {
    return TP_GEOM_FAILED;
  }
}

} // namespace tp

#endif
