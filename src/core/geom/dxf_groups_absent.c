/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* In place of dxf_groups.cpp, where Topple is built without dxflib. */

#include "geom/dxf_groups.h"

bool tp_dxf_is_there(void) {
  return false;
}

tp_geom_status tp_dxf_visit(const tp_dxf_group *groups, size_t count, tp_dxf_visitor visitor,
                            void *context) {
  (void)groups;
  (void)count;
  (void)visitor;
  (void)context;
  return TP_GEOM_FAILED;
}
