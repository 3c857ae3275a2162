/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sections that stand upright in space, as they are drawn in a model or surveyed: lines in one
 * vertical plane.
 *
 * A drawing is read in x and y first, and of points with a z is kept whether that changes. Where it
 * changes along an object that has a role, the drawing is read again, now in the vertical plane
 * through the first point, and the one that is farthest from it on the map, of the object that goes
 * farthest there: from the western one of the two on x runs along the plane, eastwards, or
 * northwards where that is straight, and y is z. With cosine and sine cut off after 256 binary
 * digits (plane/direction.h) that is a linear map in rationals: what meets in space meets in the
 * section. All objects with a role have to lie in that plane, to a 10 000th of its length. */

#ifndef TP_FORMAT_STANDING_H
#define TP_FORMAT_STANDING_H

#include "format/drawing.h"
#include "format/rise.h"
#include "format/text_file.h"

typedef struct tp_standing {
  fmpq_t x, y, far_x, far_y; /* points that the plane goes through */
  fmpq_t cosine, sine;
  double tolerance; /* by which a point may lie beside it */
} tp_standing;

/* One more point of an object, which belongs to the drawing or will: where that stands, in its
 * plane. False when memory is exhausted. */
TP_MUST_USE bool tp_drawing_add_in_space(const tp_drawing *drawing, tp_drawing_object *object,
                                         const fmpq_t x, const fmpq_t y, const fmpq_t z,
                                         tp_mark mark);

/* How the text of a drawing is read. */
typedef tp_status tp_drawing_reader(tp_drawing *drawing, const tp_text_file *file,
                                    const tp_drawing_options *options, tp_message *message);

/* Does an object with a role rise in a drawing that was read? Then it is read again in its plane,
 * and a note says how that runs; bad input where one of them lies elsewhere. */
TP_MUST_USE tp_status tp_standing_read(tp_drawing *drawing, tp_drawing_reader *read,
                                       const tp_text_file *file, const tp_drawing_options *options,
                                       tp_message *message);

#endif
