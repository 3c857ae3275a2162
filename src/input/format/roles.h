/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which objects of a drawing are the block, its base, its holes and its parts.
 *
 * An object has the role whose word is its layer or its name, whatever the case of letters. Where
 * none has the block's, and the scene did not choose that word itself, the only closed outline is
 * the block and an only open line its base. Inner rings of the polygon that is the block are holes.
 * Pieces of a role are joined (format/join.h) into chains that it takes (format/role.h). */

#ifndef TP_FORMAT_ROLES_H
#define TP_FORMAT_ROLES_H

#include "format/role.h"

/* The words of the roles. */
typedef struct tp_drawing_words {
  TP_OUTSIDE const char *block, *base, *hole;  /* NULL, all of them: it has parts alone */
  bool block_chosen, base_chosen, hole_chosen; /* by the scene; else by default */
  long part_count;
  TP_OUTSIDE const char *const *parts; /* layers of parts of the block */
  fmpq_t gap;                          /* in the drawing */
} tp_drawing_words;

/* What an object of a layer and a name is by these words. */
tp_drawing_role tp_drawing_role_by(const tp_drawing_words *words, const char *layer,
                                   const char *name);

typedef struct tp_drawing_choice {
  tp_drawing chains;        /* what pieces make */
  tp_drawing_role *roles;   /* of chains */
  long *parts;              /* of a chain that is one, which of the words it has */
  tp_drawing_role *objects; /* of each object of the drawing */
} tp_drawing_choice;

/* `place` is where the scene names the drawing. On failure `choice` is cleared. */
TP_MUST_USE tp_status tp_drawing_choose(tp_drawing_choice *choice, const tp_drawing *drawing,
                                        const tp_drawing_words *words, tp_place place,
                                        tp_message *message);
void tp_drawing_choice_clear(tp_drawing_choice *choice);

#endif
