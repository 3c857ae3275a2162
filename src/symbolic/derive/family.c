/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One formula for every number of teeth.
 *
 * Problem: the moment sums of a toothed block of N sub-blocks as functions of N, exactly and for
 * all N. Method: along the underside x_k = k a and y_k is 0 or c by the parity of k, so every term
 * of the boundary sums of area and first moments is a polynomial of degree at most 2 in k on each
 * parity of k; summed over k < N with N of one parity it is a polynomial in N of degree at most 3,
 * and so are the three terms over the top and the sides. Four members of a parity fix it
 * (Lagrange); the formula then holds for all N of that parity. Further members are compared all the
 * same, as a check of the program. In the general parameters (dx, y, A, lambda) N stands for 2 dx /
 * lambda (section 5.1). */

#include "derive/family.h"
#include "derive/field_work.h"

#include "common/host.h"
#include "derive/c_names.h"
#include "derive/model.h"
#include "derive/notation.h"

#include <stdlib.h>
#include <string.h>

enum { MEMBERS = TP_FAMILY_FIXED + TP_FAMILY_CHECKED, SUMS = TP_FAMILY_SUMS };

/* N of the k-th member of a parity. */
static long member_count(int k, bool even) {
  return 2L * k + (even ? 2 : 1);
}

void tp_family_free(tp_family *family) {
  if (family == NULL) return;
  free(family->title);
  free(family->count);
  for (size_t k = 0; k < family->symbol_count; k++) {
    free(family->symbols[k]);
    free(family->parameters[k]);
  }
  free(family->symbols);
  free(family->parameters);
  for (int k = 0; k < 4; k++) tp_notation_free(&family->formulas[k].tan_critical_angle);
  free(family);
}

/* The members of one parity: N, and twice the area and six times the first moments of each. */
typedef struct members {
  long count[MEMBERS];
  fmpz_mpoly_q_t sums[MEMBERS][SUMS];
} members;

static void members_init(members *m, const tp_field *field) {
  for (int k = 0; k < MEMBERS; k++) {
    for (int s = 0; s < SUMS; s++) fmpz_mpoly_q_init(m->sums[k][s], field->ring);
  }
}

static void members_clear(members *m, const tp_field *field) {
  for (int k = 0; k < MEMBERS; k++) {
    for (int s = 0; s < SUMS; s++) fmpz_mpoly_q_clear(m->sums[k][s], field->ring);
  }
}

/* Sums of the block with `count` teeth. */
static bool sum_member(members *m, int k, const tp_teeth_formulas *f, const tp_scene *scene,
                       const tp_field *field) {
  tp_teeth teeth = scene->block.teeth; /* borrows the numbers, of which only count and end matter */
  teeth.count = m->count[k];
  tp_symbolic_chain outline = {0};
  if (!tp_teeth_formulas_outline(&outline, f, &teeth, field)) return false;
  tp_formulas sums;
  fmpq_t one;
  tp_formulas_init(&sums, field);
  fmpq_init(one);
  fmpq_one(one);
  tp_formulas_add_chain(&sums, &outline, one, 1, field);
  fmpz_mpoly_q_swap(m->sums[k][0], sums.weighted2, field->ring);
  fmpz_mpoly_q_swap(m->sums[k][1], sums.x6, field->ring);
  fmpz_mpoly_q_swap(m->sums[k][2], sums.y6, field->ring);
  fmpq_clear(one);
  tp_formulas_clear(&sums, field);
  tp_symbolic_chain_clear(&outline, field->ring);
  return true;
}

/* The sum through the fixed members, at N = `at` (Lagrange). */
static void interpolate(fmpz_mpoly_q_t value, const members *m, int sum, const fmpz_mpoly_q_t at,
                        const tp_field *field) {
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  fmpz_mpoly_q_t term, factor;
  fmpz_t integer;
  fmpz_mpoly_q_init(term, ring);
  fmpz_mpoly_q_init(factor, ring);
  fmpz_init(integer);
  fmpz_mpoly_q_zero(value, ring);
  for (int i = 0; i < TP_FAMILY_FIXED; i++) {
    fmpz_mpoly_q_set(term, m->sums[i][sum], ring);
    for (int j = 0; j < TP_FAMILY_FIXED; j++) {
      if (j == i) continue;
      fmpz_set_si(integer, m->count[j]);
      fmpz_mpoly_q_sub_fmpz(factor, at, integer, ring);
      tp_field_mul(term, term, factor, field);
      fmpz_set_si(integer, m->count[i] - m->count[j]);
      fmpz_mpoly_q_div_fmpz(term, term, integer, ring);
    }
    tp_field_add(value, value, term, field);
  }
  fmpz_mpoly_q_clear(term, ring);
  fmpz_mpoly_q_clear(factor, ring);
  fmpz_clear(integer);
}

/* Do the members that were not used agree? */
static bool members_agree(const members *m, const tp_field *field) {
  fmpz_mpoly_q_t at, value;
  fmpz_mpoly_q_init(at, field->ring);
  fmpz_mpoly_q_init(value, field->ring);
  bool agree = true;
  for (int k = TP_FAMILY_FIXED; k < MEMBERS && agree; k++) {
    fmpz_mpoly_q_set_si(at, m->count[k], field->ring);
    for (int s = 0; s < SUMS && agree; s++) {
      interpolate(value, m, s, at, field);
      agree = fmpz_mpoly_q_equal(value, m->sums[k][s], field->ring) != 0;
    }
  }
  fmpz_mpoly_q_clear(at, field->ring);
  fmpz_mpoly_q_clear(value, field->ring);
  return agree;
}

tp_status tp_family_check(const tp_scene *scene, tp_message *message) {
  const tp_block_description *block = &scene->block;
  if (block->form == TP_OUTLINE_TEETH && block->hole_count == 0 && block->part_count == 0) {
    return TP_OK;
  }
  return tp_refuse(message, TP_FAULT_KEY, block->place,
                   "only a toothed block without holes and parts has a formula for all counts: "
                   "'block: {teeth: {count: 3, …}}'");
}

tp_pivot_kind tp_family_toe_kind(const tp_scene *scene, bool even, tp_direction towards) {
  const bool left_valley = scene->block.teeth.left_end_valley;
  const bool valley = towards == TP_TOWARDS_LEFT ? left_valley : left_valley == even;
  return valley ? TP_PIVOT_VALLEY : TP_PIVOT_PEAK;
}

void tp_family_arms(fmpz_mpoly_q_t x_arm, fmpz_mpoly_q_t y_arm, const tp_family_sums *sums,
                    const tp_teeth_formulas *f, tp_pivot_kind kind, tp_direction towards,
                    const tp_field *field) {
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  const bool left = towards == TP_TOWARDS_LEFT;
  fmpz_mpoly_q_t x, y;
  fmpz_mpoly_q_init(x, ring);
  fmpz_mpoly_q_init(y, ring);
  if (!left) tp_field_mul(x, f->count, f->a, field);
  if (kind == TP_PIVOT_PEAK) fmpz_mpoly_q_set(y, f->c, ring);
  tp_formulas_arm(x_arm, sums->of[1], sums->of[0], x, field);
  tp_formulas_arm(y_arm, sums->of[2], sums->of[0], y, field);
  if (!left) fmpz_mpoly_q_neg(x_arm, x_arm, ring);
  fmpz_mpoly_q_clear(x, ring);
  fmpz_mpoly_q_clear(y, ring);
}

static void write_toe(tp_family_formula *out, const tp_family_sums *sums,
                      const tp_teeth_formulas *f, const tp_field *field, tp_notation notation,
                      bool *failed) {
  fmpz_mpoly_q_t x_arm, y_arm;
  fmpz_mpoly_q_init(x_arm, field->ring);
  fmpz_mpoly_q_init(y_arm, field->ring);
  tp_family_arms(x_arm, y_arm, sums, f, out->kind, out->towards, field);
  out->tan_critical_angle = tp_notation_write_quotient(x_arm, y_arm, field, notation, failed);
  fmpz_mpoly_q_clear(x_arm, field->ring);
  fmpz_mpoly_q_clear(y_arm, field->ring);
}

void tp_family_sums_init(tp_family_sums *sums, const tp_field *field) {
  for (int s = 0; s < SUMS; s++) fmpz_mpoly_q_init(sums->of[s], field->ring);
}

void tp_family_sums_clear(tp_family_sums *sums, const tp_field *field) {
  for (int s = 0; s < SUMS; s++) fmpz_mpoly_q_clear(sums->of[s], field->ring);
}

tp_status tp_family_sums_derive(tp_family_sums *sums, bool even, const tp_teeth_formulas *f,
                                const tp_scene *scene, const tp_field *field, tp_message *message) {
  members m;
  bool failed = false;
  members_init(&m, field);
  for (int k = 0; k < MEMBERS; k++) {
    m.count[k] = member_count(k, even);
    failed = failed || !sum_member(&m, k, f, scene, field);
  }
  tp_status status = failed ? tp_fail_memory(message, "the family of formulas")
                            : tp_field_check(field, scene->block.place, message);
  if (status == TP_OK && !members_agree(&m, field) && tp_field_problem(field) == NULL) {
    status = tp_fail(message, TP_DEPENDENCY_FAILED, scene->block.place,
                     "the formula for all counts fails on a further count; please report this");
  }
  for (int s = 0; s < SUMS; s++) interpolate(sums->of[s], &m, s, f->count, field);
  members_clear(&m, field);
  return status == TP_OK ? tp_field_check(field, scene->block.place, message) : status;
}

static tp_status derive_parity(tp_family *family, bool even, const tp_teeth_formulas *f,
                               const tp_scene *scene, const tp_field *field, tp_message *message) {
  for (int k = 0; k < TP_FAMILY_FIXED; k++) family->fixed_by[even][k] = member_count(k, even);
  for (int k = 0; k < TP_FAMILY_CHECKED; k++) {
    family->checked_on[even][k] = member_count(TP_FAMILY_FIXED + k, even);
  }
  tp_family_sums sums;
  tp_family_sums_init(&sums, field);
  tp_status status = tp_family_sums_derive(&sums, even, f, scene, field, message);
  bool failed = false;
  for (int d = 0; d < 2 && status == TP_OK; d++) {
    const tp_direction towards = d == 0 ? TP_TOWARDS_LEFT : TP_TOWARDS_RIGHT;
    tp_family_formula *own = family->formulas + 2 * (even ? 1 : 0) + d;
    *own = (tp_family_formula){
        .towards = towards, .even = even, .kind = tp_family_toe_kind(scene, even, towards)};
    write_toe(own, &sums, f, field, family->notation, &failed);
  }
  tp_family_sums_clear(&sums, field);
  if (status == TP_OK) status = tp_field_check(field, scene->block.place, message);
  if (status == TP_OK && failed) status = tp_fail_memory(message, "the family of formulas");
  return status;
}

static tp_status describe(tp_family *family, const tp_teeth_formulas *f, const tp_scene *scene,
                          const tp_field *field, tp_message *message) {
  bool failed = false;
  tp_fraction count = tp_notation_write(f->count, field, family->notation, &failed);
  family->count = count.formula;
  count.formula = NULL;
  tp_notation_free(&count);
  if (!tp_field_list_symbols(&family->symbol_count, &family->symbols, &family->parameters, field)) {
    failed = true;
  }
  fmpz_mpoly_q_t own;
  fmpz_mpoly_q_init(own, field->ring);
  tp_field_count_symbol(own, field);
  family->count_is_symbol = fmpz_mpoly_q_equal(own, f->count, field->ring);
  fmpz_mpoly_q_clear(own, field->ring);
  if (scene->title != NULL) {
    family->title = strdup(scene->title);
    failed = failed || family->title == NULL;
  }
  return failed ? tp_fail_memory(message, "the family of formulas") : TP_OK;
}

static tp_status fill(tp_family *family, const tp_scene *scene, tp_message *message) {
  tp_symbols symbols = {0}; /* of which only the field is used: the rings are made count by count */
  tp_status status = tp_field_init(&symbols.field, scene, NULL, message);
  if (status != TP_OK) return status;
  tp_teeth_formulas f;
  tp_teeth_formulas_init(&f, &symbols.field);
  status = tp_teeth_formulas_read(&f, &symbols, scene, message);
  if (status == TP_OK && family->notation == TP_NOTATION_C && !tp_c_names_set(&symbols.field)) {
    status = tp_fail_memory(message, "the names in C");
  }
  if (status == TP_OK) status = describe(family, &f, scene, &symbols.field, message);
  for (int even = 0; even < 2 && status == TP_OK; even++) {
    status = derive_parity(family, even == 1, &f, scene, &symbols.field, message);
  }
  tp_teeth_formulas_clear(&f, &symbols.field);
  tp_field_clear(&symbols.field);
  return status;
}

tp_status tp_derive_family(tp_family **family, const tp_scene *scene, tp_notation notation,
                           tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, family);
  TP_REFUSE_NULL(message, scene);
  if ((int)notation < TP_NOTATION_TEXT || (int)notation > TP_NOTATION_C) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){0}, "there is no such notation");
  }
  tp_status suits = tp_model_check_named(scene, message);
  if (suits == TP_OK) suits = tp_family_check(scene, message);
  if (suits != TP_OK) return suits;
  tp_family *own = calloc(1, sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "the family of formulas");
  own->size = sizeof *own;
  own->notation = notation;
  const tp_status status = fill(own, scene, message);
  if (status == TP_OK) {
    *family = own;
  } else {
    tp_family_free(own);
  }
  return status;
}
