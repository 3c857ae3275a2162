/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A group of blocks that moves as one body has three velocities v, whatever their number, and its
 * joints within do no work. With g_k the wrench of column k of its contacts with other blocks, all
 * of these at rest, and w that of its loads, forces f >= 0 hold it only where w = -sum f_k g_k, so
 * that none do where
 *
 *     g_k . v <= 0 for all k,   w . v < 0                                 (Farkas)
 *
 * Columns of which the factor is bounded (cohesion) may do work: their greatest is added to w . v;
 * the search looks past them.
 *
 * Search: the point of the cone {w + sum f g} next to 0 is r, and -r the v of the least w . v over
 * its size (Moreau). It leaves the columns that act on it at rest exactly; so a little of a u with
 * g_k . u < 0 throughout is added, which opens them for certain: minus the point next to 0 of all
 * means of g_k, by one coordinate more. Both by Lawson and Hanson's method (1974, chapter 23), of
 * at most four columns at a time. Proof: both inequalities in doubles with bounds.
 *
 * Groups: each block alone; and those that no fixed block touches, as far as they touch each other.
 */

#include "assemblage/falling_group.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BODY = 3, MOST = 4 };

/* Columns of a group by their three components, or four. */
typedef struct body {
  const tp_force_program *p;
  long origin;     /* the block whose point moments are about */
  long count;      /* of its columns: */
  tp_near *wrench; /* BODY of each */
  tp_near *most;   /* the greatest factor of each */
  double *vectors; /* MOST of each: of size one, and 1 */
  tp_near load[BODY];
} body;

/* ---- the point next to 0 -----------------------------------------------------------------------
 */

typedef struct passive {
  long column[MOST];
  double factor[MOST];
  int count;
} passive;

static double dot(const double *a, const double *b, int size) {
  double sum = 0;
  for (int k = 0; k < size; k++) sum += a[k] * b[k];
  return sum;
}

/* Factors by which |w + sum f g| is least, and that `rest`, by orthogonal directions (modified
 * Gram-Schmidt), which are taken out of it twice: however short it is, it is at right angles to all
 * columns. False where these depend on each other. */
static bool solve_passive(double factor[MOST], double rest[MOST], const body *b, const passive *on,
                          const double *w, int size) {
  static const double least = 1e-12;
  double q[MOST][MOST], over[MOST][MOST];
  memcpy(rest, w, (size_t)size * sizeof *rest);
  for (int k = 0; k < on->count; k++) {
    memcpy(q[k], b->vectors + MOST * on->column[k], (size_t)size * sizeof *q[k]);
    for (int j = 0; j < k; j++) {
      over[j][k] = dot(q[j], q[k], size);
      for (int e = 0; e < size; e++) q[k][e] -= over[j][k] * q[j][e];
    }
    over[k][k] = sqrt(dot(q[k], q[k], size));
    if (!(over[k][k] > least)) return false;
    for (int e = 0; e < size; e++) q[k][e] /= over[k][k];
    factor[k] = -dot(q[k], rest, size);
    for (int e = 0; e < size; e++) rest[e] += factor[k] * q[k][e];
  }
  for (int k = 0; k < on->count; k++) {
    const double left = dot(q[k], rest, size);
    for (int e = 0; e < size; e++) rest[e] -= left * q[k][e];
  }
  for (int k = on->count - 1; k >= 0; k--) {
    for (int j = k + 1; j < on->count; j++) factor[k] -= over[k][j] * factor[j];
    factor[k] /= over[k][k];
  }
  return true;
}

static void drop(passive *on, int k) {
  on->count--;
  for (; k < on->count; k++) {
    on->column[k] = on->column[k + 1];
    on->factor[k] = on->factor[k + 1];
  }
}

/* Towards those factors as far as all stay above 0, without the one that gets there first. */
static bool settle(passive *on, double r[MOST], const body *b, const double *w, int size) {
  double wanted[MOST];
  while (on->count > 0 && solve_passive(wanted, r, b, on, w, size)) {
    double step = 1;
    int first = -1;
    for (int k = 0; k < on->count; k++) {
      const double own = on->factor[k] / (on->factor[k] - wanted[k]);
      if (wanted[k] > 0 || (first >= 0 && own >= step)) continue;
      step = own;
      first = k;
    }
    for (int k = 0; k < on->count; k++) on->factor[k] += step * (wanted[k] - on->factor[k]);
    if (first < 0) return true;
    drop(on, first);
  }
  return false;
}

/* r = w + sum f g with f >= 0, next to 0. */
static void find_nearest(double r[MOST], const body *b, const double *w, int size) {
  enum { ROUNDS = 100 };
  static const double within = 1e-12;
  passive on = {.count = 0};
  memcpy(r, w, (size_t)size * sizeof *r);
  for (int round = 0; round < ROUNDS && on.count < size; round++) {
    const double length = sqrt(dot(r, r, size));
    double least = -within * length;
    long next = -1;
    for (long k = 0; k < b->count; k++) {
      const double power = dot(b->vectors + MOST * k, r, size);
      if (power < least && !isfinite(b->most[k].value)) {
        least = power;
        next = k;
      }
    }
    if (next < 0) return;
    on.column[on.count] = next;
    on.factor[on.count++] = 0;
    if (!settle(&on, r, b, w, size)) return;
  }
}

/* ---- the body ----------------------------------------------------------------------------------
 */

/* Of a force and its moment about the point of a block, about that of the origin. */
static void move_wrench(tp_near own[BODY], const body *b, const tp_near about_block[BODY],
                        long number) {
  const tp_assemblage *a = b->p->assemblage;
  const tp_rigid_block *from = a->blocks + b->p->block[b->origin];
  const tp_rigid_block *to = a->blocks + b->p->block[number];
  memcpy(own, about_block, BODY * sizeof *own);
  if (number == b->origin) return;
  const tp_near x = tp_assemblage_length(a, from->x, to->x);
  const tp_near y = tp_assemblage_length(a, from->y, to->y);
  own[2] = tp_near_plus(own[2], tp_near_minus(tp_near_times(x, own[1]), tp_near_times(y, own[0])));
}

static void add_column(body *b, const tp_force_column *c, int side) {
  tp_near *own = b->wrench + BODY * b->count;
  double *vector = b->vectors + MOST * b->count;
  move_wrench(own, b, c->entry[side], c->row[side] / BODY);
  double size = 0;
  for (int e = 0; e < BODY; e++) size = hypot(size, own[e].value);
  for (int e = 0; e < BODY; e++) vector[e] = own[e].value / size;
  vector[BODY] = 1;
  b->most[b->count++] = c->most;
}

static void add_load(body *b, tp_near load, long number) {
  tp_near about_block[BODY], own[BODY];
  for (int e = 0; e < BODY; e++) {
    const long row = BODY * number + e;
    about_block[e] = tp_near_plus(b->p->dead[row], tp_near_times(load, b->p->live[row]));
  }
  move_wrench(own, b, about_block, number);
  for (int e = 0; e < BODY; e++) b->load[e] = tp_near_plus(b->load[e], own[e]);
}

/* ---- proof -------------------------------------------------------------------------------------
 */

static tp_near power_of(const tp_near wrench[BODY], const double v[BODY]) {
  tp_near sum = {0, 0};
  for (int e = 0; e < BODY; e++) {
    sum = tp_near_plus(sum, tp_near_times(wrench[e], (tp_near){v[e], 0}));
  }
  return sum;
}

static bool is_proven(const body *b, const double v[BODY]) {
  tp_near power = power_of(b->load, v);
  for (long k = 0; k < b->count; k++) {
    const tp_near own = power_of(b->wrench + BODY * k, v);
    if (own.value <= -own.error) continue;
    if (!isfinite(b->most[k].value)) return false;
    power = tp_near_plus(power, tp_near_mul(tp_near_larger(own, (tp_near){0, 0}), b->most[k]));
  }
  return tp_near_sign(power) < 0;
}

static bool falls(const body *b) {
  static const double tenth = 0.1, least = 1e-10;
  const double load[MOST] = {b->load[0].value, b->load[1].value, b->load[2].value};
  const double means[MOST] = {0, 0, 0, -1};
  double r[MOST] = {0}, u[MOST] = {0}, v[BODY];
  find_nearest(r, b, load, BODY);
  find_nearest(u, b, means, MOST);
  const double size = sqrt(dot(r, r, BODY)), little = sqrt(dot(u, u, BODY));
  if (!(size > 0) || !isfinite(size)) return false;
  for (double share = tenth; share > least; share *= tenth) {
    for (int e = 0; e < BODY; e++) v[e] = -r[e] / size - (little > 0 ? share * u[e] / little : 0);
    if (is_proven(b, v)) return true;
  }
  return false;
}

/* ---- groups ------------------------------------------------------------------------------------
 */

enum { TOUCHES = -1, NEW = -2 };

typedef struct grouping {
  long *group;          /* by number of a free block: the first of its group, or one of these */
  long *start, *member; /* columns by free block, as 2 k + side */
} grouping;

static void list_columns(grouping *g, const tp_force_program *p) {
  const long blocks = p->rows / BODY;
  for (int pass = 0; pass < 2; pass++) {
    for (long k = 0; k < p->count; k++) {
      for (int side = 0; side < 2; side++) {
        if (p->columns[k].row[side] < 0) continue;
        const long number = p->columns[k].row[side] / BODY;
        if (pass == 0) g->start[number + 1]++;
        if (pass == 1) g->member[g->start[number]++] = 2 * k + side;
      }
    }
    for (long n = 0; n < blocks && pass == 0; n++) g->start[n + 1] += g->start[n];
  }
  for (long n = blocks; n > 0; n--) g->start[n] = g->start[n - 1];
  g->start[0] = 0;
}

static long other_of(const tp_force_program *p, long member) {
  const long row = p->columns[member / 2].row[1 - member % 2];
  return row < 0 ? -1 : row / BODY;
}

static bool group_falls(body *b, const grouping *g, const long *blocks, long count, tp_near load) {
  const tp_force_program *p = b->p;
  b->origin = blocks[0];
  b->count = 0;
  for (int e = 0; e < BODY; e++) b->load[e] = (tp_near){0, 0};
  for (long k = 0; k < count; k++) {
    const long own = blocks[k];
    add_load(b, load, own);
    for (long m = g->start[own]; m < g->start[own + 1]; m++) {
      const long other = other_of(p, g->member[m]);
      if (count > 1 && other >= 0 && g->group[other] == g->group[own]) continue;
      add_column(b, p->columns + g->member[m] / 2, (int)(g->member[m] % 2));
    }
  }
  return falls(b);
}

/* Those blocks first that touch a fixed one. */
static void mark(grouping *g, const tp_force_program *p) {
  for (long n = 0; n < p->rows / BODY; n++) {
    g->group[n] = NEW;
    for (long m = g->start[n]; m < g->start[n + 1]; m++) {
      if (other_of(p, g->member[m]) < 0) g->group[n] = TOUCHES;
    }
  }
}

/* All that a block leads to from one to the next, which get its number. How many. */
static long follow(grouping *g, const tp_force_program *p, long *queue, long from) {
  long count = 1;
  queue[0] = from;
  g->group[from] = from;
  for (long done = 0; done < count; done++) {
    for (long m = g->start[queue[done]]; m < g->start[queue[done] + 1]; m++) {
      const long other = other_of(p, g->member[m]);
      if (other < 0 || g->group[other] != NEW) continue;
      g->group[other] = from;
      queue[count++] = other;
    }
  }
  return count;
}

static bool any_falls(body *b, grouping *g, long *queue, tp_near load) {
  const long blocks = b->p->rows / BODY;
  for (long n = 0; n < blocks; n++) {
    if (group_falls(b, g, &n, 1, load)) return true;
  }
  mark(g, b->p);
  for (long n = 0; n < blocks; n++) {
    if (g->group[n] != NEW) continue;
    const long count = follow(g, b->p, queue, n);
    if (count > 1 && group_falls(b, g, queue, count, load)) return true;
  }
  return false;
}

tp_status tp_falling_group_find(bool *found, const tp_force_program *p, tp_near load,
                                tp_message *message) {
  const size_t blocks = (size_t)p->rows / BODY, columns = (size_t)p->count;
  grouping g = {.group = calloc(blocks + 1, sizeof *g.group),
                .start = calloc(blocks + 2, sizeof *g.start),
                .member = calloc(2 * columns + 1, sizeof *g.member)};
  body b = {.p = p,
            .wrench = calloc(BODY * 2 * columns + 1, sizeof *b.wrench),
            .most = calloc(2 * columns + 1, sizeof *b.most),
            .vectors = calloc(MOST * 2 * columns + 1, sizeof *b.vectors)};
  long *queue = calloc(blocks + 1, sizeof *queue);
  const bool made = g.group != NULL && g.start != NULL && g.member != NULL && b.wrench != NULL &&
                    b.most != NULL && b.vectors != NULL && queue != NULL;
  *found = false;
  if (made) {
    list_columns(&g, p);
    *found = any_falls(&b, &g, queue, load);
  }
  free(g.group);
  free(g.start);
  free(g.member);
  free(b.wrench);
  free(b.most);
  free(b.vectors);
  free(queue);
  return made ? TP_OK : tp_fail_memory(message, "the forces between blocks");
}
