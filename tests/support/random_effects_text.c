/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "random_scenes.h"

#include <stdlib.h>

/* A point before the scene's map. */
static void write_point(FILE *file, const char *before, const random_scene *s, int at) {
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  random_scene_map(x, y, s, s->effects.x[at], s->effects.y[at]);
  random_scene_number(file, before, x, ", ");
  random_scene_number(file, "", y, "]");
  fmpq_clear(x);
  fmpq_clear(y);
}

static void write_corners(FILE *file, const random_scene *s) {
  const random_effects *e = &s->effects;
  if (e->corners == 0) return;
  fprintf(file, "\n  rounded:\n    model: %s\n    corners:", e->paper_model ? "paper" : "exact");
  for (int k = 0; k < e->corners; k++) {
    fputs("\n    - {at: ", file);
    if (e->places[k] == AT_LEFT_END) fputs("left_end", file);
    if (e->places[k] == AT_RIGHT_END) fputs("right_end", file);
    if (e->places[k] == AT_VERTEX) write_point(file, "[", s, AT_CORNERS + k);
    random_scene_number(file, ", radius: ", e->numbers + RADII + k, "}");
  }
}

/* Which end of the edge comes first in the outline. */
static int first_end(const random_scene *s, int at) {
  const random_effects *e = &s->effects;
  const polygon *o = &s->outline;
  for (long k = 0; k < o->count; k++) {
    const long next = (k + 1) % o->count;
    if (o->x[k] == e->x[at] && o->y[k] == e->y[at] && o->x[next] == e->x[at + 1] &&
        o->y[next] == e->y[at + 1]) {
      return at;
    }
  }
  return at + 1;
}

static void write_arcs(FILE *file, const random_scene *s) {
  const random_effects *e = &s->effects;
  if (e->arcs > 0) fputs("\n  arcs:", file);
  for (int k = 0; k < e->arcs; k++) {
    write_point(file, "\n  - {from: [", s, first_end(s, AT_ARCS + 2 * k));
    fprintf(file, ", bulge: %d/16}", e->bulges[k]);
  }
}

void random_effects_write_block(FILE *file, const random_scene *s) {
  const fmpq *n = s->effects.numbers;
  if (!fmpq_is_zero(n + THICKNESS)) {
    random_scene_number(file, "\n  thickness: ", n + THICKNESS, "");
  }
  if (s->effects.ellipse) {
    random_scene_number(file, "\n  ellipse: {width: ", n + ELLIPSE_WIDTH, "");
    random_scene_number(file, ", height: ", n + ELLIPSE_HEIGHT, "");
    random_scene_number(file, ", flat: ", n + ELLIPSE_FLAT, "}");
  }
  write_corners(file, s);
  write_arcs(file, s);
}

void random_effects_write_between(FILE *file, const random_scene *s) {
  if (!s->effects.has_between) return;
  write_point(file, "\n  between: [[", s, AT_BETWEEN);
  write_point(file, ", [", s, AT_BETWEEN + 1);
  fputs("]", file);
}

static void write_water(FILE *file, const random_effects *e) {
  if (!e->water) return;
  if (e->sited) {
    random_site_write_water(file, e);
    return;
  }
  random_scene_number(file, "\n  water: {height: ", e->numbers + WATER_HEIGHT, "");
  random_scene_number(file, ", unit_weight_kn_m3: ", e->numbers + WATER_WEIGHT, "");
  fprintf(file, ", uplift: %s, stays_level: %s}", e->uplift ? "true" : "false",
          e->stays_level ? "true" : "false");
}

static void write_lines(FILE *file, const random_scene *s, const char *name, int count, int at,
                        int stress, bool two) {
  if (count > 0) fprintf(file, "\n  %s:", name);
  for (int k = 0; k < count; k++) {
    const fmpq *kpa = s->effects.numbers + stress + (two ? 2 : 1) * k;
    write_point(file, "\n  - {from: [", s, at + 2 * k);
    write_point(file, ", to: [", s, at + 2 * k + 1);
    random_scene_number(file, two ? ", kpa: [" : ", kpa: ", kpa, two ? ", " : "}");
    if (two) random_scene_number(file, "", kpa + 1, "]}");
  }
}

static void write_lining(FILE *file, const random_scene *s) {
  const int last = LINES_MOST - 1;
  if (!s->effects.lined) return;
  const fmpq *kpa = s->effects.numbers + STRESSES + 2 * last;
  write_point(file, "\n  support_pressures:\n  - {from: [", s, AT_PRESSURES + 2 * last);
  write_point(file, ", to: [", s, AT_PRESSURES + 2 * last + 1);
  random_scene_number(file, ", kpa: [", kpa, ", ");
  random_scene_number(file, "", kpa + 1, "]");
  fprintf(file, ", passive: %s}", s->effects.lining_passive ? "true" : "false");
}

void random_effects_write_loads(FILE *file, const random_scene *s) {
  const random_effects *e = &s->effects;
  const fmpq *n = e->numbers;
  if (!random_effects_load(e)) return;
  fputs("\nloads:", file);
  if (e->seismic) {
    random_scene_number(file, "\n  seismic: {horizontal: ", n + HORIZONTAL, "");
    random_scene_number(file, ", vertical: ", n + VERTICAL, "}");
  }
  write_water(file, e);
  write_lines(file, s, "pressures", e->pressures - e->lined, AT_PRESSURES, STRESSES, true);
  write_lining(file, s);
  write_lines(file, s, "surcharges", e->surcharges, AT_SURCHARGES, SURCHARGES, false);
  if (e->anchors > 0) fputs("\n  anchors:", file);
  for (int k = 0; k < e->anchors; k++) {
    write_point(file, "\n  - {at: [", s, AT_ANCHORS + k);
    if (e->bolted) {
      random_scene_number(file, ", dip_deg: ", n + DIPS + k, "");
      if (e->spaced[k]) random_scene_number(file, ", spacing: ", n + SPACING, "");
    } else {
      random_scene_number(file, ", direction_deg: ", n + DIRECTIONS + k, "");
    }
    random_scene_number(file, ", force_kn: ", n + FORCES + k, "");
    fprintf(file, ", passive: %s}", e->passive[k] ? "true" : "false");
  }
  if (!fmpq_is_zero(n + BOND)) random_scene_number(file, "\n  bond_kpa: ", n + BOND, "");
  if (!fmpq_is_zero(n + COHESION))
    random_scene_number(file, "\n  cohesion_kpa: ", n + COHESION, "");
}

void random_effects_write_friction(FILE *file, const random_scene *s) {
  const random_effects *e = &s->effects;
  const fmpq *n = e->numbers, *angle = s->numbers + FRICTION;
  if (e->law == LAW_NONE) {
    random_scene_number(file, "\nfriction_angle_deg: ", angle, "");
    return;
  }
  if (e->law == LAW_PATTON) {
    random_scene_number(file, "\nfriction: {law: patton, basic_angle_deg: ", angle, "");
    random_scene_number(file, ", roughness_angle_deg: ", n + ROUGHNESS, "}");
    return;
  }
  random_scene_number(file, "\nfriction: {law: barton, residual_angle_deg: ", angle, "");
  random_scene_number(file, ", jcs_mpa: ", n + STRENGTH, "/1000");
  if (e->law == LAW_JRC) random_scene_number(file, ", jrc: ", n + JRC, "}");
  if (e->law == LAW_ROUGHNESS) {
    random_scene_number(file, ", roughness_angle_deg: ", n + ROUGHNESS, "}");
  }
  if (e->law == LAW_TEST) {
    random_scene_number(file, ", tilt_test: {angle_deg: ", n + TEST_ANGLE, "");
    random_scene_number(file, ", normal_stress_kpa: ", n + TEST_STRESS, "}}");
  }
}

void random_effects_write_tilt(FILE *file, const random_scene *s) {
  static const char *const names[] = {"both", "left", "right"};
  if (s->effects.slope) {
    random_site_write_tilt(file, s);
    return;
  }
  fprintf(file, "\ntilt: {towards: %s", names[s->effects.towards]);
  if (s->has_tilt) random_scene_number(file, ", angle_deg: ", s->numbers + TILT, "");
  fputs("}", file);
}
