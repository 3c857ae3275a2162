/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where the contact of a mated base begins and ends on the outline.
 *
 * All of the underside is the lower chain of the outline, from its leftmost to its rightmost vertex
 * (the lowest of each). That takes in the wall of a block that leans out, and half the surface of a
 * boulder. Unless the scene says otherwise the contact is a part of it:
 *
 * - it ends to the right in the vertex with the largest x - y, and to the left in the one with the
 *   smallest x + y (of several the outermost): from there on the underside rises to each of its
 *   points by more than it runs, that is at more than 45 degrees from the mean plane. What is
 * nearer upright than level is a wall of the block and no part of its sole
 * (static_limit/limit_beyond.c draws the same line), and the comparison is exact, whatever the
 * scale, and in a mirror image. Steps and steep flanks on the way stay: the support of a line at 45
 * degrees passes over them.
 * - between the lowest vertex and that end it ends before the first edge that runs back: beyond it
 *   the block overhangs its own support. Where the block reaches in below, it ends in the last
 *   corner before that, so that the upright face in which its rock ends cuts nothing. */

#ifndef TP_BASE_UNDERSIDE_H
#define TP_BASE_UNDERSIDE_H

#include "block/section.h"
#include "topple.h"

typedef struct tp_underside {
  long first, last; /* vertices of the outline, counter-clockwise from the first to the last */
  tp_contact_end left, right;
  bool stated;      /* by 'between' */
  const char *none; /* NULL, or why the default finds no contact: to be refused, once it is checked
                       that it is a block at all */
} tp_underside;

/* The refusal of an underside on which the default finds none. */
tp_status tp_underside_fail(const char *none, const tp_scene *scene, tp_message *message);

/* Fails where the scene's `between` names no part of the outline. */
TP_MUST_USE tp_status tp_underside_find(tp_underside *underside, const tp_scene *scene,
                                        const tp_section *section, tp_message *message);

#endif
