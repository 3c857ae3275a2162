/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Of bolts at a spacing a force per metre; and the design: the least force, rounded up to as few
 * digits as leave it within the stretch over which the result is at least the wanted value. The
 * scene is solved with it, and the result there is certain to be above, as is the factor that
 * governs: a force that suffices against one motion is no design while another needs more. */

#include "back_analysis/find_support.h"

#include "common/message.h"
#include "scene/anchor.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The entry of a list that the key names, from 1; 0 where it is not `list`N`end`. */
static long entry_of(const char *key, const char *list, const char *end) {
  char *rest = NULL;
  if (strncmp(key, list, strlen(list)) != 0) return 0;
  const long number = strtol(key + strlen(list), &rest, 10);
  return number >= 1 && strcmp(rest, end) == 0 ? number : 0;
}

/* The bolts whose force is looked for; NULL: it is another number. */
static const tp_anchor_description *found_bolts(const tp_search *s) {
  const tp_loads_description *loads = &s->varied.scene->loads;
  const long number = entry_of(s->options->key, "loads.anchors.", ".force_kn");
  return number >= 1 && number <= loads->anchor_count ? loads->anchors + (number - 1) : NULL;
}

/* A force of bolts at a spacing: what that is per metre, of all rows. */
void tp_search_per_metre(tp_search *s) {
  tp_found *found = s->found;
  const tp_anchor_description *bolts = found_bolts(s);
  if (bolts == NULL || !bolts->spacing.given || found->count == 0) return;
  found->per_metre_kn = calloc(found->count, sizeof *found->per_metre_kn);
  if (found->per_metre_kn == NULL) {
    s->status = tp_fail_memory(s->message, "the solutions");
    return;
  }
  fmpq_t rows;
  fmpq_init(rows);
  fmpq_mul(rows, bolts->spacing.value, s->varied.scene->metres_per_unit);
  fmpq_inv(rows, rows);
  fmpq_mul_si(rows, rows, tp_anchor_rows(bolts));
  const double factor = fmpq_get_d(rows);
  fmpq_clear(rows);
  for (size_t k = 0; k < found->count; k++) {
    const tp_bounded own = found->solutions[k];
    found->per_metre_kn[k] =
        (tp_bounded){.value = factor * own.value,
                     .error = factor * (own.error * (1 + 0x1p-50) + fabs(own.value) * 0x1p-50)};
  }
}

static bool is_support(const char *key) {
  return entry_of(key, "loads.anchors.", ".force_kn") > 0 ||
         entry_of(key, "loads.forces.", ".force_kn") > 0 ||
         entry_of(key, "loads.support_pressures.", ".kpa") > 0;
}

/* Not less than the number, with so many digits. */
static double round_up(double number, int digits) {
  const double unit = pow(10, floor(log10(number)) + 1 - digits);
  const double up = unit * ceil(number / unit);
  return up < number ? number : up;
}

/* Are the result and the governing factor certain to be above the wanted value? */
static bool is_enough(const tp_search *s, const tp_sample *at) {
  const tp_fos *g = &at->governing;
  if (!at->known || at->is_bound || tp_search_side(at) <= 0) return false;
  if (s->of_many || s->options->target == TP_FIND_GOVERNING_FOS ||
      g->state == TP_FOS_NO_OVERTURNING)
    return true;
  return g->state == TP_FOS_NUMBER && g->value.value - g->value.error >= s->options->value;
}

void tp_search_design(tp_search *s) {
  enum { FEWEST_DIGITS = 4, MOST_DIGITS = 15 };
  tp_found *f = s->found;
  f->is_support = tp_find_target_is_factor(s->options->target) && is_support(s->options->key);
  if (!f->is_support) return;
  if (f->at_least_count == 0 || !f->at_least[0].begins || !(f->at_least[0].low > 0)) return;
  const tp_found_stretch stretch = f->at_least[0];
  for (int k = FEWEST_DIGITS; k <= MOST_DIGITS && s->status == TP_OK; k++) {
    const double force = round_up(stretch.low, k);
    if (force > stretch.high) continue;
    const tp_sample at = tp_search_sample(s, force);
    if (!is_enough(s, &at)) continue;
    f->has_design = true;
    f->design = force;
    f->design_result = at.result;
    return;
  }
}
