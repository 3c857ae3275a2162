/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Affine functions with rational coefficients as an algebra of formula/evaluate.h: sums, and
 * products and quotients with a constant. */

#include "case_filter/affine.h"

#include "scene/expression.h"

#include <stdlib.h>
#include <string.h>

enum { PARTS = TP_AFFINE_VARIABLES + 1 };

void tp_affine_init(tp_affine *a) {
  for (int k = 0; k < PARTS; k++) fmpq_init(a->of + k);
}

void tp_affine_clear(tp_affine *a) {
  for (int k = 0; k < PARTS; k++) fmpq_clear(a->of + k);
}

static void set(tp_affine *a, const tp_affine *from) {
  for (int k = 0; k < PARTS; k++) fmpq_set(a->of + k, from->of + k);
}

bool tp_affine_is_constant(const tp_affine *a) {
  bool constant = true;
  for (int k = 1; k < PARTS; k++) constant = constant && fmpq_is_zero(a->of + k);
  return constant;
}

bool tp_affine_equal(const tp_affine *a, const tp_affine *b) {
  bool equal = true;
  for (int k = 0; k < PARTS; k++) equal = equal && fmpq_equal(a->of + k, b->of + k);
  return equal;
}

void tp_affine_sub(tp_affine *rest, const tp_affine *a, const tp_affine *b) {
  for (int k = 0; k < PARTS; k++) fmpq_sub(rest->of + k, a->of + k, b->of + k);
}

void tp_affine_add(tp_affine *sum, const tp_affine *a, const tp_affine *b) {
  for (int k = 0; k < PARTS; k++) fmpq_add(sum->of + k, a->of + k, b->of + k);
}

void tp_affine_value(fmpq_t value, const tp_affine *a, const fmpq *variables) {
  fmpq_set(value, a->of);
  for (int k = 1; k < PARTS; k++) {
    if (!fmpq_is_zero(a->of + k)) fmpq_addmul(value, a->of + k, variables + k - 1);
  }
}

/* ---- the algebra -------------------------------------------------------------------------------
 */

static void init_value(void *value, const void *context) {
  (void)context;
  tp_affine_init(value);
}

static void clear_value(void *value, const void *context) {
  (void)context;
  tp_affine_clear(value);
}

static void swap_values(void *value, void *other, const void *context) {
  (void)context;
  const tp_affine held = *(tp_affine *)value;
  *(tp_affine *)value = *(tp_affine *)other;
  *(tp_affine *)other = held;
}

static void negate(void *value, const void *context) {
  (void)context;
  tp_affine *a = value;
  for (int k = 0; k < PARTS; k++) fmpq_neg(a->of + k, a->of + k);
}

static void set_number(void *value, const fmpq_t number, const void *context) {
  (void)context;
  tp_affine *a = value;
  for (int k = 1; k < PARTS; k++) fmpq_zero(a->of + k);
  fmpq_set(a->of, number);
}

static bool set_name(void *value, long name, tp_evaluator *evaluator) {
  const tp_affine *parameters = evaluator->context;
  set(value, parameters + name);
  return true;
}

static void scale(tp_affine *a, const fmpq_t by) {
  for (int k = 0; k < PARTS; k++) fmpq_mul(a->of + k, a->of + k, by);
}

static bool multiply(tp_affine *a, const tp_affine *b) {
  if (tp_affine_is_constant(b)) {
    fmpq_t by;
    fmpq_init(by);
    fmpq_set(by, b->of);
    scale(a, by);
    fmpq_clear(by);
    return true;
  }
  if (!tp_affine_is_constant(a)) return false;
  fmpq_t by;
  fmpq_init(by);
  fmpq_set(by, a->of);
  set(a, b);
  scale(a, by);
  fmpq_clear(by);
  return true;
}

static bool divide(tp_affine *a, const tp_affine *b) {
  if (!tp_affine_is_constant(b) || fmpq_is_zero(b->of)) return false;
  fmpq_t by;
  fmpq_init(by);
  fmpq_inv(by, b->of);
  scale(a, by);
  fmpq_clear(by);
  return true;
}

/* Powers are left to those who solve. */
static bool combine(void *value, tp_formula_kind kind, const void *other, tp_evaluator *evaluator) {
  bool done = true;
  if (kind == TP_FORMULA_ADD) {
    tp_affine_add(value, value, other);
  } else if (kind == TP_FORMULA_SUBTRACT) {
    tp_affine_sub(value, value, other);
  } else if (kind == TP_FORMULA_MULTIPLY) {
    done = multiply(value, other);
  } else {
    done = kind == TP_FORMULA_DIVIDE && divide(value, other);
  }
  return done || tp_evaluator_fail(evaluator, "no affine function");
}

static const tp_algebra algebra = {.size = sizeof(tp_affine),
                                   .init = init_value,
                                   .clear = clear_value,
                                   .swap = swap_values,
                                   .negate = negate,
                                   .set_number = set_number,
                                   .set_name = set_name,
                                   .combine = combine};

/* ---- a scene -----------------------------------------------------------------------------------
 */

static bool take_key(tp_affine *value, const tp_affine_scene *s, const tp_node *node) {
  for (size_t k = 0; k < s->count; k++) {
    if (s->keys[k].node != node) continue;
    for (int p = 0; p < PARTS; p++) fmpq_zero(value->of + p);
    fmpq_one(value->of + 1 + k);
    return true;
  }
  return false;
}

bool tp_affine_read(tp_affine *value, const tp_affine_scene *s, const tp_node *node) {
  if (node == NULL || node->kind != TP_NODE_SCALAR || s->parameters == NULL) return false;
  if (take_key(value, s, node)) return true;
  if (tp_scene_override(s->scene, node) != NULL) return false;
  tp_message unused;
  return tp_expression_evaluate_in(value, &algebra, s->parameters, node->text,
                                   tp_node_place(node, s->scene->path), &s->scene->parameters,
                                   &unused) == TP_OK;
}

bool tp_affine_depends(const tp_affine_scene *s, const tp_node *node) {
  bool depends = false;
  for (const tp_node *child = node != NULL ? node->first : NULL; child != NULL && !depends;
       child = child->next) {
    depends = tp_affine_depends(s, child);
  }
  if (node == NULL || node->kind != TP_NODE_SCALAR) return depends;
  tp_affine value;
  fmpq_t number;
  tp_message unused;
  tp_affine_init(&value);
  fmpq_init(number);
  const bool is_number =
      tp_expression_evaluate(number, node->text, tp_node_place(node, s->scene->path),
                             &s->scene->parameters, &unused) == TP_OK;
  depends = is_number && !(tp_affine_read(&value, s, node) && tp_affine_is_constant(&value));
  tp_affine_clear(&value);
  fmpq_clear(number);
  return depends;
}

/* A parameter may use those before it. */
static bool read_parameters(tp_affine_scene *s) {
  const tp_node *node = tp_node_get(s->scene->source, "parameters");
  const tp_parameters *all = &s->scene->parameters;
  tp_parameters known = *all;
  long k = 0;
  for (const tp_node *own = node != NULL ? node->first : NULL; own != NULL; own = own->next, k++) {
    tp_message unused;
    if (k == all->count || strcmp(own->key, all->names[k]) != 0) return false;
    if (take_key(s->parameters + k, s, own)) continue;
    known.count = k;
    if (tp_scene_override(s->scene, own) != NULL ||
        tp_expression_evaluate_in(s->parameters + k, &algebra, s->parameters, own->text,
                                  tp_node_place(own, s->scene->path), &known, &unused) != TP_OK) {
      return false;
    }
  }
  return k == all->count;
}

bool tp_affine_scene_init(tp_affine_scene *s, const tp_scene *scene, const tp_scene_key *keys,
                          size_t count) {
  *s = (tp_affine_scene){.scene = scene, .keys = keys, .count = count};
  s->parameters = calloc((size_t)scene->parameters.count + 1, sizeof *s->parameters);
  if (s->parameters == NULL) return false;
  for (long k = 0; k < scene->parameters.count; k++) tp_affine_init(s->parameters + k);
  if (scene->source == NULL || count > TP_AFFINE_VARIABLES || !read_parameters(s)) {
    tp_affine_scene_clear(s);
  }
  return true;
}

void tp_affine_scene_clear(tp_affine_scene *s) {
  for (long k = 0; s->parameters != NULL && k < s->scene->parameters.count; k++) {
    tp_affine_clear(s->parameters + k);
  }
  free(s->parameters);
  s->parameters = NULL;
}
