/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Writes tan(alpha) about the axis moved by rounding, and the tangent length and radius at which
 * the block topples at alpha ((A2.4), (A2.10); docs/mechanics.md section 9). */

#include "derive/derive_rounding.h"

#include "derive/field_work.h"
#include "derive/notation.h"

#include <string.h>

enum { LENGTH, SINE, COSINE, TANGENT };

static const char *const names[] = {"r", "sin(i)", "cos(i)", "tan(alpha)"};
const tp_symbol_names tp_derive_rounding_symbols = {4, names};

tp_status tp_derive_rounding_check(const tp_scene *scene, tp_message *message) {
  static const char *const taken[] = {"r", "i", "alpha"};
  for (long k = 0; k < scene->parameters.count; k++) {
    for (size_t j = 0; j < sizeof taken / sizeof taken[0]; j++) {
      if (strcmp(scene->parameters.names[k], taken[j]) != 0) continue;
      return tp_refuse(message, TP_FAULT_KEY,
                       tp_node_place(tp_node_get(scene->source, "parameters"), scene->path),
                       "the formulas of rounded corners need the name '%s' for themselves; rename "
                       "this parameter",
                       taken[j]);
    }
  }
  return TP_OK;
}

void tp_derived_rounding_free(tp_derived_rounding *r) {
  tp_notation_free(&r->tan_critical_angle);
  tp_notation_free(&r->rounding_length);
  tp_notation_free(&r->corner_radius);
}

/* tan(alpha_crit) about the axis where rounding puts it, weight = 3 (2 A) being what the arms are
 * multiplied by. */
static void write_tangent(tp_derived_rounding *out, const tp_rounding *r, const fmpz_mpoly_q_t x,
                          const fmpz_mpoly_q_t y, const fmpz_mpoly_q_t weight,
                          const tp_field *field, tp_notation notation, bool *failed) {
  fmpz_mpoly_q_t along, up;
  fmpz_mpoly_q_init(along, field->ring);
  fmpz_mpoly_q_init(up, field->ring);
  tp_rounding_shift(along, up, r, field);
  tp_field_mul(along, along, weight, field);
  tp_field_mul(up, up, weight, field);
  tp_field_sub(along, x, along, field);
  tp_field_sub(up, y, up, field);
  out->tan_critical_angle = tp_notation_write_quotient(along, up, field, notation, failed);
  fmpz_mpoly_q_clear(along, field->ring);
  fmpz_mpoly_q_clear(up, field->ring);
}

static void write_length(tp_derived_rounding *out, const tp_rounding *r, const fmpz_mpoly_q_t x,
                         const fmpz_mpoly_q_t y, const fmpz_mpoly_q_t weight, const tp_field *field,
                         tp_notation notation, bool *failed) {
  fmpz_mpoly_q_t length, sine, cosine;
  fmpz_mpoly_q_init(length, field->ring);
  fmpz_mpoly_q_init(sine, field->ring);
  fmpz_mpoly_q_init(cosine, field->ring);
  fmpz_mpoly_q_gen(sine, tp_field_added(field, TANGENT), field->ring);
  fmpz_mpoly_q_one(cosine, field->ring); /* the quotient is the same for any multiple of both */
  tp_rounding_critical_length(length, r, x, y, sine, cosine, field);
  tp_field_div(length, length, weight, field);
  out->rounding_length = tp_notation_write(length, field, notation, failed);
  out->has_radius = r->upright_side;
  if (out->has_radius) {
    tp_rounding_radius(sine, r, length, field);
    out->corner_radius = tp_notation_write(sine, field, notation, failed);
  }
  fmpz_mpoly_q_clear(length, field->ring);
  fmpz_mpoly_q_clear(sine, field->ring);
  fmpz_mpoly_q_clear(cosine, field->ring);
}

tp_status tp_derive_rounding(tp_derived_rounding *out, const tp_model *model, const tp_case *own,
                             tp_notation notation, bool *failed, tp_message *message) {
  const tp_field *field = &model->symbols.field;
  const tp_rounding_symbols symbols = {tp_field_added(field, LENGTH), tp_field_added(field, SINE),
                                       tp_field_added(field, COSINE)};
  tp_symbolic_point pivot;
  tp_rounding rounding;
  tp_status status = tp_model_pivot(&pivot, model, own->toppling_pivot, message);
  if (status == TP_OK) {
    status =
        tp_rounding_init(&rounding, model, own->toppling_pivot, own->towards, &symbols, message);
  }
  if (status != TP_OK) return status;
  fmpz_mpoly_q_t x, y, weight;
  fmpz_t three;
  fmpz_mpoly_q_init(x, field->ring);
  fmpz_mpoly_q_init(y, field->ring);
  fmpz_mpoly_q_init(weight, field->ring);
  fmpz_init_set_ui(three, 3);
  tp_model_arms(x, y, model, &pivot, own->towards);
  fmpz_mpoly_q_mul_fmpz(weight, model->formulas.weighted2, three, field->ring);
  out->known = true;
  out->kind = own->pivots[own->toppling_pivot].kind;
  write_tangent(out, &rounding, x, y, weight, field, notation, failed);
  write_length(out, &rounding, x, y, weight, field, notation, failed);
  fmpz_mpoly_q_clear(x, field->ring);
  fmpz_mpoly_q_clear(y, field->ring);
  fmpz_mpoly_q_clear(weight, field->ring);
  fmpz_clear(three);
  tp_rounding_clear(&rounding, field);
  return TP_OK;
}
