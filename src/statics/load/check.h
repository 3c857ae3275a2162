/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Are the loads on the block? In exact rationals: a point lies in the outline by the crossings of a
 * ray from it, a line on it where both its ends lie on one edge. */

#ifndef TP_LOAD_CHECK_H
#define TP_LOAD_CHECK_H

#include "block/section.h"
#include "load/outline.h"

/* Refuse anchors outside the block, and pressures and surcharges on lines that are no part of its
 * outline. */
TP_MUST_USE tp_status tp_loads_check(const tp_scene *scene, const tp_section *section,
                                     tp_message *message);

/* Refuse lines that are no part of the outline; and those that would pull, where they push. `what`
 * they are called. */
TP_MUST_USE tp_status tp_load_lines_check(const tp_line_load *lines, long count,
                                          const tp_polyline *outline, const char *what, bool push,
                                          tp_message *message);

/* Refuse water that stands above the block's top, normal to the mean plane. The heel is the up-dip
 * end of the base joint, in scene lengths; the block goes `towards` a side. */
TP_MUST_USE tp_status tp_loads_check_water(const tp_scene *scene, const tp_section *section,
                                           const fmpq_t heel_x, const fmpq_t heel_y,
                                           const char *towards, tp_message *message);

#endif
