/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scenes drawn from bytes. Coordinates lie on a coarse grid, so that touching, repeated and
 * collinear points are common; now and then a number is extreme. */

#include "fuzz.h"

#include <stdio.h>
#include <stdlib.h>

static void put_coordinate(FILE *out, fuzz_bytes *b) {
  static const char *const odd[] = {"1/3", "-2/7", "0.1", "1e300", "1e-300", "-1e9", "2^0.5", "a"};
  const unsigned drawn = fuzz_pick(b, 256);
  if (drawn >= 248) {
    fputs(odd[drawn - 248], out);
  } else {
    fprintf(out, "%u", drawn % 10);
  }
}

static void put_positive(FILE *out, fuzz_bytes *b) {
  static const char *const sizes[] = {"1", "2",   "3",    "5",     "8",   "0.3",
                                      "a", "7/3", "1e12", "1e-12", "2*a", "0"};
  fputs(sizes[fuzz_pick(b, sizeof sizes / sizeof sizes[0])], out);
}

static void put_point(FILE *out, fuzz_bytes *b) {
  fputc('[', out);
  put_coordinate(out, b);
  fputs(", ", out);
  put_coordinate(out, b);
  fputc(']', out);
}

static void put_points(FILE *out, fuzz_bytes *b, unsigned least, unsigned most) {
  const unsigned count = least + fuzz_pick(b, most - least + 1);
  fputc('[', out);
  for (unsigned k = 0; k < count; k++) {
    if (k > 0) fputs(", ", out);
    put_point(out, b);
  }
  fputc(']', out);
}

/* A simple outline: a chain below from left to right, and back above it. */
static void put_columns(FILE *out, fuzz_bytes *b) {
  const unsigned count = 2 + fuzz_pick(b, 6);
  fputc('[', out);
  for (unsigned k = 0; k < count; k++) fprintf(out, "[%u, %u], ", 2 * k, fuzz_pick(b, 4));
  for (unsigned k = count; k-- > 0;)
    fprintf(out, "[%u, %u]%s", 2 * k, 5 + fuzz_pick(b, 6), k > 0 ? ", " : "]");
}

static void put_shape(FILE *out, fuzz_bytes *b) {
  static const char *const ends[] = {"valley", "peak"};
  switch (fuzz_pick(b, 6)) {
  case 0:
    fputs("  slab: {width: ", out);
    put_positive(out, b);
    fputs(", height: ", out);
    put_positive(out, b);
    break;
  case 1:
    fprintf(out, "  teeth: {count: %u, width: ", 1 + fuzz_pick(b, 12));
    put_positive(out, b);
    fputs(", height: ", out);
    put_positive(out, b);
    fputs(", depth: ", out);
    put_positive(out, b);
    fprintf(out, ", left_end: %s", ends[fuzz_pick(b, 2)]);
    break;
  case 2:
    fputs("  ellipse: {width: ", out);
    put_positive(out, b);
    fputs(", height: ", out);
    put_positive(out, b);
    fputs(", flat: ", out);
    put_positive(out, b);
    break;
  case 3:
    fputs("  outline: ", out);
    put_points(out, b, 3, 9);
    fputc('\n', out);
    return;
  default:
    fputs("  outline: ", out);
    put_columns(out, b);
    fputc('\n', out);
    return;
  }
  fputs("}\n", out);
}

static void put_corners(FILE *out, fuzz_bytes *b) {
  static const char *const places[] = {"left_end", "right_end"};
  fprintf(out, "  rounded: {model: %s, corners: [", fuzz_pick(b, 2) != 0 ? "paper" : "exact");
  for (unsigned count = 1 + fuzz_pick(b, 3), k = 0; k < count; k++) {
    const unsigned place = fuzz_pick(b, 3);
    fputs(k > 0 ? ", {at: " : "{at: ", out);
    if (place < 2) fputs(places[place], out);
    if (place == 2) put_point(out, b);
    fputs(", radius: ", out);
    put_positive(out, b);
    fputc('}', out);
  }
  fputs("]}\n", out);
}

static void put_block(FILE *out, fuzz_bytes *b) {
  const unsigned with = fuzz_pick(b, 64);
  fputs("block:\n", out);
  put_shape(out, b);
  if ((with & 1) != 0) fputs("  thickness: 3\n", out);
  if ((with & 6) != 0) fputs("  unit_weight_kn_m3: 26\n", out);
  if ((with & 24) == 8) {
    fputs("  holes: [", out);
    put_points(out, b, 3, 4);
    fputs("]\n", out);
  }
  if ((with & 24) == 16) {
    fputs("  parts: [{unit_weight_kn_m3: 20, outline: ", out);
    put_points(out, b, 3, 5);
    fputs("}]\n", out);
  }
  if ((with & 24) == 24) {
    fputs("  arcs: [{from: ", out);
    put_point(out, b);
    fputs(", bulge: ", out);
    put_coordinate(out, b);
    fputs("}]\n", out);
  }
  if ((with & 32) != 0) put_corners(out, b);
}

static void put_base(FILE *out, fuzz_bytes *b) {
  switch (fuzz_pick(b, 5)) {
  case 0:
    fputs("base: {mated: true, beyond: {left: ", out);
    put_positive(out, b);
    fputs(", right: ", out);
    put_positive(out, b);
    fputs("}}\n", out);
    break;
  case 1:
    fputs("base: {mated: true, between: ", out);
    put_points(out, b, 2, 2);
    fputs("}\n", out);
    break;
  case 2:
    fputs("base: {profile: ", out);
    put_points(out, b, 2, 8);
    fputs("}\n", out);
    break;
  case 3:
    fputs("base: {profile: [[-5, 0], [20, 0]]}\n", out);
    break;
  default:
    break;
  }
}

static void put_line_load(FILE *out, fuzz_bytes *b, const char *name) {
  fprintf(out, "  %s: [{from: ", name);
  put_point(out, b);
  fputs(", to: ", out);
  put_point(out, b);
  fprintf(out, ", kpa: %u}]\n", fuzz_pick(b, 200));
}

static void put_loads(FILE *out, fuzz_bytes *b) {
  const unsigned with = fuzz_pick(b, 256);
  if (with < 128) return;
  fputs("loads:\n", out);
  if ((with & 1) != 0) {
    fprintf(out, "  seismic: {horizontal: 0.%u, vertical: -0.%u}\n", fuzz_pick(b, 10),
            fuzz_pick(b, 10));
  }
  if ((with & 2) != 0) {
    fputs("  water: {height: ", out);
    put_positive(out, b);
    fprintf(out, ", uplift: %s, stays_level: %s}\n", fuzz_pick(b, 2) != 0 ? "true" : "false",
            fuzz_pick(b, 2) != 0 ? "true" : "false");
  }
  if ((with & 4) != 0) put_line_load(out, b, "pressures");
  if ((with & 8) != 0) put_line_load(out, b, "surcharges");
  if ((with & 16) != 0) {
    fputs("  anchors: [{at: ", out);
    put_point(out, b);
    fprintf(out, ", direction_deg: %d, force_kn: %u, passive: %s}]\n",
            2 * (int)fuzz_pick(b, 256) - 256, fuzz_pick(b, 200),
            fuzz_pick(b, 2) != 0 ? "true" : "false");
  }
  fprintf(out, "  bond_kpa: %u\n", (with & 32) != 0 ? fuzz_pick(b, 100) : 0);
  if ((with & 64) != 0) fprintf(out, "  cohesion_kpa: %u\n", fuzz_pick(b, 100));
}

static void put_friction(FILE *out, fuzz_bytes *b) {
  switch (fuzz_pick(b, 5)) {
  case 0:
    fprintf(out, "friction: {law: patton, basic_angle_deg: %u, roughness_angle_deg: %u}\n",
            fuzz_pick(b, 91), fuzz_pick(b, 60));
    break;
  case 1:
    fprintf(out, "friction: {law: barton, residual_angle_deg: %u, jcs_mpa: %u, jrc: %u}\n",
            fuzz_pick(b, 91), fuzz_pick(b, 200), fuzz_pick(b, 21));
    break;
  case 2:
    break;
  default:
    fprintf(out, "friction_angle_deg: %u\n", fuzz_pick(b, 92));
  }
}

char *fuzz_scene(fuzz_bytes *b) {
  static const char *const units[] = {"mm", "cm", "m", "km", "in", "ft"};
  static const char *const sides[] = {"left", "right", "both"};
  char *text = NULL;
  size_t length = 0;
  FILE *out = open_memstream(&text, &length);
  FUZZ_EXPECT(out != NULL);
  fprintf(out, "topple: 1\nlength_unit: %s\nparameters: {a: 1.5}\n", units[fuzz_pick(b, 6)]);
  put_block(out, b);
  put_base(out, b);
  put_loads(out, b);
  put_friction(out, b);
  fprintf(out, "tilt: {towards: %s", sides[fuzz_pick(b, 3)]);
  if (fuzz_pick(b, 2) != 0) fprintf(out, ", angle_deg: %u", fuzz_pick(b, 92));
  fputs("}\n", out);
  fclose(out);
  return text;
}
