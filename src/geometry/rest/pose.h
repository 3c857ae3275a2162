/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where a block lies: its own coordinates (x, y) are taken to
 *     (cosine x - sine y + shift x, sine x + cosine y + shift y),
 * all four rational. The root of cosine^2 + sine^2 is 1, or as near to it as TP_POSE_BITS tell:
 * most poses in which a block touches twice have an irrational cosine, and are given in lengths
 * that are out by a share of less than 2^-TP_POSE_BITS, with all contacts exact. */

#ifndef TP_REST_POSE_H
#define TP_REST_POSE_H

#include <flint/fmpq.h>
#include <stdbool.h>

enum { TP_POSE_BITS = 256, TP_POSE_TRUE_BITS = 208 };

typedef struct tp_pose {
  fmpq_t cosine, sine, shift_x, shift_y;
} tp_pose;

/* The block as its coordinates lie. */
void tp_pose_init(tp_pose *pose);
void tp_pose_clear(tp_pose *pose);
void tp_pose_set(tp_pose *pose, const tp_pose *other);

/* From the point (x, y) to the block's own; outputs may be the inputs. */
void tp_pose_undo(fmpq_t own_x, fmpq_t own_y, const tp_pose *pose, const fmpq_t x, const fmpq_t y);

/* The same over one denominator, for points of the block: outputs may be the inputs. */
typedef struct tp_whole_pose {
  fmpz_t cosine, sine, shift_x, shift_y, denominator;
} tp_whole_pose;

void tp_whole_pose_init(tp_whole_pose *whole);
void tp_whole_pose_clear(tp_whole_pose *whole);
void tp_whole_pose_set(tp_whole_pose *whole, const tp_pose *pose);
void tp_whole_pose_apply(fmpq_t x, fmpq_t y, const tp_whole_pose *whole, const fmpq_t own_x,
                         const fmpq_t own_y);

/* Turn and stretch the vector (x, y), without the shift. */
void tp_pose_turn_vector(fmpq_t x, fmpq_t y, const tp_pose *pose);

/* Shift so that the block's own point lies in (x, y). */
void tp_pose_pin(tp_pose *pose, const fmpq_t own_x, const fmpq_t own_y, const fmpq_t x,
                 const fmpq_t y);

/* Turn by the direction (u, v), other than zero: its root is exact, or cut off. */
void tp_pose_turn_along(tp_pose *pose, const fmpq_t u, const fmpq_t v);

/* Turn by twice the angle whose tangent is t. */
void tp_pose_turn_half(tp_pose *pose, const fmpq_t t);

/* Make the block's lengths `factor` times as long: towards the truth of a pose that is cut off. */
void tp_pose_scale(tp_pose *pose, const fmpq_t factor);

/* Is the root as near to 1 as TP_POSE_TRUE_BITS tell: more than 60 decimals? */
bool tp_pose_is_true(const tp_pose *pose);

/* Take cosine and sine of many digits to ones of TP_POSE_BITS and a unit root. */
void tp_pose_shorten(tp_pose *pose);

#endif
