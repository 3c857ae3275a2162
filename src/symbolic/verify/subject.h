/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a claim is about: a block with its pivot, and the names that formulas about it may use.
 *
 * A name stands for a rational function of the field, for an angle that is a symbol (with its sine
 * and cosine as symbols of their own, sin^2 + cos^2 = 1 between them), for the angle of a direction
 * that is derived (the critical angle), or for a formula that the claims file defines. Derived
 * quantities are computed when first asked for. */

#ifndef TP_VERIFY_SUBJECT_H
#define TP_VERIFY_SUBJECT_H

#include "derive/family.h"
#include "derive/rounding.h"
#include "formula/formula.h"

typedef enum tp_name_kind {
  TP_NAME_FORMULA,   /* `value` */
  TP_NAME_ANGLE,     /* a symbol, in degrees */
  TP_NAME_DIRECTION, /* atan2(value, run), in degrees */
  TP_NAME_DEFINITION /* `definition` */
} tp_name_kind;

typedef struct tp_subject tp_subject;
typedef struct tp_domain tp_domain;     /* domain.h */
typedef struct tp_branches tp_branches; /* branches.h */

/* Set a derived quantity: value, and run where it is a direction. */
typedef tp_status (*tp_quantity_rule)(fmpz_mpoly_q_t value, fmpz_mpoly_q_t run, tp_subject *subject,
                                      tp_message *message);

typedef struct tp_name {
  char *text;
  tp_name_kind kind;
  bool ready;            /* value and run are computed */
  bool rational;         /* of a definition that is ready: it has a value */
  tp_quantity_rule rule; /* of a derived quantity */
  fmpz_mpoly_q_t value, run;
  long angle;            /* of a TP_NAME_ANGLE */
  tp_formula definition; /* of a TP_NAME_DEFINITION; reads the names before it */
  int *used;             /* of a definition: the symbols that it depends on */
} tp_name;

/* An angle and its sine and cosine, by their indices among the field's symbols. */
typedef struct tp_angle {
  long degrees, sine, cosine;
} tp_angle;

typedef enum tp_members { TP_MEMBERS_ONE, TP_MEMBERS_EVEN, TP_MEMBERS_ODD } tp_members;

struct tp_subject {
  tp_scene *scene;
  tp_model model; /* where there is one block */
  bool has_model;
  tp_symbols own; /* where there is none, or all N: of which only the field is used */
  const tp_field *field;
  const tp_case *at; /* the case of the direction of tilt */
  tp_direction towards;
  size_t pivot;
  bool rounded;
  tp_members members;
  char **symbol_names; /* added to the field's */
  long symbol_count;
  long angle_count;
  tp_angle *angles;   /* alpha and i, then the declared ones */
  fmpz_mpoly_t *ones; /* sin^2 + cos^2 - 1 of each */
  long weight_count, first_weight;
  long length, mend; /* symbols: of rounding; an unknown number */
  bool *given;       /* by symbol: it has a value */
  fmpq *values;
  long name_count, name_capacity, permanent; /* names that are the subject's own */
  tp_name *names;
  tp_domain *domain;     /* of the claim in hand */
  tp_branches *branches; /* of its roots and magnitudes; NULL: none are taken */
};

enum { TP_ANGLE_ALPHA, TP_ANGLE_I, TP_OWN_ANGLES };

void tp_subject_clear(tp_subject *subject);

/* The number of a name, or -1. */
long tp_subject_find(const tp_subject *subject, const char *name, size_t length);

/* A formula as papers print them, in the subject's names. */
TP_MUST_USE tp_status tp_subject_read(tp_formula *formula, const char *text, tp_place place,
                                      const tp_subject *subject, tp_message *message);

/* Add a name of the given kind; NULL when memory is exhausted. */
tp_name *tp_subject_add_name(tp_subject *subject, const char *text, tp_name_kind kind);

/* Add, and take away, names that hold for one claim. */
TP_MUST_USE tp_status tp_subject_define(tp_subject *subject, const char *name, const char *text,
                                        tp_place place, tp_message *message);
void tp_subject_forget(tp_subject *subject);

/* The name with its value computed. */
TP_MUST_USE tp_status tp_subject_name(const tp_name **name, tp_subject *subject, long index,
                                      tp_message *message);

/* Complain that this block does not have a quantity. */
tp_status tp_subject_lacks(const tp_subject *subject, tp_message *message, const char *problem);

/* Bring a formula to its normal form under sin^2 + cos^2 = 1. */
void tp_subject_reduce(fmpz_mpoly_q_t formula, const tp_subject *subject);

/* Mark the field's symbols that a formula depends on. */
TP_MUST_USE tp_status tp_subject_used(int *used, const tp_formula *formula, tp_subject *subject,
                                      tp_message *message);

/* The polynomials `ones`, once the angles are in place; false when memory is exhausted. */
TP_MUST_USE bool tp_subject_init_ones(tp_subject *subject);

#endif
