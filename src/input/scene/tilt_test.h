/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a scene says of its simulated tilt test, and of the shaking of its base. */

#ifndef TP_SCENE_TILT_TEST_H
#define TP_SCENE_TILT_TEST_H

#include "plane/polyline.h"
#include "scene/quantity.h"
#include "topple_tilt.h"

/* Stress locked in on a facet of the base before the start, as the call has it. */
typedef struct tp_traction_description {
  tp_place place;
  long facet;
  tp_quantity first_kpa, last_kpa; /* normal, at its left end and its right one */
  tp_quantity shear_kpa;
} tp_traction_description;

void tp_traction_description_init(tp_traction_description *traction);

/* What is not given is as the test has it (tilt/settings.h). */
typedef struct tp_tilt_test_description {
  tp_place place; /* no file: the scene calls for no test */
  tp_tilt_engine engine;
  tp_place engine_place; /* no file: not given */
  tp_tilt_protocol protocol;
  tp_place protocol_place;
  bool set_down;        /* at each angle; else it is placed level, and tilted */
  tp_place start_place; /* no file: not given */
  tp_quantity speed_deg_min, until_deg, tolerance_deg, duration_s;
  tp_quantity normal_stiffness_gpa_m, shear_stiffness_gpa_m;
  tp_quantity damping, rounding, time_step_s; /* of springs */
  tp_quantity restitution;                    /* of rigid contacts */
  long traction_count;                        /* of the path */
  tp_traction_description *tractions;
} tp_tilt_test_description;

typedef enum tp_shaking_form {
  TP_SHAKING_NONE,
  TP_SHAKING_HALF_SINE,
  TP_SHAKING_FULL_SINE,
  TP_SHAKING_RECORD
} tp_shaking_form;

/* The acceleration of the base along one axis. */
typedef struct tp_shaking_component {
  tp_place place;
  tp_shaking_form form;
  tp_quantity peak_g, frequency_hz; /* of a pulse */
  tp_quantity scale;                /* of a record; 1 where not given */
  tp_quantity column;               /* of its file, where it is a CSV file */
  tp_polyline record;               /* seconds, and shares of standard gravity */
} tp_shaking_component;

enum { TP_SHAKING_HORIZONTAL, TP_SHAKING_VERTICAL, TP_SHAKING_AXES };

#endif
