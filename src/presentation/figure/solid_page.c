/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The page of a solid: title and verdict; the rock from the side and what touches from above, its
 * rose and a table; of a wedge its shape and its planes in the lower hemisphere. */

#include "report/solid_page.h"
#include "figure/solid.h"
#include "output/encode.h"
#include "terms/names.h"

#define SIDE_WIDTH 326.0
#define SIDE_HEIGHT 250.0
#define ROSE_SIZE 270.0
#define NET_SIZE 300.0
#define SKETCH_HEIGHT 190.0
#define HEAD_ROOM (1.5 * TP_HEAD_SIZE)

/* ---- what is said ------------------------------------------------------------------------------
 */

/* Nothing on a sheet, which has it already. */
static bool say(double *y, cairo_t *cr, const tp_solid_figure *f) {
  const tp_solid *solid = f->solid;
  tp_text title = {0}, verdict = {0};
  if (f->sketch) return true;
  tp_encode_plain(&title, solid->title != NULL ? solid->title : solid->file);
  tp_text_solid_answer(&verdict, solid);
  const bool done = !title.failed && !verdict.failed;
  if (done) {
    const double x = TP_FIGURE_MARGIN, width = TP_SOLID_PAGE_ROOM;
    tp_figure_ink(cr, TP_INK_BLACK);
    *y = tp_figure_paragraph(cr, x, *y, width, TP_TITLE_SIZE, true, title.data) + 2;
    *y = tp_figure_paragraph(cr, x, *y, width, TP_BODY_SIZE, false, verdict.data) + 4;
  }
  tp_text_drop(&title);
  tp_text_drop(&verdict);
  return done;
}

/* Over a part of the page. */
static void head(cairo_t *cr, const tp_solid_figure *f, tp_box part, const char *text) {
  char said[TP_LINE_SIZE];
  tp_figure_font(cr, TP_HEAD_SIZE, true);
  tp_figure_ink(cr, TP_INK_BLACK);
  tp_figure_text(cr, part.x0, part.y0 - HEAD_ROOM + TP_HEAD_SIZE, tp_solid_say(f, said, text));
}

/* What is drawn, in words; a sheet has them as its caption. */
static double explain(cairo_t *cr, const tp_solid_figure *f, double x, double y, double width,
                      const char *text) {
  if (f->sketch) return y;
  tp_figure_ink(cr, TP_INK_GREY);
  return tp_figure_paragraph(cr, x, y, width, TP_SMALL_SIZE, false, text) + 3;
}

/* How much of it is drawn. */
static double explain_ground(cairo_t *cr, const tp_solid_figure *f, double x, double y,
                             double width) {
  if (f->ground.triangle_count == 0) return y;
  return explain(cr, f, x, y, width,
                 f->side.is_cut || f->above.is_cut
                     ? "In the colour of sand: the ground near the rock, of a mesh that is larger; "
                       "where ground hides the rock, the rock shows through."
                     : "In the colour of sand: the ground, all of its mesh; where it hides the "
                       "rock, the rock shows through.");
}

static void say_below(cairo_t *cr, const tp_solid_figure *f, double x, double y, double width) {
  if (f->band == NULL) {
    y = tp_solid_draw_contacts(cr, f, x, y, width) + 6;
    y = explain(
        cr, f, x, y, width,
        "The rock at its tilt, which goes to the right. Dots: its contacts, hollow where the "
        "rock hides them; blue: their normals into the rock; green: forces of the ground "
        "that hold it, and black, from the centroid, the load that they bear; purple: the "
        "axis about which it turns as it begins to move, or the way in which it slides.");
    y = explain_ground(cr, f, x, y, width);
    explain(cr, f, x, y, width,
            "How far from the middle the line lies in an azimuth is the tilt up to which forces "
            "hold the rock that way; where there is none, they do at any.");
    return;
  }
  y = tp_solid_draw_bands(cr, f, x, y, width) + 6;
  y = explain(
      cr, f, x, y, width,
      f->solid->has_below
          ? "What of the rock lies above the plane that cuts it, at its tilt, which goes to "
            "the right; what lies below is ground. Red: the hull of the section, and the "
            "edge about which it would topple this way; the arrow: its weight, from the "
            "centroid to the section."
          : "The rock at its tilt, which goes to the right. Red: what touches in the least "
            "band, and the edge about which it would topple this way; the arrow: its "
            "weight, from the centroid to the base.");
  explain(
      cr, f, x, y, width,
      f->solid->has_below
          ? "The rose: how far from the middle a line lies in an azimuth is the tilt at which the "
            "rock topples that way."
          : "The rose: how far from the middle a line lies in an azimuth is the tilt at which the "
            "rock topples that way. All that is no higher than the band over its lowest point is "
            "taken to touch.");
}

/* ---- where it lies -----------------------------------------------------------------------------
 */

static double draw_wedge(cairo_t *cr, const tp_solid_figure *f, double y) {
  const double left = TP_FIGURE_MARGIN, right = left + TP_SOLID_PAGE_ROOM;
  const double top = y + HEAD_ROOM, low = top + NET_SIZE;
  const tp_box wedge = {left, top, right - NET_SIZE - 10, low},
               net = {right - NET_SIZE, top, right, low};
  head(cr, f, wedge, "The wedge, from its face");
  head(cr, f, net, "Its planes in the lower hemisphere, equal-angle");
  tp_solid_draw_wedge(cr, f, wedge);
  tp_solid_draw_stereonet(cr, f, net);
  y = explain(
      cr, f, left, low + 4, TP_SOLID_PAGE_ROOM,
      "Great circles: joints, face and ground. Circles about the poles of the joints: their cones "
      "of friction. R: the resultant of weight and all other loads; I: the line of both joints. "
      "With friction alone it slides along that line where R is beyond the thick line between the "
      "cones; cohesion holds more.");
  if (f->solid->wedge.bolt_count == 0) return y;
  return explain(
      cr, f, left, y, TP_SOLID_PAGE_ROOM,
      "Red points with a force: pulls of bolts, which are part of R; hollow where a bolt "
      "pulls upwards, at the opposite direction.");
}

/* Where the parts of a rock lie: on a sheet beside one another, so that they are not made small. */
typedef struct parts {
  tp_box side, above, rose;
} parts;

static parts place_parts(const tp_solid_figure *f, double y) {
  const double left = TP_FIGURE_MARGIN, right = left + TP_SOLID_PAGE_ROOM, top = y + HEAD_ROOM;
  if (f->sketch) {
    const double low = top + SKETCH_HEIGHT;
    return (parts){{left, top, left + 196, low},
                   {left + 202, top, left + 362, low},
                   {left + 368, top, right, low}};
  }
  const double middle = left + SIDE_WIDTH, low = top + SIDE_HEIGHT, below = low + 6 + HEAD_ROOM;
  return (parts){{left, top, middle, low},
                 {middle + 10, top, right, low},
                 {left, below, left + ROSE_SIZE, below + ROSE_SIZE}};
}

static double draw_rock(cairo_t *cr, const tp_solid_figure *f, double y) {
  const parts at = place_parts(f, y);
  const bool held = f->band == NULL;
  const bool cut = f->solid->has_below;
  head(cr, f, at.side, held ? "On its contacts" : cut ? "On its section" : "On its base");
  head(cr, f, at.above,
       held  ? "Its contacts, from above"
       : cut ? "The section, from above"
             : "What touches, from above");
  head(cr, f, at.rose,
       held ? "Tilt that forces hold, by azimuth" : "Tilt at which it topples, by azimuth");
  if (held) {
    tp_solid_draw_held(cr, f, at.side);
    tp_solid_draw_held_above(cr, f, at.above);
  } else {
    tp_solid_draw_side(cr, f, at.side);
    tp_solid_draw_above(cr, f, at.above);
  }
  tp_solid_draw_rose(cr, f, at.rose);
  if (f->sketch) return held ? at.rose.y1 : tp_solid_draw_key(cr, f, at.side.x0, at.rose.y1 + 4);
  say_below(cr, f, at.rose.x1 + 14, at.rose.y0 + 24, TP_SOLID_PAGE_ROOM - ROSE_SIZE - 14);
  return at.rose.y1;
}

bool tp_solid_page(double *height, cairo_t *cr, const tp_solid_figure *f) {
  double y = TP_FIGURE_MARGIN;
  if (!say(&y, cr, f)) return false;
  *height = (f->solid->has_wedge ? draw_wedge(cr, f, y) : draw_rock(cr, f, y)) + TP_FIGURE_MARGIN;
  return true;
}
