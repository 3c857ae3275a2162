/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* All that is known at each number found of many blocks. Where a smaller factor of safety than the
 * wanted one is proven there, the number is moved to where none is, or given up. */

#include "back_analysis/find_blocks.h"

#include "back_analysis/find_sample.h"
#include "back_analysis/find_system.h"
#include "block_system/governing_case.h"
#include "block_system/system.h"
#include "common/message.h"

#include <math.h>
#include <stdlib.h>

static void tell_system(tp_found_blocks *blocks, const tp_block_system *system) {
  const tp_system_case *own = tp_system_governing(system);
  const tp_goodman_bray *columns = &own->goodman_bray;
  *blocks = (tp_found_blocks){
      .verdict = tp_system_case_worst_verdict(tp_system_most_severe(system)),
      .has_standing_fos = own->has_standing_fos,
      .standing_fos = own->standing_fos,
      .has_moving_fos = own->has_moving_fos && !(own->fos.state == TP_FOS_NUMBER &&
                                                 own->moving_fos >= own->fos.value.value),
      .moving_fos = own->moving_fos,
      .has_fos_goodman_bray = columns->applies && columns->has_fos,
      .fos_goodman_bray = columns->fos,
      .governing_fos = system->governing_fos,
      .is_upper_bound = system->governing_fos.fos.state == TP_FOS_UNDECIDED};
  blocks->governing_fos.fos.value.digits = NULL;
}

/* In any direction, so that no acceleration is critical. */
static bool moves_at_rest(const tp_block_system *system) {
  for (size_t k = 0; k < system->case_count; k++) {
    if (tp_system_case_moves_at_rest(system->cases + k)) return true;
  }
  return false;
}

/* All that is known at a number; `excluded` where the target has no value there once motions are
 * looked for. */
static void look_for(tp_found_blocks *blocks, bool *excluded, tp_search *s, double x) {
  tp_block_system *system = NULL;
  *blocks =
      (tp_found_blocks){.verdict = TP_SYSTEM_UNDECIDED,
                        .governing_fos = {.fos = {.state = TP_FOS_UNDECIDED}, .at_most = INFINITY},
                        .is_upper_bound = true};
  *excluded = false;
  const tp_status status = tp_search_solve_system(&system, s, x, TP_MOTIONS_ALL);
  if (status == TP_OK) {
    tell_system(blocks, system);
    *excluded = s->options->target == TP_FIND_ACCELERATION && moves_at_rest(system);
  }
  if (status == TP_OUT_OF_MEMORY || status == TP_SYSTEM_FAILED) {
    s->status = tp_fail(s->message, status, (tp_place){0}, "%s", s->why.text);
  }
  tp_block_system_free(system);
}

static void look_at(tp_found_blocks *blocks, tp_search *s, double x) {
  bool excluded;
  look_for(blocks, &excluded, s, x);
}

/* Is a factor proven there that is less than the wanted one, by more than numbers are found to? */
static bool has_less(const tp_search *s, const tp_found_blocks *at) {
  static const double found_to = 1e-5;
  return at->governing_fos.at_most < s->options->value * (1 - found_to);
}

/* To which side the upper bounds rise, 1 or -1; 0: to none, within a point of the range. */
static int rising_side(tp_search *s, double x) {
  static const int sides[] = {1, -1};
  for (int k = 0; k < 2 && s->status == TP_OK; k++) {
    const double at = fmin(fmax(x + sides[k] * s->step, s->found->low), s->found->high);
    const tp_sample next = tp_search_sample(s, at);
    if (next.known && tp_search_side(&next) > 0) return sides[k];
  }
  return 0;
}

/* Between a number with a smaller factor and one without; the latter is what is found. */
static void halve(tp_bounded *solution, tp_found_blocks *blocks, double below, tp_search *s) {
  enum { HALVES = 8 };
  for (int k = 0; k < HALVES && s->status == TP_OK; k++) {
    tp_found_blocks middle;
    const double x = below + (solution->value - below) / 2;
    look_at(&middle, s, x);
    if (has_less(s, &middle)) {
      below = x;
    } else {
      solution->value = x;
      *blocks = middle;
    }
  }
  solution->error = fabs(solution->value - below);
}

/* Moves a number to where no smaller factor is proven: away from it in steps that double, and back
 * by halves. False: there is none within the range, or before the upper bounds fall again. */
static bool move(tp_bounded *solution, tp_found_blocks *blocks, tp_search *s) {
  enum { OUTWARDS = 8 }; /* which reach the end of the range */
  const int side = rising_side(s, solution->value);
  const double end = side > 0 ? s->found->high : s->found->low;
  double below = solution->value, step = fabs(end - below) / ((1 << OUTWARDS) - 1);
  tp_found_blocks at = *blocks;
  for (int k = 0; k < OUTWARDS && side != 0 && has_less(s, &at) && s->status == TP_OK; k++) {
    below = solution->value;
    solution->value = k == OUTWARDS - 1 ? end : below + side * step;
    step *= 2;
    look_at(&at, s, solution->value);
  }
  if (side == 0 || has_less(s, &at)) return false;
  *blocks = at;
  halve(solution, blocks, below, s);
  return true;
}

/* Upper bounds that are above the value throughout do not exclude that the factor passes it. */
static void look_at_ends(tp_search *s) {
  const double ends[2] = {s->found->low, s->found->high};
  tp_found_blocks at[2];
  for (int k = 0; k < 2 && s->status == TP_OK; k++) look_at(at + k, s, ends[k]);
  if (s->status != TP_OK || has_less(s, at) == has_less(s, at + 1)) return;
  const int above = has_less(s, at) ? 1 : 0;
  tp_bounded solution = {.value = ends[above]};
  halve(&solution, at + above, ends[1 - above], s);
  tp_search_add_solution(s, solution.value, solution.value);
  if (s->status != TP_OK) return;
  s->found->blocks = calloc(1, sizeof *s->found->blocks);
  if (s->found->blocks == NULL) {
    s->status = tp_fail_memory(s->message, "the solutions");
    return;
  }
  *s->found->solutions = solution;
  *s->found->blocks = at[above];
}

void tp_search_tell_blocks(tp_search *s) {
  tp_found *found = s->found;
  s->varied.options.strength_reduction = true;
  if (found->count == 0) {
    const bool asks = tp_find_target_is_governing(s->options->target) && found->is_upper_bound &&
                      found->least.value > s->options->value;
    if (asks && tp_search_cheap_motions(s) != TP_MOTIONS_ALL) look_at_ends(s);
    return;
  }
  const size_t count = found->count;
  found->blocks = calloc(count, sizeof *found->blocks);
  if (found->blocks == NULL) {
    s->status = tp_fail_memory(s->message, "the solutions");
    return;
  }
  found->count = 0;
  for (size_t k = 0; k < count && s->status == TP_OK; k++) {
    tp_bounded solution = found->solutions[k];
    tp_found_blocks blocks;
    bool excluded;
    look_for(&blocks, &excluded, s, solution.value);
    const bool less = tp_find_target_is_governing(s->options->target) && has_less(s, &blocks);
    if (s->status != TP_OK || excluded || (less && !move(&solution, &blocks, s))) continue;
    found->solutions[found->count] = solution;
    found->blocks[found->count++] = blocks;
  }
}
