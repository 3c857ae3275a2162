/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Means of force, energy and displacement over windows, and the counters of growing, drifting and
 * quiet windows that decide. */

#include "contact_springs/watch.h"

#include <math.h>

enum { WINDOWS = 16, GROWING_WINDOWS = 16, RESTING_WINDOWS = 4, DRIFTING_TIMES = 2 };

/* Shares of the weight, and of the weight times the extent. */
static const double no_force = 1e-7, no_energy = 1e-14;

/* Of the force of the window before along its direction: a force that keeps so much has neither
 * fallen nor turned. */
static const double kept_force = 0.8;

/* By so much at least kinetic energy grows in each window: far less than by a steady force from
 * rest, so that what slides already counts. */
static const double growth = 1 + 1e-4;

/* What moves on keeps so much of its displacement. */
static const double kept_drift = 0.95;

/* No motion for good is slower: of the extent in sqrt(extent / g), and of what the springs give for
 * each radian of tilt, which near the limit is a thousand times what they do on level ground. */
static const double least_speed = 1e-7, least_gives = 1e4;

/* What collapses began when it last had so much of the kinetic energy that it has when that is
 * sure, by decades; no farther back than so many windows. */
static const double at_begin = 1e-4;
enum { FARTHEST_BACK = 8 * WINDOWS };

static tp_drift place_of(const tp_stepper *s) {
  return (tp_drift){s->state.moved.x, s->state.moved.y, s->state.turned * s->body->extent_m};
}

/* All contacts of the start sheared by the weight. */
static double give(const tp_stepper *s) {
  double area = s->contacts.least_area_m2;
  for (long k = 0; k < s->body->closed_count; k++) {
    area += s->body->closed[k].share_m * s->body->thickness_m;
  }
  return s->body->mass_kg * TP_GRAVITY_M_S2 / (area * s->contacts.shear_pa_m);
}

void tp_spring_watch_init(tp_spring_watch *w, const tp_stepper *s) {
  const tp_rigid_body *body = s->body;
  *w = (tp_spring_watch){.weight_n = body->mass_kg * TP_GRAVITY_M_S2,
                         .extent_m = body->extent_m,
                         .window_s = sqrt(body->extent_m / TP_GRAVITY_M_S2) / WINDOWS,
                         .from = place_of(s),
                         .give_m = give(s)};
  w->window_end_s = s->time_s + w->window_s;
}

static double slowest(const tp_spring_watch *w, const tp_stepper *s) {
  const double before = tp_drive_angle(s->drive, s->time_s - w->window_s);
  const double rate = fabs(tp_drive_angle(s->drive, s->time_s) - before) / w->window_s;
  const double of_extent = least_speed * sqrt(w->extent_m * TP_GRAVITY_M_S2);
  return fmax(of_extent, least_gives * w->give_m * rate);
}

/* After sixteen windows: did it move on as in the sixteen before? */
static void judge_drift(tp_spring_watch *w, const tp_stepper *s) {
  const tp_drift at = place_of(s), last = w->last_drift;
  const tp_drift now = {at.x - w->from.x, at.y - w->from.y, at.turned - w->from.turned};
  const double least = slowest(w, s) * WINDOWS * w->window_s;
  const double along = now.x * last.x + now.y * last.y + now.turned * last.turned;
  const double square = last.x * last.x + last.y * last.y + last.turned * last.turned;
  const bool moves_on = square > least * least && along >= kept_drift * square;
  w->drifting = moves_on ? w->drifting + 1 : 0;
  w->from = at;
  w->last_drift = now;
}

static double product(tp_body_force f, tp_body_force g) {
  return f.x_n * g.x_n + f.y_n * g.y_n + f.moment_nm * g.moment_nm;
}

static void note_speed(tp_spring_watch *w, double kinetic, double time_s) {
  double decade = 1;
  for (int k = 0; k < TP_WATCH_DECADES; k++, decade /= 10) {
    if (kinetic < decade) w->slower_until_s[k] = time_s;
  }
}

/* Under strong damping what slides may chatter, and is sure to go on only long after it began. */
static double begin_of(const tp_spring_watch *w, double time_s, long windows) {
  const double told = time_s - (double)windows * w->window_s;
  const double level = ceil(-log10(at_begin * w->last_kinetic));
  if (!(level >= 0 && level < TP_WATCH_DECADES)) return told;
  const double slow = w->slower_until_s[(int)level];
  return slow < told && slow > time_s - FARTHEST_BACK * w->window_s ? slow : told;
}

static tp_spring_watch_news judge(tp_spring_watch *w, tp_body_force force, double kinetic,
                                  const tp_stepper *stepper) {
  const double size = sqrt(product(force, force));
  const bool kept =
      product(force, w->last_force) >= kept_force * product(w->last_force, w->last_force);
  const bool grows = size > no_force && kept && kinetic > growth * w->last_kinetic;
  const bool none = size < no_force && kinetic < no_energy;
  w->growing = grows ? w->growing + 1 : 0;
  w->resting = none ? w->resting + 1 : 0;
  w->last_force = force;
  w->last_kinetic = kinetic;
  note_speed(w, kinetic, stepper->time_s);
  if (++w->windows % WINDOWS == 0) judge_drift(w, stepper);
  if (stepper->drive->shaking != NULL && !stepper->steady) return TP_WATCH_NOTHING;
  if (w->resting >= RESTING_WINDOWS) return TP_WATCH_QUIET;
  const double speed = slowest(w, stepper);
  const bool fast = kinetic > speed * speed / (2 * TP_GRAVITY_M_S2 * w->extent_m);
  const bool grew = w->growing >= GROWING_WINDOWS && fast;
  if (!grew && w->drifting < DRIFTING_TIMES) return TP_WATCH_NOTHING;
  w->begun_s =
      begin_of(w, stepper->time_s, grew ? w->growing : (long)(DRIFTING_TIMES + 1) * WINDOWS);
  return TP_WATCH_COLLAPSES;
}

tp_spring_watch_news tp_spring_watch_step(tp_spring_watch *w, const tp_stepper *s) {
  tp_spring_watch_window *own = &w->window;
  own->steps++;
  own->x_n += s->net.x_n;
  own->y_n += s->net.y_n;
  own->moment_nm += s->net.moment_nm;
  own->kinetic += s->energies.kinetic;
  if (s->time_s < w->window_end_s) return TP_WATCH_NOTHING;
  const double all = (double)own->steps * w->weight_n;
  const tp_body_force force = {own->x_n / all, own->y_n / all,
                               own->moment_nm / (all * w->extent_m)};
  const double kinetic = fabs(own->kinetic) / (all * w->extent_m);
  *own = (tp_spring_watch_window){0};
  w->window_end_s += w->window_s;
  return judge(w, force, kinetic, s);
}
