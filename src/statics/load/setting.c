/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Weight, centroid, heel and toe that the loads act on, as balls, and lengths of the scene in
 * metres. */

#include "load/setting.h"

void tp_load_setting_init(tp_load_setting *s, const tp_scene *scene, bool mirrored, long bits) {
  *s = (tp_load_setting){.scene = scene, .mirrored = mirrored, .bits = bits};
  arb_struct *const all[] = {s->weight, s->x,      s->y,      s->toe_x,
                             s->toe_y,  s->heel_x, s->heel_y, s->thickness};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) arb_init(all[k]);
}

void tp_load_setting_clear(tp_load_setting *s) {
  arb_struct *const all[] = {s->weight, s->x,      s->y,      s->toe_x,
                             s->toe_y,  s->heel_x, s->heel_y, s->thickness};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) arb_clear(all[k]);
}

void tp_load_metres(arb_t metres, const fmpq_t length, const tp_load_setting *s) {
  fmpq_t value;
  fmpq_init(value);
  fmpq_mul(value, length, s->scene->metres_per_unit);
  arb_set_fmpq(metres, value, s->bits);
  fmpq_clear(value);
}

void tp_load_point(arb_t x, arb_t y, const tp_quantity *px, const tp_quantity *py,
                   const tp_load_setting *s) {
  tp_load_metres(x, px->value, s);
  tp_load_metres(y, py->value, s);
  if (s->mirrored) arb_neg(x, x);
}
