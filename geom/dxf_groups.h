/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The structure of a DXF file, by dxflib behind a C face.
 *
 * dxflib tells which entity is complete, and in what order entities, blocks and variables come; the
 * values of an entity are its groups, as they stand in the text of the file, because dxflib makes
 * doubles of them. Entities that Topple has no use for are not shown to dxflib, and numbers of
 * vertices and knots are those that there are, whatever the file says. Nothing that is thrown
 * crosses this face. */

#ifndef TP_DXF_FILE_H
#define TP_DXF_FILE_H

#include "geom.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A group: its code, and its value without blanks around it. */
typedef struct tp_dxf_group {
  int code, line; /* of the value */
  const char *text;
  size_t length;
} tp_dxf_group;

typedef enum tp_dxf_event {
  TP_DXF_VARIABLE, /* of the header: its name, and its value */
  TP_DXF_LAYER,    /* an entry of the table of layers */
  TP_DXF_BLOCK,
  TP_DXF_BLOCK_END,
  TP_DXF_LINE,
  TP_DXF_LWPOLYLINE,
  TP_DXF_POLYLINE, /* its vertices follow, and their end */
  TP_DXF_VERTEX,
  TP_DXF_SEQUENCE_END,
  TP_DXF_ARC,
  TP_DXF_CIRCLE,
  TP_DXF_ELLIPSE,
  TP_DXF_SPLINE,
  TP_DXF_INSERT
} tp_dxf_event;

/* Receives what is complete, from its name (code 0 or 9) on; false ends the reading. */
typedef bool (*tp_dxf_visitor)(void *context, tp_dxf_event event, const tp_dxf_group *groups,
                               size_t count);

/* Was Topple built with dxflib? */
bool tp_dxf_is_there(void);

tp_geom_status tp_dxf_visit(const tp_dxf_group *groups, size_t count, tp_dxf_visitor visitor,
                            void *context);

#ifdef __cplusplus
}
#endif

#endif
