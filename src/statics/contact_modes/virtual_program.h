/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The inequalities of a linear virtual motion (contact_modes/virtual_motion.h), of friction at both
 * of its bounds and loads at both of theirs. They are linear in either, so that they hold between.
 *
 * Forces: at end e of a contact n + s mu t, of sense s, acts where that end is closed and slips
 * against s, if at all. Its work on v is a sum of the gaps near it and of the slip: the factor of
 * each gap but its own is to be at most 0, that of the slip at least 0 times s. Relations among the
 * gaps are added to it as needed; and where the slip is such a sum too, part of that.
 *
 * Loads: their work on T a is the sum of gaps times `reach`, that on H_m is their factors.
 *
 * Mass: the matrix of a . M L a, scaled by the masses, is to dominate by its diagonal. */

#ifndef TP_CONTACT_MODES_VIRTUAL_PROGRAM_H
#define TP_CONTACT_MODES_VIRTUAL_PROGRAM_H

#include "contact_modes/linear_forms.h"
#include "contact_modes/node.h"
#include "contact_modes/virtual_frame.h"

/* An entry of the symmetric matrix of one load: twice it. Those of two blocks are the same for
 * all, and of the first. */
typedef struct tp_virtual_entry {
  long row, column, load;
} tp_virtual_entry;

typedef struct tp_virtual_program {
  const tp_virtual_frame *frame;
  const tp_modes_question *question;
  int load_count;
  tp_near drive[2]; /* by load: -w . D / (w . D') */
  long unknown_count, unknown_room;
  bool *is_traded; /* by unknown: a part of a slip that is stated by gaps */
  long *role;      /* by unknown: the same for all bounds of friction and all loads */
  long role_count;
  long *of_gap;           /* by block: the first unknown of its H; of one gap three follow */
  long *reach[2];         /* by load, by gap */
  long transform[3][2];   /* T but for its first column */
  tp_linear_forms signs;  /* at most 0 */
  tp_linear_forms powers; /* 0: of the loads along each component of each block's acceleration */
  tp_linear_forms mass;   /* the entries */
  tp_virtual_entry *entries;
  long entry_room;
  bool failed; /* memory is exhausted */
} tp_virtual_program;

/* `exists`: the loads are weights, driven by one direction. */
TP_MUST_USE tp_status tp_virtual_program_init(bool *exists, tp_virtual_program *program,
                                              const tp_virtual_frame *frame,
                                              const tp_modes_question *question,
                                              tp_message *message);
void tp_virtual_program_clear(tp_virtual_program *program);

/* The first of the signs of the work of a load, by gap; those before the first load's are of
 * forces. */
long tp_virtual_first_of_load(const tp_virtual_program *program, int load);
/* Is another entry off the diagonal in the row of this one, which is on it? */
bool tp_virtual_is_beside(const tp_virtual_program *program, long entry, long other);
/* Is the unknown of T? All others may be left out. */
bool tp_virtual_is_of_transform(long unknown);

#endif
