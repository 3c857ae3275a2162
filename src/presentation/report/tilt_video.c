/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A script for gnuplot that draws one frame after the other: outline and base are told once, and a
 * frame turns and moves them. At most some 340 frames of 960 by 720 dots; of an outline, points
 * that no eye tells apart are left out, so that neither depends on what the scene holds. */

#include "report/tilt_video.h"

#include "chart/gnuplot.h"
#include "common/message.h"
#include "output/encode.h"
#include "report/tilt_course.h"
#include "report/words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Dots; the head has the title and a line for each direction. */
static const double most_wide = 960, most_high = 660, most_scale = 1.5, head = 44;
static const double finest = 0.25;
static const double still = 0.1; /* the share of the time for which it stands still at its end */

typedef struct panel {
  tp_tilt_view view;
  tp_tilt_course course;
  double left; /* of the frame, dots */
  size_t next; /* moment behind the last one shown */
} panel;

typedef struct film {
  const tp_tilt_test *test;
  size_t count;
  panel *panels;
  double scale, width, height; /* dots a unit of the views; of a frame, even */
  double seconds, rate;
} film;

/* ---- the frame ---------------------------------------------------------------------------------
 */

static double even(double dots) {
  return 2 * ceil(dots / 2);
}

static void lay_out(film *f) {
  double width = 0, height = 0;
  for (size_t k = 0; k < f->count; k++) {
    panel *p = f->panels + k;
    p->view = tp_tilt_view_of(f->test->cases + k);
    p->course = tp_tilt_course_of(&p->view, f->test->settings.engine != TP_TILT_PATH);
    f->seconds = fmax(f->seconds, p->course.seconds);
    width += p->view.width;
    height = fmax(height, p->view.height);
  }
  f->scale = fmin(most_scale, fmin(most_wide / width, most_high / height));
  double left = 0;
  for (size_t k = 0; k < f->count; k++) {
    f->panels[k].left = left;
    left += f->scale * f->panels[k].view.width;
  }
  f->width = even(left);
  f->height = even(f->scale * height + head);
}

/* A turn and a displacement, in dots. */
typedef struct placing {
  double cosine, sine, x, y;
} placing;

/* From units of the view, y up, to the frame: the table turns about where the block began. */
static placing of_table(const film *f, const panel *p, const tp_tilt_moment *m) {
  const double turn = -tp_tilt_view_turn(&p->view, m->angle_deg) * (M_PI / 180);
  return (placing){f->scale * cos(turn), f->scale * sin(turn), p->left - f->scale * p->view.left,
                   f->scale * (p->view.top + p->view.height)};
}

static placing of_block(const film *f, const panel *p, const tp_tilt_moment *m) {
  const placing table = of_table(f, p, m);
  const double turned = m->turned_deg * (M_PI / 180), c = cos(turned), s = sin(turned);
  const double x = p->view.scale * m->moved_x_m, y = p->view.scale * m->moved_y_m;
  return (placing){table.cosine * c - table.sine * s, table.sine * c + table.cosine * s,
                   table.x + table.cosine * x - table.sine * y,
                   table.y + table.sine * x + table.cosine * y};
}

/* ---- moments -----------------------------------------------------------------------------------
 */

static double between(double from, double to, double share) {
  return from + share * (to - from);
}

/* The block at a time of the film, on the straight line between two moments. */
static tp_tilt_moment moment_at(panel *p, double seconds) {
  const tp_tilt_case *own = p->view.own;
  const tp_tilt_course *c = &p->course;
  if (own->moment_count == 0) return (tp_tilt_moment){.time_s = 0};
  const double at = between(c->from, c->to, fmin(1, seconds / c->seconds));
  while (p->next < own->moment_count && tp_tilt_course_at(c, own->moments + p->next) <= at) {
    p->next++;
  }
  if (p->next == 0) return own->moments[0];
  const tp_tilt_moment *a = own->moments + p->next - 1;
  if (p->next == own->moment_count) return *a;
  const tp_tilt_moment *b = own->moments + p->next;
  const double from = tp_tilt_course_at(c, a);
  const double share = (at - from) / (tp_tilt_course_at(c, b) - from);
  return (tp_tilt_moment){.time_s = between(a->time_s, b->time_s, share),
                          .angle_deg = between(a->angle_deg, b->angle_deg, share),
                          .moved_x_m = between(a->moved_x_m, b->moved_x_m, share),
                          .moved_y_m = between(a->moved_y_m, b->moved_y_m, share),
                          .turned_deg = between(a->turned_deg, b->turned_deg, share)};
}

/* ---- the script --------------------------------------------------------------------------------
 */

static void add_ring(tp_text *t, const film *f, const panel *p, const char *name, size_t number,
                     const tp_tilt_point *points, size_t count) {
  static const double far = 1e4; /* units: a base may reach beyond what is seen */
  double last_x = INFINITY, last_y = INFINITY;
  tp_text_add(t, "$%s%zu << E\n", name, number);
  for (size_t k = 0; k <= count && count > 0; k++) { /* the first closes it */
    const tp_tilt_point *point = points + k % count;
    const double x = fmin(far, fmax(-far, tp_tilt_view_x(&p->view, point->x_m)));
    const double y = fmin(far, fmax(-far, -tp_tilt_view_y(&p->view, point->y_m)));
    if (k > 0 && k < count && f->scale * hypot(x - last_x, y - last_y) < finest) continue;
    tp_text_add(t, "%.3f %.3f\n", x, y);
    last_x = x;
    last_y = y;
  }
  tp_text_add(t, "E\n");
}

static void add_head(tp_text *t, const film *f) {
  tp_text_add(t,
              "set encoding utf8\nset terminal pngcairo size %.0f,%.0f font 'Arial,10' "
              "background rgb 'white'\n",
              f->width, f->height);
  tp_text_add(t,
              "unset border\nunset tics\nunset key\nset lmargin 0\nset rmargin 0\nset tmargin "
              "0\nset bmargin 0\nset xrange [0:%.0f]\nset yrange [0:%.0f]\n",
              f->width, f->height);
  if (f->test->title != NULL) {
    tp_text_add(t, "set label 1 ");
    tp_encode_gnuplot(t, f->test->title);
    tp_text_add(t, " at 8,%.0f left noenhanced front\n", f->height - 12);
  }
  for (size_t k = 0; k < f->count; k++) {
    const panel *p = f->panels + k;
    add_ring(t, f, p, "base", k, p->view.own->base, p->view.own->base_count);
    add_ring(t, f, p, "block", k, p->view.own->outline, p->view.own->outline_count);
  }
}

static void add_shape(tp_text *t, const char *name, size_t number, placing at, const char *fill,
                      const char *edge) {
  tp_text_add(t,
              "$%s%zu using (%.6f*$1-%.6f*$2+%.3f):(%.6f*$1+%.6f*$2+%.3f) with filledcurves closed "
              "fc rgb '%s' fs solid border lc rgb '%s'",
              name, number, at.cosine, at.sine, at.x, at.sine, at.cosine, at.y, fill, edge);
}

static void add_caption(tp_text *t, const film *f, size_t number, const tp_tilt_moment *m) {
  const panel *p = f->panels + number;
  tp_text_add(t, "set label %zu '%s: %s; tilt %.2f°", number + 2,
              tp_text_table(f->test, p->view.own), tp_tilt_end_name(p->view.own->end),
              m->angle_deg);
  if (p->course.timed) tp_text_add(t, ", %.2f s", m->time_s);
  tp_text_add(t, "' at %.0f,%.0f left noenhanced front\n", p->left + 8, f->height - 30);
}

/* A block that is far away is left where it was seen last. */
static void add_frame(tp_text *t, const film *f, double seconds) {
  tp_text text = {0};
  for (size_t k = 0; k < f->count; k++) {
    panel *p = f->panels + k;
    tp_tilt_moment m = moment_at(p, seconds);
    add_caption(t, f, k, &m);
    tp_text_add(&text, k == 0 ? "plot " : ", ");
    add_shape(&text, "base", k, of_table(f, p, &m), "#d8d0c4", "#5b5346");
    tp_text_add(&text, ", ");
    add_shape(&text, "block", k, of_block(f, p, &m), "#7aa6c2", "#1d3b4d");
  }
  char *plot = NULL;
  if (tp_text_finish(&text, &plot) == TP_OK) tp_text_add(t, "%s\n", plot);
  t->failed = t->failed || plot == NULL;
  free(plot);
}

static tp_status write_script(char **script, const film *f) {
  tp_text t = {0};
  add_head(&t, f);
  const long count = lround(ceil(f->seconds / (1 - still) * f->rate));
  for (long k = 0; k < count; k++) add_frame(&t, f, (double)k / f->rate);
  return tp_text_finish(&t, script);
}

static tp_status make(char **video, size_t *length, const film *f, tp_video_format format,
                      tp_message *message) {
  char *script = NULL, *frames = NULL;
  size_t frames_length = 0;
  if (write_script(&script, f) != TP_OK) return tp_fail_memory(message, "the frames");
  tp_status status = tp_gnuplot_run(&frames, &frames_length, script, message);
  free(script);
  if (status == TP_OK)
    status = tp_ffmpeg_run(video, length, frames, frames_length, format, message);
  free(frames);
  return status;
}

tp_status tp_tilt_video(char **video, size_t *length, const tp_tilt_test *test,
                        tp_video_format format, tp_message *message) {
  film f = {.test = test, .count = test->case_count, .rate = tp_video_rate(format)};
  if (f.count == 0) {
    return tp_fail(message, TP_NO_ANSWER, (tp_place){0}, "the test has nothing to draw");
  }
  f.panels = calloc(f.count, sizeof *f.panels);
  if (f.panels == NULL) return tp_fail_memory(message, "the frames");
  lay_out(&f);
  const tp_status status = make(video, length, &f, format, message);
  free(f.panels);
  return status;
}
