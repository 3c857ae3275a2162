/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A DXF file while it is read: what its entities, blocks and inserts have in common. */

#ifndef TP_DXF_READER_H
#define TP_DXF_READER_H

#include "dxf_groups.h"
#include "format/curve.h"
#include "format/drawing.h"

/* A block: objects and inserts that stand one after another in the lists of the reader. */
typedef struct tp_dxf_block {
  tp_dxf_group name;
  fmpq_t x, y; /* its base point */
  long first_object, objects, first_insert, inserts;
  bool is_told; /* what follows (format/dxf_use.c) */
  int use;
  double puts; /* objects, with those of blocks within */
} tp_dxf_block;

/* A block put somewhere, once or in rows and columns. */
typedef struct tp_dxf_insert {
  tp_dxf_group block, layer;
  fmpq_t x, y, scale_x, scale_y, degrees, column_step, row_step;
  long columns, rows;
  bool mirrored;       /* its extrusion points along -z */
  const char *problem; /* of all that it puts there */
} tp_dxf_insert;

/* A layer that is off or frozen, and how many objects on it were left out. */
typedef struct tp_dxf_layer {
  tp_dxf_group name;
  bool frozen; /* else it is off */
  long left_out;
} tp_dxf_layer;

typedef struct tp_dxf_reader {
  tp_drawing *drawing; /* objects of the file itself */
  tp_drawing parts;    /* objects of its blocks */
  const tp_drawing_options *options;
  tp_message *message;
  tp_status status;
  tp_dxf_block *blocks;
  long block_count, block_room;
  tp_dxf_insert *inserts; /* of blocks, and behind these of the file itself */
  long insert_count, insert_room;
  bool in_block;
  bool named;                  /* an object has a role by its layer or its name */
  bool sparing;                /* objects of inserted blocks without a role are left out */
  tp_drawing_object *polyline; /* whose vertices follow; NULL: none, or none that is wanted */
  bool mirrored;               /* that polyline */
  fmpq_t height;               /* z of its first vertex */
  bool has_height;
  bool comma; /* a decimal comma was noted */
  tp_dxf_layer *layers;
  long layer_count, layer_room;
  long invisible;   /* objects that are so by their own word */
  int first_hidden; /* the line of the first object that is not shown */
} tp_dxf_reader;

/* The groups of an entity. */
typedef struct tp_dxf_entity {
  const tp_dxf_group *groups;
  size_t count;
} tp_dxf_entity;

/* The first group of a code; NULL: there is none. */
const tp_dxf_group *tp_dxf_find(const tp_dxf_entity *entity, int code);
bool tp_dxf_says(const tp_dxf_group *group, const char *word);

/* Fail at a group; false, for visitors. */
bool tp_dxf_fail(tp_dxf_reader *reader, const tp_dxf_group *group, const char *what);
bool tp_dxf_fail_memory(tp_dxf_reader *reader);

/* Numbers of a group; `fallback` where there is none of the code. False with the reader's status
 * set. */
bool tp_dxf_number(tp_dxf_reader *reader, fmpq_t value, const tp_dxf_group *group);
bool tp_dxf_real(tp_dxf_reader *reader, fmpq_t value, const tp_dxf_entity *entity, int code,
                 long fallback);
bool tp_dxf_whole(tp_dxf_reader *reader, long *value, const tp_dxf_entity *entity, int code,
                  long fallback);

/* Which way the extrusion points, which makes the plane of an entity: 1 along z, -1 against it, 0
 * any other way. */
bool tp_dxf_extrusion(tp_dxf_reader *reader, int *side, const tp_dxf_entity *entity);

/* x becomes -x: the plane of an entity that is extruded along -z. */
void tp_dxf_mirror(tp_drawing_object *object);

/* A new object for an entity, in the block or in the file; NULL with the reader's status set. */
tp_drawing_object *tp_dxf_add(tp_dxf_reader *reader, const char *kind, const tp_dxf_entity *entity);
/* Not memory: the curve has more chords than are taken. */
bool tp_dxf_curve(tp_dxf_reader *reader, tp_drawing_object *object, tp_curve_outcome outcome);

/* What a visitor does with an entity (format/dxf_entity.c, dxf_spline.c). */
bool tp_dxf_line(tp_dxf_reader *reader, const tp_dxf_entity *entity);
bool tp_dxf_light_polyline(tp_dxf_reader *reader, const tp_dxf_entity *entity);
bool tp_dxf_polyline(tp_dxf_reader *reader, const tp_dxf_entity *entity);
bool tp_dxf_vertex(tp_dxf_reader *reader, const tp_dxf_entity *entity);
bool tp_dxf_sequence_end(tp_dxf_reader *reader);
bool tp_dxf_circle(tp_dxf_reader *reader, const tp_dxf_entity *entity);
bool tp_dxf_arc(tp_dxf_reader *reader, const tp_dxf_entity *entity);
bool tp_dxf_ellipse(tp_dxf_reader *reader, const tp_dxf_entity *entity);
bool tp_dxf_spline(tp_dxf_reader *reader, const tp_dxf_entity *entity);

/* Blocks and inserts (format/dxf_insert.c). */
bool tp_dxf_block_begin(tp_dxf_reader *reader, const tp_dxf_entity *entity);
bool tp_dxf_block_end(tp_dxf_reader *reader);
bool tp_dxf_insert_add(tp_dxf_reader *reader, const tp_dxf_entity *entity);
/* All inserts of the file itself become objects of it. */
bool tp_dxf_insert_all(tp_dxf_reader *reader);
/* NULL: there is none of that name. */
tp_dxf_block *tp_dxf_block_find(const tp_dxf_reader *reader, const tp_dxf_group *name);
/* Of those of the file itself. */
long tp_dxf_first_insert(const tp_dxf_reader *reader);
enum { TP_DXF_DEEPEST = 16 }; /* blocks within blocks */
void tp_dxf_inserts_clear(tp_dxf_reader *reader);

#endif
