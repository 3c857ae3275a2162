/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The field in which formulas are derived: rational functions over the rationals in the scene's
 * parameters, always in lowest terms (Calcium's fmpz_mpoly_q, later part of FLINT; included here
 * alone).
 *
 * A parameter that the scene gives by a number is a symbol; one that it gives by an expression in
 * others stands for that expression. */

#ifndef TP_FIELD_H
#define TP_FIELD_H

#include "scene/scene.h"

#include <calcium/fmpz_mpoly_q.h>

typedef struct tp_field {
  fmpz_mpoly_ctx_t ring;
  const tp_parameters *parameters; /* of the scene: names and values */
  long symbol_count;               /* the parameters, and one more for a count */
  const char **names;              /* of the symbols; the last is N, or n where N is taken */
  long known;                      /* parameters read so far */
  fmpz_mpoly_q_struct *values;     /* symbol or expression of each */
} tp_field;

/* Products of more terms than this are not formed; a coordinate may have fewer still. */
enum { TP_FIELD_TERMS = 200000, TP_FIELD_COORDINATE_TERMS = 64 };

TP_MUST_USE tp_status tp_field_init(tp_field *field, const tp_scene *scene, tp_message *message);
void tp_field_clear(tp_field *field);

/* The expression of a scalar node as a rational function. */
TP_MUST_USE tp_status tp_field_read(fmpz_mpoly_q_t value, const tp_field *field,
                                    const tp_node *node, const tp_scene *scene,
                                    tp_message *message);

/* Names of the parameters that are symbols, allocated with malloc like each of them; their number.
 * NULL when memory is exhausted. */
size_t tp_field_list_symbols(char ***names, const tp_field *field);

/* The symbol that stands for a count. */
void tp_field_count_symbol(fmpz_mpoly_q_t value, const tp_field *field);

/* Its exact value at the scene's parameters; false where the denominator vanishes there.
 * The count symbol has no value and must not occur. */
bool tp_field_evaluate(fmpq_t value, const fmpz_mpoly_q_t formula, const tp_field *field);

#endif
