/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which objects of inserted blocks a scene uses, told before any of them is put anywhere.
 *
 * A block inserted in rows and columns, of blocks inserted in rows and columns, may stand for
 * billions of objects. Where layers or names say what the block and its base are, all others cost
 * nothing. Each block is looked through once: does it put an object there that has a role, one that
 * follows the layer of its insert, and how many in all? */

#ifndef TP_FORMAT_DXF_USE_H
#define TP_FORMAT_DXF_USE_H

#include "format/dxf_reader.h"

/* Before the inserts are followed: sets `sparing`, with a note, where there are so many objects
 * that those without a role are left out. */
bool tp_dxf_use_tell(tp_dxf_reader *reader);

/* Of an insert whose objects on layer 0 go on a layer; and of an object that is put on one. False:
 * nothing of it has a role, and all of it may be left out. */
bool tp_dxf_use_insert(const tp_dxf_reader *reader, const tp_dxf_block *block, const char *layer);
bool tp_dxf_use_object(const tp_dxf_reader *reader, const char *layer, const char *name);

#endif
