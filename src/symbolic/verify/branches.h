/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Signs of what roots and magnitudes are taken of.
 *
 * The root of a square p^2 is p or -p, and so is the magnitude of p. Where p keeps its sign on the
 * domain there is one branch. Where that is not known, a formula has a value for each choice of
 * signs, and an identity is one only if it is one in every branch: they are gone through one by
 * one, the last sign turned first, since what is met later may depend on what is met before. */

#ifndef TP_VERIFY_BRANCHES_H
#define TP_VERIFY_BRANCHES_H

#include "verify/domain.h"

enum { TP_MOST_BRANCH_SIGNS = 8, TP_MOST_BRANCHES = 64, TP_MOST_DIVISORS = 64 };

typedef struct tp_branch_sign {
  fmpz_mpoly_q_t of;
  int sign;
  bool turned; /* from the sign at the sample */
} tp_branch_sign;

struct tp_branches {
  tp_subject *subject;
  const tp_claim_sample *sample; /* whose branch comes first */
  bool only_sample;              /* formulas are evaluated at the sample alone */
  bool too_many;
  long count;
  tp_branch_sign items[TP_MOST_BRANCH_SIGNS];
  bool gathers_divisors;
  long divisor_count; /* of what may be zero within the domain */
  fmpz_mpoly_q_t divisors[TP_MOST_DIVISORS];
};

void tp_branches_init(tp_branches *branches, tp_subject *subject, const tp_claim_sample *sample);
void tp_branches_clear(tp_branches *branches);

/* The sign to take for a formula, 0 where none may be taken. */
int tp_branches_sign(const fmpz_mpoly_q_t of, tp_subject *subject);

/* Note that something is divided by a formula. */
void tp_branches_divide(const fmpz_mpoly_q_t by, tp_subject *subject);

/* Turn to the next branch; false after the last. */
bool tp_branches_next(tp_branches *branches);

/* Use these branches, or with NULL only roots whose sign is known, in all that is evaluated from
 * now on: definitions are evaluated anew. */
void tp_branches_use(tp_branches *branches, tp_subject *subject);

#endif
