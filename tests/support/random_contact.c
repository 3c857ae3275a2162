/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "random_contact.h"

#include <stdlib.h>

static long largest(const polygon *p) {
  long most = 0;
  for (long k = 0; k < p->count; k++) {
    most = labs(p->x[k]) > most ? labs(p->x[k]) : most;
    most = labs(p->y[k]) > most ? labs(p->y[k]) : most;
  }
  return most;
}

void random_contact_draw_kinks(random_scene *s, random_numbers *state) {
  enum { MOST = 1 << 20 }; /* twice 2^41 times as large it still is a long */
  const int shift = 6 + (int)draw_below(state, 36);
  if (largest(&s->outline) > MOST || largest(&s->profile) > MOST) return;
  polygon *rings[] = {&s->outline, &s->profile, &s->hole, &s->part};
  for (int r = 0; r < 4; r++) {
    for (long k = 0; k < rings[r]->count; k++) {
      rings[r]->x[k] *= 1L << shift;
      rings[r]->y[k] *= 1L << shift;
    }
  }
  fmpq_div_2exp(s->numbers + XX, s->numbers + XX, (ulong)shift);
  fmpq_div_2exp(s->numbers + YX, s->numbers + YX, (ulong)shift);
  fmpq_div_2exp(s->numbers + YY, s->numbers + YY, (ulong)shift);
  polygon *o = &s->outline, *p = &s->profile;
  for (long k = 1; k + 1 < o->count && o->x[k] > o->x[k - 1] && o->x[k + 1] > o->x[k]; k++) {
    const long by = draw_signed(state, 1);
    for (long i = 0; i < p->count; i++) {
      if (p->x[i] == o->x[k] && p->y[i] == o->y[k]) p->y[i] += by;
    }
    o->y[k] += by;
  }
}

void random_contact_draw_wall(random_scene *s, random_numbers *state) {
  polygon *p = &s->profile;
  if (p->count == 0 || p->count + 2 >= POLYGON_MOST) return;
  const long off = GRAIN * draw_below(state, 4), up = GRAIN * (1 + draw_below(state, 12));
  if (draw_once_in(state, 2)) {
    polygon_add(p, p->x[p->count - 1] + off, p->y[p->count - 1] + up);
    polygon_add(p, p->x[p->count - 1] + GRAIN, p->y[p->count - 1]);
    return;
  }
  const polygon old = *p;
  p->count = 0;
  polygon_add(p, old.x[0] - off - GRAIN, old.y[0] + up);
  polygon_add(p, old.x[0] - off, old.y[0] + up);
  for (long k = 0; k < old.count; k++) polygon_add(p, old.x[k], old.y[k]);
}
