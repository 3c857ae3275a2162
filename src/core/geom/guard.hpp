/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calls a function and turns every C++ exception into a status, so that none passes the C
 * interface. */

#ifndef TP_GEOM_GUARD_HPP
#define TP_GEOM_GUARD_HPP

#include "geom/geom.h"

#include <new>

namespace tp {

/* Run `body`, turning whatever it throws into a status. */
template <class Body> tp_geom_status guard(Body body) {
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
