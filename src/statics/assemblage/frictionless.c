/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Some normals bear nothing in any equilibrium, as of bricks side by side: their forces fall to
 * nothing as those of all come near to equilibrium, and they are left out. Blocks that are then
 * pushed straight upwards alone, exactly, lack nothing along x: the proof gives their contacts a
 * shear that may be nothing and has to be nothing, so that the tree of contacts spans all rows. */

#include "assemblage/frictionless.h"

#include "assemblage/common_slide.h"
#include "assemblage/held_forces.h"
#include "assemblage/interior_point.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct balancing {
  const tp_assemblage *a;
  tp_near load;
  tp_force_program normals;
  double *forces; /* by column */
  double *left;   /* by row: what they leave */
  bool *pushed;   /* by number of a free block: along x too */
} balancing;

/* Of the two edges of a cone, alike without friction, the first; later, those that bear. */
static void keep(balancing *s, bool those_that_bear) {
  static const double nothing = 1e-5; /* of the weight of a block */
  tp_force_program *p = &s->normals;
  long count = 0, from = 0;
  for (long k = 0; k < s->a->contact_count; k++) {
    const long first = from, end = p->first[k + 1];
    p->first[k] = count;
    for (long c = first; c < end; c++) {
      if (those_that_bear ? s->forces[c] <= nothing : (c - first) % 2 == 1) continue;
      s->forces[count] = s->forces[c];
      p->columns[count++] = p->columns[c];
    }
    from = end;
  }
  p->first[s->a->contact_count] = p->count = count;
}

/* Is so little left that what bears nothing is told from what does? */
static bool watch(void *context, const tp_interior_iterate *at) {
  static const double enough = 1e-9;
  balancing *s = context;
  const tp_force_program *p = &s->normals;
  memcpy(s->forces, at->forces, (size_t)p->count * sizeof *s->forces);
  for (long r = 0; r < p->rows; r++) {
    s->left[r] = p->dead[r].value + at->load * p->live[r].value;
  }
  for (long k = 0; k < p->count; k++) {
    const tp_force_column *c = p->columns + k;
    for (int side = 0; side < 2; side++) {
      for (int e = 0; e < 3 && c->row[side] >= 0; e++) {
        s->left[c->row[side] + e] += at->forces[k] * c->entry[side][e].value;
      }
    }
  }
  double most = 0;
  for (long r = 0; r < p->rows; r++) most = fmax(most, fabs(s->left[r]));
  return most <= enough;
}

static tp_status balance(balancing *s, tp_message *message) {
  tp_force_program *p = &s->normals;
  for (long k = 0; k < p->count; k++) s->forces[k] = fmax(s->forces[k], DBL_MIN);
  return p->count == 0 ? TP_OK : tp_interior_centre(p, s->forces, s->load.value, watch, s, message);
}

/* ---- proof -------------------------------------------------------------------------------------
 */

static void find_pushed(balancing *s) {
  const tp_force_program *p = &s->normals;
  for (long b = 0; b < p->rows / 3; b++) {
    const tp_near live = tp_near_times(s->load, p->live[3 * b]);
    s->pushed[b] = !tp_near_is_zero(p->dead[3 * b]) || !tp_near_is_zero(live);
  }
  for (long k = 0; k < p->count; k++) {
    const tp_force_column *c = p->columns + k;
    for (int side = 0; side < 2; side++) {
      if (c->row[side] < 0 || tp_near_is_zero(c->entry[side][0])) continue;
      s->pushed[c->row[side] / 3] = true;
    }
  }
}

/* Of blocks that are not pushed along x, where they touch by an edge that bears. */
static bool has_shear(const balancing *s, long contact, const tp_contact_frame *f) {
  const tp_force_program *p = &s->normals;
  if (p->first[contact] == p->first[contact + 1] || f->ends[0] == f->ends[1]) return false;
  const long *row = p->columns[p->first[contact]].row;
  return (row[0] < 0 || !s->pushed[row[0] / 3]) && (row[1] < 0 || !s->pushed[row[1] / 3]);
}

/* The normals, and shears that are nothing; in `proof`, and forces with them. */
static void add_shears(tp_force_program *proof, double *forces, const balancing *s) {
  const tp_force_program *p = &s->normals;
  long count = 0;
  for (long k = 0; k < s->a->contact_count; k++) {
    const tp_contact_frame f = tp_contact_frame_of(s->a, k, (tp_near){0, 0});
    const tp_near along[2] = {f.dx, f.dy};
    proof->first[k] = count;
    for (long c = p->first[k]; c < p->first[k + 1]; c++) {
      forces[count] = s->forces[c];
      proof->columns[count++] = p->columns[c];
    }
    if (!has_shear(s, k, &f)) continue;
    tp_contact_frame_column(proof->columns + count, s->a, k, &f, 0, along);
    proof->columns[count].most = (tp_near){0, 0};
    forces[count++] = 0;
  }
  proof->first[s->a->contact_count] = proof->count = count;
}

static tp_status prove(bool *held, balancing *s, tp_force_program *proof, tp_message *message) {
  tp_ground_tree tree = {.links = NULL};
  const size_t room = 3 * (size_t)s->a->contact_count + 1;
  double *forces = calloc(room, sizeof *forces);
  tp_near *lacks = calloc((size_t)proof->rows + 1, sizeof *lacks);
  bool done = forces != NULL && lacks != NULL;
  if (done) {
    find_pushed(s);
    add_shears(proof, forces, s);
    done = tp_ground_tree_init(&tree, proof);
  }
  *held = done && tp_forces_hold(lacks, proof, &tree, forces, s->load);
  tp_ground_tree_clear(&tree);
  free(forces);
  free(lacks);
  return done ? TP_OK : tp_fail_memory(message, "a proof");
}

/* ---- both --------------------------------------------------------------------------------------
 */

static tp_status find(bool *held, bool *slides, balancing *s, tp_force_program *proof,
                      tp_message *message) {
  static const double first = 10; /* weights of a block */
  tp_force_program *p = &s->normals;
  s->forces = calloc((size_t)p->count + 1, sizeof *s->forces);
  s->left = calloc((size_t)p->rows + 1, sizeof *s->left);
  s->pushed = calloc((size_t)p->rows / 3 + 1, sizeof *s->pushed);
  if (s->forces == NULL || s->left == NULL || s->pushed == NULL) {
    return tp_fail_memory(message, "a proof");
  }
  keep(s, false);
  *slides = tp_common_slide(p, s->load.value);
  if (*slides) return TP_OK;
  for (long k = 0; k < p->count; k++) s->forces[k] = first;
  tp_status status = balance(s, message);
  keep(s, true);
  if (status == TP_OK) status = balance(s, message);
  return status == TP_OK ? prove(held, s, proof, message) : status;
}

tp_status tp_frictionless_hold(bool *held, bool *slides, const tp_assemblage *a,
                               const tp_weight_loads *loads, tp_near load, tp_message *message) {
  balancing s = {.a = a, .load = load};
  tp_force_program proof;
  *held = *slides = false;
  tp_contact_strength *none = calloc((size_t)a->contact_count + 1, sizeof *none);
  if (none == NULL) return tp_fail_memory(message, "a proof");
  tp_status status = tp_force_program_init(&s.normals, a, none, loads, message);
  if (status == TP_OK) {
    status = tp_force_program_init(&proof, a, none, loads, message);
    if (status == TP_OK) {
      status = find(held, slides, &s, &proof, message);
      tp_force_program_clear(&proof);
    }
    tp_force_program_clear(&s.normals);
  }
  free(none);
  free(s.forces);
  free(s.left);
  free(s.pushed);
  return status;
}
