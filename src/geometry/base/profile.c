/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Base of a scene: the profile as given, or the underside of the mated part, continued past the
 * contact along the teeth or level as far as the scene says, and closed below as a ring. */

#include "base/profile.h"

#include "base/underside.h"
#include "block/outline.h"
#include "number/ratio.h"

#include <string.h>

/* To either side of the block: 80 MB of exact points of short numbers. */
enum { MOST_TEETH_BEYOND = 1000000 };

void tp_base_clear(tp_base *base) {
  tp_polyline_clear(&base->ring);
  memset(base, 0, sizeof *base);
}

void tp_base_drop_points(tp_base *base) {
  tp_polyline_clear(&base->ring);
}

/* Even ground from `from` by `beyond` to the left (-1) or the right (1): along x, or in the
 * direction of the mean plane where the coordinates are not along it. */
static bool add_even(tp_base *base, const tp_base_description *of, const tp_polyline *outline,
                     long from, const fmpq_t beyond, int side) {
  if (fmpq_is_zero(beyond)) return true;
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  fmpq_set(x, beyond);
  if (of->beyond_cosine != NULL) {
    fmpq_mul(x, beyond, of->beyond_cosine);
    fmpq_mul(y, beyond, of->beyond_sine);
  }
  if (side < 0) {
    fmpq_neg(x, x);
    fmpq_neg(y, y);
  }
  fmpq_add(x, x, outline->x + from);
  fmpq_add(y, y, outline->y + from);
  const bool done = tp_polyline_append(&base->ring, x, y, base->ring.mark);
  fmpq_clear(x);
  fmpq_clear(y);
  return done;
}

/* Whole teeth that fit into `beyond`, and whether a piece of one is left over. */
static long whole_teeth(const fmpq_t beyond, const tp_teeth *teeth, bool *piece) {
  fmpq_t ratio;
  fmpz_t whole;
  fmpq_init(ratio);
  fmpz_init(whole);
  fmpq_div(ratio, beyond, teeth->width);
  fmpz_fdiv_q(whole, fmpq_numref(ratio), fmpq_denref(ratio));
  *piece = !fmpz_is_one(fmpq_denref(ratio));
  const long count = fmpz_cmp_si(whole, MOST_TEETH_BEYOND) > 0 ? -1 : fmpz_get_si(whole);
  fmpz_clear(whole);
  fmpq_clear(ratio);
  return count;
}

/* A joint of the endless row of teeth. */
static bool add_joint(tp_base *base, const tp_teeth *teeth, long joint, const fmpq_t abscissa) {
  fmpq_t y;
  fmpq_init(y);
  tp_outline_joint_height(y, teeth, joint);
  const bool done = tp_polyline_append(&base->ring, abscissa, y, base->ring.mark);
  fmpq_clear(y);
  return done;
}

/* Where the base ends on a flank: between the joints `inner` and `outer`. */
static bool add_piece(tp_base *base, const tp_teeth *teeth, long inner, long outer,
                      const fmpq_t left_over, const fmpq_t abscissa) {
  fmpq_t y, far;
  fmpq_init(y);
  fmpq_init(far);
  tp_outline_joint_height(y, teeth, inner);
  tp_outline_joint_height(far, teeth, outer);
  fmpq_sub(far, far, y);
  fmpq_mul(far, far, left_over);
  fmpq_div(far, far, teeth->width);
  fmpq_add(y, y, far);
  const bool done = tp_polyline_append(&base->ring, abscissa, y, base->ring.mark);
  fmpq_clear(y);
  fmpq_clear(far);
  return done;
}

/* The teeth go on by `beyond`: whole ones, then perhaps a piece of one. Points from left to right.
 */
static bool add_teeth(tp_base *base, const tp_teeth *teeth, long count, bool piece,
                      const fmpq_t beyond, int side) {
  fmpq_t x, left_over;
  fmpz_t joint;
  fmpq_init(x);
  fmpq_init(left_over);
  fmpz_init_set_si(joint, count);
  fmpq_mul_fmpz(left_over, teeth->width, joint);
  fmpq_sub(left_over, beyond, left_over);
  bool done = true;
  for (long step = side < 0 ? count + 1 : 1; step >= 1 && step <= count + 1 && done; step += side) {
    const long inner = side < 0 ? -(step - 1) : teeth->count + step - 1;
    const long outer = inner + side;
    if (step <= count) {
      fmpz_set_si(joint, outer);
      fmpq_mul_fmpz(x, teeth->width, joint);
      done = add_joint(base, teeth, outer, x);
    } else if (piece) {
      fmpz_set_si(joint, side < 0 ? 0 : teeth->count);
      fmpq_mul_fmpz(x, teeth->width, joint);
      if (side < 0) {
        fmpq_sub(x, x, beyond);
      } else {
        fmpq_add(x, x, beyond);
      }
      done = add_piece(base, teeth, inner, outer, left_over, x);
    }
  }
  fmpz_clear(joint);
  fmpq_clear(x);
  fmpq_clear(left_over);
  return done;
}

static tp_status add_beyond(tp_base *base, const tp_scene *scene, const tp_polyline *outline,
                            long from, int side, tp_message *message) {
  const tp_quantity *beyond = side < 0 ? &scene->base.beyond_left : &scene->base.beyond_right;
  bool done = true;
  if (scene->block.form == TP_OUTLINE_TEETH && base->mated) {
    bool piece = false;
    const long count = whole_teeth(beyond->value, &scene->block.teeth, &piece);
    if (count < 0) {
      return tp_refuse(message, TP_FAULT_GEOMETRY, beyond->place,
                       "the base extends for more than a million teeth");
    }
    done = add_teeth(base, &scene->block.teeth, count, piece, beyond->value, side);
  } else {
    done = add_even(base, &scene->base, outline, from, beyond->value, side);
  }
  return done ? TP_OK : tp_fail_memory(message, "the base");
}

/* Does the rest of the block stay clear of a base that goes on level past this end? Where its side
 * begins it rises by more than it runs from there. */
static bool stays_clear(tp_contact_end end) {
  return end == TP_END_WHOLE || end == TP_END_STEEP;
}

static tp_status set_mated(tp_base *base, const tp_scene *scene, const tp_section *section,
                           tp_message *message) {
  const tp_polyline *outline = section->rings;
  tp_underside underside;
  tp_status status = tp_underside_find(&underside, scene, section, message);
  if (status != TP_OK) return status;
  const long first = underside.first, last = underside.last;
  base->left = underside.left;
  base->right = underside.right;
  base->none = underside.none;
  base->mated = !underside.stated && stays_clear(underside.left) && stays_clear(underside.right);
  base->outline_first = first;
  base->mated_count = (last - first + outline->count) % outline->count;
  status = add_beyond(base, scene, outline, first, -1, message);
  if (status != TP_OK) return status;
  base->mated_first = base->ring.count;
  if (!tp_polyline_reserve(&base->ring, base->ring.count + base->mated_count + 4)) {
    return tp_fail_memory(message, "the base");
  }
  for (long k = 0; k <= base->mated_count; k++) {
    const long vertex = (first + k) % outline->count;
    if (!tp_polyline_append(&base->ring, outline->x + vertex, outline->y + vertex,
                            outline->marks[vertex])) {
      return tp_fail_memory(message, "the base");
    }
  }
  return add_beyond(base, scene, outline, last, 1, message);
}

/* Rock ends in an upright face below the profile's last point: no step may stand in its way. */
static tp_status check_end(const tp_polyline *profile, bool left, tp_message *message) {
  const long end = left ? 0 : profile->count - 1;
  for (long k = end; fmpq_equal(profile->x + k, profile->x + end); k += left ? 1 : -1) {
    if (fmpq_cmp(profile->y + k, profile->y + end) >= 0) continue;
    return tp_refuse(message, TP_FAULT_GEOMETRY, tp_polyline_place(profile, end),
                     "the base profile %s with an upright step up to its %s point: rock without "
                     "thickness; let it go on past the step, or leave the step out",
                     left ? "begins" : "ends", left ? "first" : "last");
  }
  return TP_OK;
}

static tp_status set_profile(tp_base *base, const tp_polyline *profile, tp_message *message) {
  if (profile->count < 2) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, tp_polyline_place(profile, -1),
                     "a base profile needs at least two points");
  }
  for (long k = 1; k < profile->count; k++) {
    if (fmpq_cmp(profile->x + k, profile->x + k - 1) < 0) {
      return tp_refuse(message, TP_FAULT_GEOMETRY, tp_polyline_place(profile, k),
                       "a base profile runs from left to right: point %ld lies left of point %ld",
                       k + 1, k);
    }
  }
  if (fmpq_equal(profile->x, profile->x + profile->count - 1)) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, tp_polyline_place(profile, -1),
                     "the base profile has no width: all its points lie on one upright line");
  }
  for (int side = 0; side < 2; side++) {
    const tp_status status = check_end(profile, side == 0, message);
    if (status != TP_OK) return status;
  }
  base->left = base->right = TP_END_PROFILE;
  tp_polyline_clear(&base->ring);
  return tp_polyline_copy(&base->ring, profile) ? TP_OK : tp_fail_memory(message, "the base");
}

/* Two corners so far below that no block reaches them: the rock under the profile as a ring. */
static bool close_below(tp_base *base, const tp_polyline *outline) {
  const fmpq *low = outline->y, *high = outline->y;
  for (long k = 1; k < outline->count; k++) {
    if (fmpq_cmp(outline->y + k, low) < 0) low = outline->y + k;
    if (fmpq_cmp(outline->y + k, high) > 0) high = outline->y + k;
  }
  fmpq_t y, x_left, x_right;
  fmpq_init(y);
  fmpq_init(x_left);
  fmpq_init(x_right);
  fmpq_set(y, low);
  for (long k = 0; k < base->ring.count; k++) {
    if (fmpq_cmp(base->ring.y + k, y) < 0) fmpq_set(y, base->ring.y + k);
  }
  fmpq_sub(y, y, high);
  fmpq_add(y, y, low);
  fmpq_set(x_left, base->ring.x); /* copies: appending may move the arrays */
  fmpq_set(x_right, base->ring.x + base->ring.count - 1);
  const bool done = tp_polyline_append(&base->ring, x_right, y, base->ring.mark) &&
                    tp_polyline_append(&base->ring, x_left, y, base->ring.mark);
  fmpq_clear(y);
  fmpq_clear(x_left);
  fmpq_clear(x_right);
  return done;
}

tp_status tp_base_init(tp_base *base, const tp_scene *scene, const tp_section *section,
                       tp_message *message) {
  memset(base, 0, sizeof *base);
  base->unit = scene->length_unit;
  const tp_place place = scene->base.place.file != NULL ? scene->base.place : scene->block.place;
  base->ring.file = place.file;
  base->ring.mark = (tp_mark){place.line, place.column};
  tp_status status = scene->base.mated ? set_mated(base, scene, section, message)
                                       : set_profile(base, &scene->base.profile, message);
  if (status == TP_OK) {
    base->edge_count = base->ring.count - 1;
    if (!close_below(base, section->rings)) status = tp_fail_memory(message, "the base");
  }
  if (status != TP_OK) tp_base_clear(base);
  return status;
}
