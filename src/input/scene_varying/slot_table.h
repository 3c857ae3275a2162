/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The table of keys and the numbers of a scene in memory that they name. */

#ifndef TP_SCENE_VARYING_SLOT_TABLE_H
#define TP_SCENE_VARYING_SLOT_TABLE_H

#include "scene/check.h"
#include "scene/members.h"

typedef enum tp_slot_kind {
  TP_SLOT_QUANTITY, /* a tp_quantity, there where it is given */
  TP_SLOT_NUMBER,   /* a number of the form of the block */
  TP_SLOT_TEETH,    /* how many teeth */
  TP_SLOT_POINT     /* a coordinate in a chain of points */
} tp_slot_kind;

typedef struct tp_slot_row {
  const char *key; /* # is a number from 1 on: of an item, of a point, of x and y */
  tp_slot_kind kind;
  tp_list_kind list; /* that the first # counts in; TP_LISTS: none */
  size_t offset;     /* in the scene, or in the item */
  tp_rule rule;
  bool (*has)(const tp_scene *scene); /* NULL: where it is given */
  /* What follows from the number: computed anew, or refused beside another one. */
  tp_status (*settle)(tp_scene *scene, void *holder, tp_message *message);
} tp_slot_row;

extern const tp_slot_row *const tp_slot_rows;
extern const size_t tp_slot_row_count;

#endif
