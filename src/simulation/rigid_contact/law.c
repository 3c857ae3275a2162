/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Solution of the contact equations of one choice of edges by Gaussian elimination with pivots, and
 * enumeration of all choices with the checks of forces, gaps and slips. */

#include "rigid_contact/law.h"

#include <math.h>

const double tp_law_tolerance = 1e-11;

enum { MOST_LISTED = 24 };

/* Equations that are dependent but for this share of their largest coefficient give nothing. */
static const double least_pivot = 1e-11;

double tp_law_slack(const tp_law *law) {
  double scale = 0;
  for (int e = 0; e < 3; e++) scale = fmax(scale, fabs(law->free[e]));
  for (long c = 0; c < law->count; c++) {
    scale = fmax(scale, fmax(fabs(law->contacts[c].least), fabs(law->contacts[c].rest)));
  }
  return tp_law_tolerance * scale;
}

/* M^-1 e */
static void set_push(double push[3], const tp_law *law, tp_law_edge edge) {
  const tp_law_contact *own = law->contacts + edge.contact;
  tp_double_cone_row(push, own->across, own->along, &own->friction, edge.side < 0);
  for (int e = 0; e < 3; e++) push[e] /= law->inertia[e];
}

/* By elimination with the largest pivot of each column. */
static bool eliminate(double a[TP_LAW_EDGES][TP_LAW_EDGES + 1], int count) {
  double largest = 0;
  for (int i = 0; i < count; i++) {
    for (int j = 0; j < count; j++) largest = fmax(largest, fabs(a[i][j]));
  }
  for (int k = 0; k < count; k++) {
    int pivot = k;
    for (int i = k + 1; i < count; i++) {
      if (fabs(a[i][k]) > fabs(a[pivot][k])) pivot = i;
    }
    if (!(fabs(a[pivot][k]) > least_pivot * largest)) return false;
    for (int j = 0; j <= count; j++) {
      const double own = a[k][j];
      a[k][j] = a[pivot][j];
      a[pivot][j] = own;
    }
    for (int i = 0; i < count; i++) {
      if (i == k) continue;
      const double share = a[i][k] / a[k][k];
      for (int j = k; j <= count; j++) a[i][j] -= share * a[k][j];
    }
  }
  return true;
}

/* Is this the second edge of a contact that sticks by both? */
static bool is_second(const tp_law_solution *s, int edge) {
  return edge > 0 && s->edges[edge - 1].contact == s->edges[edge].contact;
}

static bool is_double(const tp_law_solution *s, int edge) {
  return is_second(s, edge) || (edge + 1 < s->count && is_second(s, edge + 1));
}

bool tp_law_solve(tp_law_solution *s, const tp_law *law) {
  double push[TP_LAW_EDGES][3], a[TP_LAW_EDGES][TP_LAW_EDGES + 1];
  for (int k = 0; k < s->count; k++) set_push(push[k], law, s->edges[k]);
  for (int i = 0; i < s->count; i++) {
    const tp_law_contact *own = law->contacts + s->edges[i].contact;
    const double *row = is_second(s, i) ? own->along : own->across;
    for (int k = 0; k < s->count; k++) a[i][k] = tp_double_dot(row, push[k]);
    a[i][s->count] = (is_second(s, i) ? own->rest : own->least) - tp_double_dot(row, law->free);
  }
  s->paradox = s->count == 1 && a[0][0] <= 0 && law->contacts[s->edges[0].contact].slip != 0;
  if (!eliminate(a, s->count)) return false;
  for (int e = 0; e < 3; e++) s->x[e] = law->free[e];
  for (int k = 0; k < s->count; k++) {
    s->factors[k] = a[k][s->count] / a[k][k];
    for (int e = 0; e < 3; e++) s->x[e] += s->factors[k] * push[k][e];
  }
  return true;
}

/* Is a solution of the equations one of the law, as far as its own edges tell? */
static bool edges_hold(const tp_law_solution *s, const tp_law *law, double slack) {
  for (int k = 0; k < s->count; k++) {
    const tp_law_contact *own = law->contacts + s->edges[k].contact;
    if (!(s->factors[k] >= -slack)) return false;
    if (own->slip != 0 || own->friction == 0 || is_double(s, k)) continue;
    if (s->edges[k].side * (tp_double_dot(own->along, s->x) - own->rest) > slack) return false;
  }
  return true;
}

long tp_law_worst(const tp_law_solution *s, const tp_law *law, double slack) {
  double deepest = -slack;
  long worst = -1;
  for (long c = 0; c < law->count; c++) {
    const double own = tp_double_dot(law->contacts[c].across, s->x) - law->contacts[c].least;
    if (own < deepest) {
      deepest = own;
      worst = c;
    }
  }
  return worst;
}

typedef struct enumeration {
  const tp_law *law;
  const long *listed;
  long listed_count;
  int most;
  double slack;
  tp_law_found found;
  void *context;
  tp_law_solution tried;
} enumeration;

/* Can an edge serve: against the slip that is given; of one without friction, one of the two. */
static bool serves(const tp_law_contact *own, int side) {
  if (own->friction == 0) return side < 0;
  return own->slip == 0 || side == -own->slip;
}

/* Sets with edges behind the one given, told in the order of their numbers. */
static bool extend(enumeration *of, long from) {
  tp_law_solution own = of->tried;
  if (tp_law_solve(&own, of->law) && edges_hold(&own, of->law, of->slack) &&
      !of->found(of->context, &own)) {
    return false;
  }
  if (of->tried.count == of->most) return true;
  for (long k = from; k < 2 * of->listed_count; k++) {
    const long contact = of->listed[k / 2];
    const int side = k % 2 == 0 ? -1 : 1;
    if (!serves(of->law->contacts + contact, side)) continue;
    of->tried.edges[of->tried.count++] = (tp_law_edge){contact, side};
    const bool more = extend(of, k + 1);
    of->tried.count--;
    if (!more) return false;
  }
  return true;
}

void tp_law_enumerate(const tp_law *law, const long *listed, long listed_count, int most,
                      tp_law_found found, void *context) {
  enumeration of = {.law = law,
                    .listed = listed,
                    .listed_count = listed_count,
                    .most = most,
                    .slack = tp_law_slack(law),
                    .found = found,
                    .context = context};
  (void)extend(&of, 0);
}

/* One round of a search: are there solutions, and if not, what do those of the list violate? */
typedef struct search_round {
  const tp_law *law;
  const long *listed;
  long listed_count;
  tp_law_found found;
  void *context;
  double slack;
  bool any;
  long worst;
} search_round;

static bool look(void *context, const tp_law_solution *solution) {
  search_round *own = context;
  for (long k = 0; k < own->listed_count; k++) {
    const tp_law_contact *contact = own->law->contacts + own->listed[k];
    if (tp_double_dot(contact->across, solution->x) - contact->least < -own->slack) return true;
  }
  const long worst = tp_law_worst(solution, own->law, own->slack);
  if (worst < 0) {
    own->any = true;
    return own->found(own->context, solution);
  }
  own->worst = worst;
  return true;
}

static bool is_listed(const long *listed, long count, long contact) {
  for (long k = 0; k < count; k++) {
    if (listed[k] == contact) return true;
  }
  return false;
}

void tp_law_search(const tp_law *law, tp_law_found found, void *context) {
  long listed[MOST_LISTED], count = 0;
  for (;;) {
    search_round own = {.law = law,
                        .listed = listed,
                        .listed_count = count,
                        .slack = tp_law_slack(law),
                        .found = found,
                        .context = context,
                        .worst = -1};
    tp_law_enumerate(law, listed, count, TP_LAW_EDGES, look, &own);
    if (own.any || count == MOST_LISTED) return;
    /* Where the list has no solution of its own: the next by number. */
    for (long c = 0; c < law->count && own.worst < 0; c++) {
      if (!is_listed(listed, count, c)) own.worst = c;
    }
    if (own.worst < 0) return;
    listed[count++] = own.worst;
  }
}

void tp_law_search_all(const tp_law *law, tp_law_found found, void *context) {
  long listed[MOST_LISTED], count = 0;
  for (; count < law->count && count < MOST_LISTED; count++) listed[count] = count;
  search_round own = {.law = law, .slack = tp_law_slack(law), .found = found, .context = context};
  tp_law_enumerate(law, listed, count, TP_LAW_EDGES, look, &own);
}
