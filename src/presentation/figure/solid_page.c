/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The page of a solid: title, the rock from the side and what touches from above, the rose and the
 * table of bands; and the file that it becomes. */

#include "common/host.h"
#include "common/message.h"
#include "figure/drawn_page.h"
#include "figure/name.h"
#include "figure/solid.h"
#include "figure/version.h"
#include "output/encode.h"
#include "output/file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define WIDTH 558.0
#define SIDE_WIDTH 326.0
#define SIDE_HEIGHT 250.0
#define ROSE_SIZE 270.0
#define ELEVATION 0.21 /* of the eye over the horizontal, radians */

enum { DOTS = 1100 };

static const double radian = 3.14159265358979323846 / 180;

double tp_solid_page_width(void) {
  return 2 * TP_FIGURE_MARGIN + WIDTH;
}

/* ---- what is said ------------------------------------------------------------------------------
 */

static const char *against(tp_mechanism mechanism) {
  return mechanism == TP_SLIDES    ? "sliding"
         : mechanism == TP_TOPPLES ? "toppling"
                                   : "toppling and sliding";
}

static void add_verdict(tp_text *t, const tp_solid_figure *f) {
  const tp_solid *solid = f->solid;
  const tp_solid_stance *own = &f->band->stance;
  char n[TP_NUMBER_SIZE];
  if (!f->band->has_stance && !f->band->stands) {
    tp_text_add(t, "it does not stand.");
    return;
  }
  if (f->band->has_stance) {
    if (solid->is_on_slope) {
      tp_text_add(t, "on its base, which dips %.6g° towards %.6g°, it %s", solid->tilt_angle_deg,
                  solid->tilt_azimuth_deg, tp_mechanism_name(own->verdict));
    } else if (solid->has_tilt_angle) {
      tp_text_add(t, "tilted by %.6g° it %s", solid->tilt_angle_deg,
                  tp_mechanism_name(own->verdict));
    } else {
      tp_text_add(t, "as it lies it %s", tp_mechanism_name(own->verdict));
    }
    if (own->has_fos) {
      tp_text_add(t, ", factor of safety %s against %s", tp_text_significant(n, own->fos, 4),
                  against(own->fos_mechanism));
    }
    tp_text_add(t, ". ");
    if (own->has_acceleration) {
      tp_text_add(t, "Least horizontal acceleration that moves it: %s g towards %.0f°. ",
                  tp_text_significant(n, own->acceleration_g, 4),
                  own->acceleration_azimuth_deg.value);
    }
  }
  if (f->band->stands) {
    tp_text_add(t, "%s level on it %s at %s°, towards %.0f°.",
                f->band->has_stance ? "From" : "from", tp_mechanism_name(f->band->mechanism),
                tp_text_significant(n, f->band->critical_deg, 5), f->band->least.azimuth_deg.value);
  }
}

static bool say(double *y, cairo_t *cr, const tp_solid_figure *f) {
  const tp_solid *solid = f->solid;
  tp_text title = {0}, verdict = {0};
  tp_encode_plain(&title, solid->title != NULL ? solid->title : solid->file);
  tp_text_add(&verdict, "With the least band, %.6g %s, which governs, ", f->band->band,
              solid->length_unit);
  add_verdict(&verdict, f);
  const bool done = !title.failed && !verdict.failed;
  if (done) {
    tp_figure_ink(cr, TP_INK_BLACK);
    *y = tp_figure_paragraph(cr, TP_FIGURE_MARGIN, *y, WIDTH, TP_TITLE_SIZE, true, title.data) + 2;
    *y =
        tp_figure_paragraph(cr, TP_FIGURE_MARGIN, *y, WIDTH, TP_BODY_SIZE, false, verdict.data) + 4;
  }
  tp_text_drop(&title);
  tp_text_drop(&verdict);
  return done;
}

static void head(cairo_t *cr, double x, double y, const char *text) {
  tp_figure_font(cr, TP_HEAD_SIZE, true);
  tp_figure_ink(cr, TP_INK_BLACK);
  tp_figure_text(cr, x, y, text);
}

static void say_below(cairo_t *cr, const tp_solid_figure *f, double x, double y, double width) {
  static const char *const of_side =
      "The rock at its tilt, which goes to the right. Red: what touches in the least band, and the "
      "edge about which it would topple this way; the arrow: its weight, from the centroid to the "
      "base.";
  static const char *const of_rose =
      "The rose: how far from the middle a line lies in an azimuth is the tilt at which the rock "
      "topples that way. All that is no higher than the band over its lowest point is taken to "
      "touch.";
  y = tp_solid_draw_bands(cr, f, x, y, width) + 6;
  tp_figure_ink(cr, TP_INK_GREY);
  y = tp_figure_paragraph(cr, x, y, width, TP_SMALL_SIZE, false, of_side) + 3;
  tp_figure_paragraph(cr, x, y, width, TP_SMALL_SIZE, false, of_rose);
}

bool tp_solid_page(double *height, cairo_t *cr, const tp_solid_figure *f) {
  const double left = TP_FIGURE_MARGIN, right = left + WIDTH, middle = left + SIDE_WIDTH;
  double y = left;
  if (!say(&y, cr, f)) return false;
  head(cr, left, y + TP_HEAD_SIZE, "On its base");
  head(cr, middle + 10, y + TP_HEAD_SIZE, "What touches, from above");
  y += 1.5 * TP_HEAD_SIZE;
  tp_solid_draw_side(cr, f, (tp_box){left, y, middle, y + SIDE_HEIGHT});
  tp_solid_draw_above(cr, f, (tp_box){middle + 10, y, right, y + SIDE_HEIGHT});
  y += SIDE_HEIGHT + 6;
  head(cr, left, y + TP_HEAD_SIZE, "Tilt at which it topples, towards every azimuth");
  y += 1.5 * TP_HEAD_SIZE;
  tp_solid_draw_rose(cr, f, (tp_box){left, y, left + ROSE_SIZE, y + ROSE_SIZE});
  say_below(cr, f, left + ROSE_SIZE + 14, y + 24, WIDTH - ROSE_SIZE - 14);
  *height = y + ROSE_SIZE + left;
  return true;
}

/* ---- what is drawn -----------------------------------------------------------------------------
 */

/* The azimuth to the right, and the tilt that is drawn. */
static void choose_way(tp_solid_figure *f) {
  const tp_solid *solid = f->solid;
  if (solid->has_tilt_azimuth) {
    f->has_way = true;
    f->azimuth_deg = solid->tilt_azimuth_deg;
  } else if (f->band->stands) {
    f->has_way = true;
    f->azimuth_deg = f->band->least.azimuth_deg.value;
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

static tp_status init(tp_solid_figure *f, const tp_solid *solid, tp_message *message) {
  static const tp_solid_view above = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  *f = (tp_solid_figure){.solid = solid, .band = solid->bands + solid->governing};
  const tp_status status = tp_solid_mesh_init(&f->mesh, solid, message);
  if (status != TP_OK) return status;
  choose_way(f);
  set_view(f);
  if (tp_solid_picture_init(&f->side, &f->mesh, &f->view, true, DOTS) &&
      tp_solid_picture_init(&f->above, &f->mesh, &above, false, DOTS)) {
    return TP_OK;
  }
  tp_solid_picture_clear(&f->side);
  tp_solid_mesh_clear(&f->mesh);
  return tp_fail_memory(message, "the figure");
}

static void clear(tp_solid_figure *f) {
  tp_solid_picture_clear(&f->side);
  tp_solid_picture_clear(&f->above);
  tp_solid_mesh_clear(&f->mesh);
}

static bool draw_page(double *height, cairo_t *cr, const void *what) {
  return tp_solid_page(height, cr, what);
}

static tp_status write_figure(const char *path, const tp_solid_figure *figure,
                              tp_figure_consent consent, tp_message *message) {
  const tp_drawn_page page = {tp_solid_page_width(), draw_page, figure};
  const char *read[] = {figure->solid->file, figure->solid->scene};
  const tp_file_sources sources = {figure->solid->scene != NULL ? 2 : 1, read};
  char *bytes = NULL;
  size_t length = 0;
  tp_status status = tp_drawn_page_bytes(&bytes, &length, path, &page, message);
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
                     "the ending of the name of a figure of a solid is its format: .svg, .pdf or "
                     ".png");
  }
  if (solid->band_count == 0) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){solid->scene, 0, 0},
                     "a figure of a solid shows what of it touches a plane, and this one lies on "
                     "contacts of its own, or slides as a wedge: the report and --json have all "
                     "that is found");
  }
  tp_solid_figure figure;
  tp_status status = init(&figure, solid, message);
  if (status == TP_OK) {
    status = write_figure(path, &figure, consent, message);
    clear(&figure);
  }
  return status;
}
