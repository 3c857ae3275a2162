/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Distribution of a variable as words, with its truncation. */

#include "study/law.h"

#include "output/text.h"

#include <math.h>

static void add_ends(tp_text *t, const tp_distribution *d) {
  if (!d->truncated) return;
  if (isfinite(d->truncated_low) && isfinite(d->truncated_high)) {
    tp_text_add(t, ", between %.6g and %.6g", d->truncated_low, d->truncated_high);
  } else if (isfinite(d->truncated_low)) {
    tp_text_add(t, ", above %.6g", d->truncated_low);
  } else if (isfinite(d->truncated_high)) {
    tp_text_add(t, ", below %.6g", d->truncated_high);
  }
}

static void add_distribution(tp_text *t, const tp_distribution *d) {
  switch (d->kind) {
  case TP_DISTRIBUTION_UNIFORM:
    tp_text_add(t, "%.6g to %.6g", d->low, d->high);
    break;
  case TP_DISTRIBUTION_NORMAL:
  case TP_DISTRIBUTION_LOGNORMAL:
    tp_text_add(t, "mean %.6g, deviation %.6g", d->mean, d->deviation);
    break;
  case TP_DISTRIBUTION_TRIANGULAR:
    tp_text_add(t, "%.6g to %.6g, mode %.6g", d->low, d->high, d->mode);
    break;
  case TP_DISTRIBUTION_BETA:
    tp_text_add(t, "a %.6g, b %.6g, %.6g to %.6g", d->a, d->b, d->low, d->high);
    break;
  case TP_DISTRIBUTION_LIST:
  case TP_DISTRIBUTION_EMPIRICAL:
    tp_text_add(t, "%zu numbers", d->count);
    break;
  }
  add_ends(t, d);
}

char *tp_study_law(const tp_variable *variable) {
  tp_text t = {0};
  char *law = NULL;
  if (variable->source == TP_VARIABLE_DRAWN) {
    add_distribution(&t, &variable->distribution);
  } else {
    tp_text_add(&t, "%zu numbers", variable->count);
  }
  return tp_text_finish(&t, &law) == TP_OK ? law : NULL;
}
