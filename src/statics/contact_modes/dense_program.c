/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A pivot exchanges a basic variable and one outside. The column of the steepest objective enters;
 * after very many steps the first one that rises does, which goes in no circles (Bland 1977). */

#include "contact_modes/dense_program.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of entries of size one: what an objective rises by, and what is a pivot. Less is rounding, and as
 * a pivot would make all else of it. */
static const double tiny = 1e-11, least_pivot = 1e-9;

bool tp_dense_program_init(tp_dense_program *p, long rows, long columns) {
  *p = (tp_dense_program){.rows = rows, .columns = columns};
  p->entries = calloc((size_t)((rows + TP_DENSE_OBJECTIVES) * (columns + 1)), sizeof *p->entries);
  p->basic = calloc((size_t)rows + 1, sizeof *p->basic);
  p->outside = calloc((size_t)columns + 1, sizeof *p->outside);
  p->exact = calloc((size_t)rows + 1, sizeof *p->exact);
  p->barred = calloc((size_t)(rows + columns) + 1, sizeof *p->barred);
  if (p->entries == NULL || p->basic == NULL || p->outside == NULL || p->exact == NULL ||
      p->barred == NULL) {
    tp_dense_program_clear(p);
    return false;
  }
  for (long k = 0; k < rows; k++) p->basic[k] = columns + k;
  for (long k = 0; k < columns; k++) p->outside[k] = k;
  return true;
}

void tp_dense_program_clear(tp_dense_program *p) {
  free(p->entries);
  free(p->basic);
  free(p->outside);
  free(p->exact);
  free(p->barred);
  memset(p, 0, sizeof *p);
}

double *tp_dense_program_entry(tp_dense_program *p, long row, long column) {
  return p->entries + row * (p->columns + 1) + column;
}

double *tp_dense_program_right(tp_dense_program *p, long row) {
  return tp_dense_program_entry(p, row, p->columns);
}

/* The slack of a row that must hold exactly has left for good. */
static bool may_enter(const tp_dense_program *p, long column) {
  const long variable = p->outside[column];
  return !p->barred[variable] && (variable < p->columns || !p->exact[variable - p->columns]);
}

static bool is_more(const tp_dense_program *p, double own, double other) {
  return own > other + p->tie * fabs(other);
}

static long entering(tp_dense_program *p, int objective, bool first) {
  const double *own = tp_dense_program_entry(p, p->rows + objective, 0);
  long best = -1;
  for (long c = 0; c < p->columns; c++) {
    if (!(own[c] > tiny) || !may_enter(p, c)) continue;
    const bool better =
        best < 0 || (first ? p->outside[c] < p->outside[best] : is_more(p, own[c], own[best]));
    if (better) best = c;
  }
  return best;
}

/* Of rows that end at the same length the one of the largest pivot; or of the least variable. */
static long leaving(tp_dense_program *p, long column, bool first) {
  long best = -1;
  double least = INFINITY;
  for (long r = 0; r < p->rows; r++) {
    const double own = *tp_dense_program_entry(p, r, column), right = *tp_dense_program_right(p, r);
    /* of a row that holds exactly, already without slack, any pivot will do */
    const bool rests = p->basic[r] >= p->columns && p->exact[p->basic[r] - p->columns] &&
                       right <= tiny && own < -least_pivot;
    if (!(own > least_pivot) && !rests) continue;
    const double length = rests || !(right > 0) ? 0 : right / own;
    const bool same = best >= 0 && length <= least + tiny && length >= least - tiny;
    const bool preferred =
        same && (first ? p->basic[r] < p->basic[best]
                       : is_more(p, fabs(own), fabs(*tp_dense_program_entry(p, best, column))));
    if (best < 0 || length < least - tiny || preferred) {
      best = r;
      least = fmin(least, length);
    }
  }
  return best;
}

static void exchange(tp_dense_program *p, long row, long column) {
  const long width = p->columns + 1;
  double *own = tp_dense_program_entry(p, row, 0);
  const double share = 1 / own[column];
  own[column] = 1;
  for (long c = 0; c < width; c++) own[c] *= share;
  for (long r = 0; r < p->rows + TP_DENSE_OBJECTIVES; r++) {
    double *other = tp_dense_program_entry(p, r, 0);
    const double factor = other[column];
    if (r == row || factor == 0) continue;
    other[column] = 0;
    for (long c = 0; c < width; c++) other[c] -= factor * own[c];
    p->work += width;
  }
  const long out = p->basic[row];
  p->basic[row] = p->outside[column];
  p->outside[column] = out;
}

bool tp_dense_program_climb(tp_dense_program *p, int objective) {
  memset(p->barred, 0, (size_t)(p->rows + p->columns) * sizeof *p->barred);
  const long patience = 4 * (p->rows + p->columns), most = 4 * patience;
  for (long step = 0; step < most; step++) {
    const bool first = step > patience;
    const long column = entering(p, objective, first);
    if (column < 0) return true;
    const long row = leaving(p, column, first);
    if (row < 0 && !p->is_limited) return false;
    if (row < 0) {
      p->barred[p->outside[column]] = true;
      continue;
    }
    exchange(p, row, column);
  }
  return false;
}

void tp_dense_program_solution(double *x, const tp_dense_program *p) {
  memset(x, 0, (size_t)p->columns * sizeof *x);
  for (long r = 0; r < p->rows; r++) {
    if (p->basic[r] >= p->columns) continue;
    x[p->basic[r]] = fmax(0, p->entries[r * (p->columns + 1) + p->columns]);
  }
}

void tp_dense_program_multipliers(double *of_row, const tp_dense_program *p, int objective) {
  const double *own = p->entries + (p->rows + objective) * (p->columns + 1);
  memset(of_row, 0, (size_t)p->rows * sizeof *of_row);
  for (long c = 0; c < p->columns; c++) {
    if (p->outside[c] >= p->columns) of_row[p->outside[c] - p->columns] = -own[c];
  }
}
