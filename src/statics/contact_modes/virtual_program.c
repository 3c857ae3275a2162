/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Of two loads T and H are the same but for the slide in T: what does not depend on that is stated
 * once. */

#include "contact_modes/virtual_program.h"

#include "number/ball.h"

#include <stdlib.h>
#include <string.h>

void tp_virtual_program_clear(tp_virtual_program *p) {
  free(p->is_traded);
  free(p->role);
  free(p->of_gap);
  for (int k = 0; k < 2; k++) free(p->reach[k]);
  free(p->entries);
  tp_linear_forms_clear(&p->signs);
  tp_linear_forms_clear(&p->powers);
  tp_linear_forms_clear(&p->mass);
  memset(p, 0, sizeof *p);
}

static long add_unknown(tp_virtual_program *p, long role) {
  enum { FIRST_ROOM = 1024 };
  if (p->unknown_count == p->unknown_room && !p->failed) {
    const long room = p->unknown_room == 0 ? FIRST_ROOM : 2 * p->unknown_room;
    bool *traded = realloc(p->is_traded, (size_t)room * sizeof *traded);
    if (traded != NULL) p->is_traded = traded;
    long *roles = realloc(p->role, (size_t)room * sizeof *roles);
    if (roles != NULL) p->role = roles;
    p->failed = traded == NULL || roles == NULL;
    if (!p->failed) p->unknown_room = room;
  }
  if (p->failed) return -1;
  p->is_traded[p->unknown_count] = false;
  p->role[p->unknown_count] = role;
  if (role >= p->role_count) p->role_count = role + 1;
  return p->unknown_count++;
}

static const tp_virtual_row zero_row = {{{0, 0}, {0, 0}, {0, 0}}};

/* The unknowns of H of a block and a gap near it, three; -1: that is not near. */
static long unknown_of(const tp_virtual_program *p, long block, long gap) {
  const tp_virtual_block *centre = p->frame->blocks + block;
  for (long k = 0; k < centre->near_count; k++) {
    if (centre->near[k] == gap) return p->of_gap[block] + 3 * k;
  }
  return -1;
}

/* ---- forces ------------------------------------------------------------------------------------
 */

/* One edge of the cone of an end, with a load. */
typedef struct edge {
  const tp_virtual_contact *contact;
  const tp_virtual_relations *relations;
  long number; /* of the contact */
  int end, sense;
  tp_near drive;
  tp_virtual_row force; /* on the twist of the first block less that of the second */
  long traded;          /* the unknown part of the slip that is stated by gaps; -1 */
  long first_relation;  /* unknown */
} edge;

/* The work of a force on T times a twist, times a factor. */
static void add_transformed(tp_virtual_program *p, const edge *g, const tp_virtual_row *twist,
                            tp_near factor) {
  tp_linear_forms *to = &p->signs;
  const tp_virtual_row *force = &g->force;
  const tp_near slide = tp_near_plus(force->of[0], tp_near_times(g->drive, force->of[1]));
  const tp_near share = tp_near_times(slide, twist->of[0]);
  tp_linear_forms_add_constant(to, tp_near_times(factor, share));
  for (int r = 0; r < 3; r++) {
    for (int c = 0; c < 2; c++) {
      const tp_near product = tp_near_times(force->of[r], twist->of[c + 1]);
      tp_linear_forms_add(to, p->transform[r][c], tp_near_times(factor, product));
    }
  }
}

/* The work on H of a gap. */
static void add_by_gap(tp_virtual_program *p, const edge *g, long gap) {
  for (int side = 0; side < 2; side++) {
    const long block = g->contact->block[side];
    const long unknown = block >= 0 ? unknown_of(p, block, gap) : -1;
    if (unknown < 0) continue;
    const tp_virtual_row central = tp_virtual_about_centroid(&g->force, p->frame->blocks + block);
    for (int c = 0; c < 3; c++) {
      tp_linear_forms_add(&p->signs, unknown + c,
                          side == 0 ? central.of[c] : tp_near_neg(central.of[c]));
    }
  }
}

/* Does the factor of a gap depend on T? Otherwise it is the same for all loads. */
static bool is_by_transform(const edge *g, long at) {
  const tp_virtual_relations *r = g->relations;
  const bool turns = r->has_turn && g->contact->is_joint;
  return turns ? !tp_near_is_zero(r->turn[at]) : r->gaps[at] == 2 * g->number + 1 - g->end;
}

static void add_sign_of_gap(tp_virtual_program *p, const edge *g, long at) {
  const tp_virtual_relations *r = g->relations;
  const tp_virtual_contact *c = g->contact;
  const tp_near sense = {g->sense, 0}, none = {0, 0};
  if (r->gaps[at] == 2 * g->number + g->end) return; /* is closed */
  tp_linear_forms_begin(&p->signs, none);
  const long before = p->signs.term_count;
  add_by_gap(p, g, r->gaps[at]);
  const tp_virtual_row *turn = c->turn + g->end;
  if (r->has_turn && c->is_joint) {
    add_transformed(p, g, turn, r->turn[at]);
  } else if (is_by_transform(g, at)) {
    const tp_near opens = tp_virtual_times(c->gaps + 1 - g->end, turn);
    add_transformed(p, g, turn, tp_near_div((tp_near){1, 0}, opens));
  }
  if (g->traded >= 0) tp_linear_forms_add(&p->signs, g->traded, tp_near_times(sense, r->slip[at]));
  for (long k = 0; k < r->relation_count; k++) {
    tp_linear_forms_add(&p->signs, g->first_relation + k, r->relations[k * r->count + at]);
  }
  const tp_near constant = p->signs.failed ? none : p->signs.forms[p->signs.count - 1].constant;
  if (p->signs.term_count == before && tp_near_is_zero(constant)) p->signs.count--;
}

/* sense times the factor of the slip less what is traded of it is at least 0. */
static void add_sign_of_slip(tp_virtual_program *p, const edge *g) {
  const tp_near sense = {-g->sense, 0};
  tp_linear_forms_begin(&p->signs, (tp_near){0, 0});
  add_transformed(p, g, &g->contact->slide, sense);
  tp_linear_forms_add(&p->signs, g->traded, (tp_near){1, 0});
}

static void add_edge(tp_virtual_program *p, const tp_virtual_relations *r, long contact, int end,
                     int sense, tp_near friction, long role) {
  const tp_virtual_contact *c = p->frame->contacts + contact;
  edge g = {.contact = c,
            .relations = r,
            .number = contact,
            .end = end,
            .sense = sense,
            .force = zero_row,
            .traded = r->has_slip ? add_unknown(p, role) : -1};
  if (g.traded >= 0) p->is_traded[g.traded] = true;
  g.first_relation = p->unknown_count;
  for (long k = 0; k < r->relation_count; k++) (void)add_unknown(p, role + 1 + k);
  const tp_near shear = sense > 0 ? friction : tp_near_neg(friction);
  for (int k = 0; k < 3; k++) {
    g.force.of[k] = tp_near_plus(c->gaps[end].of[k], tp_near_times(shear, c->slips.of[k]));
  }
  for (int load = 0; load < p->load_count; load++) {
    g.drive = p->drive[load];
    add_sign_of_slip(p, &g);
    for (long k = 0; k < r->count && !p->failed; k++) {
      if (load == 0 || is_by_transform(&g, k)) add_sign_of_gap(p, &g, k);
    }
  }
}

static bool is_same(tp_near a, tp_near b) {
  return a.value == b.value && a.error == b.error;
}

static void add_contact(tp_virtual_program *p, long contact) {
  const tp_modes_question *q = p->question;
  const bool one = is_same(q->friction[0][contact], q->friction[1][contact]);
  tp_virtual_relations r;
  p->failed = p->failed || !tp_virtual_relations_init(&r, p->frame, contact);
  if (p->failed) return;
  for (int k = 0; k < 4; k++) {
    const long role = p->role_count;
    for (int bound = 0; bound < (one ? 1 : 2); bound++) {
      add_edge(p, &r, contact, k / 2, k % 2 == 0 ? 1 : -1, q->friction[bound][contact], role);
    }
  }
  tp_virtual_relations_clear(&r);
}

/* ---- loads -------------------------------------------------------------------------------------
 */

/* Of a block, over its weight and the part across D: (drive, -1, 0) about its centroid. */
static tp_virtual_row load_of(const tp_virtual_block *block, tp_near drive) {
  return (tp_virtual_row){
      {tp_near_times(block->weight, drive), tp_near_neg(block->weight), {0, 0}}};
}

/* The row about its centroid as one about the origin, and back. */
static tp_virtual_row about_origin(const tp_virtual_row *row, const tp_virtual_block *b) {
  tp_virtual_row shifted = *row;
  shifted.of[2] = tp_near_minus(shifted.of[2], tp_near_minus(tp_near_times(row->of[0], b->across),
                                                             tp_near_times(row->of[1], b->along)));
  return shifted;
}

/* Work on T a less the sum of gaps times `reach`, by component of the block's acceleration; on the
 * first column of T loads do no work. */
static void add_powers(tp_virtual_program *p, int load, long block) {
  const tp_virtual_block *b = p->frame->blocks + block;
  const tp_virtual_row central = load_of(b, p->drive[load]);
  const tp_virtual_row force = about_origin(&central, b);
  for (int c = 0; c < 3; c++) {
    tp_linear_forms_begin(&p->powers, (tp_near){0, 0});
    for (int r = 0; r < 3 && c > 0; r++) {
      tp_linear_forms_add(&p->powers, p->transform[r][c - 1], force.of[r]);
    }
    for (long gap = 0; gap < 2 * p->frame->contact_count; gap++) {
      const tp_virtual_contact *contact = p->frame->contacts + gap / 2;
      for (int side = 0; side < 2; side++) {
        if (contact->block[side] != block) continue;
        const tp_near row = contact->gaps[gap % 2].of[c];
        tp_linear_forms_add(&p->powers, p->reach[load][gap], side == 0 ? tp_near_neg(row) : row);
      }
    }
  }
}

static void add_loads(tp_virtual_program *p, int load, long role) {
  const tp_virtual_frame *f = p->frame;
  for (long gap = 0; gap < 2 * f->contact_count; gap++) {
    p->reach[load][gap] = add_unknown(p, role + gap);
    tp_linear_forms_begin(&p->signs, (tp_near){0, 0});
    tp_linear_forms_add(&p->signs, p->reach[load][gap], (tp_near){1, 0});
    for (long b = 0; b < f->block_count; b++) {
      const long unknown = unknown_of(p, b, gap);
      const tp_virtual_row weight = load_of(f->blocks + b, p->drive[load]);
      for (int c = 0; c < 2 && unknown >= 0; c++) {
        tp_linear_forms_add(&p->signs, unknown + c, weight.of[c]);
      }
    }
  }
  for (long b = 0; b < f->block_count; b++) add_powers(p, load, b);
}

bool tp_virtual_is_of_transform(long unknown) {
  return unknown < 6;
}

long tp_virtual_first_of_load(const tp_virtual_program *p, int load) {
  return p->signs.count - (p->load_count - load) * 2 * p->frame->contact_count;
}

/* ---- mass --------------------------------------------------------------------------------------
 */

/* Of block b, in the components about its centroid: M v . a over the square roots of both. */
typedef struct massing {
  tp_virtual_program *p;
  int load;
  tp_near *scale; /* by component: 1 over the root of about its mass */
  tp_near *mass;
} massing;

static tp_near scaled(const massing *m, long row, long column) {
  return tp_near_times(m->scale[row], tp_near_times(m->mass[row], m->scale[column]));
}

/* T about the centroid of a block: the factor of T_rc on entry (i, k) is C_ir C^-1_ck. */
static void set_shifts(tp_near to[3][3], tp_near back[3][3], const tp_virtual_block *b) {
  for (int r = 0; r < 3; r++) {
    for (int c = 0; c < 3; c++) to[r][c] = back[r][c] = (tp_near){r == c ? 1 : 0, 0};
  }
  to[0][2] = tp_near_neg(b->across);
  to[1][2] = b->along;
  back[0][2] = b->across;
  back[1][2] = tp_near_neg(b->along);
}

static void add_of_block(massing *m, long block, int i, int k, tp_near factor) {
  tp_virtual_program *p = m->p;
  tp_near to[3][3], back[3][3];
  set_shifts(to, back, p->frame->blocks + block);
  const tp_near scale = tp_near_times(factor, scaled(m, 3 * block + i, 3 * block + k));
  const tp_near slide = tp_near_plus(to[i][0], tp_near_times(p->drive[m->load], to[i][1]));
  tp_linear_forms_add_constant(&p->mass, tp_near_times(scale, tp_near_times(slide, back[0][k])));
  for (int r = 0; r < 3; r++) {
    for (int c = 1; c < 3; c++) {
      const tp_near share = tp_near_times(to[i][r], back[c][k]);
      tp_linear_forms_add(&p->mass, p->transform[r][c - 1], tp_near_times(scale, share));
    }
  }
}

/* H of a block times the row of each gap near it. */
static void add_of_gaps(massing *m, long row, long column, tp_near factor) {
  tp_virtual_program *p = m->p;
  const long block = row / 3, other = column / 3;
  const tp_virtual_block *b = p->frame->blocks + block;
  const tp_near scale = tp_near_times(factor, scaled(m, row, column));
  for (long k = 0; k < b->near_count; k++) {
    const tp_virtual_contact *c = p->frame->contacts + b->near[k] / 2;
    for (int side = 0; side < 2; side++) {
      if (c->block[side] != other) continue;
      const tp_virtual_row g =
          tp_virtual_about_centroid(c->gaps + b->near[k] % 2, p->frame->blocks + other);
      const tp_near entry = side == 0 ? g.of[column % 3] : tp_near_neg(g.of[column % 3]);
      tp_linear_forms_add(&p->mass, p->of_gap[block] + 3 * k + row % 3,
                          tp_near_times(scale, entry));
    }
  }
}

static bool are_coupled(const tp_virtual_frame *f, long block, long other) {
  bool coupled = block == other;
  for (long k = 0; k < f->blocks[block].near_count && !coupled; k++) {
    const long *of = f->contacts[f->blocks[block].near[k] / 2].block;
    coupled = of[0] == other || of[1] == other;
  }
  return coupled;
}

static void add_entry(massing *m, long row, long column) {
  tp_virtual_program *p = m->p;
  enum { FIRST_ROOM = 1024 };
  if (p->mass.count == p->entry_room && !p->failed) {
    const long room = p->entry_room == 0 ? FIRST_ROOM : 2 * p->entry_room;
    tp_virtual_entry *more = realloc(p->entries, (size_t)room * sizeof *more);
    p->failed = more == NULL;
    if (!p->failed) {
      p->entries = more;
      p->entry_room = room;
    }
  }
  if (p->failed) return;
  const tp_near one = {1, 0};
  p->entries[p->mass.count] = (tp_virtual_entry){row, column, m->load};
  tp_linear_forms_begin(&p->mass, (tp_near){0, 0});
  if (row / 3 == column / 3) {
    add_of_block(m, row / 3, (int)(row % 3), (int)(column % 3), one);
    add_of_block(m, row / 3, (int)(column % 3), (int)(row % 3), one);
  }
  add_of_gaps(m, row, column, one);
  add_of_gaps(m, column, row, one);
}

bool tp_virtual_is_beside(const tp_virtual_program *p, long entry, long other) {
  const tp_virtual_entry *one = p->entries + entry, *of = p->entries + other;
  const bool is_of_load = one->load == of->load || of->row / 3 != of->column / 3;
  return entry != other && is_of_load && (of->row == one->row || of->column == one->row);
}

static void add_mass(tp_virtual_program *p, int load) {
  const tp_virtual_frame *f = p->frame;
  const size_t rows = 3 * (size_t)f->block_count + 1;
  massing m = {.p = p,
               .load = load,
               .scale = calloc(rows, sizeof *m.scale),
               .mass = calloc(rows, sizeof *m.mass)};
  p->failed = p->failed || m.scale == NULL || m.mass == NULL;
  for (long r = 0; r < 3 * f->block_count && !p->failed; r++) {
    const tp_virtual_block *b = f->blocks + r / 3;
    m.mass[r] = tp_near_times(b->weight, r % 3 < 2 ? f->size2 : b->gyration2);
    m.scale[r] = (tp_near){1 / sqrt(m.mass[r].value), 0};
  }
  for (long b = 0; b < f->block_count; b++) {
    for (long other = b; other < f->block_count; other++) {
      const bool is_repeated = load > 0 && b != other; /* of the first load */
      if (is_repeated || (!are_coupled(f, b, other) && !are_coupled(f, other, b))) continue;
      for (int k = 0; k < 9 && !p->failed; k++) {
        const long row = 3 * b + k / 3, column = 3 * other + k % 3;
        if (column >= row) add_entry(&m, row, column);
      }
    }
  }
  free(m.scale);
  free(m.mass);
}

/* ---- all ---------------------------------------------------------------------------------------
 */

static bool set_drive(tp_near *drive, const tp_virtual_frame *f, const tp_near *loads) {
  const tp_near down[2] = {tp_near_neg(loads[0]), tp_near_neg(loads[1])};
  const tp_near dx = tp_near_whole(f->direction[0]), dy = tp_near_whole(f->direction[1]);
  const tp_near along = tp_near_plus(tp_near_times(down[0], dx), tp_near_times(down[1], dy));
  const tp_near across = tp_near_minus(tp_near_times(down[1], dx), tp_near_times(down[0], dy));
  if (tp_near_sign(across) <= 0) return false;
  *drive = tp_near_neg(tp_near_div(along, across));
  return true;
}

static bool has_room(tp_virtual_program *p) {
  const tp_virtual_frame *f = p->frame;
  p->of_gap = calloc((size_t)f->block_count + 1, sizeof *p->of_gap);
  bool done = p->of_gap != NULL;
  for (int k = 0; k < 2; k++) {
    p->reach[k] = calloc(2 * (size_t)f->contact_count + 1, sizeof *p->reach[k]);
    done = done && p->reach[k] != NULL;
  }
  return done;
}

tp_status tp_virtual_program_init(bool *exists, tp_virtual_program *p, const tp_virtual_frame *f,
                                  const tp_modes_question *q, tp_message *message) {
  *p = (tp_virtual_program){.frame = f, .question = q, .load_count = q->load_count};
  *exists = q->weights_alone;
  for (int k = 0; k < q->load_count; k++) *exists &= set_drive(p->drive + k, f, q->loads[k]);
  for (long k = 0; k < f->contact_count; k++) *exists &= tp_near_is_zero(q->cohesion[1][k]);
  if (!*exists) return TP_OK;
  p->failed = !has_room(p);
  for (int k = 0; k < 6; k++) p->transform[k / 2][k % 2] = add_unknown(p, k);
  for (long b = 0; b < f->block_count && !p->failed; b++) {
    p->of_gap[b] = p->unknown_count;
    for (long k = 0; k < 3 * f->blocks[b].near_count; k++) {
      (void)add_unknown(p, p->role_count);
    }
  }
  for (long k = 0; k < f->contact_count && !p->failed; k++) add_contact(p, k);
  const long role = p->role_count;
  for (int k = 0; k < p->load_count && !p->failed; k++) add_loads(p, k, role);
  for (int k = 0; k < p->load_count && !p->failed; k++) add_mass(p, k);
  if (!p->failed && !p->signs.failed && !p->powers.failed && !p->mass.failed) return TP_OK;
  tp_virtual_program_clear(p);
  *exists = false;
  return tp_fail_memory(message, "a proof");
}
