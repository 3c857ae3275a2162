/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where the means themselves fail, the design points lie on the side of what holds: then that is
 * the rare event that is sampled, and failure is the rest. */

#include "statistics/importance_sampling.h"

#include "generate/random.h"
#include "statistics/form.h"
#include "statistics/mixture.h"
#include "statistics/score.h"
#include "statistics/standard_space.h"
#include "statistics/sum.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BATCH = 1024 };

/* A failure weighs too much where it is heavier than any centre by this, and this share of all. */
static const double heavy = 1.5, heavy_share = 0.02;

/* Weights of the samples that are the event, their squares, and of those undecided. */
typedef struct tally {
  tp_sum weights, squares, undecided, undecided_squares;
  tp_sum of_centres[TP_MIXTURE_CENTRES]; /* the event's weights by the centre they are owed to */
  double heaviest;                       /* of both, which lies at `place` */
  uint64_t failures;
} tally;

typedef struct sampler {
  const tp_reliability *problem;
  tp_standard_space space;
  tp_mixture mixture;
  bool fails; /* the event is failure */
  double *z, *g, *weights;
  double *place, *parts; /* of the heaviest; of one weight */
  tally tally;
  uint64_t stream, calls_of_form;
} sampler;

static tp_status begin(sampler *s, const tp_reliability *problem, const double *scores,
                       size_t count, uint64_t seed, tp_message *message) {
  const size_t n = problem->dimensions;
  *s = (sampler){.problem = problem, .stream = tp_random_stream(seed, TP_STREAM_IMPORTANCE)};
  tp_status status = tp_standard_space_init(&s->space, problem, BATCH, message);
  if (status != TP_OK) return status;
  s->z = calloc(BATCH * (n + 2) + n + TP_MIXTURE_CENTRES, sizeof *s->z);
  if (s->z == NULL) return tp_fail_memory(message, "the samples");
  s->g = s->z + BATCH * n;
  s->weights = s->g + BATCH;
  s->place = s->weights + BATCH;
  s->parts = s->place + n;
  status = tp_mixture_init(&s->mixture, scores, count, n, message);
  if (status != TP_OK) return status;
  status = tp_standard_space_values(&s->space, s->g, s->z, 1, message);
  s->fails = !(s->g[0] <= 0);
  return status;
}

static void end(sampler *s) {
  tp_mixture_clear(&s->mixture);
  free(s->z);
  tp_standard_space_clear(&s->space);
}

/* ---- samples -----------------------------------------------------------------------------------
 */

static void count_in(sampler *s, size_t k) {
  const size_t n = s->problem->dimensions;
  tally *t = &s->tally;
  const bool undecided = isnan(s->g[k]);
  const double *z = s->z + k * n, weight = s->weights[k];
  t->failures += s->g[k] <= 0;
  if (!undecided && (s->g[k] <= 0) != s->fails) return;
  tp_sum_add(undecided ? &t->undecided : &t->weights, weight);
  tp_sum_add(undecided ? &t->undecided_squares : &t->squares, weight * weight);
  (void)tp_mixture_weight(&s->mixture, z, s->parts);
  for (size_t c = 0; c < s->mixture.count; c++) {
    tp_sum_add(t->of_centres + c, weight * s->parts[c]);
  }
  if (weight <= t->heaviest) return;
  t->heaviest = weight;
  memcpy(s->place, z, n * sizeof *z);
}

/* By the numbers of a stream of their own, with so much of the wide part. */
static tp_status sample(sampler *s, uint64_t samples, uint64_t number, double wide,
                        tp_message *message) {
  const size_t n = s->problem->dimensions;
  const uint64_t stream = tp_random_branch(s->stream, number);
  s->tally = (tally){.failures = 0};
  s->mixture.wide = wide;
  for (uint64_t first = 0; first < samples; first += BATCH) {
    const size_t count = samples - first < BATCH ? (size_t)(samples - first) : BATCH;
    for (size_t k = 0; k < count; k++) {
      tp_mixture_draw(&s->mixture, s->z + k * n, stream, first + k);
      s->weights[k] = tp_mixture_weight(&s->mixture, s->z + k * n, NULL);
    }
    const tp_status status = tp_standard_space_values(&s->space, s->g, s->z, count, message);
    if (status != TP_OK) return status;
    for (size_t k = 0; k < count; k++) count_in(s, k);
  }
  return TP_OK;
}

static double weight_of_all(const tally *t) {
  return tp_sum_value(&t->weights) + tp_sum_value(&t->undecided);
}

static bool weighs_too_much(const sampler *s) {
  return s->tally.heaviest > heavy * tp_mixture_expected(&s->mixture) &&
         s->tally.heaviest > heavy_share * weight_of_all(&s->tally);
}

/* ---- centres -----------------------------------------------------------------------------------
 */

static bool is_centre(const tp_mixture *m, const double *z) {
  static const double apart = 0.3; /* deviations */
  for (size_t k = 0; k < m->count; k++) {
    double square = 0;
    for (size_t i = 0; i < m->dimensions; i++) {
      square +=
          (z[i] - m->centres[k * m->dimensions + i]) * (z[i] - m->centres[k * m->dimensions + i]);
    }
    if (square < apart * apart) return true;
  }
  return false;
}

/* The design point that is reached from the heaviest sample; where none is, or a known one, which
 * then lies too far from it, the sample itself. */
static tp_status add_centre(sampler *s, tp_message *message) {
  tp_form_options options = tp_form_options_default();
  tp_form form;
  options.start = s->place;
  options.most_steps = 30;
  const tp_status status = tp_form_find(&form, s->problem, &options, message);
  if (status != TP_OK) return status;
  s->calls_of_form += form.calls;
  const bool found = form.state == TP_FORM_CONVERGED && !is_centre(&s->mixture, form.scores);
  tp_mixture_add(&s->mixture, found ? form.scores : s->place);
  tp_form_clear(&form);
  return TP_OK;
}

/* The shares that the weights have, and a tenth alike. */
static void share_out(sampler *s) {
  static const double alike = 0.1;
  const size_t count = s->mixture.count;
  double sum = 0;
  for (size_t k = 0; k < count; k++) sum += tp_sum_value(s->tally.of_centres + k);
  for (size_t k = 0; k < count && sum > 0; k++) {
    const double own = tp_sum_value(s->tally.of_centres + k) / sum;
    s->mixture.shares[k] = (1 - alike) * own + alike / (double)count;
  }
}

static tp_status pilot(sampler *s, uint64_t samples, tp_message *message) {
  enum { ROUNDS = 10, LEAST = 250, MOST = 1000 };
  const uint64_t size = samples < LEAST ? LEAST : samples < MOST ? samples : MOST;
  for (uint64_t round = 0; round < ROUNDS; round++) {
    tp_status status = sample(s, size, 1 + round, 0.5, message);
    if (status != TP_OK) return status;
    const bool more = weighs_too_much(s);
    share_out(s);
    if (!more) return TP_OK;
    status = add_centre(s, message);
    if (status != TP_OK) return status;
  }
  return TP_OK;
}

/* Anew, as long as a sample shows that a centre is missing. */
static tp_status sample_until_covered(sampler *s, uint64_t samples, tp_message *message) {
  enum { TRIES = 4, NUMBER = 1000 };
  tp_status status = pilot(s, samples, message);
  for (uint64_t k = 0; k < TRIES && status == TP_OK; k++) {
    status = sample(s, samples, NUMBER + k, 0.2, message);
    if (status != TP_OK || !weighs_too_much(s) || k + 1 == TRIES) return status;
    share_out(s);
    status = add_centre(s, message);
  }
  return status;
}

/* ---- what they tell ----------------------------------------------------------------------------
 */

/* The coefficient of variation of a mean of weights with this sum and sum of squares. */
static double variation(double sum, double squares, double n) {
  return sqrt(fmax(squares / (sum * sum) - 1 / n, 0) * n / (n - 1));
}

/* How far the interval goes: by this factor, up and down. */
static double reach(double sum, double squares, double n, double confidence) {
  const double cv = variation(sum, squares, n);
  const double score = tp_student_score(confidence, fmax(sum * sum / squares - 1, 1));
  return exp(score * sqrt(log1p(cv * cv)));
}

static tp_status fail_weights(const sampler *s, tp_message *message) {
  return tp_fail(message, TP_NO_ANSWER, (tp_place){0},
                 s->tally.heaviest > 0
                     ? "a few samples make up the probability, of which there is no interval then: "
                       "allow more samples, or take subset simulation"
                     : "no sample fails: allow more samples, or take subset simulation");
}

static tp_status tell(tp_importance *importance, const sampler *s, double n, double confidence,
                      tp_message *message) {
  enum { EFFECTIVE_LEAST = 20 };
  static const double largest = 0.2;
  const tally *t = &s->tally;
  const double sum = tp_sum_value(&t->weights), squares = tp_sum_value(&t->squares);
  const double all = weight_of_all(t);
  const double all_squares = squares + tp_sum_value(&t->undecided_squares);
  if (!(all > 0) || !(all * all >= EFFECTIVE_LEAST * all_squares) ||
      !(t->heaviest <= largest * all)) {
    return fail_weights(s, message);
  }
  const double low = sum > 0 ? sum / n / reach(sum, squares, n, confidence) : 0;
  const double high = fmin(all / n * reach(all, all_squares, n, confidence), 1);
  const tp_estimate p = s->fails ? (tp_estimate){sum / n, low, high}
                                 : (tp_estimate){fmax(1 - all / n, 0), 1 - high, 1 - low};
  const double own = sum > 0 ? variation(sum, squares, n) * sum / n : 0;
  *importance = (tp_importance){.probability = p,
                                .variation = p.value > 0 ? own / p.value : INFINITY,
                                .undecided = tp_sum_value(&t->undecided) / n,
                                .effective = all * all / all_squares,
                                .largest = t->heaviest / all,
                                .centres = s->mixture.count,
                                .calls = s->space.calls + s->calls_of_form,
                                .failures = t->failures};
  return TP_OK;
}

tp_status tp_importance_sample(tp_importance *importance, const tp_reliability *problem,
                               const double *scores, size_t count, uint64_t samples, uint64_t seed,
                               double confidence, tp_message *message) {
  if (samples < 2) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0}, "at least 2 samples must be drawn");
  }
  sampler s;
  tp_status status = begin(&s, problem, scores, count, seed, message);
  if (status == TP_OK) status = sample_until_covered(&s, samples, message);
  if (status == TP_OK) status = tell(importance, &s, (double)samples, confidence, message);
  end(&s);
  return status;
}
