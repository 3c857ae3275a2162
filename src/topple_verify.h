/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The public library's symbolic half: verdicts on printed formulas and numbers. Included by
 * topple.h. */

#ifndef TOPPLE_VERIFY_H
#define TOPPLE_VERIFY_H

#include "topple_solve.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum tp_verdict {
  TP_VERDICT_PROVEN,    /* an exact identity */
  TP_VERDICT_AGREES,    /* the printed digits are the rounding of the computed value; of a formula
                           that is not rational: equal to `digits` digits at `points` points */
  TP_VERDICT_TRUNCATED, /* the printed digits are the computed value cut off */
  TP_VERDICT_REFUTED,   /* a formula that differs */
  TP_VERDICT_DISAGREES, /* a number that differs */
  TP_VERDICT_UNDECIDED
} tp_verdict;

enum { TP_VERDICTS = TP_VERDICT_UNDECIDED + 1 };

const char *tp_verdict_name(tp_verdict verdict);

typedef struct tp_claim_result {
  TP_OUTSIDE char *id, *where, *geometry;            /* geometry NULL: none */
  TP_OUTSIDE char *quantity, *printed, *unit, *note; /* unit and note NULL: none */
  tp_verdict verdict;
  bool is_formula;
  /* The quantity in closed form, of its tangent if it is an angle, and, of a refuted formula,
   * printed minus derived, likewise; NULL: none. */
  TP_OUTSIDE char *derived, *difference;
  bool is_tangent;         /* derived and difference are of tangents of angles */
  TP_OUTSIDE char *mend;   /* the printed formula, mended by one change; NULL: none found */
  TP_OUTSIDE char *change; /* what the change is */
  /* What keeps the verdict from being more, or where a formula holds; NULL: none. */
  TP_OUTSIDE char *condition;
  bool has_values; /* numbers at `values`: what is printed, and what is derived */
  TP_OUTSIDE char *values;
  tp_bounded printed_value, computed;
  int digits, points; /* of a formula that agrees in numbers */
} tp_claim_result;

typedef struct tp_verification {
  TP_OUTSIDE char *title, *source; /* NULL: none */
  size_t count;
  tp_claim_result *claims;
  size_t tally[TP_VERDICTS];
} tp_verification;

/* Verdicts on the claims of a file. */
TP_MUST_USE tp_status tp_verify(tp_verification **verification, const char *path,
                                tp_message *message);
/* The same from text in memory; `name` is what messages call it, and the scenes that the claims
 * name are looked for beside a file of that name. */
TP_MUST_USE tp_status tp_verify_text(tp_verification **verification, const char *text,
                                     const char *name, tp_message *message);
void tp_verification_free(tp_verification *verification);

/* Is anything refuted, or does it disagree? */
bool tp_verification_objects(const tp_verification *verification);

TP_MUST_USE tp_status tp_report_verification(char **text, const tp_verification *verification);
TP_MUST_USE tp_status tp_report_verification_json(char **text, const tp_verification *verification);
TP_MUST_USE tp_status tp_report_verification_markdown(char **text,
                                                      const tp_verification *verification);

#ifdef __cplusplus
}
#endif

#endif
