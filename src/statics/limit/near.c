/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Each candidate tilt of the search is refined to a fixed point, the zero of its mechanism's
 * excess, at full precision, and then proven; loads that push the block up-dip are treated with the
 * sines of the loads reversed (docs/mechanics.md section 6). */

#include "limit/near.h"

#include "certificate/bracket.h"
#include "certificate/certify.h"
#include "certificate/excess.h"
#include "certificate/prove.h"
#include "limit/program.h"
#include "limit/search.h"
#include "linear_program/precise.h"

/* One candidate for the limit: the basis of the program at a tilt near it. */
typedef struct candidate {
  tp_limit_answer *answer;
  const tp_limit_question *question;
  tp_scaled *scaled;
  tp_program program;
  arb_t near;
  tp_basis basis;
} candidate;

static void candidate_init(candidate *c, tp_limit_answer *answer, const tp_limit_question *q,
                           double near_degrees, tp_scaled *scaled) {
  c->answer = answer;
  c->question = q;
  c->scaled = scaled;
  c->basis = (tp_basis){.columns = {-1, -1, -1}};
  tp_program_init(&c->program);
  arb_init(c->near);
  arb_set_d(c->near, near_degrees);
  answer->bracketed = false;
}

static void candidate_clear(candidate *c) {
  tp_program_clear(&c->program);
  arb_clear(c->near);
}

/* Without taking anything for zero; or on the last rungs, where mechanisms tie as far as the bits
 * tell, which these are by what is taken for zero, and the number by a bracket that takes nothing
 * for it. */
static tp_answer prove(candidate *c) {
  const tp_limit_question *q = c->question;
  const double near = arf_get_d(arb_midref(c->near), ARF_RND_NEAR);
  if (c->basis.outcome != TP_SIMPLEX_OPTIMAL) return TP_NO;
  tp_limit_question strict = *q;
  strict.judge.settled = false;
  tp_answer done =
      tp_prove_limit(c->answer, &strict, c->scaled, &c->basis, &c->program.direction, near);
  if (done == TP_YES || !q->judge.settled) return done;
  done = tp_prove_limit(c->answer, q, c->scaled, &c->basis, &c->program.direction, near);
  return done == TP_YES ? tp_bracket_limit(c->answer, q, c->scaled) : done;
}

/* The next tilt to look at: where the face of the last basis meets the loads. */
static bool move_near(candidate *c) {
  const tp_limit_question *q = c->question;
  if (c->basis.outcome != TP_SIMPLEX_OPTIMAL || c->basis.count != 2) return false;
  tp_limit_answer *a = c->answer;
  if (tp_face_span(&a->face, q->cones, c->basis.columns[0], c->basis.columns[1],
                   &c->program.direction, &q->judge) == TP_NO) {
    return false;
  }
  tp_face_find_resistance(&a->face, q->cones, &q->judge);
  const double near = arf_get_d(arb_midref(c->near), ARF_RND_NEAR);
  if (tp_excess_tilt(a, &a->face, q, near) != TP_YES) return false;
  arb_get_mid_arb(c->near, a->degrees);
  return true;
}

static bool is_same(const tp_basis *a, const tp_basis *b) {
  return a->count == b->count && a->columns[0] == b->columns[0] && a->columns[1] == b->columns[1] &&
         a->columns[2] == b->columns[2];
}

/* Where doubles do not tell the columns apart: programs at full precision, each at the tilt that
 * the last one gave, until one is its own. */
static tp_answer find_precisely(candidate *c) {
  enum { MOST_ROUNDS = 8, STEPS = 8 }; /* then given up; steps that a program is counted for */
  tp_answer done = TP_OPEN;
  for (int round = 0; round < MOST_ROUNDS && done != TP_YES; round++) {
    if (!tp_work_spend(c->question->work, STEPS, c->scaled->count, c->question->judge.bits)) break;
    const tp_basis before = c->basis;
    tp_program_set_near(&c->program, c->question, c->near);
    const tp_simplex_answer found = tp_program_solve_precisely(&c->program, c->scaled, c->question);
    c->basis = tp_basis_of(&found);
    if (round > 0 && is_same(&before, &c->basis)) break;
    done = prove(c);
    if (done != TP_YES && !move_near(c)) break;
  }
  return done;
}

static tp_limit_outcome outcome_of(tp_answer answer) {
  return answer == TP_YES ? TP_LIMIT_PROVEN : TP_LIMIT_OPEN;
}

static tp_limit_outcome find_at(tp_limit_answer *answer, const tp_limit_question *q,
                                double near_degrees, tp_scaled *scaled) {
  candidate c;
  candidate_init(&c, answer, q, near_degrees, scaled);
  tp_answer done = TP_OPEN;
  if (!q->without_doubles && tp_work_spend(q->work, 4, scaled->count, q->judge.bits)) {
    tp_program_set_near(&c.program, q, c.near);
    const tp_simplex_answer found = tp_program_solve(&c.program, scaled);
    c.basis = tp_basis_of(&found);
    done = prove(&c);
  }
  /* with fewer bits, doubling them is cheaper */
  const bool precisely = q->judge.bits >= TP_PRECISE_BITS || q->without_doubles;
  if (done != TP_YES && precisely) done = find_precisely(&c);
  candidate_clear(&c);
  return outcome_of(done);
}

/* The question as the tilt falls: sines change their sign. */
static void set_mirrored(tp_wrench *load, const tp_wrench *of, long bits) {
  const tp_trig *given[3] = {&of->x, &of->y, &of->moment};
  tp_trig *own[3] = {&load->x, &load->y, &load->moment};
  for (int k = 0; k < 3; k++) {
    tp_trig_add(own[k], given[k], bits);
    arb_neg(own[k]->of + TP_SIN, own[k]->of + TP_SIN);
  }
}

/* Between a tilt that does not hold and one above that does lies where forces begin to hold: the
 * limit as the tilt falls. Nothing holds from there down to level ground, and as far below. */
static tp_limit_outcome find_entry(arb_t degrees, const tp_limit_question *q,
                                   const tp_search_tilts *tilts, tp_scaled *scaled) {
  tp_limit_answer entry;
  if (!tp_limit_answer_init(&entry, q->cones)) return TP_LIMIT_OUT_OF_MEMORY;
  tp_wrench load;
  tp_wrench_init(&load);
  set_mirrored(&load, q->load, q->judge.precision);
  tp_limit_question mirrored = *q;
  mirrored.load = &load;
  const double near = tp_search_between(scaled, &mirrored, -tilts->held, -tilts->before);
  tp_limit_outcome outcome = find_at(&entry, &mirrored, near, scaled);
  if (outcome == TP_LIMIT_PROVEN && tp_certify_infeasible(&mirrored, scaled, &entry) != TP_YES) {
    outcome = TP_LIMIT_OPEN;
  }
  tp_certify_held_end(degrees, &entry);
  arb_neg(degrees, degrees);
  tp_wrench_clear(&load);
  tp_limit_answer_clear(&entry);
  return outcome;
}

/* The limit that doubles found, or an earlier one that its proof came upon. `start` NULL: level. */
static tp_limit_outcome find_first(tp_limit_answer *answer, const tp_limit_question *q,
                                   tp_search_tilts *tilts, bool always, const arb_t start,
                                   tp_scaled *scaled) {
  enum { MOST_ROUNDS = 8 }; /* each at an earlier limit, that doubles did not see */
  for (int round = 0; round < MOST_ROUNDS; round++) {
    answer->kind = TP_LIMIT_INTERLOCKED;
    if (!always) {
      const tp_limit_outcome outcome = find_at(answer, q, tilts->fails, scaled);
      if (outcome != TP_LIMIT_PROVEN) return outcome;
      if (start == NULL && arb_is_negative(answer->degrees)) { /* doubles were wrong of level */
        return outcome_of(tp_certify_infeasible(q, scaled, answer));
      }
    }
    double held = 0, lost = 0;
    const tp_answer done = tp_certify_holds(&held, &lost, q, scaled, start, always ? NULL : answer);
    if (done != TP_NO) return outcome_of(done);
    tilts->fails = tp_search_between(scaled, q, held, lost);
    always = false;
  }
  return TP_LIMIT_OPEN;
}

tp_limit_outcome tp_near_find(tp_limit_answer *answer, const tp_limit_question *q,
                              tp_scaled *scaled) {
  tp_search_tilts tilts = {.held = 0};
  if (!tp_search_pay(q, scaled)) return TP_LIMIT_OPEN;
  const tp_search_found found = tp_search_near(&tilts, scaled, q);
  if (found == TP_SEARCH_OPEN) return TP_LIMIT_OPEN;
  if (found == TP_SEARCH_HOLDS_NEVER) {
    answer->kind = TP_LIMIT_NOWHERE;
    return outcome_of(tp_certify_never(q, scaled));
  }
  if (tilts.held == 0) {
    return find_first(answer, q, &tilts, found == TP_SEARCH_HOLDS_ALWAYS, NULL, scaled);
  }
  if (tilts.held < 0) {
    if (found != TP_SEARCH_TILT) return TP_LIMIT_OPEN; /* level ground is between */
    const tp_limit_outcome outcome = find_at(answer, q, tilts.fails, scaled);
    if (outcome != TP_LIMIT_PROVEN) return outcome;
    double held = 0, lost = 0;
    return outcome_of(arb_is_positive(answer->degrees)
                          ? tp_certify_holds(&held, &lost, q, scaled, NULL, answer)
                          : tp_certify_infeasible(q, scaled, answer));
  }
  arb_t start;
  arb_init(start);
  tp_limit_outcome outcome = find_entry(start, q, &tilts, scaled);
  if (outcome == TP_LIMIT_PROVEN) {
    outcome = find_first(answer, q, &tilts, found == TP_SEARCH_HOLDS_ALWAYS, start, scaled);
  }
  arb_clear(start);
  return outcome;
}
