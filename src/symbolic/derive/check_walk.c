/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Moves the symbols geometrically away from the scene's values, evaluates conditions there in
 * balls, and solves the scene at the decimals of such a point. */

#include "derive/check_walk.h"

#include "number/ball.h"
#include "number/ladder.h"
#include "scene/vary.h"
#include "stability/friction.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Digits that the solver is asked for, and bits that tell far more: 160 are 48 digits. */
enum { BITS = TP_BALL_BITS, DIGITS = 12 };

static const char friction_key[] = "friction_angle_deg";

/* Does the symbol occur in the formula or in a condition? */
static bool occurs(const tp_checked_formula *f, long symbol) {
  const fmpz_mpoly_ctx_struct *ring = f->conditions->field->ring;
  const fmpz_mpoly_q_struct *t = f->tangent;
  bool found = fmpz_mpoly_degree_si(fmpz_mpoly_q_numref(t), symbol, ring) > 0 ||
               fmpz_mpoly_degree_si(fmpz_mpoly_q_denref(t), symbol, ring) > 0;
  for (long k = 0; k < f->conditions->count && !found; k++) {
    found = fmpz_mpoly_degree_si(fmpz_mpoly_q_numref(f->conditions->items + k), symbol, ring) > 0;
  }
  return found;
}

static void add_number(tp_walk *w, const char *key, const tp_node *node, long symbol,
                       const fmpq_t value) {
  if (w->count == TP_WALK_SYMBOLS) return;
  w->numbers[w->count++] = (tp_walk_number){.key = key,
                                            .node = node,
                                            .symbol = symbol,
                                            .is_friction = key == friction_key,
                                            .own = fmpq_get_d(value)};
}

/* The scalar of a number; NULL where the scene gives none of its own. */
static const tp_node *node_of(const tp_scene *scene, const char *key) {
  const tp_node *map =
      key == friction_key ? scene->source : tp_node_get(scene->source, "parameters");
  const tp_node *found = map != NULL ? tp_node_get(map, key) : NULL;
  return found != NULL && found->kind == TP_NODE_SCALAR ? found : NULL;
}

/* Numbers that stand alone: a parameter that the friction angle names would change that, too. */
static tp_status find_numbers(tp_walk *w, tp_message *message) {
  const tp_checked_formula *f = w->formula;
  const tp_scene *scene = f->model->problem.scene;
  const tp_node *friction = node_of(scene, friction_key);
  tp_status status = TP_OK;
  bool free_friction = friction != NULL;
  for (long k = 0; k < scene->parameters.count && status == TP_OK; k++) {
    const tp_node *own = node_of(scene, scene->parameters.names[k]);
    if (own == NULL) continue;
    tp_reach reach;
    status = tp_key_reach(&reach, scene->source, own, message);
    if (status != TP_OK) break;
    if (reach.friction) {
      free_friction = false;
    } else if (occurs(f, k)) {
      add_number(w, scene->parameters.names[k], own, k, scene->parameters.values + k);
    }
  }
  if (status == TP_OK && free_friction && occurs(f, f->friction)) {
    add_number(w, friction_key, friction, f->friction, scene->friction_angle_deg.value);
  }
  return status;
}

tp_status tp_walk_init(tp_walk *w, const tp_checked_formula *formula, tp_message *message) {
  *w = (tp_walk){.formula = formula};
  return find_numbers(w, message);
}

void tp_walk_point_init(tp_walk_point *p, const tp_walk *w) {
  memset(p->texts, 0, sizeof p->texts);
  p->values = _arb_vec_init(w->formula->conditions->field->symbol_count);
}

void tp_walk_point_clear(tp_walk_point *p, const tp_walk *w) {
  _arb_vec_clear(p->values, w->formula->conditions->field->symbol_count);
}

/* Angles stay between 0 and 90 degrees, and what is above zero stays so. */
static double go(const tp_walk *w, const tp_walk_number *n, double by) {
  if (n->is_friction) return by > 0 ? 90 - (90 - n->own) * exp(-by) : n->own * exp(by);
  if (w->formula->conditions->positive) return n->own * exp(by);
  return n->own + by * (n->own != 0 ? fabs(n->own) : 1);
}

/* The exact value of the text. */
static bool read_text(arb_t value, const tp_walk_number *n, const char *text) {
  static const tp_parameters none = {0};
  fmpq_t exact;
  fmpq_init(exact);
  tp_message message;
  const bool read = tp_expression_evaluate(exact, text, (tp_place){0}, &none, &message) == TP_OK;
  arb_set_fmpq(value, exact, BITS);
  if (n->is_friction) tp_friction_tangent(value, value, BITS);
  fmpq_clear(exact);
  return read;
}

bool tp_walk_go(tp_walk_point *p, const tp_walk *w, const tp_walk_direction *direction,
                double distance) {
  const tp_scene *scene = w->formula->model->problem.scene;
  for (long k = 0; k < scene->parameters.count; k++) {
    arb_set_fmpq(p->values + k, scene->parameters.values + k, BITS);
  }
  arb_set_fmpq(p->values + w->formula->friction, scene->friction_angle_deg.value, BITS);
  tp_friction_tangent(p->values + w->formula->friction, p->values + w->formula->friction, BITS);
  for (size_t k = 0; k < w->count; k++) {
    const tp_walk_number *n = w->numbers + k;
    p->texts[k][0] = '\0';
    if (direction->of[k] == 0 || distance == 0) continue;
    snprintf(p->texts[k], sizeof p->texts[k], "%.7g", go(w, n, direction->of[k] * distance));
    if (!read_text(p->values + n->symbol, n, p->texts[k])) return false;
    if (n->is_friction && !(strtod(p->texts[k], NULL) < 90)) return false;
  }
  return true;
}

long tp_walk_fails(const tp_walk *w, const tp_walk_point *p, long from) {
  const tp_conditions *c = w->formula->conditions;
  arb_t ball;
  arb_init(ball);
  long found = -1;
  for (long k = from; k < c->count && found < 0; k++) {
    tp_field_evaluate_ball(ball, c->items + k, p->values, c->field, BITS);
    if (arb_is_negative(ball)) found = k;
  }
  arb_clear(ball);
  return found;
}

bool tp_walk_holds(const tp_walk *w, const tp_walk_point *p) {
  const tp_conditions *c = w->formula->conditions;
  arb_t ball;
  arb_init(ball);
  bool holds = true;
  for (long k = 0; k < c->count && holds; k++) {
    tp_field_evaluate_ball(ball, c->items + k, p->values, c->field, BITS);
    holds = arb_is_positive(ball);
  }
  arb_clear(ball);
  return holds;
}

/* The scene with the values of the point for its numbers. */
static tp_status scene_at(tp_scene **scene, const tp_walk *w, const tp_walk_point *p,
                          tp_message *message) {
  tp_scene_key keys[TP_WALK_SYMBOLS] = {{.node = NULL}};
  fmpq values[TP_WALK_SYMBOLS] = {{0}};
  tp_status status = TP_OK;
  size_t count = 0;
  for (size_t k = 0; k < w->count && status == TP_OK; k++) {
    if (p->texts[k][0] == '\0') continue;
    keys[count] = (tp_scene_key){.node = w->numbers[k].node};
    fmpq_init(values + count);
    status = tp_expression_evaluate(values + count++, p->texts[k], (tp_place){0}, NULL, message);
  }
  if (status == TP_OK) {
    status = tp_scene_vary(scene, w->formula->model->problem.scene, keys, values, count, message);
  }
  for (size_t k = 0; k < count; k++) fmpq_clear(values + k);
  return status;
}

static tp_status solve_at(tp_solution **solution, const tp_walk *w, const tp_walk_point *p,
                          tp_message *message) {
  tp_scene *scene = NULL;
  tp_status status = scene_at(&scene, w, p, message);
  if (status == TP_OK) {
    tp_solve_options options = tp_solve_options_default();
    options.strength_reduction = false;
    options.digits = DIGITS;
    status = tp_solve(solution, scene, &options, message);
  }
  tp_scene_free(scene);
  return status;
}

/* The formula's angle there, and the solver's. */
static tp_check_verdict compare(const tp_walk *w, const tp_walk_point *p, tp_bounded solved) {
  const tp_bounded own =
      tp_field_angle(w->formula->tangent, p->values, w->formula->conditions->field, BITS);
  return fabs(own.value - solved.value) <= own.error + solved.error ? TP_CHECK_SAME
                                                                    : TP_CHECK_OTHER;
}

/* The formula is of the contact that the scene has. */
static bool has_contact(const tp_walk *w, const tp_contact_result *there) {
  const tp_contact_result *here = &w->formula->model->solution->contact;
  return there->facets == here->facets && there->points == here->points &&
         there->corner_points == here->corner_points && there->left_end == here->left_end &&
         there->right_end == here->right_end;
}

static tp_check_verdict judge(const tp_walk *w, const tp_walk_point *p, const tp_case *own) {
  if (w->formula->onset) {
    const tp_onset *o = &own->onset;
    if (o->kind == TP_ONSET_AT_ANGLE) return compare(w, p, o->critical_angle_deg);
    return o->kind == TP_ONSET_UNDECIDED ? TP_CHECK_UNDECIDED : TP_CHECK_NONE;
  }
  const tp_limit *l = &own->limit;
  if (l->kind == TP_LIMIT_AT_ANGLE) return compare(w, p, l->critical_angle_deg);
  return l->kind == TP_LIMIT_UNDECIDED ? TP_CHECK_UNDECIDED : TP_CHECK_NONE;
}

tp_status tp_walk_solve(tp_check_verdict *verdict, const tp_walk *w, const tp_walk_point *p,
                        tp_message *message) {
  tp_solution *solution = NULL;
  tp_message why;
  const tp_status status = solve_at(&solution, w, p, &why);
  *verdict = status == TP_UNDECIDED ? TP_CHECK_UNDECIDED : TP_CHECK_REFUSED;
  if (status != TP_OK && status != TP_UNDECIDED && status != TP_BAD_INPUT &&
      status != TP_NO_ANSWER) {
    *message = why;
    return status;
  }
  for (size_t k = 0; status == TP_OK && k < solution->case_count; k++) {
    if (solution->cases[k].towards != w->formula->towards) continue;
    *verdict =
        has_contact(w, &solution->contact) ? judge(w, p, solution->cases + k) : TP_CHECK_CONTACT;
  }
  tp_solution_free(solution);
  return TP_OK;
}

char *tp_walk_write(const tp_walk *w, const tp_walk_point *p) {
  size_t size = 1;
  for (size_t k = 0; k < w->count; k++) size += strlen(w->numbers[k].key) + TP_WALK_TEXT + 5;
  char *text = calloc(1, size);
  for (size_t k = 0; text != NULL && k < w->count; k++) {
    if (p->texts[k][0] == '\0') continue;
    const size_t length = strlen(text);
    snprintf(text + length, size - length, "%s%s = %s", length > 0 ? ", " : "", w->numbers[k].key,
             p->texts[k]);
  }
  return text;
}
