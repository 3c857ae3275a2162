/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solid rock as a scene gives it: the key solid. Included by scene/scene.h. */

#ifndef TP_SCENE_SOLID_DESCRIPTION_H
#define TP_SCENE_SOLID_DESCRIPTION_H

typedef struct tp_solid_description {
  tp_place place;         /* no file: the scene is of a section */
  const tp_mesh *mesh;    /* of the scene's file, */
  long object;            /* one object of it; below zero: all */
  fmpq_t metres_per_unit; /* of the mesh, by its unit or by a known length */
  fmpq up[3];             /* across the base, in the axes of the mesh: not zero */
  tp_quantity unit_weight_kn_m3, azimuths;
  tp_quantity dip_deg, dip_direction_deg; /* of the base, where `up` is the vertical instead */
  long band_count;
  fmpq *bands; /* in scene lengths */
} tp_solid_description;

#endif
