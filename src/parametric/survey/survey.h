/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A table of blocks: what its head names, and the scene that a row makes. */

#ifndef TP_SURVEY_SURVEY_H
#define TP_SURVEY_SURVEY_H

#include "format/cells.h"
#include "scene/check.h"
#include "scene/node.h"

typedef enum tp_column_kind {
  TP_COLUMN_KEY,     /* a key of a scene */
  TP_COLUMN_PLANE,   /* dip and dip direction in one field, 30/120 */
  TP_COLUMN_NAME,    /* of the block; the title of its scene */
  TP_COLUMN_SCENE,   /* the file of the scene that the row is over */
  TP_COLUMN_CASE,    /* the load case of its scene that is solved; else all are */
  TP_COLUMN_OUTLINE, /* a file with the outline of the block */
  TP_COLUMN_PASSED   /* what a survey notes and no scene has */
} tp_column_kind;

typedef struct tp_column {
  tp_column_kind kind;
  const char *head;   /* as it stands in the table */
  char *key;          /* of a scene; owned. Of a plane that of its dip */
  bool reversed;      /* of a plane: its direction comes first, 120/30 */
  bool is_number;     /* its cells are numbers, */
  tp_rule rule;       /* of which this must hold */
  bool is_length;     /* its numbers are lengths, */
  const char *unit;   /* in this unit; NULL: that of the scene */
  const char *factor; /* by which a cell is multiplied, "(1/1000)"; NULL: by none */
} tp_column;

typedef struct tp_survey {
  const char *path;
  const char *scene; /* of the options; or NULL */
  tp_node *root;     /* what stands in that, read once; NULL: there is none, or it cannot be read */
  tp_cells cells;
  size_t column_count;
  tp_column *columns;
} tp_survey;

/* By the key of the column: is it of numbers, and what must hold of them? */
void tp_column_take_rule(tp_column *column);

/* The key of the dip direction that a field of a plane has. */
extern const char tp_plane_direction_key[];

/* Read the table and its head, of the text or where that is NULL of the file; to be cleared,
 * whatever the outcome. */
TP_MUST_USE tp_status tp_survey_read(tp_survey *survey, const char *path, const char *text,
                                     tp_message *message);
void tp_survey_clear(tp_survey *survey);

/* The cell of the row in the first column of a kind; NULL: there is none, or it is empty. */
const char *tp_survey_cell(const tp_survey *survey, size_t row, tp_column_kind kind);

/* Where each line of the text of a scene comes from. */
typedef struct tp_origin {
  tp_mark mark; /* in the file of the scene; a line below 0: of column -line - 1 of the table */
} tp_origin;

typedef struct tp_scene_text {
  char *name; /* of the file beside which it names others */
  char *text;
  size_t line_count;
  tp_origin *lines;
} tp_scene_text;

/* The scene of a row as text; to be cleared, whatever the outcome. What is wrong with its cells is
 * added to the faults, and is bad input; other complaints are without the name of the row. */
typedef struct tp_row_faults tp_row_faults;
TP_MUST_USE tp_status tp_survey_scene(tp_scene_text *text, tp_row_faults *faults,
                                      const tp_survey *survey, size_t row, tp_message *message);
void tp_scene_text_clear(tp_scene_text *text);

/* The tree as the text of a scene file, a scalar a line. False when memory is exhausted. */
TP_MUST_USE bool tp_scene_text_write(tp_scene_text *text, const tp_node *root);

#endif
