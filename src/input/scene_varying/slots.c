/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Matches a key word by word against the rows of scene_varying/slot_table.h, with indices of items,
 * points and axes, and reads or writes the number found. */

#include "scene_varying/slots.h"

#include "common/outside.h"
#include "scene/members.h"
#include "scene_keys.h"
#include "scene_varying/slot_table.h"

#include <stdlib.h>
#include <string.h>

#define A_ROW(key, kind, list, offset, rule, has, settle) 0,
enum { ROWS = sizeof((const char[]){TP_SCENE_KEYS(A_ROW)}) };

/* The scene, or the item of its list. */
static char *holder(const tp_slot *slot, const tp_scene *scene) {
  if (slot->row->list == TP_LISTS) return (char *)scene;
  return tp_member_items(scene, slot->row->list) +
         (size_t)slot->item * tp_scene_lists[slot->row->list].size;
}

static tp_quantity *quantity_of(const tp_slot *slot, const tp_scene *scene) {
  return (tp_quantity *)(void *)(holder(slot, scene) + slot->row->offset);
}

static tp_polyline *line_of(const tp_slot *slot, const tp_scene *scene) {
  return tp_member_line(holder(slot, scene), slot->row->offset);
}

static fmpq *number_of(const tp_slot *slot, const tp_scene *scene) {
  return tp_member_number(holder(slot, scene), slot->row->offset);
}

static fmpq *coordinate_of(const tp_slot *slot, const tp_scene *scene) {
  const tp_polyline *line = line_of(slot, scene);
  return (slot->axis == 0 ? line->x : line->y) + slot->point;
}

/* ---- the way to a number -----------------------------------------------------------------------
 */

/* A row on the way: the rest of its key, and how many numbers of the key it has taken. */
typedef struct way {
  tp_slot slot;
  const char *rest;
  int numbers;
} way;

/* Has the scene what a row names, so far as its item is known? */
static bool is_given(const way *w, const tp_scene *scene) {
  const tp_slot_row *row = w->slot.row;
  if (row->has != NULL && !row->has(scene)) return false;
  if (row->list != TP_LISTS && w->numbers == 0) return tp_member_count(scene, row->list) > 0;
  if (row->kind == TP_SLOT_QUANTITY) return quantity_of(&w->slot, scene)->given;
  return row->kind != TP_SLOT_POINT || line_of(&w->slot, scene)->count > 0;
}

/* Of up to 9 digits; 0: none. */
static long read_number(const char *text, size_t length) {
  long number = 0;
  for (size_t k = 0; k < length; k++) {
    if (length > 9 || text[k] < '0' || text[k] > '9') return 0;
    number = 10 * number + (text[k] - '0');
  }
  return number;
}

/* The next number of a key: of an item, of a point in a chain, of x or y. */
static bool take_number(way *w, const tp_scene *scene, long number) {
  const int kind = w->numbers++ + (w->slot.row->list == TP_LISTS ? 1 : 0);
  if (number < 1) return false;
  if (kind == 0) {
    w->slot.item = number - 1;
    return number <= tp_member_count(scene, w->slot.row->list) && is_given(w, scene);
  }
  if (kind == 1) {
    w->slot.point = number - 1;
    return number <= line_of(&w->slot, scene)->count;
  }
  w->slot.axis = (int)number - 1;
  return number <= 2;
}

/* Does the way go on by this word? */
static bool take_word(way *w, const tp_scene *scene, const char *word, size_t length) {
  const size_t own = strcspn(w->rest, ".");
  const bool goes_on = *w->rest == '#' ? take_number(w, scene, read_number(word, length))
                                       : own == length && strncmp(w->rest, word, own) == 0;
  w->rest += own + (w->rest[own] == '.' ? 1 : 0);
  return goes_on;
}

/* `nearest` of the words by which the ways go on. */
static tp_status fail(const way *ways, size_t count, const char *word, size_t length,
                      const tp_scene *scene, tp_message *message) {
  char *key = strndup(word, length), *words[ROWS + 1] = {NULL};
  bool done = key != NULL;
  for (size_t k = 0; k < count && done; k++) {
    words[k] = strndup(ways[k].rest, strcspn(ways[k].rest, "."));
    done = words[k] != NULL;
  }
  const char *nearest = done ? tp_nearest(key, (const char *const *)words) : NULL;
  const bool tells = nearest != NULL && *nearest != '#';
  const tp_status status =
      done ? tp_refuse(message, TP_FAULT_KEY, (tp_place){scene->path, 0, 0},
                       "there is no '%s' here%s%s%s", tp_quote_all(key).text,
                       tells ? "; did you mean '" : "", tells ? nearest : "", tells ? "'?" : "")
           : tp_fail_memory(message, "a key");
  for (size_t k = 0; k < count; k++) free(words[k]);
  free(key);
  return status;
}

tp_status tp_slot_find(tp_slot *slot, const tp_scene *scene, const char *key, tp_message *message) {
  way ways[ROWS];
  size_t count = 0;
  for (size_t k = 0; k < ROWS; k++) {
    const way w = {.slot = {.row = tp_slot_rows + k, .key = key}, .rest = tp_slot_rows[k].key};
    if (is_given(&w, scene)) ways[count++] = w;
  }
  for (const char *word = key; word != NULL;) {
    const size_t length = strcspn(word, ".");
    way next[ROWS];
    size_t left = 0;
    for (size_t k = 0; k < count; k++) {
      next[left] = ways[k];
      if (take_word(next + left, scene, word, length)) left++;
    }
    if (left == 0) return fail(ways, count, word, length, scene, message);
    memcpy(ways, next, left * sizeof *ways);
    count = left;
    word = word[length] == '.' ? word + length + 1 : NULL;
  }
  for (size_t k = 0; k < count; k++) {
    if (*ways[k].rest != '\0') continue;
    *slot = ways[k].slot;
    return TP_OK;
  }
  return tp_refuse(message, TP_FAULT_KEY, (tp_place){scene->path, 0, 0},
                   "'%s' is a list or a map; a single number can be found", tp_quote_all(key).text);
}

/* ---- the number --------------------------------------------------------------------------------
 */

const char *tp_slot_pattern(const tp_slot *slot) {
  return slot->row->key;
}

tp_place tp_slot_place(const tp_slot *slot, const tp_scene *scene) {
  switch (slot->row->kind) {
  case TP_SLOT_QUANTITY:
    return quantity_of(slot, scene)->place;
  case TP_SLOT_POINT:
    return tp_polyline_place(line_of(slot, scene), slot->point);
  case TP_SLOT_NUMBER:
  case TP_SLOT_TEETH:
    break;
  }
  return scene->block.place;
}

void tp_slot_get(fmpq_t value, const tp_slot *slot, const tp_scene *scene) {
  switch (slot->row->kind) {
  case TP_SLOT_QUANTITY:
    fmpq_set(value, quantity_of(slot, scene)->value);
    break;
  case TP_SLOT_POINT:
    fmpq_set(value, coordinate_of(slot, scene));
    break;
  case TP_SLOT_NUMBER:
    fmpq_set(value, number_of(slot, scene));
    break;
  case TP_SLOT_TEETH:
    fmpq_set_si(value, scene->block.teeth.count, 1);
    break;
  }
}

/* The last word of the key; of a coordinate, which has none, the whole. */
static const char *name_of(const tp_slot *slot) {
  const char *dot = strrchr(slot->key, '.');
  const char *last = dot != NULL ? dot + 1 : slot->key;
  return *last >= '0' && *last <= '9' ? slot->key : last;
}

static tp_status set_number(tp_scene *scene, const tp_slot *slot, const fmpq_t value,
                            tp_message *message) {
  const tp_place place = tp_slot_place(slot, scene);
  tp_status status = tp_check_rule(slot->row->rule, value, name_of(slot), place, message);
  if (status != TP_OK) return status;
  switch (slot->row->kind) {
  case TP_SLOT_QUANTITY:
    fmpq_set(quantity_of(slot, scene)->value, value);
    break;
  case TP_SLOT_POINT:
    if (!tp_polyline_separate(line_of(slot, scene))) return tp_fail_memory(message, "the scene");
    fmpq_set(coordinate_of(slot, scene), value);
    break;
  case TP_SLOT_NUMBER:
    fmpq_set(number_of(slot, scene), value);
    break;
  case TP_SLOT_TEETH:
    status = tp_check_tooth_count(&scene->block.teeth.count, value, "count", place, message);
    break;
  }
  return status;
}

/* What follows from a slot has followed from the one before it already. */
static bool is_settled(const tp_scene *scene, const tp_slot *slots, size_t k) {
  return k > 0 && slots[k].row->settle == slots[k - 1].row->settle &&
         holder(slots + k, scene) == holder(slots + k - 1, scene);
}

tp_status tp_slots_set(tp_scene *scene, const tp_slot *slots, const fmpq *values, size_t count,
                       tp_message *message) {
  tp_status status = TP_OK;
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    status = set_number(scene, slots + k, values + k, message);
  }
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    const tp_slot_row *row = slots[k].row;
    if (row->settle == NULL || is_settled(scene, slots, k)) continue;
    status = row->settle(scene, holder(slots + k, scene), message);
  }
  return status;
}
