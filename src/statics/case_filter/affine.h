/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Numbers of a scene as affine functions of those that vary, exactly: c_0 + sum c_k v_k. Formulas
 * that multiply or divide by what varies are none. */

#ifndef TP_CASE_FILTER_AFFINE_H
#define TP_CASE_FILTER_AFFINE_H

#include "scene_varying/vary.h"

enum { TP_AFFINE_VARIABLES = 8 };

typedef struct tp_affine {
  fmpq of[TP_AFFINE_VARIABLES + 1]; /* c_0, then c_k */
} tp_affine;

void tp_affine_init(tp_affine *affine);
void tp_affine_clear(tp_affine *affine);
bool tp_affine_is_constant(const tp_affine *affine);
bool tp_affine_equal(const tp_affine *a, const tp_affine *b);
void tp_affine_sub(tp_affine *rest, const tp_affine *a, const tp_affine *b);
void tp_affine_add(tp_affine *sum, const tp_affine *a, const tp_affine *b);
void tp_affine_value(fmpq_t value, const tp_affine *affine, const fmpq *variables);

/* A scene of a file whose numbers at so many keys vary, the parameters as functions of these. */
typedef struct tp_affine_scene {
  const tp_scene *scene;
  const tp_scene_key *keys;
  size_t count;
  tp_affine *parameters; /* scene->parameters.count; NULL: one is no affine function */
} tp_affine_scene;

/* False when memory is exhausted. */
TP_MUST_USE bool tp_affine_scene_init(tp_affine_scene *affine, const tp_scene *scene,
                                      const tp_scene_key *keys, size_t count);
void tp_affine_scene_clear(tp_affine_scene *affine);

/* The number at a node; false where it is no affine function, or no number. */
bool tp_affine_read(tp_affine *value, const tp_affine_scene *affine, const tp_node *node);

/* Does any number at the node or within it depend on what varies, or stay open? */
bool tp_affine_depends(const tp_affine_scene *affine, const tp_node *node);

#endif
