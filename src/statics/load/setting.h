/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the loads of a scene act on, and each of them, a file of its own: its wrench in the frame of
 * load/wrench.h. */

#ifndef TP_LOAD_SETTING_H
#define TP_LOAD_SETTING_H

#include "load/wetted.h"
#include "load/wrench.h"
#include "scene/scene.h"

/* Newtons of a kilonewton, pascals of a kilopascal: scenes have the latter. */
enum { TP_KILO = 1000 };

/* In metres, x mirrored towards the right: the block's weight (N) and
 * its centroid, the ends of the base joint where there is water, the thickness. */
typedef struct tp_load_setting {
  const tp_scene *scene;
  const tp_wetted *wetted; /* what its water presses on, where that is sited */
  bool mirrored;
  arb_t weight, x, y;                 /* of the weight */
  arb_t toe_x, toe_y, heel_x, heel_y; /* of the joint: its down-dip and its up-dip end */
  arb_t thickness;
  long bits;
} tp_load_setting;

void tp_load_setting_init(tp_load_setting *setting, const tp_scene *scene, bool mirrored,
                          long bits);
void tp_load_setting_clear(tp_load_setting *setting);

/* A number of the scene in metres, and a point of it in the frame. */
void tp_load_metres(arb_t metres, const fmpq_t length, const tp_load_setting *setting);
void tp_load_point(arb_t x, arb_t y, const tp_quantity *px, const tp_quantity *py,
                   const tp_load_setting *setting);

/* The loads, added to a wrench. */
void tp_load_weight(tp_wrench *wrench, const tp_load_setting *setting);
void tp_load_seismic(tp_wrench *wrench, const tp_load_setting *setting);
void tp_load_water(tp_wrench *wrench, const tp_load_setting *setting);
void tp_load_uplift(tp_wrench *wrench, const tp_load_setting *setting);
void tp_load_wet_lines(tp_wrench *wrench, const tp_wet_lines *lines,
                       const tp_load_setting *setting);
void tp_load_pressure(tp_wrench *wrench, const tp_line_load *load, const tp_load_setting *setting);
void tp_load_surcharge(tp_wrench *wrench, const tp_line_load *load, const tp_load_setting *setting);
void tp_load_anchor(tp_wrench *wrench, const tp_anchor_description *anchor, long row,
                    const tp_load_setting *setting);

#endif
