/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene made, with what holds where nothing is given, copied, and given back; the block that was
 * read moved to the list of many, and those of the list copied with it. */

#include "scene/members.h"
#include "scene/partial_factors.h"

#include <stdlib.h>
#include <string.h>

tp_scene *tp_scene_make(const char *path) {
  tp_scene *scene = calloc(1, sizeof *scene);
  if (scene == NULL) return NULL;
  scene->path = path;
  for (size_t k = 0; k < tp_scene_numbers.count; k++) {
    fmpq_init(tp_member_number(scene, tp_scene_numbers.items[k]));
  }
  scene->base.mated = true;
  scene->towards_left = scene->towards_right = true;
  return scene;
}

static void clear_numbers(void *of, const tp_offsets *numbers) {
  for (size_t k = 0; k < numbers->count; k++) fmpq_clear(tp_member_number(of, numbers->items[k]));
}

static void clear_list(tp_scene *scene, tp_list_kind kind) {
  const tp_list *list = tp_scene_lists + kind;
  char *items = tp_member_items(scene, kind);
  const long count = tp_member_count(scene, kind);
  for (long k = 0; k < count && items != NULL; k++) {
    char *item = items + (size_t)k * list->size;
    clear_numbers(item, &list->numbers);
    if (list->has_line) tp_polyline_clear(tp_member_line(item, list->line));
  }
  free(items);
}

static bool is_of_block(size_t offset) {
  return offset >= offsetof(tp_scene, block) &&
         offset < offsetof(tp_scene, block) + sizeof(tp_block_description);
}

static void clear_block(tp_scene *scene) {
  for (int k = 0; k < TP_LISTS; k++) {
    if (is_of_block(tp_scene_lists[k].items)) clear_list(scene, (tp_list_kind)k);
  }
  for (size_t k = 0; k < tp_scene_lines.count; k++) {
    const size_t offset = tp_scene_lines.items[k];
    if (is_of_block(offset)) tp_polyline_clear(tp_member_line(scene, offset));
  }
  for (size_t k = 0; k < tp_scene_numbers.count; k++) {
    const size_t offset = tp_scene_numbers.items[k];
    if (is_of_block(offset)) fmpq_clear(tp_member_number(scene, offset));
  }
}

/* Numbers of a block with nothing given: it is all zero already. */
static void init_shape(tp_block_description *shape) {
  for (size_t k = 0; k < tp_scene_numbers.count; k++) {
    const size_t offset = tp_scene_numbers.items[k];
    if (is_of_block(offset)) fmpq_init(tp_member_number(shape, offset - offsetof(tp_scene, block)));
  }
}

void tp_listed_block_init(tp_listed_block *listed, tp_place place) {
  memset(listed, 0, sizeof *listed);
  listed->place = listed->shape.place = place;
  for (size_t k = 0; k < tp_listed_block_numbers.count; k++) {
    fmpq_init(tp_member_number(listed, tp_listed_block_numbers.items[k]));
  }
  init_shape(&listed->shape);
}

const tp_quantity *tp_listed_block_unit_weight(const tp_scene *scene,
                                               const tp_listed_block *listed) {
  const tp_quantity *own = &listed->shape.unit_weight_kn_m3;
  return own->given ? own : &scene->block.unit_weight_kn_m3;
}

tp_listed_block *tp_scene_next_block(tp_scene *scene, tp_place place,
                                     const tp_quantity *unit_weight) {
  tp_listed_block *own = scene->many.blocks + scene->many.count++;
  tp_listed_block_init(own, place);
  scene->block.place = place;
  tp_quantity_copy(&scene->block.unit_weight_kn_m3, unit_weight);
  return own;
}

void tp_scene_list_block(tp_scene *scene, tp_listed_block *listed) {
  listed->shape = scene->block;
  memset(&scene->block, 0, sizeof scene->block);
  init_shape(&scene->block);
}

const tp_joint_set *tp_block_list_set(const tp_block_list *many, long block, long edge) {
  const int *sets = many->blocks[block].edge_sets;
  if (sets == NULL || sets[edge] == TP_EDGE_OF_NONE) return NULL;
  return sets[edge] == TP_EDGE_OF_BASE ? &many->slope.base : many->slope.sets + sets[edge];
}

/* The members of a scene are known by their offsets in it: each block takes its place once more. */
static void clear_blocks(tp_scene *scene) {
  tp_block_list *many = &scene->many;
  for (long k = 0; k < many->count; k++) {
    clear_block(scene);
    scene->block = many->blocks[k].shape;
    clear_numbers(many->blocks + k, &tp_listed_block_numbers);
    free(many->blocks[k].name);
    free(many->blocks[k].edge_sets);
  }
  for (long k = 0; k < many->slope.set_count; k++) {
    clear_numbers(many->slope.sets + k, &tp_joint_set_numbers);
    free(many->slope.sets[k].name);
  }
  free(many->slope.sets);
  free(many->blocks);
}

static void clear_contact(tp_contact_description *contact) {
  clear_numbers(contact, &tp_contact_numbers);
  for (int k = 0; k < 3; k++) {
    fmpq_clear(contact->at + k);
    fmpq_clear(contact->normal + k);
  }
}

void tp_scene_free(tp_scene *scene) {
  if (scene == NULL) return;
  clear_blocks(scene);
  for (long k = 0; k < scene->solid.band_count; k++) fmpq_clear(scene->solid.bands + k);
  free(scene->solid.bands);
  for (long k = 0; k < scene->solid.contact_count; k++) clear_contact(scene->solid.contacts + k);
  free(scene->solid.contacts);
  for (long k = 0; k < scene->solid.part_count; k++) {
    clear_numbers(scene->solid.parts + k, &tp_solid_part_numbers);
  }
  free(scene->solid.parts);
  for (int k = 0; k < TP_LISTS; k++) clear_list(scene, (tp_list_kind)k);
  for (size_t k = 0; k < tp_scene_lines.count; k++) {
    tp_polyline_clear(tp_member_line(scene, tp_scene_lines.items[k]));
  }
  clear_numbers(scene, &tp_scene_numbers);
  for (long k = 0; k < scene->parameters.count; k++) {
    free(scene->parameters.names[k]);
    fmpq_clear(scene->parameters.values + k);
  }
  free(scene->parameters.names);
  free(scene->parameters.values);
  tp_overrides_free(scene->overrides, scene->override_count);
  tp_notes_clear(&scene->notes);
  free(scene->title);
  tp_letterhead_clear(&scene->letterhead);
  tp_partial_factors_free(scene->partial_factors);
  if (scene->own_drawn != NULL) tp_drawn_clear(scene->own_drawn);
  free(scene->own_drawn);
  tp_scene_file_free(scene->file);
  free(scene);
}

/* A number that was copied as it lies in memory becomes one of its own. */
static void own_number(void *copy, size_t offset) {
  fmpq *number = tp_member_number(copy, offset);
  const fmpq held = *number;
  fmpq_init(number);
  fmpq_set(number, &held);
}

static void own_numbers(void *copy, const tp_offsets *numbers) {
  for (size_t k = 0; k < numbers->count; k++) own_number(copy, numbers->items[k]);
}

static void own_line(void *copy, size_t offset) {
  tp_polyline *line = tp_member_line(copy, offset);
  *line = tp_polyline_share(line);
}

/* Room for a power of two, as the calls that add to a list keep it (scene_building/build.c). */
static void *room_for(long count, size_t size) {
  long room = 1;
  while (room < count) room *= 2;
  return malloc((size_t)room * size);
}

/* Instead of the one that it shares; it has none where memory is exhausted. */
static bool own_list(tp_scene *copy, tp_list_kind kind) {
  const tp_list *list = tp_scene_lists + kind;
  const char *shared = tp_member_items(copy, kind);
  const long count = tp_member_count(copy, kind);
  tp_member_set_items(copy, kind, NULL);
  if (count == 0) return true;
  char *items = room_for(count, list->size);
  if (items == NULL) return false;
  memcpy(items, shared, (size_t)count * list->size);
  for (long k = 0; k < count; k++) {
    char *item = items + (size_t)k * list->size;
    own_numbers(item, &list->numbers);
    if (list->has_line) own_line(item, list->line);
  }
  tp_member_set_items(copy, kind, items);
  return true;
}

static bool own_lists(tp_scene *copy, bool of_block_alone) {
  bool done = true;
  for (int k = 0; k < TP_LISTS; k++) {
    if (of_block_alone && !is_of_block(tp_scene_lists[k].items)) continue;
    done = own_list(copy, (tp_list_kind)k) && done;
  }
  return done;
}

static bool own_block(tp_scene *copy) {
  for (size_t k = 0; k < tp_scene_numbers.count; k++) {
    if (is_of_block(tp_scene_numbers.items[k])) own_number(copy, tp_scene_numbers.items[k]);
  }
  for (size_t k = 0; k < tp_scene_lines.count; k++) {
    if (is_of_block(tp_scene_lines.items[k])) own_line(copy, tp_scene_lines.items[k]);
  }
  return own_lists(copy, true);
}

/* As clear_blocks does, by the place of the scene's block. */
static bool own_blocks(tp_scene *copy) {
  tp_block_list *many = &copy->many;
  const tp_listed_block *shared = many->blocks;
  const tp_block_description held = copy->block;
  const long count = many->count;
  many->count = 0;
  many->blocks = NULL;
  if (count == 0) return true;
  many->blocks = room_for(count, sizeof *many->blocks);
  bool done = many->blocks != NULL;
  for (; many->count < count && done; many->count++) {
    tp_listed_block *own = many->blocks + many->count;
    *own = shared[many->count];
    own->name = strdup(own->name);
    own_numbers(own, &tp_listed_block_numbers);
    copy->block = own->shape;
    done = own_block(copy) && own->name != NULL;
    own->shape = copy->block;
  }
  copy->block = held;
  return done;
}

static bool own_overrides(tp_scene *copy, const tp_scene *scene) {
  copy->overrides = NULL;
  copy->override_count = 0;
  if (scene->override_count == 0) return true;
  copy->overrides = calloc((size_t)scene->override_count, sizeof *copy->overrides);
  if (copy->overrides == NULL) return false;
  return tp_overrides_append(copy->overrides, &copy->override_count, scene);
}

tp_scene *tp_scene_copy(const tp_scene *scene) {
  tp_scene *copy = malloc(sizeof *copy);
  if (copy == NULL) return NULL;
  *copy = *scene;
  own_numbers(copy, &tp_scene_numbers);
  for (size_t k = 0; k < tp_scene_lines.count; k++) own_line(copy, tp_scene_lines.items[k]);
  copy->title = scene->title != NULL ? strdup(scene->title) : NULL;
  const bool headed = tp_letterhead_copy(&copy->letterhead, &scene->letterhead);
  bool done =
      own_overrides(copy, scene) && headed && (copy->title == NULL) == (scene->title == NULL);
  done = own_lists(copy, false) && done;
  done = own_blocks(copy) && done;
  if (done) return copy;
  tp_scene_free(copy);
  return NULL;
}
