/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads the key columns: columns of one width on the steps of a slope, as Goodman and Bray (1976)
 * describe them, and the ground that carries them, all as exact rationals. x runs along the bases
 * from the toe on and y along the columns. With the first at the toe, the base of column n lies at
 * (n - 1) b. Tops rise by a1 from column to column up to the crest, so that heights are
 *     y_n = n (a1 - b)                    up to the crest, column c,
 *     y_n = y_c - (n - c) (a2 + b)        behind it.
 * Or each has the area of the slope between its joints (jointing/equal_area.h). */

#include "scene/members.h"
#include "scene_reading/read.h"

#include <flint/fmpq_vec.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_COLUMNS = TP_MOST_COLUMNS, MOST_NAME = 32 };

typedef struct made {
  long count;
  fmpq *heights;
} made;

/* ---- heights -----------------------------------------------------------------------------------
 */

static tp_status make_room(const tp_reader *reader, made *m, long count) {
  m->heights = _fmpq_vec_init(count);
  if (m->heights == NULL) return tp_fail_memory(reader->message, "the columns");
  m->count = count;
  return TP_OK;
}

static tp_status refuse_count(const tp_reader *reader, tp_place place, const char *what) {
  return tp_refuse(reader->message, TP_FAULT_RANGE, place,
                   "%s must be a whole number, and all columns no more than %d", what,
                   MOST_COLUMNS);
}

static tp_status read_count(const tp_reader *reader, long *count, const tp_quantity *given,
                            const char *what) {
  const fmpq *value = given->value;
  if (!fmpz_is_one(fmpq_denref(value)) || fmpq_sgn(value) < 0 ||
      fmpq_cmp_si(value, MOST_COLUMNS) >= 0) {
    return refuse_count(reader, given->place, what);
  }
  *count = fmpz_get_si(fmpq_numref(value));
  return TP_OK;
}

/* Of the columns from the toe to the crest, and behind it. */
static tp_status read_counts(const tp_reader *reader, long *front, long *back) {
  const tp_columns_description *own = &reader->scene->many.columns;
  tp_status status = read_count(reader, front, &own->below_crest, "below_crest");
  if (status == TP_OK) status = read_count(reader, back, &own->above_crest, "above_crest");
  if (status != TP_OK) return status;
  *front += 1;
  return *front + *back <= MOST_COLUMNS
             ? TP_OK
             : refuse_count(reader, own->above_crest.place, "above_crest");
}

/* `change` is the height of the toe. */
static tp_status make_front(const tp_reader *reader, const made *m, long front,
                            const fmpq_t change) {
  if (fmpq_sgn(change) <= 0) {
    return tp_refuse(reader->message, TP_FAULT_RANGE, reader->scene->many.columns.rise.place,
                     "the toe is as high as the difference of 'rise' to 'step', which is not above "
                     "zero here: give a greater 'rise', or the 'heights'");
  }
  for (long k = 0; k < front; k++) fmpq_mul_si(m->heights + k, change, k + 1);
  return TP_OK;
}

static tp_status make_back(const tp_reader *reader, const made *m, long front,
                           const fmpq_t change) {
  for (long k = front; k < m->count; k++) {
    fmpq_sub(m->heights + k, m->heights + k - 1, change);
    if (fmpq_sgn(m->heights + k) > 0) continue;
    return tp_refuse(reader->message, TP_FAULT_RANGE, reader->scene->many.columns.above_crest.place,
                     "column %ld would have no height left, as tops fall by 'fall' and bases rise "
                     "by 'step' behind the crest: give 'above_crest' of %ld or less, or a smaller "
                     "'fall'",
                     k + 1, k - front);
  }
  return TP_OK;
}

static tp_status make_heights(const tp_reader *reader, made *m) {
  const tp_columns_description *own = &reader->scene->many.columns;
  long front = 0, back = 0;
  fmpq_t change;
  tp_status status = read_counts(reader, &front, &back);
  if (status == TP_OK) status = make_room(reader, m, front + back);
  if (status != TP_OK) return status;
  fmpq_init(change);
  fmpq_sub(change, own->rise.value, own->step.value);
  status = make_front(reader, m, front, change);
  fmpq_add(change, own->fall.value, own->step.value);
  if (status == TP_OK) status = make_back(reader, m, front, change);
  fmpq_clear(change);
  return status;
}

static tp_status read_heights(const tp_reader *reader, made *m, const tp_node *node) {
  const tp_columns_description *own = &reader->scene->many.columns;
  if (own->rise.given || own->fall.given || own->below_crest.given || own->above_crest.given) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "columns have their 'heights', or 'rise', 'fall', 'below_crest' and "
                        "'above_crest' that make them, not both");
  }
  if (node->kind != TP_NODE_SEQUENCE || node->count == 0 || node->count > MOST_COLUMNS) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node,
                        "heights are a list from the toe on, of up to %d: [4, 8, 6]", MOST_COLUMNS);
  }
  tp_status status = make_room(reader, m, node->count);
  long k = 0;
  for (const tp_node *n = node->first; n != NULL && status == TP_OK; n = n->next) {
    status =
        tp_read_by_rule(reader, m->heights + k++, n, "the height of a column", TP_RULE_ABOVE_ZERO);
  }
  return status;
}

static tp_status find_heights(const tp_reader *reader, made *m, const tp_node *node,
                              const tp_node *root) {
  const tp_node *heights = tp_node_get(node, "heights"), *found = NULL;
  if (tp_node_get(node, "equal_area") != NULL)
    return tp_read_equal_area(reader, &m->heights, &m->count, node, root);
  if (heights != NULL) return read_heights(reader, m, heights);
  tp_status status = tp_read_required(reader, &found, node, "rise", "rise: 5");
  if (status == TP_OK) {
    status = tp_read_required(reader, &found, node, "below_crest", "below_crest: 9");
  }
  return status == TP_OK ? make_heights(reader, m) : status;
}

/* ---- blocks ------------------------------------------------------------------------------------
 */

static tp_listed_block *next_block(const tp_reader *reader, const tp_node *node,
                                   const tp_quantity *unit_weight) {
  return tp_scene_next_block(reader->scene, tp_node_place(node, reader->scene->path), unit_weight);
}

static tp_status list(const tp_reader *reader, tp_listed_block *own, const char *name) {
  own->name = strdup(name);
  tp_scene_list_block(reader->scene, own);
  return own->name != NULL ? TP_OK : tp_fail_memory(reader->message, "the columns");
}

/* A point at so many widths along x, and so many steps and, below the lowest base, widths up. */
static bool append(const tp_reader *reader, long along, long steps, long down) {
  const tp_columns_description *own = &reader->scene->many.columns;
  tp_block_description *block = &reader->scene->block;
  fmpq_t x, y, part;
  fmpq_init(x);
  fmpq_init(y);
  fmpq_init(part);
  fmpq_mul_si(x, own->width.value, along);
  fmpq_mul_si(y, own->step.value, steps);
  fmpq_mul_si(part, own->width.value, down);
  fmpq_sub(y, y, part);
  const bool done =
      tp_polyline_append(&block->outline, x, y, (tp_mark){block->place.line, block->place.column});
  fmpq_clear(x);
  fmpq_clear(y);
  fmpq_clear(part);
  return done;
}

/* A width beyond either end, and two deep. Level ground has no steps. */
static bool make_ground(const tp_reader *reader, long count) {
  enum { DEEP = 2 };
  const int sign = fmpq_sgn(reader->scene->many.columns.step.value);
  const long lowest = sign < 0 ? count - 1 : 0;
  tp_block_description *block = &reader->scene->block;
  block->form = TP_OUTLINE_VERTICES;
  block->outline.file = reader->scene->path;
  block->outline.mark = (tp_mark){block->place.line, block->place.column};
  bool done = append(reader, -1, lowest, DEEP) && append(reader, count + 1, lowest, DEEP) &&
              append(reader, count + 1, count - 1, 0);
  for (long k = count - 1; k > 0 && sign != 0 && done; k--) {
    done = append(reader, k, k, 0) && append(reader, k, k - 1, 0);
  }
  return done && append(reader, -1, 0, 0);
}

static tp_status add_ground(const tp_reader *reader, const tp_node *node, long count,
                            const tp_quantity *unit_weight) {
  tp_listed_block *own = next_block(reader, node, unit_weight);
  own->fixed = true;
  const bool done = make_ground(reader, count);
  const tp_status status = list(reader, own, "ground");
  return done ? status : tp_fail_memory(reader->message, "the columns");
}

static tp_status add_column(const tp_reader *reader, const tp_node *node, const made *m, long k,
                            const tp_quantity *unit_weight) {
  const tp_columns_description *columns = &reader->scene->many.columns;
  tp_block_description *block = &reader->scene->block;
  tp_listed_block *own = next_block(reader, node, unit_weight);
  char name[MOST_NAME];
  snprintf(name, sizeof name, "column %ld", k + 1);
  block->form = TP_OUTLINE_SLAB;
  block->teeth.count = 1;
  fmpq_set(block->teeth.width, columns->width.value);
  fmpq_set(block->teeth.height, m->heights + k);
  own->at_x.given = own->at_y.given = true;
  fmpq_mul_si(own->at_x.value, columns->width.value, k);
  fmpq_mul_si(own->at_y.value, columns->step.value, k);
  return list(reader, own, name);
}

static tp_status add_blocks(const tp_reader *reader, const tp_node *node, const made *m,
                            const tp_quantity *unit_weight) {
  tp_block_list *many = &reader->scene->many;
  many->blocks = calloc((size_t)m->count + 1, sizeof *many->blocks);
  if (many->blocks == NULL) return tp_fail_memory(reader->message, "the columns");
  tp_status status = add_ground(reader, node, m->count, unit_weight);
  for (long k = 0; k < m->count && status == TP_OK; k++) {
    status = add_column(reader, node, m, k, unit_weight);
  }
  return status;
}

tp_status tp_read_columns(const tp_reader *reader, const tp_node *node, const tp_node *root,
                          const tp_quantity *unit_weight) {
  made m = {.count = 0};
  tp_status status = tp_read_map(reader, reader->scene, node, &tp_key_map_columns, "columns");
  if (status == TP_OK) status = find_heights(reader, &m, node, root);
  if (status == TP_OK) status = add_blocks(reader, node, &m, unit_weight);
  if (m.heights != NULL) _fmpq_vec_clear(m.heights, m.count);
  return status;
}

/* ---- joints ------------------------------------------------------------------------------------
 */

tp_status tp_read_column_joints(const tp_reader *reader) {
  tp_block_list *many = &reader->scene->many;
  const tp_quantity *friction = &many->columns.side_friction_angle_deg;
  if (!friction->given) return TP_OK;
  tp_joint_description *joints =
      realloc(many->joints, (size_t)(many->joint_count + many->count) * sizeof *joints);
  if (joints == NULL) return tp_fail_memory(reader->message, "the joints");
  many->joints = joints;
  for (long k = 1; k + 1 < many->count; k++) {
    tp_joint_description *own = joints + many->joint_count++;
    memset(own, 0, sizeof *own);
    tp_joint_init(own);
    own->place = friction->place;
    own->between[0] = k;
    own->between[1] = k + 1;
    own->friction_angle_deg.given = true;
    own->friction_angle_deg.place = friction->place;
    fmpq_set(own->friction_angle_deg.value, friction->value);
  }
  return TP_OK;
}
