/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Releases the memory of a derivation. */

#include "common/notes.h"
#include "derive/derive_limit.h"
#include "derive/derive_onset.h"
#include "derive/derive_rounding.h"
#include "derive/notation.h"

#include <stdlib.h>

static void free_pivot(tp_derived_pivot *p) {
  tp_fraction *fractions[] = {&p->x,
                              &p->y,
                              &p->tan_critical_angle,
                              &p->fos_cot,
                              &p->fos_constant,
                              &p->stabilising_cos,
                              &p->stabilising_sin,
                              &p->overturning_cos,
                              &p->overturning_sin};
  for (size_t k = 0; k < sizeof fractions / sizeof fractions[0]; k++)
    tp_notation_free(fractions[k]);
}

void tp_derivation_free(tp_derivation *derivation) {
  if (derivation == NULL) return;
  free(derivation->title);
  tp_notation_free(&derivation->area);
  tp_notation_free(&derivation->x_moment);
  tp_notation_free(&derivation->y_moment);
  for (size_t k = 0; k < derivation->symbol_count; k++) {
    free(derivation->symbols[k]);
    free(derivation->parameters[k]);
  }
  free(derivation->symbols);
  free(derivation->parameters);
  for (size_t k = 0; k < derivation->pivot_count; k++) free_pivot(derivation->pivots + k);
  free(derivation->pivots);
  for (int d = 0; d < 2; d++) {
    tp_derived_rounding_free(derivation->rounded + d);
    tp_derived_limit_free(derivation->limit + d);
    tp_derived_onset_free(derivation->onset + d);
    for (size_t k = 0; derivation->elements[d] != NULL && k < derivation->element_count; k++) {
      tp_notation_free(&derivation->elements[d][k].area);
      tp_notation_free(&derivation->elements[d][k].normal_arm);
      tp_notation_free(&derivation->elements[d][k].parallel_arm);
    }
    free(derivation->elements[d]);
  }
  tp_notes_clear(&derivation->notes);
  free(derivation);
}
