/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a CAD program shows of a DXF file; what it does not show is left out, and told.
 *
 * An object is not shown where it is invisible (group 60), or on a layer that is off (its colour
 * below 0, group 62) or frozen (1 in its flags, group 70). On layer 0 of a block it is on the layer
 * of the insert. An insert on a frozen layer hides all of its block, one on a layer that is off
 * only what is on layer 0 there. */

#ifndef TP_DXF_SHOWN_H
#define TP_DXF_SHOWN_H

#include "format/dxf_reader.h"

/* An entry of the table of layers. */
bool tp_dxf_layer_add(tp_dxf_reader *reader, const tp_dxf_entity *entity);

/* Of an object or an insert, before it is taken; counted where it is not shown. False with the
 * reader's status set. */
bool tp_dxf_shown(tp_dxf_reader *reader, bool *shown, const tp_dxf_entity *entity, bool insert);
/* The same of an object that is put on a layer by an insert. */
bool tp_dxf_shown_on(tp_dxf_reader *reader, const char *layer);

/* What was left out, once all is read. */
bool tp_dxf_shown_note(tp_dxf_reader *reader);

#endif
