/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Contacts that can stay closed by cutting sectors of motions, enumeration of the feasible modes,
 * the next tilt at which one becomes feasible from inequalities a + b tan(alpha) >= 0, and contact
 * forces that hold the block by non-negative least squares. */

#include "rigid_contact/rest.h"

#include <math.h>

/* Two rays of a plane with all between them, at most half a turn counter-clockwise. */
typedef struct sector {
  bool cut; /* not the whole plane */
  double from[2], to[2];
} sector;

/* Cut by h . u >= 0; false where nothing is left. */
static bool cut_sector(sector *of, const double h[2]) {
  const double size = hypot(h[0], h[1]);
  if (size < tp_law_tolerance) return true;
  const double u[2] = {h[0] / size, h[1] / size};
  const double from = u[0] * of->from[0] + u[1] * of->from[1];
  const double to = u[0] * of->to[0] + u[1] * of->to[1];
  if (of->cut && from < -tp_law_tolerance && to < -tp_law_tolerance) return false;
  if (!of->cut || from < -tp_law_tolerance) {
    of->from[0] = u[1];
    of->from[1] = -u[0];
  }
  if (!of->cut || to < -tp_law_tolerance) {
    of->to[0] = -u[1];
    of->to[1] = u[0];
  }
  of->cut = true;
  return true;
}

/* Two unit vectors across the row, at right angles. */
static void set_plane(double plane[2][3], const double row[3]) {
  const double size = sqrt(tp_double_dot(row, row)), side = hypot(row[0], row[1]);
  plane[0][0] = -row[1] / side; /* rows have unit normals: side is 1 */
  plane[0][1] = row[0] / side;
  plane[0][2] = 0;
  plane[1][0] = -row[2] * plane[0][1] / size;
  plane[1][1] = row[2] * plane[0][0] / size;
  plane[1][2] = (row[0] * plane[0][1] - row[1] * plane[0][0]) / size;
}

/* Is there a motion that keeps the contact closed and that no contact forbids? */
static bool can_stay(const tp_law *law, long contact) {
  double plane[2][3];
  sector left = {0};
  set_plane(plane, law->contacts[contact].across);
  for (long c = 0; c < law->count; c++) {
    if (c == contact) continue;
    const double h[2] = {tp_double_dot(plane[0], law->contacts[c].across),
                         tp_double_dot(plane[1], law->contacts[c].across)};
    if (!cut_sector(&left, h)) return false;
  }
  return true;
}

typedef struct motions {
  const tp_law *law;
  double slack;
  tp_law_found found;
  void *context;
} motions;

static bool look(void *context, const tp_law_solution *solution) {
  const motions *own = context;
  double size = 0;
  for (int e = 0; e < 3; e++) size = fmax(size, fabs(solution->x[e]));
  if (!(size > own->slack) || tp_law_worst(solution, own->law, own->slack) >= 0) return true;
  return own->found(own->context, solution);
}

long tp_rest_list(long *listed, const tp_law *law) {
  long count = 0;
  for (long c = 0; c < law->count; c++) {
    if (can_stay(law, c)) listed[count++] = c;
  }
  return count;
}

void tp_rest_motions(const tp_law *law, const long *listed, long listed_count, tp_law_found found,
                     void *context) {
  motions own = {law, tp_law_slack(law), found, context};
  tp_law_enumerate(law, listed, listed_count, 2, look, &own);
}

/* ---- the next tilt ---- */

/* Tangents of tilts at which one set of edges moves the block. */
typedef struct tangents {
  double low, high;
} tangents;

/* Cut by a + b tan(alpha) >= 0; false where nothing is left. */
static bool cut_tangents(tangents *of, double a, double b) {
  const double slack = 1e-9 * (fabs(a) + fabs(b)) + 1e-12;
  const double bound = -(a + slack) / b;
  if (b > 0) of->low = fmax(of->low, bound);
  if (b < 0) of->high = fmin(of->high, bound);
  return of->low <= of->high && (b != 0 || a + slack >= 0);
}

typedef struct tilt_search {
  tp_law level, upright;
  double from, next; /* tangents */
} tilt_search;

static const double narrowest = 1e-7;

static void try_edges(tilt_search *of, const tp_law_solution *edges) {
  tp_law_solution a = *edges, b = *edges;
  if (!tp_law_solve(&a, &of->level) || !tp_law_solve(&b, &of->upright)) return;
  tangents left = {of->from, of->next};
  const bool both = edges->count == 2 && edges->edges[0].contact == edges->edges[1].contact;
  for (int k = 0; k < edges->count; k++) {
    const double *along = of->level.contacts[edges->edges[k].contact].along;
    const int side = edges->edges[k].side;
    if (!cut_tangents(&left, a.factors[k], b.factors[k])) return;
    if (both || of->level.contacts[edges->edges[k].contact].friction == 0) continue;
    if (!cut_tangents(&left, -side * tp_double_dot(along, a.x), -side * tp_double_dot(along, b.x)))
      return;
  }
  for (long c = 0; c < of->level.count; c++) {
    const double *across = of->level.contacts[c].across;
    if (!cut_tangents(&left, tp_double_dot(across, a.x), tp_double_dot(across, b.x))) return;
  }
  /* what is narrower is a tilt at which it rests, widened by the slack */
  if (left.high - left.low > narrowest) of->next = left.low;
}

double tp_rest_next_tilt(const tp_law *law, const long *listed, long listed_count,
                         const double level[3], const double upright[3], double from) {
  tilt_search of = {.level = *law, .upright = *law, .from = tan(from), .next = INFINITY};
  for (int e = 0; e < 3; e++) {
    of.level.free[e] = level[e];
    of.upright.free[e] = upright[e];
  }
  tp_law_solution edges = {.count = 0};
  try_edges(&of, &edges);
  for (long i = 0; i < 2 * listed_count; i++) {
    edges.edges[0] = (tp_law_edge){listed[i / 2], i % 2 == 0 ? -1 : 1};
    edges.count = 1;
    try_edges(&of, &edges);
    edges.count = 2;
    for (long j = i + 1; j < 2 * listed_count; j++) {
      edges.edges[1] = (tp_law_edge){listed[j / 2], j % 2 == 0 ? -1 : 1};
      try_edges(&of, &edges);
    }
  }
  return isinf(of.next) ? INFINITY : atan(of.next);
}

/* ---- forces ---- */

/* Least squares of up to three columns, which are kept independent: their multipliers from the
 * columns made orthogonal one after the other. */
typedef struct least_squares {
  const double *target;
  int count;
  long chosen[3];
  double columns[3][3];
} least_squares;

static bool solve_squares(double factors[3], const least_squares *of) {
  double q[3][3], r[3][3] = {{0}}, b[3];
  for (int k = 0; k < of->count; k++) {
    double v[3] = {of->columns[k][0], of->columns[k][1], of->columns[k][2]};
    for (int j = 0; j < k; j++) {
      r[j][k] = tp_double_dot(q[j], v);
      for (int e = 0; e < 3; e++) v[e] -= r[j][k] * q[j][e];
    }
    r[k][k] = sqrt(tp_double_dot(v, v));
    if (!(r[k][k] > tp_law_tolerance * sqrt(tp_double_dot(of->columns[k], of->columns[k]))))
      return false;
    for (int e = 0; e < 3; e++) q[k][e] = v[e] / r[k][k];
    b[k] = tp_double_dot(q[k], of->target);
  }
  for (int k = of->count - 1; k >= 0; k--) {
    factors[k] = b[k];
    for (int j = k + 1; j < of->count; j++) factors[k] -= r[k][j] * factors[j];
    factors[k] /= r[k][k];
  }
  return true;
}

static void drop(least_squares *of, double held[3], int k) {
  of->count--;
  for (int j = k; j < of->count; j++) {
    of->chosen[j] = of->chosen[j + 1];
    held[j] = held[j + 1];
    for (int e = 0; e < 3; e++) of->columns[j][e] = of->columns[j + 1][e];
  }
}

/* The multipliers `held` go towards the least squares until one of them vanishes, which is left
 * out, as often as it takes. */
static bool settle(least_squares *of, double held[3]) {
  for (;;) {
    double wanted[3], share = 1;
    int first = -1;
    if (!solve_squares(wanted, of)) return false;
    for (int k = 0; k < of->count; k++) {
      if (wanted[k] > 0) continue;
      const double own = held[k] / (held[k] - wanted[k]);
      if (first < 0 || own < share) {
        share = own;
        first = k;
      }
    }
    for (int k = 0; k < of->count; k++) held[k] += share * (wanted[k] - held[k]);
    if (first < 0) return true;
    drop(of, held, first);
    if (of->count == 0) return true;
  }
}

static void set_column(double column[3], const tp_law *law, long k) {
  const tp_law_contact *own = law->contacts + k / 2;
  const int side = k % 2 == 0 ? -1 : 1;
  for (int e = 0; e < 3; e++) column[e] = own->across[e] + side * own->friction * own->along[e];
}

/* The column, not chosen yet, along which the residual is largest; -1: none. */
static long choose(const least_squares *of, const tp_law *law, const double residual[3],
                   double least) {
  long best = -1;
  for (long k = 0; k < 2 * law->count; k++) {
    double column[3];
    set_column(column, law, k);
    const double own = tp_double_dot(column, residual) / sqrt(tp_double_dot(column, column));
    bool taken = false;
    for (int j = 0; j < of->count; j++) taken = taken || of->chosen[j] == k;
    if (taken || own <= least) continue;
    least = own;
    best = k;
  }
  return best;
}

bool tp_rest_forces(double *factors, const tp_law *law) {
  /* More exchanges than this say that rounding goes in circles. */
  const long most = 100 + 4 * law->count;
  double target[3], residual[3], held[3] = {0};
  for (int e = 0; e < 3; e++) residual[e] = target[e] = -law->inertia[e] * law->free[e];
  const double size = sqrt(tp_double_dot(target, target)), slack = 10 * tp_law_tolerance * size;
  least_squares of = {.target = target};
  for (long round = 0; round < most && sqrt(tp_double_dot(residual, residual)) > slack; round++) {
    const long next = of.count == 3 ? -1 : choose(&of, law, residual, 1e-14 * size);
    if (next < 0) break;
    set_column(of.columns[of.count], law, next);
    of.chosen[of.count] = next;
    held[of.count++] = 0;
    if (!settle(&of, held)) break;
    for (int e = 0; e < 3; e++) {
      residual[e] = target[e];
      for (int k = 0; k < of.count; k++) residual[e] -= held[k] * of.columns[k][e];
    }
  }
  for (long k = 0; k < 2 * law->count; k++) factors[k] = 0;
  for (int k = 0; k < of.count; k++) factors[of.chosen[k]] = held[k];
  return sqrt(tp_double_dot(residual, residual)) <= slack;
}
