/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the figure of a solid shows, from its result; and the file that it becomes. */

#include "common/host.h"
#include "common/message.h"
#include "figure/name.h"
#include "figure/solid.h"
#include "figure/version.h"
#include "output/file.h"

#include <math.h>
#include <stdlib.h>

#define ELEVATION 0.21 /* of the eye over the horizontal, radians */

static const double radian = 3.14159265358979323846 / 180;

/* The azimuth to the right, and the tilt that is drawn. */
static void choose_way(tp_solid_figure *f) {
  const tp_solid *solid = f->solid;
  if (solid->has_tilt_azimuth) {
    f->has_way = true;
    f->azimuth_deg = solid->tilt_azimuth_deg;
  } else if (f->band != NULL && f->band->stands) {
    f->has_way = true;
    f->azimuth_deg = f->band->least.azimuth_deg.value;
  } else if (solid->has_contacts && solid->contacts.has_critical) {
    f->has_way = true;
    f->azimuth_deg = solid->contacts.critical_azimuth_deg.value;
  }
  if (solid->has_tilt_angle) f->tilt = radian * fmin(solid->tilt_angle_deg, 89);
}

/* Right along the horizontal of the azimuth, the eye a little above the horizontal; in the axes of
 * the base, which is tilted. */
static void set_view(tp_solid_figure *f) {
  const double way = radian * f->azimuth_deg, c = cos(f->tilt), s = sin(f->tilt);
  const double down[3] = {sin(way), cos(way), 0};
  const double right[3] = {c * down[0], c * down[1], s};
  const double upright[3] = {-s * down[0], -s * down[1], c};
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const double ahead = right[i] * upright[j] - right[j] * upright[i];
    f->view.right[k] = right[k];
    f->view.up[k] = cos(ELEVATION) * upright[k] - sin(ELEVATION) * ahead;
    f->view.eye[k] = cos(ELEVATION) * ahead + sin(ELEVATION) * upright[k];
  }
}

tp_status tp_solid_figure_init(tp_solid_figure *f, const tp_solid *solid, int dots,
                               tp_message *message) {
  *f = (tp_solid_figure){.solid = solid};
  if (solid->has_wedge) return TP_OK;
  if (solid->band_count > 0) f->band = solid->bands + solid->governing;
  const tp_status status = tp_solid_mesh_init(&f->mesh, &f->ground, solid, message);
  if (status != TP_OK) return status;
  choose_way(f);
  if (dots == 0) return TP_OK;
  set_view(f);
  if (tp_solid_picture_init(&f->side, f, &f->view, true, dots) &&
      tp_solid_picture_init(&f->above, f, &tp_solid_from_above, false, dots)) {
    return TP_OK;
  }
  tp_solid_figure_clear(f);
  return tp_fail_memory(message, "the figure");
}

void tp_solid_figure_clear(tp_solid_figure *f) {
  tp_solid_picture_clear(&f->side);
  tp_solid_picture_clear(&f->above);
  tp_solid_mesh_clear(&f->mesh);
  tp_solid_mesh_clear(&f->ground);
}

static bool draw_page(double *height, cairo_t *cr, const void *what) {
  return tp_solid_page(height, cr, what);
}

tp_drawn_page tp_solid_drawn_page(const tp_solid_figure *figure) {
  return (tp_drawn_page){2 * TP_FIGURE_MARGIN + TP_SOLID_PAGE_ROOM, draw_page, figure};
}

static tp_status write_figure(const char *path, const tp_solid_figure *figure,
                              tp_figure_consent consent, tp_message *message) {
  const char *read[] = {figure->solid->file, figure->solid->scene};
  const tp_file_sources sources = {figure->solid->scene != NULL ? 2 : 1, read};
  char *bytes = NULL;
  size_t length = 0;
  tp_status status = TP_OK;
  if (tp_figure_kind_of(path) == TP_FIGURE_GLB) {
    status = tp_solid_gltf(&bytes, &length, figure, message);
  } else {
    const tp_drawn_page page = tp_solid_drawn_page(figure);
    status = tp_drawn_page_bytes(&bytes, &length, path, &page, message);
  }
  if (status == TP_OK) status = tp_file_write_if(path, bytes, length, sources, consent, message);
  free(bytes);
  return status;
}

tp_status tp_report_figure_solid(const char *path, const tp_solid *solid, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, path);
  TP_REFUSE_NULL(message, solid);
  TP_REFUSE_OTHER_VERSION(message);
  return tp_report_figure_solid_if(path, solid, (tp_figure_consent){0}, message);
}

tp_status tp_report_figure_solid_if(const char *path, const tp_solid *solid,
                                    tp_figure_consent consent, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, path);
  TP_REFUSE_NULL(message, solid);
  TP_REFUSE_OTHER_VERSION(message);
  const tp_figure_kind kind = tp_figure_kind_of(path);
  if (kind == TP_FIGURE_UNKNOWN || kind == TP_FIGURE_DXF) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){path, 0, 0},
                     "the ending of the name of a figure of a solid is its format: .svg, .pdf, "
                     ".png or .glb");
  }
  if (kind == TP_FIGURE_GLB && solid->has_wedge) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){path, 0, 0},
                     "a wedge has no mesh that a .glb could hold: draw it as .svg, .pdf or .png");
  }
  tp_solid_figure figure;
  tp_status status =
      tp_solid_figure_init(&figure, solid, kind == TP_FIGURE_GLB ? 0 : TP_SOLID_DOTS, message);
  if (status == TP_OK) {
    status = write_figure(path, &figure, consent, message);
    tp_solid_figure_clear(&figure);
  }
  return status;
}
