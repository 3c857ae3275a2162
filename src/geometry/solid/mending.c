/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Arrays that grow, and shrink to what is kept. */

#include "solid/mending.h"

#include <stdlib.h>
#include <string.h>

bool tp_mending_reserve(tp_mending *m, long more) {
  if (m->count + more <= m->room) return true;
  const size_t room = (size_t)(m->count + m->count / 8 + more);
  int *triangles = realloc(m->triangles, 3 * room * sizeof *triangles);
  if (triangles != NULL) m->triangles = triangles;
  int *faces = realloc(m->faces, room * sizeof *faces);
  if (faces != NULL) m->faces = faces;
  bool *turned = realloc(m->turned, room * sizeof *turned);
  if (turned != NULL) m->turned = turned;
  if (triangles == NULL || faces == NULL || turned == NULL) return false;
  m->room = (long)room;
  return true;
}

void tp_mending_add(tp_mending *m, int a, int b, int c, int face) {
  int *own = m->triangles + 3 * m->count;
  own[0] = a;
  own[1] = b;
  own[2] = c;
  m->turned[m->count] = false;
  m->faces[m->count++] = face;
}

void tp_mending_keep(tp_mending *m, const bool *dropped) {
  long kept = 0;
  for (long t = 0; t < m->count; t++) {
    if (dropped[t]) continue;
    memmove(m->triangles + 3 * kept, m->triangles + 3 * t, 3 * sizeof *m->triangles);
    m->faces[kept] = m->faces[t];
    m->turned[kept++] = m->turned[t];
  }
  m->count = kept;
}

long tp_mending_number(const tp_mending *m, long triangle) {
  const int face = m->faces[triangle];
  return face < 0 ? face : m->surface->mesh->faces[face].number;
}

double tp_mending_step(const tp_surface *s) {
  slong exponent = 0;
  const double mantissa = fmpz_get_d_2exp(&exponent, s->divisor);
  return ldexp(1 / mantissa, (int)(s->exponent - exponent));
}
