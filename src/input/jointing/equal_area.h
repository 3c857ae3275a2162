/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Columns that have the area of a slope: its section between the face, the ground behind the crest
 * and a base is cut into strips of one width by joints normal to the bases of the columns, and each
 * column is the rectangle on its step that has the area of its strip. */

#ifndef TP_JOINTING_EQUAL_AREA_H
#define TP_JOINTING_EQUAL_AREA_H

#include "scene/scene.h"

/* Such columns by their heights from the toe on, `count` of them, and the step that their bases
 * rise by. */
typedef struct tp_equal_area {
  fmpq_t width, step;
  fmpq_t rise, fall;  /* of the depth below the surface along x: up to the crest, and behind it */
  fmpq_t crest, back; /* x of the crest, and where the ground behind it meets the base */
} tp_equal_area;

/* `dip_deg`: of the bases. Bad input: the slope has no such section. On failure cleared. */
TP_MUST_USE tp_status tp_equal_area_init(tp_equal_area *area, const tp_columns_description *columns,
                                         const tp_quantity *dip_deg, tp_message *message);
void tp_equal_area_clear(tp_equal_area *area);

/* How many columns there are; and the height of one, counted from 0 at the toe. */
void tp_equal_area_count(fmpz_t count, const tp_equal_area *area);
void tp_equal_area_height(fmpq_t height, const tp_equal_area *area, long column);

#endif
