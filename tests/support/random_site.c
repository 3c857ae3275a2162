/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What practice asks for of a block at its place: a slope that an earthquake shakes both ways,
 * water by its level with uplift, cracks and ice, bolts in rows of a spacing, linings. It comes on
 * top of what random_effects.c has drawn, and combines with all of it. */

#include "random_scenes.h"

/* `part` in `of` of a number, above 0. */
static void take_part(fmpq *part, const fmpq *of, long most, unsigned long of_them,
                      random_numbers *state) {
  fmpq_set(part, of);
  fmpq_mul_si(part, part, 1 + draw_below(state, most));
  fmpz_mul_ui(fmpq_denref(part), fmpq_denref(part), of_them);
  fmpq_canonicalise(part);
}

/* A level goes on from the height of the water, and may lie below the joint; where there is
 * none, the block's size is not known here and the water stays as it was drawn. */
static void draw_water(random_effects *e, random_numbers *state) {
  fmpq *n = e->numbers;
  e->sited = true;
  e->uplift_kind = (random_uplift)draw_below(state, 3);
  e->faces = (random_faces)draw_below(state, 3);
  if (draw_once_in(state, 8)) fmpq_neg(n + WATER_HEIGHT, n + WATER_HEIGHT);
  e->crack = draw_once_in(state, 3);
  take_part(n + CRACK_HEIGHT, n + WATER_HEIGHT, 8, 4, state);
  fmpq_abs(n + CRACK_HEIGHT, n + CRACK_HEIGHT);
  take_part(n + CRACK_DISTANCE, n + CRACK_HEIGHT, 4, 8, state);
  if (e->crack) e->faces = FACES_BOTH; /* the level is that in front */
  e->ice = draw_once_in(state, 3);
  take_part(n + ICE_THICKNESS, n + CRACK_HEIGHT, 4, 8, state);
  fmpq_mul(n + ICE_STRESS, n + CRACK_HEIGHT, &random_units[e->unit_of_site].metres);
  fmpq_mul_si(n + ICE_STRESS, n + ICE_STRESS, 5 * (1 + draw_below(state, 8)));
}

void random_site_draw(random_scene *s, random_numbers *state) {
  random_effects *e = &s->effects;
  fmpq *n = e->numbers;
  e->unit_of_site = s->unit;
  e->slope = s->has_tilt && e->towards != TOWARDS_BOTH && draw_once_in(state, 2);
  if (e->water && !e->ellipse && e->arcs == 0 && draw_once_in(state, 2)) draw_water(e, state);
  e->lined = e->pressures == LINES_MOST && draw_once_in(state, 2);
  e->lining_passive = draw_once_in(state, 2);
  e->bolted = e->slope && draw_once_in(state, 2);
  fmpq_set_si(n + SPACING, 1 + draw_below(state, 12), 4);
  fmpq_div(n + SPACING, n + SPACING, &random_units[s->unit].metres);
  for (int k = 0; k < ANCHORS_MOST; k++) {
    fmpq_set_si(n + DIPS + k, draw_below(state, 9) * 10, 1);
    e->spaced[k] = draw_once_in(state, 2);
  }
}

void random_site_write_water(FILE *file, const random_effects *e) {
  static const char *const uplifts[] = {"none", "triangular", "full"};
  static const char *const faces[] = {"behind", "front", "both"};
  const fmpq *n = e->numbers;
  random_scene_number(file, "\n  water: {level: ", n + WATER_HEIGHT, "");
  random_scene_number(file, ", unit_weight_kn_m3: ", n + WATER_WEIGHT, "");
  if (e->crack) {
    random_scene_number(file, ", tension_crack: {height: ", n + CRACK_HEIGHT, "");
    random_scene_number(file, ", distance: ", n + CRACK_DISTANCE, "}");
  }
  if (e->ice) {
    random_scene_number(file, ", ice_kpa: ", n + ICE_STRESS, "");
    random_scene_number(file, ", ice_thickness: ", n + ICE_THICKNESS, "");
  }
  fprintf(file, ", uplift: %s, faces: %s}", uplifts[e->uplift_kind], faces[e->faces]);
}

void random_site_write_tilt(FILE *file, const random_scene *s) {
  fprintf(file, "\nslope: {towards: %s", s->effects.towards == TOWARDS_LEFT ? "left" : "right");
  random_scene_number(file, ", dip_deg: ", s->numbers + TILT, "}");
}
