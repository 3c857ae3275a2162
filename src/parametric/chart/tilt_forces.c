/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sorted list of facets with their largest reaction, colours for those that bear most, and forces
 * by moment up to the end of the bracket. */

#include "chart/tilt_forces.h"

#include <math.h>
#include <stdlib.h>

/* ---- the facets --------------------------------------------------------------------------------
 */

size_t tp_force_facets_find(const tp_force_facets *d, long number) {
  size_t low = 0, high = d->count;
  while (low < high) {
    const size_t middle = (low + high) / 2;
    if (d->items[middle].number < number) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

/* Where its number belongs. */
static void add_facet(tp_force_facets *d, tp_force_facet own) {
  const size_t at = tp_force_facets_find(d, own.number);
  if (at < d->count && d->items[at].number == own.number) return;
  for (size_t k = d->count; k > at; k--) d->items[k] = d->items[k - 1];
  d->items[at] = own;
  d->count++;
}

static bool collect(tp_force_facets *d) {
  size_t room = 1; /* an end face */
  for (size_t c = 0; c < d->test->case_count; c++) room += d->test->cases[c].facet_count;
  d->items = calloc(room, sizeof *d->items);
  if (d->items == NULL) return false;
  for (size_t c = 0; c < d->test->case_count; c++) {
    const tp_tilt_case *own = d->test->cases + c;
    for (size_t k = 0; k < own->facet_count; k++) {
      const tp_tilt_facet *f = own->facets + k;
      add_facet(
          d, (tp_force_facet){.number = f->facet, .colour = -1, .x0_m = f->x0_m, .x1_m = f->x1_m});
    }
    for (size_t k = 0; k < own->reaction_count; k++) {
      const tp_tilt_reaction *r = own->reactions + k;
      if (r->facet == 0) add_facet(d, (tp_force_facet){.number = 0, .colour = -1});
      tp_force_facet *f = d->items + tp_force_facets_find(d, r->facet);
      f->most_n = fmax(f->most_n, r->normal_n);
    }
  }
  return true;
}

/* Those that bear most, coloured from left to right. */
static void colour(tp_force_facets *d) {
  for (int k = 0; k < TP_FACETS_COLOURED; k++) {
    tp_force_facet *most = NULL;
    for (size_t j = 0; j < d->count; j++) {
      tp_force_facet *f = d->items + j;
      if (f->colour < 0 && f->most_n > 0 && (most == NULL || f->most_n > most->most_n)) most = f;
    }
    if (most != NULL) most->colour = 0;
  }
  int next = 0;
  for (size_t j = 0; j < d->count; j++) {
    if (d->items[j].colour == 0) d->items[j].colour = next++;
    d->has_others = d->has_others || (d->items[j].colour < 0 && d->items[j].most_n > 0);
  }
}

bool tp_force_facets_init(tp_force_facets *d, const tp_tilt_test *test) {
  const tp_tilt_settings *s = &test->settings;
  *d = (tp_force_facets){.test = test,
                         .by_tilt = s->engine == TP_TILT_PATH || s->protocol == TP_TILT_RAMP};
  if (!collect(d)) return false;
  colour(d);
  return true;
}

void tp_force_facets_clear(tp_force_facets *d) {
  free(d->items);
}

/* ---- the moments -------------------------------------------------------------------------------
 */

size_t tp_tilt_forces_shown(const tp_force_facets *d, const tp_tilt_case *own) {
  if (!d->by_tilt || !own->has_bracket) return own->moment_count;
  size_t count = 0;
  while (count < own->moment_count && own->moments[count].angle_deg < own->lets_go_at_deg) count++;
  return count;
}

double tp_tilt_forces_at(const tp_tilt_forces *f, size_t moment) {
  const tp_tilt_moment *m = f->own->moments + moment;
  return f->by_tilt ? m->angle_deg : m->time_s;
}

void tp_tilt_forces_clear(tp_tilt_forces *f) {
  for (int k = 0; k < TP_FORCES; k++) free(f->of[k]);
}

/* A facet that is not told of at a moment bears nothing. */
bool tp_tilt_forces_init(tp_tilt_forces *f, const tp_force_facets *d, const tp_tilt_case *own) {
  *f = (tp_tilt_forces){.own = own, .by_tilt = d->by_tilt, .count = tp_tilt_forces_shown(d, own)};
  for (int k = 0; k < TP_FORCES; k++) {
    f->of[k] = calloc(f->count * d->count + 1, sizeof *f->of[k]);
  }
  if (f->of[0] == NULL || f->of[1] == NULL) {
    tp_tilt_forces_clear(f);
    return false;
  }
  for (size_t k = 0; k < own->reaction_count; k++) {
    const tp_tilt_reaction *r = own->reactions + k;
    if (r->moment >= f->count) break;
    const size_t place = tp_force_facets_find(d, r->facet) * f->count + r->moment;
    f->of[0][place] = r->normal_n;
    f->of[1][place] = r->shear_n;
  }
  return true;
}
