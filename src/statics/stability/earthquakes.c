/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Combinations of horizontal direction and vertical part as separate scenes, ordered by mechanism
 * and governing factor of safety; the least safe one is the solution (pseudo-static method,
 * docs/mechanics.md section 5). */

#include "stability/earthquakes.h"

#include "common/notes.h"
#include "stability/governing.h"

#include <string.h>

static bool shakes(const tp_scene *scene) {
  return scene->loads.horizontal.given && !fmpq_is_zero(scene->loads.horizontal.value);
}

tp_status tp_earthquakes_asked(bool *several, const tp_scene *scene, tp_message *message) {
  const tp_loads_description *loads = &scene->loads;
  *several = false;
  if (!tp_scene_lies_in_place(scene)) {
    if (!loads->direction_given || loads->direction == TP_SEISMIC_DOWN_DIP) return TP_OK;
    return tp_refuse(
        message, TP_FAULT_KEY, loads->seismic_place,
        "an earthquake is considered both ways, or up-dip, where the block lies on a "
        "slope, 'frame: world'; on a table 'horizontal' acts towards the side that the "
        "tilt lowers, and a negative one against it");
  }
  const bool vertical = loads->vertical.given && !fmpq_is_zero(loads->vertical.value);
  *several =
      shakes(scene) && (!loads->direction_given || loads->direction == TP_SEISMIC_BOTH || vertical);
  return TP_OK;
}

bool tp_earthquake_is_one_sided(const tp_scene *scene) {
  return !tp_scene_lies_in_place(scene) && shakes(scene) &&
         fmpq_sgn(scene->loads.horizontal.value) > 0 && !scene->loads.direction_given &&
         scene->towards_left != scene->towards_right;
}

/* The scene under one of them, sharing all else. */
static void shake(tp_scene *shaken, const tp_scene *scene, bool up_dip, bool vertical) {
  *shaken = *scene;
  shaken->loads.direction_given = true;
  shaken->loads.direction = up_dip ? TP_SEISMIC_UP_DIP : TP_SEISMIC_DOWN_DIP;
  if (vertical) return;
  fmpq_init(shaken->loads.vertical.value); /* zero, which owns nothing */
  shaken->loads.vertical.given = false;
}

void tp_earthquake_scene(tp_scene *shaken, const tp_scene *scene, const tp_solution *solution) {
  const tp_earthquake *governs = solution->earthquakes;
  *shaken = *scene;
  if (solution->earthquake_count > 0) shake(shaken, scene, governs->up_dip, governs->vertical);
}

tp_status tp_earthquake_note_water(tp_notes *notes, const tp_water_description *water,
                                   tp_message *message) {
  return tp_notes_add(
      notes, message, TP_NOTE, water->place,
      "under the earthquake up-dip the push of the water, which holds the block back, is "
      "neglected%s: "
      "conservative at any level up to the one given where the block slides or turns about the "
      "upper "
      "end of its contact; where its push is certain, give it as 'pressures' on the edges that it "
      "wets",
      water->uplift ? ", and only its uplift acts" : "");
}

/* ---- which is worse ----------------------------------------------------------------------------
 */

/* An earthquake with its state. */
typedef struct shaken_state {
  tp_earthquake earthquake;
  tp_safety safety;
} shaken_state;

/* Of a block that fails against the shaking, as it does under that in the other direction, which
 * drives it, the factor is no measure. */
static bool is_worse(const shaken_state *one, const shaken_state *than) {
  const bool against = one->earthquake.fails_against;
  if (one->safety.verdict == than->safety.verdict && against != than->earthquake.fails_against) {
    return !against;
  }
  return tp_safety_compare(&one->safety, &than->safety) < 0;
}

/* The worst of its cases. */
static shaken_state result_of(const tp_solution *solution, bool up_dip, bool vertical) {
  shaken_state worst = {.safety = {.least = 0}};
  for (size_t k = 0; k < solution->case_count; k++) {
    const tp_case *c = solution->cases + k;
    tp_fos fos = c->governing_fos.fos;
    fos.value.digits = NULL; /* of the solution, which may go before the others */
    const shaken_state state = {
        {c->towards, up_dip, vertical, c->mechanism, fos, c->governing_fos.up_dip},
        tp_case_safety(c)};
    if (k == 0 || is_worse(&state, &worst)) worst = state;
  }
  return worst;
}

/* ---- all of them -------------------------------------------------------------------------------
 */

typedef struct looking {
  tp_solution *governs; /* NULL: none yet */
  size_t count;
  shaken_state all[TP_EARTHQUAKES_MAX]; /* the one that governs first */
} looking;

/* Take a solution over, or give it back. */
static void take(looking *l, tp_solution *solution, bool up_dip, bool vertical) {
  const shaken_state own = result_of(solution, up_dip, vertical);
  if (l->count == 0 || is_worse(&own, l->all)) {
    memmove(l->all + 1, l->all, l->count * sizeof own);
    l->all[0] = own;
    tp_solution_free(l->governs);
    l->governs = solution;
  } else {
    l->all[l->count] = own;
    tp_solution_free(solution);
  }
  l->count++;
}

static tp_status solve_one(looking *l, const tp_scene *scene, bool up_dip, bool vertical,
                           const tp_solve_options *options, tp_earthquake_solve *solve,
                           tp_message *message) {
  tp_scene shaken;
  tp_solution *solution = NULL;
  shake(&shaken, scene, up_dip, vertical);
  const tp_status status = solve(&solution, &shaken, options, message);
  if (status == TP_OK) take(l, solution, up_dip, vertical);
  return status;
}

/* One way, with and without the vertical part. */
static tp_status solve_way(looking *l, const tp_scene *scene, bool up_dip,
                           const tp_solve_options *options, tp_earthquake_solve *solve,
                           tp_message *message) {
  const bool rises = scene->loads.vertical.given && !fmpq_is_zero(scene->loads.vertical.value);
  tp_status status = solve_one(l, scene, up_dip, rises, options, solve, message);
  if (status == TP_OK && rises) {
    status = solve_one(l, scene, up_dip, false, options, solve, message);
  }
  return status;
}

/* Where the way against the dip cannot be looked at, that is a caution: what stands is half an
 * answer. */
static tp_status solve_up_dip(looking *l, const tp_scene *scene, const tp_solve_options *options,
                              tp_earthquake_solve *solve, tp_message *message) {
  tp_message why = {.text = ""};
  const tp_water_description *water = &scene->loads.water;
  const tp_status status = solve_way(l, scene, true, options, solve, &why);
  const bool sited = tp_water_is_sited(water) && water->faces != TP_WATER_IN_FRONT;
  const bool wets = sited || (water->given && !fmpq_is_zero(water->height.value));
  if (status == TP_OK && wets && !l->all->earthquake.up_dip) { /* else the solution has it */
    return tp_earthquake_note_water(&l->governs->notes, water, message);
  }
  if (status != TP_BAD_INPUT && status != TP_NO_ANSWER && status != TP_UNDECIDED) {
    if (status != TP_OK && message != NULL) *message = why;
    return status;
  }
  return tp_notes_add(&l->governs->notes, message, TP_CAUTION, scene->loads.seismic_place,
                      "the earthquake is considered down-dip only, but it shakes up-dip too: %s",
                      why.text);
}

tp_status tp_earthquakes_solve(tp_solution **solution, const tp_scene *scene,
                               const tp_solve_options *options, tp_earthquake_solve *solve,
                               tp_message *message) {
  const tp_loads_description *loads = &scene->loads;
  const bool both = !loads->direction_given || loads->direction == TP_SEISMIC_BOTH;
  const bool up_dip = loads->direction_given && loads->direction == TP_SEISMIC_UP_DIP;
  looking l = {.governs = NULL};
  tp_status status = solve_way(&l, scene, up_dip, options, solve, message);
  /* on level ground both directions of tilt are solved, each shaken towards its side */
  if (status == TP_OK && both && l.governs->frame.dips) {
    status = solve_up_dip(&l, scene, options, solve, message);
  }
  if (status != TP_OK) {
    tp_solution_free(l.governs);
    return status;
  }
  l.governs->earthquake_count = l.count > 1 ? l.count : 0;
  for (size_t k = 0; k < l.count; k++) {
    l.governs->earthquakes[k] = l.all[k].earthquake;
    for (size_t c = 0; c < l.governs->case_count; c++) {
      tp_case_add_state(l.governs->cases + c, &l.all[k].safety);
    }
  }
  *solution = l.governs;
  return TP_OK;
}
