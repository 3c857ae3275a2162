/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the options of a solid, or its scene, give, checked and in exact numbers. */

#ifndef TP_SOLID_TILT_SOLID_GIVEN_H
#define TP_SOLID_TILT_SOLID_GIVEN_H

#include "scene/scene.h"
#include "solid/azimuth.h"
#include "solid/surface.h"

typedef struct tp_solid_given {
  const char *length_unit; /* static */
  bool has_unit;           /* else it is taken for metres */
  fmpq_t metres_per_unit, unit_weight;
  fmpz up[3];         /* across the base */
  bool is_on_slope;   /* it dips, and `up` is not the vertical: */
  tp_map_frame frame; /* if is_on_slope: its east and north */
  size_t band_count;
  fmpq *bands;         /* in lengths of the mesh; NULL where none are given */
  bool has_below;      /* a plane cuts the rock, which rests on the section: */
  fmpq_t below;        /* so high over its lowest point, in lengths of the mesh */
  fmpq_t band_lengths; /* of the mesh, in one of those that bands are told in */
  bool has_friction;
  double friction_angle_deg;
  size_t azimuths;
  const tp_scene *scene;    /* NULL: by options */
  size_t ground_band_count; /* of a scene with a ground: its bands, and no others */
  fmpq *ground_bands;
  long contact_count;                     /* what it rests on instead of a plane; 0: a plane */
  const tp_contact_description *contacts; /* borrowed */
  const double *contact_gaps; /* if not NULL: how far each is from the rock, in metres, found with
                                 its normal: else both are looked for */
  bool has_mean_normals; /* contacts have the mean of their normals: they are taken as a plane */
} tp_solid_given;

/* To be cleared, also on failure. */
TP_MUST_USE tp_status tp_solid_given_init(tp_solid_given *given, const tp_solid_options *options,
                                          tp_message *message);
TP_MUST_USE tp_status tp_solid_given_of_scene(tp_solid_given *given, const tp_scene *scene,
                                              tp_message *message);
void tp_solid_given_clear(tp_solid_given *given);

/* 0 and the three powers of ten from a ten-thousandth to a hundredth of a height. */
TP_MUST_USE tp_status tp_solid_given_bands(tp_solid_given *given, double height,
                                           tp_message *message);

#endif
