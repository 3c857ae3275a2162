/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The modes in which a block can begin to move, in symbols: which there are is found at the scene's
 * values (motion/strata.h), and stays so while the signs do that are told here. */

#ifndef TP_DERIVE_ONSET_MODES_H
#define TP_DERIVE_ONSET_MODES_H

#include "derive/conditions.h"
#include "derive/onset_terms.h"
#include "motion/strata.h"

/* What spans the cone of loads of a mode: M r of a ray, or -e of an edge. */
typedef struct tp_onset_row {
  tp_vector_formulas row;
  tp_vector at; /* at the values */
  bool is_ray;
  long ray; /* or */
  long point;
  bool against; /* of the edge */
} tp_onset_row;

typedef struct tp_onset_mode {
  bool leaves;    /* its base: no rows; every normal line that bounds K opens */
  long row_count; /* planes that bound the cone are spanned by the first `spanning` */
  long spanning;
  tp_onset_row *rows;
} tp_onset_mode;

typedef struct tp_onset_modes {
  const tp_onset_terms *terms;
  tp_normals normals;
  tp_twists twists;
  long base_rays; /* those behind are of turning about points that stick on a face */
  long ray_count;
  tp_vector_formulas *rays;
  long count, room;
  tp_onset_mode *modes;
} tp_onset_modes;

/* As tp_onset_terms_init. The terms are borrowed. */
const char *tp_onset_modes_init(tp_onset_modes *modes, const tp_onset_terms *terms, bool *failed);
void tp_onset_modes_clear(tp_onset_modes *modes);

/* The signs on which it depends which modes there are. */
const char *tp_onset_modes_conditions(tp_conditions *conditions, const tp_onset_modes *modes);

/* The determinant of three rows: its sign, by identity or at the values. */
int tp_onset_rows_sign(const tp_onset_modes *modes, const tp_onset_row *a, const tp_onset_row *b,
                       const tp_onset_row *c);
void tp_onset_rows_determinant(fmpz_mpoly_q_t value, const tp_onset_modes *modes,
                               const tp_onset_row *a, const tp_onset_row *b, const tp_onset_row *c);

#endif
