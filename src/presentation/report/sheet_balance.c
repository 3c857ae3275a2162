/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* All forces on the block at its static limit, horizontal and vertical, with their moments about
 * the centroid of the weight, and that they cancel. Along the axes of the solution gravity is
 * (-sin a, -cos a) at a tilt a towards the left, (sin a, -cos a) towards the right, so a force
 * (X, Y) has
 *
 *     H = X cos a - Y sin a,   V = X sin a + Y cos a,
 *
 * with -a for a towards the right. Without a unit weight forces are shares of the weight W. Points
 * have the coordinates of the drawing: arms are turned to the axes of the forces. */

#include "report/sheet.h"

#include "number/near_angle.h"
#include "report/words.h"

#include <math.h>

typedef struct frame {
  tp_near sine, cosine, weight; /* of the tilt; the weight as it is printed */
  bool in_weights;
} frame;

typedef struct force {
  tp_near x, y, moment; /* as shares of the weight; the moment in metres */
} force;

static tp_near near_of(tp_bounded number) {
  return (tp_near){number.value, number.error};
}

static force force_of(tp_wrench_share share) {
  return (force){near_of(share.share_x), near_of(share.share_y), near_of(share.moment_m)};
}

static force less(force a, force b) {
  return (force){tp_near_sub(a.x, b.x), tp_near_sub(a.y, b.y), tp_near_sub(a.moment, b.moment)};
}

static bool is_nothing(force f) {
  const tp_near parts[] = {f.x, f.y, f.moment};
  bool nothing = true;
  for (int k = 0; k < 3; k++) nothing = nothing && fabs(parts[k].value) <= parts[k].error;
  return nothing;
}

static force weight_of(const frame *f) {
  return (force){tp_near_neg(f->sine), tp_near_neg(f->cosine), {0, 0}};
}

/* About the centroid. */
static force reaction_of(const tp_sheet *s, const tp_reaction *r) {
  const tp_block_result *b = &s->solution->block;
  const tp_near x = near_of(r->share_x), y = near_of(r->share_y);
  const tp_near dx = tp_near_sub(near_of(r->x_m), near_of(b->centroid_x_m));
  const tp_near dy = tp_near_sub(near_of(r->y_m), near_of(b->centroid_y_m));
  tp_near sine, cosine;
  tp_near_sin_cos(&sine, &cosine, near_of(s->solution->frame.turned_deg));
  const tp_near along = tp_near_add(tp_near_mul(cosine, dx), tp_near_mul(sine, dy));
  const tp_near up = tp_near_sub(tp_near_mul(cosine, dy), tp_near_mul(sine, dx));
  return (force){x, y, tp_near_sub(tp_near_mul(along, y), tp_near_mul(up, x))};
}

static tp_bounded horizontal(const frame *f, force own) {
  const tp_near sum = tp_near_sub(tp_near_mul(own.x, f->cosine), tp_near_mul(own.y, f->sine));
  return (tp_bounded){.value = sum.value, .error = sum.error};
}

static tp_bounded vertical(const frame *f, force own) {
  const tp_near sum = tp_near_add(tp_near_mul(own.x, f->sine), tp_near_mul(own.y, f->cosine));
  return (tp_bounded){.value = sum.value, .error = sum.error};
}

/* ---- the table ---------------------------------------------------------------------------------
 */

static tp_bounded times_weight(const frame *f, tp_bounded share) {
  const tp_near product = tp_near_mul(near_of(share), f->weight);
  return (tp_bounded){.value = product.value, .error = product.error};
}

/* A sum is told with its bound, of a force the digits that are certain. */
static void add_number(tp_document *d, tp_bounded number, bool sum) {
  char n[TP_NUMBER_SIZE];
  const bool zero = fabs(number.value) <= number.error || number.value == 0;
  if (!zero) {
    tp_document_cell(d, "%s", tp_text_significant(n, number, 6));
  } else if (sum && number.error > 0) { /* twice as much: one digit of it is no less */
    tp_document_cell(d, "0 ± %.0e", 2 * (fabs(number.value) + number.error));
  } else {
    tp_document_cell(d, "0");
  }
}

static void add_numbers(tp_sheet *s, const frame *f, force own, bool sum) {
  tp_document *d = &s->document;
  const tp_bounded moment = {.value = own.moment.value, .error = own.moment.error};
  if (f->in_weights) {
    add_number(d, horizontal(f, own), sum);
    add_number(d, vertical(f, own), sum);
    add_number(d, tp_text_over(moment, s->solution->metres_per_unit), sum);
  } else {
    add_number(d, tp_sheet_force(s, times_weight(f, horizontal(f, own))), sum);
    add_number(d, tp_sheet_force(s, times_weight(f, vertical(f, own))), sum);
    add_number(d, tp_sheet_turning(s, times_weight(f, moment)), sum);
  }
}

static void add_reaction(tp_sheet *s, const frame *f, const tp_reaction *r) {
  tp_document *d = &s->document;
  const tp_page page = {.solution = s->solution};
  char n[2][TP_NUMBER_SIZE];
  tp_page_coordinate(&page, n[0], r->x_m);
  tp_page_coordinate(&page, n[1], r->y_m);
  if (!r->of_facet) {
    tp_document_cell(d, "base past the toe, at (%s, %s)", n[0], n[1]);
  } else if (r->at_right_end) {
    tp_document_cell(d, "base, facet %zu, right end (%s, %s)", r->facet + 1, n[0], n[1]);
  } else {
    tp_document_cell(d, "base, facet %zu, left end (%s, %s)", r->facet + 1, n[0], n[1]);
  }
  add_numbers(s, f, reaction_of(s, r), false);
}

static void add_heads(tp_sheet *s, const frame *f) {
  tp_document *d = &s->document;
  const char *force_unit = f->in_weights ? "W" : tp_sheet_force_unit(s);
  tp_document_word(d, "Force on the block");
  tp_document_cell(d, "H (%s)", force_unit);
  tp_document_cell(d, "V (%s)", force_unit);
  if (f->in_weights) {
    tp_document_cell(d, "M (W %s)", s->solution->length_unit);
  } else {
    tp_document_cell(d, "M (%s)", tp_sheet_turning_unit(s));
  }
}

static frame frame_of(const tp_sheet *s, const tp_case *c) {
  const tp_block_result *b = &s->solution->block;
  frame f = {.weight = b->has_weight ? near_of(b->weight_n) : (tp_near){1, 0},
             .in_weights = !b->has_weight};
  tp_near_sin_cos(&f.sine, &f.cosine, near_of(c->limit.critical_angle_deg));
  if (c->towards == TP_TOWARDS_RIGHT) f.sine = tp_near_neg(f.sine);
  return f;
}

void tp_sheet_add_balance(tp_sheet *s, const tp_case *c) {
  tp_document *d = &s->document;
  const tp_limit_balance *balance = &c->balance;
  const double upright = 90;
  char n[TP_NUMBER_SIZE];
  if (!balance->known || !(fabs(c->limit.critical_angle_deg.value) < upright)) return;
  const frame f = frame_of(s, c);
  const force strength = force_of(balance->strength);
  tp_document_heading(d, 3, "Forces at the limit");
  tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                  tp_sheet_tilts_are_dips(s)
                      ? "At the dip α_w = %s° these forces just hold the block, and cancel: H "
                        "horizontal, to the right, V upwards, M about the centroid of the weight, "
                        "counter-clockwise."
                      : "At the tilt α_w = %s° these forces just hold the block, and cancel: H "
                        "horizontal, to the right, V upwards, M about the centroid of the weight, "
                        "counter-clockwise.",
                  tp_text_fixed(n, c->limit.critical_angle_deg, 3));
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 4, 0xe, "Forces at the limit and their sums");
  add_heads(s, &f);
  tp_document_word(d, "weight");
  add_numbers(s, &f, weight_of(&f), false);
  const force loads = less(force_of(balance->applied), weight_of(&f));
  if (s->solution->loaded && !is_nothing(loads)) {
    tp_document_word(d, "loads beside it");
    add_numbers(s, &f, loads, false);
  }
  if (!is_nothing(strength)) {
    tp_document_word(d, "cohesion and bonds, used up");
    add_numbers(s, &f, strength, false);
  }
  for (size_t k = 0; k < c->limit.reaction_count; k++) {
    add_reaction(s, &f, c->limit.reactions + k);
  }
  tp_document_mark_row(d);
  tp_document_word(d, "ΣH, ΣV, ΣM");
  add_numbers(s, &f, force_of(balance->sum), true);
}
