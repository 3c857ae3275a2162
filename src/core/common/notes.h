/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Notes and cautions beside an answer: gathered by a scene as it is read, and by its solution. */

#ifndef TP_COMMON_NOTES_H
#define TP_COMMON_NOTES_H

#include "common/message.h"

/* Add one: what, and what to do if it was not meant. The text is made plain, as a message is. */
TP_MUST_USE tp_status tp_notes_add(tp_notes *notes, tp_message *message, tp_note_kind kind,
                                   tp_place place, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

/* Append all of `more`, which keeps its own. */
TP_MUST_USE tp_status tp_notes_append(tp_notes *notes, const tp_notes *more, tp_message *message);

void tp_notes_clear(tp_notes *notes);

#endif
