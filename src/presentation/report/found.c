/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Results of a back-analysis as text and as JSON: numbers found, intervals, the range searched, and
 * what the result was otherwise. */

#include "common/host.h"
#include "common/options.h"
#include "output/encode.h"
#include "report/governing.h"
#include "report/results.h"
#include "report/solution_json.h"
#include "report/system_words.h"

#include <string.h>

/* Up to which forces can hold the blocks, though a motion may begin before? */
static bool is_limit_of_forces(tp_find_target target) {
  return target == TP_FIND_LIMIT_FOS || target == TP_FIND_LIMIT_ANGLE ||
         target == TP_FIND_ACCELERATION;
}

/* What the result was instead of the value. */
static void add_none(tp_text *t, const tp_found *f, const tp_find_options *options) {
  char least[TP_NUMBER_SIZE], greatest[TP_NUMBER_SIZE];
  tp_text_significant(least, f->least, 12);
  tp_text_significant(greatest, f->greatest, 12);
  const bool of_forces = is_limit_of_forces(options->target);
  tp_text_add(t, "  none in range: %s%s%s ",
              f->is_upper_bound && !of_forces ? "the upper bound of " : "",
              tp_find_target_name(options->target),
              f->is_upper_bound && of_forces ? ", an upper bound," : "");
  if (strcmp(least, greatest) == 0) {
    tp_text_add(t, "is %s at every point examined\n", least);
  } else {
    tp_text_add(t, "goes from %s to %s there\n", least, greatest);
  }
  const bool passes = f->least.value < options->value && options->value < f->greatest.value;
  if (passes && options->target == TP_FIND_ACCELERATION) {
    tp_text_add(t,
                "  where it passes the value the blocks may move at rest, so that no acceleration\n"
                "  is critical\n");
  } else if (passes && f->is_upper_bound && !of_forces) {
    tp_text_add(t, "  where it passes the value, and at the numbers beyond that were tried, a "
                   "smaller factor is\n  proven\n");
  }
}

/* Is the factor that governs the one that was looked for? */
static bool governs(const tp_governing_fos *g, tp_find_target target) {
  if (target == TP_FIND_GOVERNING_FOS) return true;
  if (!g->has_factor) return false;
  switch (g->factors[g->factor].definition) {
  case TP_FOS_BY_MOMENTS:
    return target == TP_FIND_FOS;
  case TP_FOS_BY_SHEAR:
  case TP_FOS_BY_ROUGHNESS:
    return target == TP_FIND_SLIDING_FOS;
  case TP_FOS_BY_REDUCTION:
    return target == TP_FIND_LIMIT_FOS;
  case TP_FOS_BY_DRIVING:
    break;
  }
  return false;
}

static void add_governing(tp_text *t, const tp_governing_fos *g, tp_find_target target) {
  if (governs(g, target)) return;
  tp_text_add(t,
              "    Caution: %s is not the governing factor there: ", tp_find_target_name(target));
  tp_text_factor(t, g);
  tp_text_add(t, "; use --for governing_fos\n");
}

static const char *found_down(char out[TP_NUMBER_SIZE], double factor) {
  return tp_text_significant_down(out, (tp_bounded){factor, 0, NULL}, 5);
}

static bool is_factor_of_many(tp_find_target target) {
  return target == TP_FIND_FOS || target == TP_FIND_GOVERNING_FOS || target == TP_FIND_LIMIT_FOS ||
         target == TP_FIND_FOS_GOODMAN_BRAY;
}

/* The factor of safety there, and what else is known. */
static void add_blocks(tp_text *t, const tp_found_blocks *b, tp_find_target target) {
  char n[TP_NUMBER_SIZE];
  if (is_limit_of_forces(target)) {
    tp_text_add(t, "    %s is an upper bound: up to it forces can hold the blocks\n",
                tp_find_target_name(target));
  }
  if (is_factor_of_many(target)) {
    tp_text_add(t, "    factor of safety there: ");
    tp_text_system_safety(t, &b->governing_fos);
    tp_text_system_against(t, &b->governing_fos);
    tp_text_add(t, "\n");
    if (b->is_upper_bound) {
      tp_text_add(t, "    this is an upper bound: no smaller factor is proven there, and none is "
                     "excluded\n");
    }
  }
  switch (b->verdict) {
  case TP_SYSTEM_STANDS:
    tp_text_add(t, "    the blocks stand there: no motion can begin");
    if (b->has_standing_fos) {
      tp_text_add(t, ", nor with strength divided by %s", found_down(n, b->standing_fos));
    }
    tp_text_add(t, "\n");
    break;
  case TP_SYSTEM_COLLAPSES:
    tp_text_add(t, "    the blocks collapse there, as they lie\n");
    break;
  case TP_SYSTEM_UNDECIDED:
    tp_text_add(t, "    what the blocks do there is undecided\n");
    break;
  case TP_SYSTEM_MAY_MOVE:
    if (!b->has_moving_fos) {
      tp_text_add(t, "    Caution: a motion can begin there, proven, though forces can hold the "
                     "blocks\n");
    }
    break;
  case TP_SYSTEM_CAN_HOLD:
    if (!b->has_moving_fos) {
      tp_text_add(t, "    Caution: forces can hold the blocks there; that a motion begins all the "
                     "same is neither\n    excluded nor proven\n");
    }
    break;
  }
  if (b->has_moving_fos) {
    tp_text_add(
        t,
        "    Caution: a motion can begin there with strength divided by %s, proven, though\n    "
        "forces can hold the blocks\n",
        tp_text_significant_up(n, (tp_bounded){b->moving_fos, 0, NULL}, 5));
  }
  if (b->has_fos_goodman_bray && target != TP_FIND_FOS_GOODMAN_BRAY) {
    tp_text_add(t, "    by Goodman and Bray the factor there is %s\n",
                found_down(n, b->fos_goodman_bray));
  }
}

static const char *number_text(char out[TP_NUMBER_SIZE], double number, int digits) {
  return tp_text_significant(out, (tp_bounded){.value = number}, digits);
}

/* Between which numbers the result is at least the value, and what is beyond. */
static void add_stretch(tp_text *t, const tp_found_stretch *s, const tp_found *f,
                        const tp_find_options *options) {
  char from[TP_NUMBER_SIZE], to[TP_NUMBER_SIZE];
  const char *begin = s->begins          ? ""
                      : s->low == f->low ? ", where the range begins,"
                                         : ", not known before,";
  const char *end = s->ends              ? ""
                    : s->high == f->high ? ", where the range ends"
                                         : ", not known beyond";
  tp_text_add(t, "  %s ≥ %.15g from %s%s to %s%s", tp_find_target_name(options->target),
              options->value, number_text(from, s->low, 12), begin, number_text(to, s->high, 12),
              end);
  if (s->begins || s->ends) {
    tp_text_add(t, "; below %.15g %s", options->value,
                s->begins && s->ends ? "before and after"
                : s->begins          ? "before"
                                     : "after");
  }
  tp_text_add(t, "\n");
}

/* The force to build for; or that there is no need of one. */
static void add_design(tp_text *t, const tp_found *f, const tp_find_options *options) {
  const char *target = tp_find_target_name(options->target);
  const char *unit = strstr(f->key, ".force_kn") != NULL ? "kN" : "kPa";
  char n[TP_NUMBER_SIZE];
  if (!f->is_support || f->at_least_count == 0) return;
  const tp_found_stretch *first = f->at_least;
  if (f->has_design) {
    tp_text_add(t, "  design value: %.15g %s, the least rounded up, which gives %s %s", f->design,
                unit, target, tp_text_fixed_down(n, f->design_result, 4));
    if (first->ends)
      tp_text_add(t, "; above %s %s is too much", number_text(n, first->high, 6), unit);
    tp_text_add(t, "\n");
  } else if (!first->begins && first->low <= f->low) {
    tp_text_add(t,
                "  no design value: %s is above %.15g already with the least that was tried, %s "
                "%s%s\n",
                target, options->value, number_text(n, first->low, 6), unit,
                first->low > 0 ? "; look below it with --from" : "");
  }
}

tp_status tp_report_found(char **text, const tp_found *f, const tp_find_options *options) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, f);
  TP_REFUSE_NULL(NULL, options);
  tp_find_options own = tp_find_options_default();
  TP_TAKE_OPTIONS(NULL, own, options);
  tp_text t = {0};
  char number[TP_NUMBER_SIZE];
  tp_encode_plain(&t, f->key);
  tp_text_add(&t, " for %s = %.15g\n", tp_find_target_name(options->target), options->value);
  if (f->least_over != NULL) {
    tp_text_add(&t, "  least at ");
    tp_encode_plain(&t, f->least_over);
    tp_text_add(&t, " = %.4f: the direction is a search in doubles; the force there is proven\n",
                f->direction_deg);
  }
  for (size_t k = 0; k < f->count; k++) {
    tp_text_add(&t, "  %s  (within %.2g)\n", tp_text_significant(number, f->solutions[k], 12),
                f->solutions[k].error);
    if (f->per_metre_kn != NULL) {
      tp_text_add(&t, "    %s kN per metre along the slope, of all rows\n",
                  tp_text_significant(number, f->per_metre_kn[k], 9));
    }
    if (f->governing != NULL) add_governing(&t, f->governing + k, own.target);
    if (f->blocks != NULL) add_blocks(&t, f->blocks + k, own.target);
  }
  for (size_t k = 0; k < f->touching_count; k++) {
    tp_text_add(&t,
                "  %s  (within %.2g): approaches the value and turns back or\n"
                "    ends; whether it reaches it is undecided\n",
                tp_text_significant(number, f->touching[k], 12), f->touching[k].error);
  }
  for (size_t k = 0; k < f->interval_count; k++) {
    char end[TP_NUMBER_SIZE];
    tp_text_add(&t,
                "  every number from %s to %s  (within %.2g and %.2g): the\n"
                "  result stays at the value, equal to 30 digits at every point examined\n",
                tp_text_significant(number, f->intervals[k].low, 12),
                tp_text_significant(end, f->intervals[k].high, 12), f->intervals[k].low.error,
                f->intervals[k].high.error);
  }
  for (size_t k = 0; k < f->at_least_count; k++) add_stretch(&t, f->at_least + k, f, &own);
  add_design(&t, f, &own);
  if (f->count + f->touching_count + f->interval_count == 0) add_none(&t, f, options);
  tp_text_add(&t, "search range with a solution: %.6g to %.6g\n", f->low, f->high);
  return tp_text_finish(&t, text);
}

tp_status tp_report_found_json(char **text, const tp_found *f, const tp_solution *solution) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, f);
  TP_REFUSE_NULL(NULL, solution);
  tp_json j = {0};
  tp_json_report(&j);
  tp_json_solution(&j, solution, TP_PIVOTS_BY_COUNT);
  tp_json_subject x = {.s = solution};
  tp_json_object(&j, "find", TP_JSON_LINE);
  tp_json_members_of_find(&j, f, &x);
  tp_json_close(&j);
  tp_json_close(&j);
  return tp_json_finish(&j, text);
}

tp_status tp_report_found_block_system_json(char **text, const tp_found *f,
                                            const tp_block_system *system) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, f);
  TP_REFUSE_NULL(NULL, system);
  tp_json j = {0};
  tp_json_subject x = {.system = system};
  tp_json_report(&j);
  tp_json_members_of_block_system(&j, system, &x);
  tp_json_object(&j, "find", TP_JSON_LINE);
  tp_json_members_of_block_find(&j, f, &x);
  tp_json_close(&j);
  tp_json_close(&j);
  return tp_json_finish(&j, text);
}
