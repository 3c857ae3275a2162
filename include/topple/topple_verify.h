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

/* What is said of a claim. */
typedef enum tp_verdict {
  TP_VERDICT_PROVEN,    /* an exact identity */
  TP_VERDICT_AGREES,    /* the printed digits are the rounding of the computed value; of a formula
                           that is not rational: equal to `digits` digits at `points` points */
  TP_VERDICT_TRUNCATED, /* the printed digits are the computed value cut off */
  TP_VERDICT_REFUTED,   /* a formula that differs */
  TP_VERDICT_DISAGREES, /* a number that differs */
  TP_VERDICT_UNDECIDED
} tp_verdict;

/* How many there are. */
enum { TP_VERDICTS = TP_VERDICT_UNDECIDED + 1 };

/* proven, agrees, truncated, refuted, disagrees or undecided. */
const char *tp_verdict_name(tp_verdict verdict);

/* A claim, its texts as its file has them, and the verdict on it. */
typedef struct tp_claim_result {
  TP_OUTSIDE char *id;         /* its name */
  TP_OUTSIDE char *where;      /* where it is printed */
  TP_OUTSIDE char *geometry;   /* of which scene it is; NULL: none */
  TP_OUTSIDE char *quantity;   /* what it is of */
  TP_OUTSIDE char *printed;    /* what is printed */
  TP_OUTSIDE char *unit;       /* of a number; NULL: none */
  TP_OUTSIDE char *note;       /* on the claim; NULL: none */
  tp_verdict verdict;          /* on what is printed */
  bool is_formula;             /* else a number */
  TP_OUTSIDE char *computed;   /* the quantity in closed form; NULL: none */
  TP_OUTSIDE char *difference; /* of a refuted formula, printed minus computed; NULL: none */
  bool of_tangents;            /* computed and difference are of tangents of angles */
  TP_OUTSIDE char *mend;       /* the printed formula, mended by one change; NULL: none found */
  TP_OUTSIDE char *change;     /* what the change is; NULL: likewise */
  TP_OUTSIDE char *condition;  /* what keeps the verdict from being more, or where a formula holds;
                                  NULL: none */
  bool has_values;             /* there are numbers at */
  TP_OUTSIDE char *at;         /* these values of the symbols: */
  tp_bounded printed_there,
      computed_there; /* if has_values: of what is printed, and of what is computed */
  int digits, points; /* of a formula that agrees in numbers */
} tp_claim_result;

/* The verdicts on a file of claims. */
typedef struct tp_verification {
  size_t size;                     /* of this struct, as the library has it (TP_HAS_MEMBER) */
  TP_OUTSIDE char *title, *source; /* of the file; NULL: none */
  size_t count;                    /* of the claims */
  tp_claim_result *claims;         /* in the order of the file */
  size_t tally[TP_VERDICTS];       /* by verdict: how many have it */
} tp_verification;

/* Verdicts on the claims of the file `path` (docs/verify.md). A claim that is refuted, or not
 * decided, is a verdict, and the status TP_OK. TP_NO_ANSWER where a scene has no such formula;
 * TP_DEPENDENCY_FAILED. */
TP_MUST_USE tp_status tp_verify(tp_verification **verification, const char *path,
                                tp_message *message);

/* The same from text in memory; `name` is what messages call it, and the scenes that the claims
 * name are looked for beside a file of that name. */
TP_MUST_USE tp_status tp_verify_text(tp_verification **verification, const char *text,
                                     const char *name, tp_message *message);

/* Free it with all that it points to; NULL is allowed. */
void tp_verification_free(tp_verification *verification);

/* Is any claim refuted, or in disagreement? */
bool tp_verification_objects(const tp_verification *verification);

/* The verdicts as a page, as JSON and as a table in Markdown. `*text` is allocated with malloc and
 * is the caller's to free. */
TP_MUST_USE tp_status tp_report_verification(char **text, const tp_verification *verification);
TP_MUST_USE tp_status tp_report_verification_json(char **text, const tp_verification *verification);
TP_MUST_USE tp_status tp_report_verification_markdown(char **text,
                                                      const tp_verification *verification);

#ifdef __cplusplus
}
#endif

#endif
