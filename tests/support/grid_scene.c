/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "grid_scene.h"

#include <check.h>
#include <stdio.h>
#include <unistd.h>

/* By a fan of triangles from the first vertex: sums of c and of c (x_0 + x_i + x_j), c twice an
 * area. */
static void find_centroid(exact_point *centroid, const grid_figure *f) {
  long area = 0, x = 0, y = 0;
  const grid_point *p = f->outline;
  for (long k = 2; k < f->outline_count; k++) {
    const long c = grid_cross(p[0], p[k - 1], p[0], p[k]);
    area += c;
    x += c * (p[0].x + p[k - 1].x + p[k].x);
    y += c * (p[0].y + p[k - 1].y + p[k].y);
  }
  fmpq_set_si(&centroid->x, x, (ulong)(3 * area));
  fmpq_set_si(&centroid->y, y, (ulong)(3 * area));
}

void grid_scene_init(grid_scene *s, random_numbers *state) {
  static const long frictions[] = {0, 20, 45, 70};
  exact_point_init(&s->centroid);
  for (bool found = false; !found;) {
    tp_polyline ring = {0};
    tp_scene scene = {0};
    tp_base base;
    tp_message message = {.text = ""};
    grid_draw_outline(&s->f, state);
    grid_draw_profile(&scene.base.profile, state);
    grid_set_ring(&ring, &s->f);
    const tp_section section = {.ring_count = 1, .rings = &ring};
    ck_assert_int_eq(tp_base_init(&base, &scene, &section, &message), TP_OK);
    grid_take_base(&s->f, &base);
    grid_compare_edges(&s->all, &s->touching, &s->f);
    found = !grid_overlaps(&s->f) && s->touching.count > 0;
    tp_base_clear(&base);
    tp_polyline_clear(&scene.base.profile);
    tp_polyline_clear(&ring);
  }
  find_centroid(&s->centroid, &s->f);
  s->friction_deg = frictions[draw_below(state, 4)];
}

static void write_points(FILE *file, const char *key, const grid_point *points, long count) {
  fprintf(file, "%s: [", key);
  for (long k = 0; k < count; k++) {
    fprintf(file, "%s[%ld, %ld]", k > 0 ? ", " : "", points[k].x, points[k].y);
  }
  fputs("]", file);
}

void grid_scene_solve(tp_solution **solution, const grid_scene *s) {
  char path[] = "/tmp/topple-stability-XXXXXX";
  tp_scene *scene = NULL;
  tp_message message = {.text = ""};
  const tp_solve_options options = tp_solve_options_default();
  const int handle = mkstemp(path);
  ck_assert_int_ge(handle, 0);
  FILE *file = fdopen(handle, "w");
  ck_assert_ptr_nonnull(file);
  fputs("topple: 1\nlength_unit: m\nblock:\n", file);
  write_points(file, "  outline", s->f.outline, s->f.outline_count);
  fputs("\nbase:\n", file);
  write_points(file, "  profile", s->f.base + 1, s->f.base_count - 2);
  fprintf(file, "\nfriction_angle_deg: %ld\ntilt: {towards: both, angle_deg: 45}\n",
          s->friction_deg);
  fclose(file);
  tp_status status = tp_scene_read(&scene, path, &message);
  unlink(path);
  if (status == TP_OK) status = tp_solve(solution, scene, &options, &message);
  ck_assert_msg(status == TP_OK, "%s", message.text);
  tp_scene_free(scene);
}

void grid_scene_clear(grid_scene *s) {
  exact_point_clear(&s->centroid);
}
