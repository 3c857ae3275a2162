/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How many blocks begin to move, as an SVG that moves, over and over, by declarative animation that
 * needs no script: the motion that is proven to be possible, and the collapse beside it.
 *
 * It is one instant drawn larger. With s the way of the fastest corner each block is displaced by
 * s v and turned by s omega about its centroid, as a rigid body; s grows as the square of time
 * where v are accelerations from rest, evenly where they are velocities of a mechanism, up to a
 * share of the size of all. What comes after that instant, contacts that open or close, is not
 * computed, and the drawing says so. */

#include "block_system/governing_case.h"
#include "common/host.h"
#include "common/message.h"
#include "report/kept_file.h"
#include "report/system_moving.h"
#include "report/system_words.h"
#include "report/tilt_svg.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* Of the motion; seconds, and between which shares of them all moves. */
enum { STEPS = 12 };
static const double seconds_of_all = 3, begins = 0.1, ends = 0.8;

/* ---- drawn -------------------------------------------------------------------------------------
 */

/* The ground goes on far beyond what is seen: numbers of a drawing are short. */
static double clamp_far(double value) {
  const double far = 1e5;
  return fmin(far, fmax(-far, value));
}

static void add_path(tp_text *t, const tp_moving_view *m, const tp_chain *chain,
                     const char *style) {
  tp_text_add(t, "<path %s fill-rule=\"evenodd\" d=\"", style);
  for (size_t k = 0; k < chain->count; k++) {
    const bool jumps = chain->nodes[k].step == TP_STEP_JUMP;
    const tp_spot at = tp_moving_on_page(m, chain->nodes[k].at);
    if (jumps && k > 0) tp_text_add(t, "Z");
    tp_text_add(t, "%s%.2f %.2f", jumps ? "M" : "L", clamp_far(at.x), clamp_far(at.y));
  }
  tp_text_add(t, "Z\"/>\n");
}

static const char *style_of(const tp_moving_view *m, size_t block) {
  if (!tp_moving_moves(m, block)) return "fill=\"#d6ecf9\" stroke=\"#55555c\"";
  switch (m->motions[block].mechanism) {
  case TP_SLIDES:
    return "fill=\"#fbe6ad\" stroke=\"#55555c\"";
  case TP_TOPPLES:
    return "fill=\"#f2b894\" stroke=\"#55555c\"";
  default:
    return "fill=\"#cca8cc\" stroke=\"#55555c\"";
  }
}

/* Share k of STEPS of the way. */
static double way(const tp_moving_view *m, int k) {
  const double share = (double)k / STEPS;
  return m->is_start ? share * share : share;
}

static void add_times(tp_text *t) {
  tp_text_add(t, "\" dur=\"%gs\" repeatCount=\"indefinite\" keyTimes=\"0", seconds_of_all);
  for (int k = 0; k <= STEPS; k++) {
    tp_text_add(t, ";%.4f", begins + (ends - begins) * k / STEPS);
  }
  tp_text_add(t, ";1\"/>\n");
}

/* Of values from rest over STEPS, with a rest before and after. */
static void add_animated(tp_text *t, const tp_moving_view *m, bool turns, double x, double y,
                         tp_spot at) {
  tp_text_add(t, "<animateTransform attributeName=\"transform\" type=\"%s\" values=\"",
              turns ? "rotate" : "translate");
  for (int k = -1; k <= STEPS + 1; k++) {
    const double share = way(m, k < 0 ? 0 : k > STEPS ? STEPS : k);
    if (k >= 0) tp_text_add(t, ";");
    if (turns) {
      tp_text_add(t, "%.4f %.3f %.3f", share * x, at.x, at.y);
    } else {
      tp_text_add(t, "%.3f %.3f", share * x, share * y);
    }
  }
  add_times(t);
}

static void add_block(tp_text *t, const tp_moving_view *m, size_t block) {
  const double degrees = 45 / atan(1);
  const tp_block_shape *shape = m->shapes->blocks + block;
  tp_text_add(t, "<g>\n");
  if (tp_moving_moves(m, block)) {
    const tp_system_motion *own = m->motions + block;
    const tp_spot v = tp_moving_turned(m, (tp_spot){own->velocity_x, own->velocity_y});
    const double scale = TP_MOVING_SIZE * m->moved;
    add_animated(t, m, false, scale * v.x, -scale * v.y, (tp_spot){0, 0});
    tp_text_add(t, "<g>\n");
    if (own->turn_per_m != 0) {
      add_animated(t, m, true, -tp_moving_turn(m, block) * degrees, 0,
                   tp_moving_on_page(m, shape->centroid));
    }
  }
  add_path(t, m, &shape->outline, style_of(m, block));
  tp_text_add(t, tp_moving_moves(m, block) ? "</g>\n</g>\n" : "</g>\n");
}

static void add_heading(tp_text *t, const tp_moving_view *m) {
  tp_text_add(t, "<text x=\"%.2f\" y=\"20\" font-weight=\"bold\">", m->left + 8);
  tp_text_system_stance(t, m->system, m->own);
  tp_text_add(t, "</text>\n<text x=\"%.2f\" y=\"36\">", m->left + 8);
  if (!m->is_start) {
    tp_text_add(t, "Collapse %s", tp_text_system_collapse(m->system, m->own));
  } else if (m->own->start.divisor == 1) {
    tp_text_add(t, "A motion that can begin as they lie, proven");
  } else {
    tp_text_add(t, "A motion that can begin with strength divided by %.5g, proven",
                m->own->start.divisor);
  }
  tp_text_add(t, "</text>\n<text x=\"%.2f\" y=\"52\" fill=\"#55555c\">", m->left + 8);
  tp_text_add(t, "%s at its beginning, the fastest corner drawn %.3g m away",
              m->is_start ? "accelerations" : "velocities", m->moved * m->shapes->unit_m);
  tp_text_add(t, "</text>\n");
}

static void add_panel(tp_text *t, const tp_moving_view *m) {
  enum { TOP = TP_MOVING_HEAD - TP_MOVING_MARGIN / 2 };
  add_heading(t, m);
  tp_text_add(t,
              "<svg x=\"%.2f\" y=\"%d\" width=\"%.2f\" height=\"%.2f\" viewBox=\"%.2f %d %.2f "
              "%.2f\">\n",
              m->left, TOP, tp_moving_width(m), tp_moving_height(m) - TOP, m->left, TOP,
              tp_moving_width(m), tp_moving_height(m) - TOP);
  for (size_t k = 0; k < m->shapes->count; k++) {
    if (m->system->blocks[k].ground) {
      add_path(t, m, &m->shapes->blocks[k].outline, "fill=\"#e3e0db\" stroke=\"#55555c\"");
    }
  }
  for (size_t k = 0; k < m->shapes->count; k++) {
    if (!m->system->blocks[k].ground) add_block(t, m, k);
  }
  tp_text_add(t, "</svg>\n");
}

/* The tints, which are those of the figure (figure/view.c). */
static void add_foot(tp_text *t, double y) {
  static const struct {
    const char *words, *tint;
    int x;
  } tints[] = {{"slides", "#fbe6ad", 8},
               {"topples", "#f2b894", 72},
               {"slides and topples", "#cca8cc", 144},
               {"at rest", "#d6ecf9", 276}};
  for (size_t k = 0; k < sizeof tints / sizeof tints[0]; k++) {
    tp_text_add(t,
                "<rect x=\"%d\" y=\"%.2f\" width=\"10\" height=\"10\" fill=\"%s\" "
                "stroke=\"#55555c\"/>\n<text x=\"%d\" y=\"%.2f\">%s</text>\n",
                tints[k].x, y + 3, tints[k].tint, tints[k].x + 15, y + 12, tints[k].words);
  }
  tp_text_add(t,
              "<text x=\"8\" y=\"%.2f\" fill=\"#55555c\">One instant drawn larger, not a "
              "simulation of what follows.</text>\n",
              y + 30);
}

/* ---- the whole ---------------------------------------------------------------------------------
 */

static void write_panels(tp_text *t, tp_moving_view *panels, size_t count) {
  enum { LEAST_WIDTH = 420, FOOT = 40 };
  double width = 0, height = 0;
  for (size_t k = 0; k < count; k++) {
    tp_moving_set_up(panels + k);
    panels[k].left = width;
    width += fmax(tp_moving_width(panels + k), LEAST_WIDTH);
    height = fmax(height, tp_moving_height(panels + k));
  }
  tp_tilt_svg_begin(t, width, height + FOOT);
  for (size_t k = 0; k < count; k++) add_panel(t, panels + k);
  add_foot(t, height);
  tp_text_add(t, "</svg>\n");
}

static tp_status draw_moving(tp_text *t, const tp_block_shapes *shapes,
                             const tp_block_system *system, tp_message *message) {
  const tp_system_case *own = tp_system_governing(system);
  tp_moving_view panels[2];
  size_t count = 0;
  const bool collapses_first = own->fos.state == TP_FOS_NUMBER && !own->fos_is_least &&
                               own->start.divisor > fmax(1, own->fos.value.value);
  if (own->has_start && !collapses_first) {
    panels[count++] = (tp_moving_view){.system = system,
                                       .own = own,
                                       .shapes = shapes,
                                       .motions = own->start.motions,
                                       .is_start = true};
  }
  if (own->motion_count > 0) {
    panels[count++] =
        (tp_moving_view){.system = system, .own = own, .shapes = shapes, .motions = own->motions};
  }
  if (count == 0) {
    return tp_fail(message, TP_NO_ANSWER, (tp_place){0},
                   "no motion of the blocks is known, so there is none to draw: they are held at "
                   "every strength and tilt that was tried");
  }
  write_panels(t, panels, count);
  return t->failed ? tp_fail_memory(message, "the drawing") : TP_OK;
}

tp_status tp_report_block_system_animation(char **text, const tp_scene *scene,
                                           const tp_block_system *system, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, text);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, system);
  tp_block_shapes shapes;
  tp_status status = tp_block_shapes_init(&shapes, scene, system, message);
  if (status != TP_OK) return status;
  tp_text t = {0};
  status = draw_moving(&t, &shapes, system, message);
  tp_block_shapes_clear(&shapes);
  if (status == TP_OK) return tp_text_finish(&t, text);
  tp_text_drop(&t);
  return status;
}

tp_status tp_report_block_system_animation_file(const char *path, const tp_scene *scene,
                                                const tp_block_system *system,
                                                tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, path);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, system);
  const char *ending = strrchr(path, '.');
  if (ending == NULL || strcasecmp(ending, ".svg") != 0) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){path, 0, 0},
                     "a drawing of many blocks that moves is SVG: give a name that ends in .svg");
  }
  char *text = NULL;
  tp_status status = tp_report_block_system_animation(&text, scene, system, message);
  if (status == TP_OK) {
    status = tp_report_keep_file(scene, path, text, strlen(text), "the drawing", message);
  }
  free(text);
  return status;
}
