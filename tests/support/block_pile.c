/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "block_pile.h"

#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void grow(block_pile *p) {
  if (p->count < p->room) return;
  p->room = 2 * p->room + 16;
  p->descriptions = realloc(p->descriptions, (size_t)p->room * sizeof *p->descriptions);
  ck_assert_ptr_nonnull(p->descriptions);
}

void pile_add(block_pile *p, const long *corners, long count, long divisor, bool fixed) {
  grow(p);
  tp_block_description *own = p->descriptions + p->count++;
  *own = (tp_block_description){.form = TP_OUTLINE_VERTICES};
  own->repair = false;
  own->part_count = fixed; /* kept here until pile_assemble */
  fmpq_init(own->unit_weight_kn_m3.value);
  fmpq_set_si(own->unit_weight_kn_m3.value, 25, 1);
  own->unit_weight_kn_m3.given = true;
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  for (long k = 0; k < count; k++) {
    fmpq_set_si(x, corners[2 * k], (ulong)divisor);
    fmpq_set_si(y, corners[2 * k + 1], (ulong)divisor);
    ck_assert(tp_polyline_append(&own->outline, x, y, (tp_mark){1, 1}));
  }
  fmpq_clear(x);
  fmpq_clear(y);
}

void pile_add_box(block_pile *p, long left, long low, long right, long high, long divisor,
                  bool fixed) {
  const long corners[] = {left, low, right, low, right, high, left, high};
  pile_add(p, corners, 4, divisor, fixed);
}

void pile_add_wall(block_pile *p, int courses, int bricks) {
  pile_add_box(p, -400, -400, 400 * (bricks + 1), 0, 100, true);
  for (int c = 0; c < courses; c++) {
    const bool halves = c % 2 == 0;
    for (int k = 0; k < bricks + (halves ? 1 : 0); k++) {
      const long from = 400L * k - (halves ? 200 : 0), to = from + 400;
      pile_add_box(p, from < 0 ? 0 : from, 175L * c, to > 400L * bricks ? 400L * bricks : to,
                   175L * (c + 1), 100, false);
    }
  }
}

tp_status pile_assemble(block_pile *p, tp_message *message) {
  p->sections = calloc((size_t)p->count, sizeof *p->sections);
  p->given = calloc((size_t)p->count, sizeof *p->given);
  p->names = calloc((size_t)p->count, sizeof *p->names);
  ck_assert(p->sections != NULL && p->given != NULL && p->names != NULL);
  for (long k = 0; k < p->count; k++) {
    const bool fixed = p->descriptions[k].part_count > 0;
    p->descriptions[k].part_count = 0;
    ck_assert_int_eq(tp_section_init(p->sections + k, p->descriptions + k, message), TP_OK);
    snprintf(p->names[k], PILE_NAME, "%ld", k);
    p->given[k] = (tp_given_block){.section = p->sections + k, .name = p->names[k], .fixed = fixed};
  }
  fmpq_t metres;
  fmpq_init(metres);
  fmpq_one(metres);
  const tp_status status = tp_assemblage_init(&p->assemblage, p->given, p->count, metres, message);
  fmpq_clear(metres);
  return status;
}

void pile_build(block_pile *p) {
  tp_message message = {.text = ""};
  ck_assert_msg(pile_assemble(p, &message) == TP_OK, "%s", message.text);
}

void pile_clear(block_pile *p) {
  tp_assemblage_clear(&p->assemblage);
  for (long k = 0; k < p->count; k++) {
    if (p->sections != NULL) tp_section_clear(p->sections + k);
    tp_polyline_clear(&p->descriptions[k].outline);
    fmpq_clear(p->descriptions[k].unit_weight_kn_m3.value);
  }
  free(p->descriptions);
  free(p->sections);
  free(p->given);
  free(p->names);
  *p = (block_pile){.count = 0};
}

tp_contact_strength *pile_strengths(const block_pile *p, double tangent) {
  tp_contact_strength *strengths =
      calloc((size_t)p->assemblage.contact_count + 1, sizeof *strengths);
  ck_assert_ptr_nonnull(strengths);
  for (long k = 0; k < p->assemblage.contact_count; k++) {
    strengths[k] = (tp_contact_strength){.tangent = {tangent, 0}};
  }
  return strengths;
}

void pile_program(tp_force_program *program, const block_pile *p, double tangent,
                  bool towards_left) {
  tp_message message = {.text = ""};
  const tp_weight_loads loads = tp_weight_loads_tilted(towards_left);
  tp_contact_strength *strengths = pile_strengths(p, tangent);
  ck_assert_int_eq(tp_force_program_init(program, &p->assemblage, strengths, &loads, &message),
                   TP_OK);
  free(strengths);
}

tp_load_bracket pile_limit(const block_pile *p, double tangent, bool towards_left, double share) {
  tp_message message = {.text = ""};
  tp_force_program program;
  tp_load_bracket bracket;
  pile_program(&program, p, tangent, towards_left);
  const tp_bracket_aim aim = {.share = share, .enough = INFINITY};
  ck_assert_int_eq(tp_load_bracket_find(&bracket, &program, &aim, &message), TP_OK);
  tp_force_program_clear(&program);
  return bracket;
}
