/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Force and moment of pressures along lines, in rationals, by the formulas of load/wetted.h. */

#include "load/wet_lines.h"

#include <stdlib.h>

/* Of one line, in metres. */
static void add_line(fmpq_t fx, fmpq_t fy, fmpq_t moment, const tp_line_load *line,
                     const fmpq_t metres) {
  fmpq_t dx, dy, x, y, mean, along, work;
  fmpq *const all[] = {dx, dy, x, y, mean, along, work};
  for (int k = 0; k < 7; k++) fmpq_init(all[k]);
  fmpq_mul(x, line->x0.value, metres);
  fmpq_mul(y, line->y0.value, metres);
  fmpq_mul(dx, line->x1.value, metres);
  fmpq_mul(dy, line->y1.value, metres);
  fmpq_sub(dx, dx, x);
  fmpq_sub(dy, dy, y);
  fmpq_add(mean, line->first_kpa.value, line->last_kpa.value);
  fmpq_div_2exp(mean, mean, 1);
  fmpq_submul(fx, mean, dy);
  fmpq_addmul(fy, mean, dx);
  fmpq_mul(along, x, dx);
  fmpq_addmul(along, y, dy);
  fmpq_addmul(moment, along, mean);
  fmpq_mul_si(work, line->last_kpa.value, 2);
  fmpq_add(work, work, line->first_kpa.value);
  fmpq_div_fmpz(work, work, (const fmpz[]){6});
  fmpq_mul(along, dx, dx);
  fmpq_addmul(along, dy, dy);
  fmpq_addmul(moment, along, work);
  for (int k = 0; k < 7; k++) fmpq_clear(all[k]);
}

void tp_wet_lines_sum(fmpq_t fx, fmpq_t fy, fmpq_t moment, const tp_wet_lines *lines,
                      const fmpq_t metres_per_unit, bool mirrored) {
  fmpq_zero(fx);
  fmpq_zero(fy);
  fmpq_zero(moment);
  for (long k = 0; k < lines->count; k++) {
    add_line(fx, fy, moment, lines->items + k, metres_per_unit);
  }
  if (!mirrored) return;
  fmpq_neg(fx, fx);
  fmpq_neg(moment, moment);
}

tp_line_load *tp_wet_lines_next(tp_wet_lines *lines) {
  if (lines->count == lines->capacity) {
    const long room = 2 * lines->capacity + 4;
    tp_line_load *items = realloc(lines->items, (size_t)room * sizeof *items);
    if (items == NULL) return NULL;
    lines->items = items;
    lines->capacity = room;
  }
  tp_line_load *line = lines->items + lines->count++;
  *line = (tp_line_load){0};
  tp_line_load_init(line);
  return line;
}

void tp_wet_lines_clear(tp_wet_lines *lines) {
  for (long k = 0; k < lines->count; k++) tp_line_load_clear(lines->items + k);
  free(lines->items);
  *lines = (tp_wet_lines){0};
}
