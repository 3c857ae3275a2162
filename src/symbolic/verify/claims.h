/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A claims file as it is written: geometries, names, and claims, the cells of tables among them. */

#ifndef TP_VERIFY_CLAIMS_H
#define TP_VERIFY_CLAIMS_H

#include "verify/domain.h"
#include "verify/subject_init.h"

/* A block that claims are about. */
typedef struct tp_geometry {
  const char *name;
  tp_place place;
  char *scene; /* path */
  tp_subject_options options;
} tp_geometry;

/* What is printed about a quantity. Of the cell of a table `with` and `at` come from its column and
 * its row. */
typedef struct tp_claim {
  char *id;
  const char *where, *unit, *note; /* NULL: none */
  const tp_geometry *geometry;     /* NULL: none */
  const tp_node *printed, *quantity;
  const tp_node *with[2], *at[2], *domain[2];
} tp_claim;

typedef struct tp_claims {
  char *path;
  tp_node *root;
  const char *title, *source;
  long declared_count;
  tp_declared *declared;
  fmpq *declared_values;
  const tp_node *with, *domain; /* for all claims; NULL: none */
  long geometry_count;
  tp_geometry *geometries;
  long claim_count, claim_capacity;
  tp_claim *claims;
} tp_claims;

/* From the file `path`, or from `text` where that is not NULL; `path` is then its name. On failure
 * `claims` is cleared. */
TP_MUST_USE tp_status tp_claims_read(tp_claims *claims, const char *path, const char *text,
                                     tp_message *message);
void tp_claims_clear(tp_claims *claims);

/* The claims under `claims:`, by claims_list.c. */
TP_MUST_USE tp_status tp_claims_read_list(tp_claims *claims, const tp_node *list,
                                          tp_message *message);

/* Bound a domain as a `domain` says, NULL: nothing; names that the subject does not have are left
 * out unless `all_names` are to be known. */
TP_MUST_USE tp_status tp_claims_read_domain(tp_domain *domain, const tp_claims *claims,
                                            const tp_node *node, bool all_names,
                                            tp_subject *subject, const tp_claim_sample *sample,
                                            tp_message *message);

/* Fail at a node of the file. */
tp_status tp_claims_fail(const tp_claims *claims, const tp_node *node, tp_message *message,
                         const char *format, ...) __attribute__((format(printf, 4, 5)));

/* The text of a scalar child; NULL where it is missing and may be. */
TP_MUST_USE tp_status tp_claims_text(const char **text, const tp_claims *claims,
                                     const tp_node *mapping, const char *key, bool needed,
                                     tp_message *message);

#endif
