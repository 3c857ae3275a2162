/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Order of the stages at each precision, direction by direction and tilt by tilt: loads, formulas
 * of moments and of sliding, limit, onset, mechanism; results that are certain are kept for the
 * next precision. */

#include "stability/climb.h"

#include "evaluation/friction.h"
#include "evaluation/loaded.h"
#include "evaluation/stages.h"
#include "linear_program/cones.h"
#include "problem/effects.h"
#include "stability/climbing.h"

#include <string.h>

/* By contact forces, what is not settled yet; with what further tilts share of it. False when
 * memory is exhausted. */
static bool evaluate_statics(const tp_evaluation *e, tp_case *own, tp_climbing *c,
                             tp_certainty *certainty) {
  const tp_place place = c->problem->scene->friction_angle_deg.place;
  tp_direction_settled *kept = c->settled + own->towards;
  tp_certainty limit = {0}, onset = {0};
  tp_cones cones = {.count = 0};
  bool done = true;
  if (!kept->limit) {
    const tp_effect_begin began = tp_effects_begin(c->solution);
    done =
        tp_evaluate_limit(e, own, &kept->limit_angle, &kept->back_angle, &c->tilts, &cones, &limit);
    done = tp_effects_note(c->solution, "limit", place, "", began) && done;
  }
  if (done && !kept->onset) {
    const tp_effect_begin began = tp_effects_begin(c->solution);
    done = tp_evaluate_onset(e, own, &kept->onset_found, &c->tilts, &cones, &onset);
    done = tp_effects_note(c->solution, "onset", place, "", began) && done;
  }
  tp_cones_clear(&cones);
  if (done && !limit.open && !onset.open) {
    tp_onset_meet_limit(own, e, &kept->onset_found, &kept->limit_angle, &onset);
  }
  kept->limit = !limit.open;
  kept->onset = !onset.open;
  tp_certainty_add(certainty, &limit);
  tp_certainty_add(certainty, &onset);
  return done;
}

/* By the formulas of moments and of sliding. False when memory is exhausted. */
static bool evaluate_formulas(const tp_evaluation *e, tp_case *own, tp_direction_ball *toppling,
                              tp_direction_ball *sliding, tp_climbing *c, tp_certainty *certainty) {
  const tp_scene *scene = c->problem->scene;
  tp_effect_begin began = tp_effects_begin(c->solution);
  tp_evaluate_pivots(e, own, c->settled[own->towards].pivots, toppling, certainty);
  if (c->problem->corners.count > 0) tp_evaluate_rolling(e, own, toppling, certainty);
  const tp_place place = tp_scene_lies_in_place(scene) ? scene->frame_place : scene->tilt_place;
  const bool done =
      tp_effects_note(c->solution, "toppling", place, "both directions, as none is given", began);
  if (!scene->friction_angle_deg.given || !done) return done;
  began = tp_effects_begin(c->solution);
  tp_evaluate_sliding(e, own, sliding, certainty);
  tp_evaluate_toe(e, own, toppling, certainty);
  return tp_effects_note(c->solution, "sliding", scene->friction_angle_deg.place, "", began);
}

/* What the mechanism leaves open the limit and the onset have to tell on a higher rung. */
static void tell_mechanism(const tp_evaluation *e, tp_case *own, const tp_direction_ball *toppling,
                           const tp_direction_ball *sliding, tp_direction_settled *kept,
                           tp_certainty *certainty) {
  tp_certainty mechanism = {0};
  tp_evaluate_mechanism(
      e, own,
      &(tp_statics){toppling, sliding, &kept->limit_angle, &kept->back_angle, &kept->onset_found},
      &mechanism);
  if (mechanism.open) kept->limit = kept->onset = false;
  tp_certainty_add(certainty, &mechanism);
}

/* One direction of tilt. False when memory is exhausted. */
static bool evaluate_direction(const tp_evaluation *e, tp_case *own, tp_climbing *c,
                               tp_certainty *certainty) {
  tp_direction_ball toppling, sliding;
  tp_direction_ball_init(&toppling);
  tp_direction_ball_init(&sliding);
  const bool statics = c->problem->scene->friction_angle_deg.given && c->options->limit;
  bool done = evaluate_formulas(e, own, &toppling, &sliding, c, certainty) &&
              (!statics || evaluate_statics(e, own, c, certainty));
  if (statics && done) {
    done = tp_evaluate_bearing_pivots(e, own, c->settled[own->towards].pivots, certainty);
  }
  tell_mechanism(e, own, &toppling, &sliding, c->settled + own->towards, certainty);
  if (c->options->elements) tp_evaluate_account(e, own, &toppling, certainty);
  tp_direction_ball_clear(&toppling);
  tp_direction_ball_clear(&sliding);
  return done;
}

/* Each load's own time; what they share goes to the first of them. False when memory is
 * exhausted. */
static bool note_loads(tp_solution *solution, const tp_loaded *loaded,
                       const tp_loads_description *d, tp_effect_begin began) {
  bool done = true;
  for (long k = 1; k < loaded->count && done; k++) { /* without the weight */
    const tp_load *own = loaded->items + k;
    const double ended = k + 1 < loaded->count ? own[1].began : loaded->evaluated;
    done = tp_effects_add(solution, tp_load_name(own->kind), own->place, "", ended - own->began);
  }
  if (done && loaded->count > 1) {
    const tp_load *first = loaded->items + 1;
    done = tp_effects_note(solution, tp_load_name(first->kind), first->place, "", began);
  }
  if (done && d->bond_kpa.given) {
    done = tp_effects_note(solution, "bond", d->bond_kpa.place, "", began);
  }
  if (done && d->cohesion_kpa.given) {
    done = tp_effects_note(solution, "cohesion", d->cohesion_kpa.place, "", began);
  }
  return done;
}

/* One direction of one tilt, under the loads of the evaluation. */
static bool evaluate_tilt(const tp_evaluation *e, tp_case *own, tp_climbing *c,
                          tp_certainty *certainty) {
  if (e->loaded == NULL) return evaluate_direction(e, own, c, certainty);
  const bool done =
      evaluate_direction(e, own, c, certainty) && tp_loaded_account(own, e->loaded, e, certainty);
  tp_loaded_overtops(own, e, certainty);
  return done;
}

/* At the scene's own tilt, and where all is certain of that at the further ones of this rung. */
static bool evaluate_tilts(const tp_evaluation *e, size_t number, tp_climbing *c,
                           tp_certainty *certainty) {
  tp_case *own = c->solution->cases + number;
  tp_climbing_take_case(c, number, e->loaded);
  bool done = evaluate_tilt(e, own, c, certainty);
  tp_climbing_share(c, own->towards);
  for (size_t k = 0; k < c->tilts.count && done && !certainty->open; k++) {
    const tp_further_tilt *at = c->tilts.items + k;
    if (!at->certainty->open) {
      done = evaluate_tilt(at->e, at->result, &c->others[k].climbing, at->certainty);
    }
  }
  return done;
}

/* Under its loads, where the scene calls for some. */
static bool evaluate_case(const tp_evaluation *unloaded, size_t number, tp_climbing *c,
                          tp_certainty *certainty) {
  if (!c->problem->loaded) return evaluate_tilts(unloaded, number, c, certainty);
  const tp_effect_begin began = tp_effects_begin(c->solution);
  tp_loaded loaded;
  if (!tp_loaded_init(&loaded, unloaded, c->solution->cases[number].towards)) return false;
  tp_evaluation under_loads = *unloaded;
  under_loads.loaded = &loaded;
  const bool done = note_loads(c->solution, &loaded, &c->problem->scene->loads, began) &&
                    evaluate_tilts(&under_loads, number, c, certainty);
  tp_loaded_clear(&loaded);
  return done;
}

static tp_status step(void *context, tp_rung rung, bool *certain) {
  tp_climbing *c = context;
  if (tp_problem_is_enclosed(c->problem) && rung.level == TP_LEVEL_EXACT) {
    rung.level = TP_LEVEL_BALL;
  }
  const tp_effect_begin began = tp_effects_begin(c->solution);
  tp_certainty certainty = {0};
  tp_evaluation e;
  tp_evaluation_init(&e, c->problem, rung, c->options);
  e.decimals = c->solution->decimals;
  e.work = &c->work;
  tp_friction_stress_when_level(e.weight_per_area_pa, &e);
  tp_friction_tangent_given(e.friction_tangent, &e);
  tp_evaluate_block(&e, &c->solution->block, &certainty);
  tp_evaluate_contact(&e, &c->solution->contact, &certainty);
  bool done = tp_effects_note(c->solution, "moments", c->problem->scene->block.place, "", began);
  if (c->rungs++ == 0) tp_climbing_begin_tilts(c, &e);
  for (size_t k = 0; k < c->solution->case_count && done; k++) {
    done = evaluate_case(&e, k, c, &certainty);
  }
  tp_climbing_end_tilts(c, !certainty.open);
  tp_evaluation_clear(&e);
  *certain = !certainty.open;
  c->solution->open_number = certainty.undecided_number;
  tp_certainty_add(&certainty, &(tp_certainty){.zero_bits = c->solution->zero_bits}); /* settled */
  c->solution->zero_bits = certainty.zero_bits;
  done = done && (c->solution->decimals == NULL || !tp_decimals_failed(c->solution->decimals));
  return done ? TP_OK : tp_fail_memory(c->message, "the loads, the limit or the digits");
}

/* What was computed on the ladder was computed at the level that it reached. */
static void note_level(tp_solution *solution, tp_rung reached) {
  solution->level = reached.level;
  solution->bits = reached.bits;
  static const char *const climbing[] = {"moments", "toppling", "sliding", "limit", "onset"};
  for (size_t k = 0; k < solution->effect_count; k++) {
    for (size_t c = 0; c < sizeof climbing / sizeof climbing[0]; c++) {
      if (strcmp(solution->effects[k].name, climbing[c]) == 0) {
        solution->effects[k].level = reached.level;
      }
    }
  }
}

static tp_status fail_undecided(tp_message *message, const tp_climbing *c, tp_rung reached) {
  const tp_level highest = c->options->level;
  const int digits = c->options->digits;
  return tp_fail(message, TP_UNDECIDED, (tp_place){c->problem->scene->path, 0, 0},
                 "undecided at %ld bits%s%s: a number is not certain to %d digit%s", reached.bits,
                 highest < TP_LEVEL_EXACT ? " of level " : "",
                 highest < TP_LEVEL_EXACT ? tp_level_name(highest) : "", digits,
                 digits == 1 ? "" : "s");
}

tp_status tp_climb(tp_solution *solution, const tp_problem *problem,
                   const tp_solve_options *options, tp_tilts *tilts, tp_message *message) {
  tp_climbing c;
  tp_status status = tp_climbing_init(&c, solution, problem, options, tilts, message);
  if (status == TP_OK) {
    tp_rung reached = {TP_LEVEL_DOUBLE, 0};
    status = tp_ladder_climb(step, &c, options->level, options->digits, &reached);
    note_level(solution, reached);
    if (status == TP_UNDECIDED) status = fail_undecided(message, &c, reached);
  }
  if (status == TP_OK && tilts != NULL) tp_climbing_hand_out(tilts, &c);
  tp_climbing_clear(&c);
  return status;
}
