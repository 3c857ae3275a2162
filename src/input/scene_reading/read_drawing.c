/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads the key drawing of a scene: layers and words of the roles, unit or reference length,
 * tolerance and gap; then the drawing itself, shared by all scenes of the file. */

#include "common/outside.h"
#include "format/read.h"
#include "format/reference.h"
#include "scene/drawn.h"
#include "scene_reading/read.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

typedef struct drawing_keys {
  tp_drawing_options options;
  tp_drawing_words words;
  const tp_node *file, *unit, *parts;
  const char **part_layers;
  const char *path;
  bool varies;    /* a number among them does */
  bool of_blocks; /* many of them */
} drawing_keys;

static tp_status read_word(const tp_reader *reader, const char **word, const tp_node *node,
                           const char *name) {
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_SCALAR || node->text[0] == '\0') {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node, "'%s' is a word, not a list or a map", name);
  }
  *word = node->text;
  return TP_OK;
}

/* A number above zero in lengths of the drawing. */
static tp_status read_length(const tp_reader *reader, fmpq_t value, const tp_node *node,
                             const char *name, tp_rule rule) {
  return node == NULL ? TP_OK : tp_read_by_rule(reader, value, node, name, rule);
}

static tp_status read_reference(const tp_reader *reader, drawing_keys *k, const tp_node *node) {
  const tp_node *id = NULL, *length = NULL;
  if (node == NULL) return TP_OK;
  tp_status status = tp_read_keys(reader, node, &tp_key_map_drawing_reference, "reference");
  if (status == TP_OK) status = tp_read_required(reader, &id, node, "id", "id: scale_bar");
  if (status == TP_OK) status = tp_read_required(reader, &length, node, "length", "length: 2");
  if (status == TP_OK) status = read_word(reader, &k->options.reference, id, "id");
  if (status == TP_OK)
    status = read_length(reader, k->options.length, length, "length", TP_RULE_ABOVE_ZERO);
  return status;
}

/* {layer, unit_weight_kn_m3}, or a list of these: their layers now, their weights with the block.
 */
static tp_status read_part_layers(const tp_reader *reader, drawing_keys *k) {
  static const char *const keys[] = {"layer", "unit_weight_kn_m3", NULL};
  const tp_node *node = k->parts;
  if (node == NULL) return TP_OK;
  const bool list = node->kind == TP_NODE_SEQUENCE;
  k->part_layers = calloc(list ? (size_t)node->count + 1 : 1, sizeof *k->part_layers);
  if (k->part_layers == NULL) return tp_fail_memory(reader->message, "the parts");
  k->words.parts = k->part_layers;
  tp_status status = TP_OK;
  for (const tp_node *p = list ? node->first : node; p != NULL && status == TP_OK;
       p = list ? p->next : NULL) {
    const tp_node *layer = NULL, *weight = NULL;
    status = tp_node_expect_keys(p, keys, "a part", reader->scene->path, reader->message);
    if (status == TP_OK) status = tp_read_required(reader, &layer, p, "layer", "layer: PART");
    if (status == TP_OK)
      status = tp_read_required(reader, &weight, p, "unit_weight_kn_m3", "unit_weight_kn_m3: 20");
    if (status == TP_OK)
      status = read_word(reader, k->part_layers + k->words.part_count, layer, "layer");
    if (status == TP_OK) k->words.part_count++;
  }
  return status;
}

/* Layers of many blocks, and then those of ground: parts, and nothing else. */
static tp_status read_block_layers(const tp_reader *reader, drawing_keys *k, const tp_node *node) {
  const long count = tp_drawn_layer_count(node, "blocks") + tp_drawn_layer_count(node, "ground");
  k->words.block = k->words.base = k->words.hole = NULL;
  k->part_layers = calloc((size_t)count + 1, sizeof *k->part_layers);
  if (k->part_layers == NULL) return tp_fail_memory(reader->message, "the blocks");
  k->words.parts = k->part_layers;
  k->words.part_count = count;
  return tp_read_drawn_layers(reader, k->part_layers, node);
}

static tp_status read_words(const tp_reader *reader, drawing_keys *k, const tp_node *node) {
  const tp_node *block = tp_node_get(node, "block"), *base = tp_node_get(node, "base");
  const tp_node *hole = tp_node_get(node, "hole");
  k->words.block = "BLOCK";
  k->words.base = "BASE";
  k->words.hole = "HOLE";
  k->words.block_chosen = block != NULL;
  k->words.base_chosen = base != NULL;
  k->words.hole_chosen = hole != NULL;
  tp_status status = read_word(reader, &k->words.block, block, "block");
  if (status == TP_OK) status = read_word(reader, &k->words.base, base, "base");
  if (status == TP_OK) status = read_word(reader, &k->words.hole, hole, "hole");
  return status;
}

static tp_status read_keys(const tp_reader *reader, drawing_keys *k, const tp_node *node) {
  static const char *const keys[] = {"file", "unit",   "block",  "base",      "hole",      "part",
                                     "gap",  "blocks", "ground", "tolerance", "reference", NULL};
  k->of_blocks = tp_node_get(node, "blocks") != NULL || tp_node_get(node, "ground") != NULL;
  const tp_node *reference = tp_node_get(node, "reference");
  tp_status status =
      tp_node_expect_keys(node, keys, "the drawing", reader->scene->path, reader->message);
  if (status == TP_OK)
    status = tp_read_required(reader, &k->file, node, "file", "drawing: {file: section.dxf}");
  if (status == TP_OK) status = read_word(reader, &k->path, k->file, "file");
  if (status == TP_OK && !k->of_blocks) status = read_words(reader, k, node);
  k->unit = tp_node_get(node, "unit");
  k->parts = tp_node_get(node, "part");
  if (status == TP_OK) {
    status = k->of_blocks ? read_block_layers(reader, k, node) : read_part_layers(reader, k);
  }
  reader->reading->varies = false;
  if (status == TP_OK)
    status =
        read_length(reader, k->words.gap, tp_node_get(node, "gap"), "gap", TP_RULE_NOT_NEGATIVE);
  if (status == TP_OK)
    status = read_length(reader, k->options.tolerance, tp_node_get(node, "tolerance"), "tolerance",
                         TP_RULE_ABOVE_ZERO);
  if (status == TP_OK) status = read_reference(reader, k, reference);
  k->options.words = &k->words;
  k->varies = reader->reading->varies;
  return status;
}

/* ---- unit --------------------------------------------------------------------------------------
 */

/* A page that says how long its units are, and is drawn to no scale of 1, 10, 100 … or one to 10, …
 * in the unit that the scene says: the two were likely taken for each other, as pixels for
 * millimetres. */
static tp_status check_page(const tp_reader *reader, const drawing_keys *k, tp_drawing *drawing,
                            const char *unit, const fmpq_t metres) {
  static const double within = 1e-3, mm = 1000;
  const double page_m = drawing->page_unit_m;
  if (page_m <= 0 || k->options.reference != NULL) return TP_OK;
  const double times = fmpq_get_d(metres) / page_m;
  if (fabs(log10(times) - nearbyint(log10(times))) < within) return TP_OK;
  return tp_notes_add(
      &drawing->notes, reader->message, TP_CAUTION, tp_read_place(reader, k->unit),
      "one unit of this drawing is %.4g mm on its page (its width and viewBox), and "
      "is taken for 1 %s, %.4g times that: if its lengths are true on the page, let "
      "the program that wrote it use %s for its units; or scale it by an object of "
      "known length, drawing: {reference: {id: …, length: …}}",
      mm * page_m, unit, times, unit);
}

/* That of the drawing: what the scene says it is, or the file; of a scaled one that of the length
 * that scales it. */
static tp_status choose_unit(const tp_reader *reader, const drawing_keys *k, tp_drawing *drawing) {
  fmpq_t metres;
  fmpq_init(metres);
  const char *said = NULL;
  tp_status status = read_word(reader, &said, k->unit, "unit");
  if (status == TP_OK && said != NULL) {
    if (tp_unit_find(metres, &said) && drawing->unit != NULL && strcmp(said, drawing->unit) != 0 &&
        k->options.reference == NULL) {
      status = tp_read_fail(reader, TP_FAULT_UNIT, k->unit,
                            "the drawing states that its lengths are in %s, not %s: leave 'unit' "
                            "out, or correct the drawing (%s)",
                            drawing->unit, said, drawing->unit_from);
    } else if (!tp_unit_find(metres, &said)) {
      status =
          tp_read_fail(reader, TP_FAULT_UNIT, k->unit, "unit must be one of mm, cm, m, km, in, ft");
    }
    if (status == TP_OK) status = check_page(reader, k, drawing, said, metres);
    drawing->unit = said;
  } else if (k->options.reference != NULL) {
    drawing->unit = reader->scene->length_unit;
  }
  fmpq_clear(metres);
  if (status != TP_OK || drawing->unit != NULL) return status;
  return tp_read_fail(reader, TP_FAULT_UNIT, k->file,
                      k->options.reference != NULL
                          ? "in which unit is the length of the reference? Say 'length_unit: m' "
                            "or drawing: {unit: m}"
                          : "the drawing does not say what the unit of its lengths is: say "
                            "drawing: {unit: mm}, or --unit mm for a drawing without a scene; or "
                            "scale it by an object of known length, drawing: {reference: {id: …, "
                            "length: …}}");
}

/* Scene lengths per length of the drawing. */
static void set_scale(fmpq_t scale, const tp_scene *scene, const tp_drawing *drawing) {
  const char *unit = drawing->unit;
  tp_unit_find(scale, &unit);
  fmpq_div(scale, scale, scene->metres_per_unit);
}

/* ---- the drawing -------------------------------------------------------------------------------
 */

static tp_status use_drawing_unit(const tp_reader *reader, const char *unit, const tp_node *node) {
  if (reader->scene->length_unit != NULL) return TP_OK;
  return tp_scene_use_unit(reader->scene, unit, tp_read_place(reader, node), reader->message);
}

/* Objects on the layer of parts, which need a weight. */
static tp_status check_part_layer(const tp_reader *reader, const drawing_keys *k,
                                  const tp_drawing *drawing) {
  for (long i = 0; i < drawing->count && k->parts == NULL && !k->of_blocks; i++) {
    const tp_drawing_object *object = drawing->objects + i;
    if (strcasecmp(object->layer, "PART") != 0) continue;
    return tp_refuse(
        reader->message, TP_FAULT_UNIT, tp_drawing_place(object),
        "an object on layer 'PART', a part of the block with another unit weight: which? "
        "Say drawing: {part: {layer: PART, unit_weight_kn_m3: 20}}");
  }
  return TP_OK;
}

static tp_status make_drawn(const tp_reader *reader, tp_drawn *drawn, const drawing_keys *k,
                            const tp_node *node) {
  tp_drawing drawing;
  tp_drawing_choice choice;
  fmpq_t scale;
  fmpq_init(scale);
  const char *path = tp_scene_file_name(reader->scene->file, k->path);
  tp_drawing_init(&drawing, path);
  tp_status status = path != NULL ? tp_drawing_read(&drawing, &k->options, reader->message)
                                  : tp_fail_memory(reader->message, "the drawing");
  if (status == TP_OK) status = tp_drawing_scale(&drawing, &k->options, reader->message);
  if (status == TP_OK) status = choose_unit(reader, k, &drawing);
  if (status == TP_OK) status = use_drawing_unit(reader, drawing.unit, node);
  if (status == TP_OK) status = check_part_layer(reader, k, &drawing);
  if (status == TP_OK) {
    status = tp_drawing_choose(&choice, &drawing, &k->words, tp_read_place(reader, node),
                               reader->message);
    if (status == TP_OK) {
      set_scale(scale, reader->scene, &drawing);
      *drawn = (tp_drawn){.path = path, .length_unit = drawing.unit};
      status =
          tp_drawn_make(drawn, &choice, &drawing, &k->words, &k->options, scale, reader->message);
      tp_drawing_choice_clear(&choice);
    }
  }
  tp_drawing_clear(&drawing);
  fmpq_clear(scale);
  return status;
}

/* What the file's drawing was made into before, unless a number that bears upon it is another. */
static tp_status find_drawn(const tp_reader *reader, const drawing_keys *k, const tp_node *node) {
  tp_scene *scene = reader->scene;
  tp_drawn *kept = scene->file->drawn;
  if (kept != NULL && kept->fixed && !k->varies) {
    scene->drawn = kept;
    return use_drawing_unit(reader, kept->length_unit, node);
  }
  tp_drawn *own = calloc(1, sizeof *own);
  if (own == NULL) return tp_fail_memory(reader->message, "the drawing");
  const tp_status status = make_drawn(reader, own, k, node);
  if (status != TP_OK) {
    free(own);
    return status;
  }
  own->fixed = !k->varies;
  scene->drawn = own;
  if (!reader->reading->again && own->fixed) {
    scene->file->drawn = own;
  } else {
    scene->own_drawn = own;
  }
  return TP_OK;
}

tp_status tp_read_drawing(const tp_reader *reader, const tp_node *node) {
  if (node == NULL) return TP_OK;
  drawing_keys k = {.file = NULL};
  tp_drawing_options_init(&k.options);
  fmpq_init(k.words.gap);
  tp_status status = read_keys(reader, &k, node);
  if (status == TP_OK) status = find_drawn(reader, &k, node);
  if (status == TP_OK) {
    status = tp_notes_append(&reader->scene->notes, &reader->scene->drawn->notes, reader->message);
  }
  free(k.part_layers);
  fmpq_clear(k.words.gap);
  tp_drawing_options_clear(&k.options);
  return status;
}
