/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Blocks in another order, seen from the other side, move as they do.
 *
 * Searches for motions see blocks from the ground on, along the drive, whatever order they were
 * listed in. Were a sign wrong there, an end the other one, or a moment about another point, they
 * would prove of other blocks that these stand. So random accelerations of random piles are told
 * both as given and as arranged: every end of every contact must part by as much, every slip be
 * the same, its sign by the modes it is told by; forces must do the same work, loads too, and
 * inertia take as much. The mirror image of a pile, of which the blocks are listed backwards, must
 * be arranged alike, number by number. */

#include "block_pile.h"
#include "contact_modes/arranged.h"
#include "contact_modes/corner_modes.h"
#include "random_numbers.h"
#include "suite.h"

#include <math.h>
#include <stdlib.h>

enum { BOXES = 5, COLUMNS = 6 };
static const double little = 1e-12;

typedef struct box {
  long left, low, right, high;
} box;

typedef struct scene {
  block_pile pile;
  tp_contact_strength *strengths;
  tp_resting resting;
  tp_arranged arranged;
} scene;

/* On a grid of three courses: so corners of some meet. */
static long draw_boxes(box *boxes, random_numbers *r) {
  long count = 0;
  for (long low = 0; low < 3; low++) {
    long at = draw_below(r, 2);
    while (at < COLUMNS && count < BOXES) {
      const long width = 1 + draw_below(r, 3);
      if (low == 0 || draw_below(r, 3) > 0) boxes[count++] = (box){at, low, at + width, low + 1};
      at += width;
    }
  }
  return count;
}

static bool touches_below(const box *boxes, long count, long k) {
  bool touches = boxes[k].low == 0;
  for (long other = 0; other < count; other++) {
    touches = touches || (boxes[other].high == boxes[k].low && boxes[other].left < boxes[k].right &&
                          boxes[k].left < boxes[other].right);
  }
  return touches;
}

/* As drawn, going to the left; or its mirror image, listed backwards. */
static void build(scene *s, const box *boxes, long count, bool is_image) {
  tp_message message = {.text = ""};
  *s = (scene){.pile = {.count = 0}};
  for (long n = -1; n < count; n++) {
    const long k = is_image ? count - 2 - n : n;
    const box own = k < 0 ? (box){-50, -1, 50, 0} : boxes[k];
    if (is_image)
      pile_add_box(&s->pile, -own.right, own.low, -own.left, own.high, 3, k < 0);
    else
      pile_add_box(&s->pile, own.left, own.low, own.right, own.high, 3, k < 0);
  }
  pile_build(&s->pile);
  const tp_assemblage *a = &s->pile.assemblage;
  s->strengths = calloc((size_t)a->contact_count + 1, sizeof *s->strengths);
  ck_assert_int_eq(tp_resting_init(&s->resting, a, s->strengths, &message), TP_OK);
  ck_assert_int_eq(tp_arranged_init(&s->arranged, &s->resting, !is_image, &message), TP_OK);
}

static void clear(scene *s) {
  tp_arranged_clear(&s->arranged);
  tp_resting_clear(&s->resting);
  free(s->strengths);
  pile_clear(&s->pile);
}

/* ---- one pile as given and as arranged ---------------------------------------------------------
 */

/* Of blocks' own points; of their centroids. */
static void draw_accelerations(double *given, double *own, const tp_arranged *a,
                               random_numbers *r) {
  const double sign = a->mirrored ? -1 : 1;
  for (long row = 0; row < a->resting.rows; row++) given[row] = draw_part(r) - 0.5;
  for (long b = 0; b < a->resting.rows / 3; b++) {
    const double *of = given + 3 * a->number[b];
    const tp_rigid_block *block = a->given->assemblage->blocks + a->resting.block[b];
    own[3 * b] = sign * (of[0] - of[2] * block->arm_y.value);
    own[3 * b + 1] = of[1] + of[2] * block->arm_x.value;
    own[3 * b + 2] = sign * of[2];
  }
}

static void check_near(double own, double known) {
  ck_assert_msg(fabs(own - known) < little * (1 + fabs(known)), "%g, not %g", own, known);
}

/* What it does of contact `k`, by one mode: the ends that part; the slip. */
static tp_mode_set mode_of(double first, double second, double slip) {
  const tp_mode_slip way = slip > 0 ? TP_MODE_FORWARD : TP_MODE_BACK;
  return first > 0 && second > 0 ? TP_MODES_OPEN : tp_mode_of(first <= 0, second <= 0, way);
}

static void check_contacts(const tp_arranged *a, const double *given, const double *own) {
  const tp_resting *r = &a->resting;
  tp_mode_set *modes = calloc((size_t)r->contact_count + 1, sizeof *modes);
  tp_mode_set *back = calloc((size_t)r->contact_count + 1, sizeof *back);
  for (long k = 0; k < r->contact_count; k++) {
    const tp_resting_contact *c = r->contacts + k, *of = a->given->contacts + a->contact[k];
    ck_assert_int_eq(c->ends, of->ends);
    const double sign = a->mirrored ? -1 : 1;
    double parts[2] = {1, 1}, parted[2] = {1, 1};
    for (int e = 0; e < c->ends; e++) {
      parts[e] = tp_resting_along_double(c->normal + e, own);
      parted[e] = tp_resting_along_double(of->normal + e, given) / a->size[k];
    }
    for (int e = 0; e < c->ends; e++) check_near(parts[e], parted[a->swapped[k] ? 1 - e : e]);
    const double slip = tp_resting_along_double(&c->along, own);
    const double slipped = tp_resting_along_double(&of->along, given) / a->size[k];
    check_near(slip, sign * slipped);
    modes[k] = mode_of(parts[0], parts[1], slip);
    tp_arranged_modes(back, a, modes);
    if (of->twin < 0) ck_assert_int_eq(back[a->contact[k]], mode_of(parted[0], parted[1], slipped));
  }
  free(modes);
  free(back);
}

/* M^-1 of the same wrenches is the same, and so is their power. */
static void check_inertia(const tp_arranged *a, const double *given, const double *own,
                          random_numbers *r) {
  const size_t rows = (size_t)a->resting.rows;
  tp_near *wrench = calloc(rows, sizeof *wrench), *arranged = calloc(rows, sizeof *arranged);
  for (long b = 0; b < a->resting.rows / 3; b++) {
    const tp_rigid_block *block = a->given->assemblage->blocks + a->given->block[b];
    tp_near *of = wrench + 3 * b;
    for (int e = 0; e < 3; e++) of[e].value = draw_part(r) - 0.5;
    /* about the centroid from about the own point */
    of[2].value -= block->arm_x.value * of[1].value - block->arm_y.value * of[0].value;
  }
  tp_arranged_loads(arranged, a, wrench);
  double power = 0, known_power = 0, taken = 0, known_taken = 0;
  for (long b = 0; b < a->resting.rows / 3; b++) {
    const tp_rigid_block *block = a->given->assemblage->blocks + a->given->block[b];
    double about[3] = {wrench[3 * b].value, wrench[3 * b + 1].value, wrench[3 * b + 2].value};
    about[2] += block->arm_x.value * about[1] - block->arm_y.value * about[0];
    double y[3], of_wrench[3];
    tp_resting_accelerate_double(y, block, about);
    for (int e = 0; e < 3; e++) {
      known_power += about[e] * given[3 * b + e];
      known_taken += about[e] * y[e];
      of_wrench[e] = arranged[3 * b + e].value;
    }
    tp_resting_accelerate_double(y, a->resting.assemblage->blocks + a->resting.block[b], of_wrench);
    for (int e = 0; e < 3; e++) {
      power += of_wrench[e] * own[3 * b + e];
      taken += of_wrench[e] * y[e];
    }
  }
  check_near(power, known_power);
  check_near(taken, known_taken);
  free(wrench);
  free(arranged);
}

/* ---- a pile and its image ----------------------------------------------------------------------
 */

static void check_column(const tp_force_column *own, const tp_force_column *other) {
  for (int side = 0; side < 2; side++) {
    ck_assert_int_eq(own->row[side], other->row[side]);
    for (int e = 0; e < 3 && own->row[side] >= 0; e++) {
      check_near(own->entry[side][e].value, other->entry[side][e].value);
    }
  }
}

static void check_alike(const tp_resting *own, const tp_resting *other) {
  ck_assert_int_eq(own->contact_count, other->contact_count);
  ck_assert_int_eq(own->pair_first, other->pair_first);
  for (long k = 0; k < own->pair_first; k++) {
    const tp_resting_contact *c = own->contacts + k, *image = other->contacts + k;
    ck_assert_int_eq(c->ends, image->ends);
    ck_assert_int_eq(c->line, image->line);
    for (int e = 0; e < c->ends; e++) check_column(c->normal + e, image->normal + e);
    check_column(&c->along, &image->along);
  }
}

START_TEST(as_given) {
  enum { PILES = 200 };
  random_numbers r = random_numbers_from(7);
  long pairs = 0, swaps = 0, piles = 0;
  for (long n = 0; n < PILES; n++) {
    box boxes[BOXES];
    long count = draw_boxes(boxes, &r);
    for (long k = count - 1; k >= 0; k--) {
      if (!touches_below(boxes, count, k)) count = k;
    }
    if (count == 0) continue;
    scene own, image;
    double given[3 * BOXES], arranged[3 * BOXES];
    build(&own, boxes, count, false);
    build(&image, boxes, count, true);
    const scene *both[] = {&own, &image};
    for (int k = 0; k < 2; k++) {
      const tp_arranged *a = &both[k]->arranged;
      draw_accelerations(given, arranged, a, &r);
      check_contacts(a, given, arranged);
      check_inertia(a, given, arranged, &r);
      for (long c = 0; c < a->resting.contact_count; c++) swaps += a->swapped[c];
    }
    check_alike(&own.arranged.resting, &image.arranged.resting);
    pairs += own.resting.contact_count - own.resting.pair_first;
    piles++;
    clear(&own);
    clear(&image);
  }
  ck_assert_msg(pairs > 20 && swaps > 20 && piles > PILES / 2, "%ld, %ld, %ld", pairs, swaps,
                piles);
}
END_TEST

SUITE(arranged) {
  Suite *suite = suite_create("arranged");
  TCase *tests = tcase_create("piles");
  tcase_add_test(tests, as_given);
  suite_add_tcase(suite, tests);
  return suite;
}
