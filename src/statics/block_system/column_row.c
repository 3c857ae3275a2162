/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* By the signs of exact cross products of lattice points: first the sides between free blocks, then
 * what each has of the ground, then whether they make one row. */

#include "block_system/column_row.h"

#include "common/outside.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double newtons = 1000; /* in a kN */

/* What a block has of its neighbours: numbers of contacts, or of blocks; -1: none. */
typedef struct neighbours {
  long up, down;      /* the next free block on either side */
  long side, side_at; /* the contact with the one up, and its highest point */
  long base, edge;    /* a contact with the ground below, and the end of all towards the toe */
  double tangent;     /* the least of the base */
} neighbours;

typedef struct finding {
  const tp_built_system *s;
  const tp_assemblage *a;
  bool left; /* pressed to the left */
  neighbours *of;
  long reference; /* a contact between free blocks */
  tp_column_row *row;
} finding;

/* ---- why not -----------------------------------------------------------------------------------
 */

static const char *name_of(const finding *x, long block) {
  return x->a->given[block].name;
}

static bool no_row(const finding *x, const char *format, ...) __attribute__((format(printf, 2, 3)));

static bool no_row(const finding *x, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(x->row->why_not, sizeof x->row->why_not, format, arguments);
  va_end(arguments);
  return false;
}

/* ---- exact -------------------------------------------------------------------------------------
 */

static int cross(const finding *x, long a, long b, long c, long d) {
  return tp_lattice_cross(&x->a->lattice, a, b, c, d);
}

static int rise(const finding *x, long from, long to) {
  const int order = fmpz_cmp(x->a->lattice.y + to, x->a->lattice.y + from);
  return (order > 0) - (order < 0);
}

/* Above zero where the second point has the greater x. */
static int run(const finding *x, long from, long to) {
  const int order = fmpz_cmp(x->a->lattice.x + to, x->a->lattice.x + from);
  return (order > 0) - (order < 0);
}

/* And where it lies further from the toe. */
static int run_up(const finding *x, long from, long to) {
  return x->left ? run(x, from, to) : -run(x, from, to);
}

static bool is_parallel(const finding *x, const tp_block_contact *c, const tp_block_contact *d) {
  return cross(x, c->from, c->to, d->from, d->to) == 0;
}

static bool is_on_one_line(const finding *x, const tp_block_contact *c, const tp_block_contact *d) {
  return is_parallel(x, c, d) && cross(x, c->from, c->to, c->from, d->from) == 0;
}

/* Which of its two blocks lies on the left, of a contact that is not level: the first where its
 * direction goes up. */
static int left_of(const finding *x, const tp_block_contact *c) {
  return rise(x, c->from, c->to) > 0 ? 0 : 1;
}

static bool is_ground(const finding *x, long block) {
  return x->a->blocks[block].number < 0;
}

/* ---- sides -------------------------------------------------------------------------------------
 */

static bool check_side(const finding *x, const tp_block_contact *c) {
  const tp_block_contact *reference = x->a->contacts + x->reference;
  const char *first = name_of(x, c->block[0]), *second = name_of(x, c->block[1]);
  if (rise(x, c->from, c->to) == 0) {
    return no_row(x, "block '%s' lies on or below '%s', and not beside it",
                  tp_quote_all(first).text, tp_quote_all(second).text);
  }
  if (c->ends[0] == c->ends[1] || !is_parallel(x, c, reference)) {
    return no_row(x, "where '%s' and '%s' touch is not parallel to the sides of '%s'",
                  tp_quote_all(first).text, tp_quote_all(second).text,
                  tp_quote_all(name_of(x, reference->block[0])).text);
  }
  return true;
}

/* A side may have several contacts, on one line. */
static bool set_side(const finding *x, long contact) {
  const tp_block_contact *c = x->a->contacts + contact;
  if (!check_side(x, c)) return false;
  const int left = left_of(x, c);
  const long down = c->block[x->left ? left : 1 - left], up = c->block[x->left ? 1 - left : left];
  neighbours *own = x->of + down, *next = x->of + up;
  const long top = rise(x, c->ends[0], c->ends[1]) > 0 ? c->ends[1] : c->ends[0];
  if ((own->up >= 0 && own->up != up) || (next->down >= 0 && next->down != down)) {
    return no_row(x, "block '%s' touches two others on one side",
                  tp_quote_all(name_of(x, own->up >= 0 && own->up != up ? down : up)).text);
  }
  if (own->side >= 0 && !is_on_one_line(x, c, x->a->contacts + own->side)) {
    return no_row(x, "the side between '%s' and '%s' is not one plane",
                  tp_quote_all(name_of(x, down)).text, tp_quote_all(name_of(x, up)).text);
  }
  if (own->side < 0 || rise(x, own->side_at, top) > 0) own->side_at = top;
  own->side = contact;
  own->up = up;
  next->down = down;
  return true;
}

/* ---- bases -------------------------------------------------------------------------------------
 */

/* Ground beside a column, as the riser of a step: it presses nothing from above, and from below it
 * would hold the column, which the method does not know. */
static bool check_riser(const finding *x, const tp_block_contact *c, int free) {
  const bool is_on_left = left_of(x, c) == free;
  if (is_on_left == x->left) return true;
  return no_row(x, "ground holds '%s' on its side towards the toe, which this method has not",
                tp_quote_all(name_of(x, c->block[free])).text);
}

static bool set_base(const finding *x, long contact) {
  const tp_block_contact *c = x->a->contacts + contact;
  const int free = is_ground(x, c->block[0]) ? 1 : 0;
  const long block = c->block[free];
  neighbours *own = x->of + block;
  if (is_parallel(x, c, x->a->contacts + x->reference)) return check_riser(x, c, free);
  const int along = run(x, c->from, c->to);
  if (along == 0 || (along > 0 ? 0 : 1) != free) {
    return no_row(x, "ground touches '%s' elsewhere than below it and beside it",
                  tp_quote_all(name_of(x, block)).text);
  }
  if (own->base >= 0 && !is_on_one_line(x, c, x->a->contacts + own->base)) {
    return no_row(x, "block '%s' stands on more than one plane of the ground",
                  tp_quote_all(name_of(x, block)).text);
  }
  const double tangent = x->s->strengths[contact].tangent.value;
  own->tangent = own->base < 0 ? tangent : fmin(own->tangent, tangent);
  for (int e = 0; e < 2; e++) {
    const long end = c->ends[e];
    if ((own->base < 0 && e == 0) || run_up(x, end, own->edge) > 0) own->edge = end;
  }
  own->base = contact;
  return true;
}

/* ---- the row -----------------------------------------------------------------------------------
 */

static bool set_contacts(finding *x) {
  const tp_assemblage *a = x->a;
  x->reference = -1;
  for (long k = 0; k < a->contact_count; k++) {
    const long *block = a->contacts[k].block;
    if (is_ground(x, block[0]) || is_ground(x, block[1])) continue;
    if (x->reference < 0) x->reference = k;
    if (!set_side(x, k)) return false;
  }
  if (x->reference < 0) return no_row(x, "no two columns stand side by side");
  for (long k = 0; k < a->contact_count; k++) {
    const long *block = a->contacts[k].block;
    if (is_ground(x, block[0]) != is_ground(x, block[1]) && !set_base(x, k)) return false;
  }
  return true;
}

/* The toe; -1: not each block stands on the ground in one row. */
static long find_toe(const finding *x) {
  long toe = -1, length = 0;
  for (long k = 0; k < x->a->count; k++) {
    if (is_ground(x, k)) continue;
    if (x->of[k].base < 0) {
      (void)no_row(x, "block '%s' does not stand on the ground", tp_quote_all(name_of(x, k)).text);
      return -1;
    }
    if (x->of[k].down < 0) toe = k;
  }
  for (long k = toe; k >= 0; k = x->of[k].up) length++;
  if (length == x->a->free_count) return toe;
  if (toe < 0) {
    (void)no_row(x, "the blocks interlock");
    return -1;
  }
  (void)no_row(x, "the blocks are not one row: '%s' and others stand apart",
               tp_quote_all(name_of(x, toe)).text);
  return -1;
}

/* ---- measured ----------------------------------------------------------------------------------
 */

static tp_row_vector vector_of(const finding *x, double along_x, double along_y) {
  const double metre = ldexp(fmpq_get_d(x->a->lattice.step_m), (int)x->a->length_exponent);
  return (tp_row_vector){(x->left ? along_x : -along_x) * metre, along_y * metre};
}

static tp_row_vector way(const finding *x, long from, long to) {
  const tp_lattice *l = &x->a->lattice;
  return vector_of(x, tp_assemblage_length(x->a, l->x + from, l->x + to).value,
                   tp_assemblage_length(x->a, l->y + from, l->y + to).value);
}

static tp_row_vector to_centroid(const finding *x, long from, const tp_rigid_block *b) {
  const tp_lattice *l = &x->a->lattice;
  return vector_of(x, tp_assemblage_length(x->a, l->x + from, b->x).value + b->arm_x.value,
                   tp_assemblage_length(x->a, l->y + from, b->y).value + b->arm_y.value);
}

static tp_row_vector to_reference(const finding *x, long from, const tp_rigid_block *b) {
  const tp_lattice *l = &x->a->lattice;
  return vector_of(x, tp_assemblage_length(x->a, l->x + from, b->x).value,
                   tp_assemblage_length(x->a, l->y + from, b->y).value);
}

/* Along the direction of a contact, turned to have the part above zero. */
static tp_row_vector unit(const finding *x, const tp_block_contact *c, bool upwards) {
  const tp_row_vector w = way(x, c->from, c->to);
  const double size = copysign(hypot(w.u, w.v), upwards ? w.v : w.u);
  return (tp_row_vector){w.u / size, w.v / size};
}

/* The top of the side of a block that is furthest towards the toe. */
static long free_top(const finding *x, long block) {
  const tp_rigid_block *b = x->a->blocks + block;
  const tp_block_contact *c = x->a->contacts + x->reference;
  const int towards = (rise(x, c->from, c->to) > 0) == x->left ? 1 : -1;
  long best = b->outline;
  for (long p = b->outline + 1; p < b->end; p++) {
    const int side = towards * cross(x, c->from, c->to, best, p);
    if (side > 0 || (side == 0 && rise(x, best, p) > 0)) best = p;
  }
  return best;
}

static void measure(const finding *x, tp_row_column *own, long block) {
  const neighbours *n = x->of + block;
  const tp_rigid_block *b = x->a->blocks + block;
  const long lower = n->down >= 0 ? x->of[n->down].side_at : free_top(x, block);
  own->block = block;
  own->weight_n_m = ldexp(newtons * b->weight.value, (int)x->a->weight_exponent);
  own->centroid = to_centroid(x, n->edge, b);
  own->reference = to_reference(x, n->edge, b);
  own->lower = way(x, n->edge, lower);
  own->along_base = unit(x, x->a->contacts + n->base, false);
  own->base_tangent = n->tangent;
  if (n->up < 0) return;
  own->upper = way(x, n->edge, n->side_at);
  own->side_tangent = x->s->strengths[n->side].tangent.value;
}

static tp_status set_row(finding *x, tp_message *message) {
  const long toe = set_contacts(x) ? find_toe(x) : -1;
  if (toe < 0) return TP_OK;
  x->row->columns = calloc((size_t)x->a->free_count, sizeof *x->row->columns);
  if (x->row->columns == NULL) return tp_fail_memory(message, "the columns");
  for (long k = toe; k >= 0; k = x->of[k].up) measure(x, x->row->columns + x->row->count++, k);
  x->row->along_sides = unit(x, x->a->contacts + x->reference, true);
  return TP_OK;
}

tp_status tp_column_row_find(tp_column_row *row, const tp_built_system *s, bool towards_left,
                             tp_message *message) {
  memset(row, 0, sizeof *row);
  finding x = {.s = s, .a = &s->assemblage, .left = towards_left, .row = row};
  x.of = malloc((size_t)x.a->count * sizeof *x.of);
  if (x.of == NULL) return tp_fail_memory(message, "the columns");
  for (long k = 0; k < x.a->count; k++) x.of[k] = (neighbours){-1, -1, -1, -1, -1, -1, 0};
  const tp_status status = set_row(&x, message);
  free(x.of);
  if (status != TP_OK) tp_column_row_clear(row);
  return status;
}

void tp_column_row_clear(tp_column_row *row) {
  free(row->columns);
  memset(row, 0, sizeof *row);
}
