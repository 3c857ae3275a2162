/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Triangles under repair (mend.h). */

#ifndef TP_SOLID_MENDING_H
#define TP_SOLID_MENDING_H

#include "solid/surface.h"
#include "topple.h"

typedef struct tp_mending {
  const tp_surface *surface; /* as it is read: its points */
  tp_solid_repair *record;
  long count, room;
  int *triangles; /* vertices of the surface, three each */
  int *faces;     /* of the mesh that each is of; or below zero: -1 - the gap that it closes */
  bool *turned;   /* against how the file has it */
} tp_mending;

/* Room for so many more; false when memory is exhausted. */
TP_MUST_USE bool tp_mending_reserve(tp_mending *m, long more);
void tp_mending_add(tp_mending *m, int a, int b, int c, int face);

/* The triangles that are not `dropped` stay, in their order. */
void tp_mending_keep(tp_mending *m, const bool *dropped);

/* The number of a triangle in its file. */
long tp_mending_number(const tp_mending *m, long triangle);

/* A length of the surface's `near` in lengths of the mesh. */
double tp_mending_step(const tp_surface *surface);

#endif
