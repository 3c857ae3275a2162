/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A random scene as a scene file. */

#include "random_scenes.h"

#include <stdio.h>

void random_scene_number(FILE *file, const char *before, const fmpq *value, const char *after) {
  char *text = fmpq_get_str(NULL, 10, value);
  fprintf(file, "%s%s%s", before, text, after);
  flint_free(text);
}

static void write_ring(FILE *file, const random_scene *s, const polygon *ring) {
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  for (long k = 0; k < ring->count; k++) {
    random_scene_vertex(x, y, s, ring, k);
    random_scene_number(file, k == 0 ? "[[" : ", [", x, ", ");
    random_scene_number(file, "", y, "]");
  }
  fputs("]", file);
  fmpq_clear(x);
  fmpq_clear(y);
}

static void write_base(FILE *file, const random_scene *s) {
  const fmpq *n = s->numbers;
  if (s->profile.count > 0) {
    fputs("\nbase:\n  profile: ", file);
    write_ring(file, s, &s->profile);
    return;
  }
  if (!s->beyond_stated && !s->effects.has_between) return;
  /* where nothing is said of the base, the default cuts its steep ends off */
  fprintf(file, "\nbase:\n  mated: %s", s->effects.has_between ? "true" : "whole");
  random_effects_write_between(file, s);
  if (!s->beyond_stated) return;
  random_scene_number(file, "\n  beyond: {left: ", n + BEYOND_LEFT, "");
  random_scene_number(file, ", right: ", n + BEYOND_RIGHT, "}");
}

char *random_scene_text(const random_scene *s) {
  char *text = NULL;
  size_t size = 0;
  FILE *file = open_memstream(&text, &size);
  fprintf(file, "topple: 1\nlength_unit: %s\nblock:\n  unit_weight_kn_m3: %d",
          random_units[s->unit].name, BLOCK_WEIGHT);
  if (!s->effects.ellipse) {
    fputs("\n  outline: ", file);
    write_ring(file, s, &s->outline);
  }
  random_effects_write_block(file, s);
  if (s->hole.count > 0) {
    fputs("\n  holes:\n  - ", file);
    write_ring(file, s, &s->hole);
  }
  if (s->part.count > 0) {
    fprintf(file, "\n  parts:\n  - unit_weight_kn_m3: %ld\n    outline: ", s->part_weight);
    write_ring(file, s, &s->part);
  }
  write_base(file, s);
  random_effects_write_loads(file, s);
  if (s->has_friction) random_effects_write_friction(file, s);
  random_effects_write_tilt(file, s);
  fputs("\n", file);
  fclose(file);
  return text;
}
