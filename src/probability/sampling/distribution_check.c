/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Makes distributions from their parameters (lognormal by mean and deviation) and checks ends,
 * spread, shape and the mass that truncation leaves. */

#include "common/outside.h"
#include "sampling/beta.h"
#include "sampling/distribution.h"

#include <math.h>
#include <stdio.h>

tp_distribution tp_distribution_list(const double *values, size_t count) {
  return (tp_distribution){.kind = TP_DISTRIBUTION_LIST, .values = values, .count = count};
}

tp_distribution tp_distribution_uniform(double low, double high) {
  return (tp_distribution){.kind = TP_DISTRIBUTION_UNIFORM, .low = low, .high = high};
}

tp_distribution tp_distribution_normal(double mean, double deviation) {
  return (tp_distribution){.kind = TP_DISTRIBUTION_NORMAL, .mean = mean, .deviation = deviation};
}

/* E X = exp(m + s^2 / 2) and Var X = (E X)^2 (exp(s^2) - 1). */
tp_distribution tp_distribution_lognormal(double mean, double deviation) {
  const double variation = deviation / mean, square = log1p(variation * variation);
  return (tp_distribution){.kind = TP_DISTRIBUTION_LOGNORMAL,
                           .mean = mean,
                           .deviation = deviation,
                           .log_mean = log(mean) - square / 2,
                           .log_spread = sqrt(square)};
}

tp_distribution tp_distribution_triangular(double low, double mode, double high) {
  return (tp_distribution){
      .kind = TP_DISTRIBUTION_TRIANGULAR, .low = low, .mode = mode, .high = high};
}

tp_distribution tp_distribution_beta(double a, double b, double low, double high) {
  return (tp_distribution){.kind = TP_DISTRIBUTION_BETA, .a = a, .b = b, .low = low, .high = high};
}

tp_distribution tp_distribution_empirical(const double *values, size_t count) {
  return (tp_distribution){.kind = TP_DISTRIBUTION_EMPIRICAL, .values = values, .count = count};
}

const char *tp_distribution_kind_name(tp_distribution_kind kind) {
  switch (kind) {
  case TP_DISTRIBUTION_LIST:
    return "list";
  case TP_DISTRIBUTION_UNIFORM:
    return "uniform";
  case TP_DISTRIBUTION_NORMAL:
    return "normal";
  case TP_DISTRIBUTION_LOGNORMAL:
    return "lognormal";
  case TP_DISTRIBUTION_TRIANGULAR:
    return "triangular";
  case TP_DISTRIBUTION_BETA:
    return "beta";
  case TP_DISTRIBUTION_EMPIRICAL:
    return "empirical";
  }
  return NULL;
}

/* Where a complaint is to say so. */
typedef struct complaint {
  const char *name;
  tp_place place;
  tp_message *message;
} complaint;

static tp_status refuse(const complaint *c, const char *what, double first, double second) {
  const tp_quote name = tp_quote_all(c->name);
  char text[256];
  snprintf(text, sizeof text, what, first, second);
  return tp_refuse(c->message, TP_FAULT_RANGE, c->place, "'%s': %s", name.text, text);
}

static tp_status check_ends(const complaint *c, const tp_distribution *d) {
  if (!isfinite(d->low) || !isfinite(d->high) || !isfinite(d->high - d->low)) {
    return refuse(c, "from %g to %g is not a range: give two finite numbers", d->low, d->high);
  }
  if (!(d->low < d->high)) {
    return refuse(c, "from %g to %g is not a range: the low end must be below the high one", d->low,
                  d->high);
  }
  return TP_OK;
}

static tp_status check_spread(const complaint *c, const tp_distribution *d) {
  if (!isfinite(d->mean) || !isfinite(d->deviation)) {
    return refuse(c, "mean %g and deviation %g must be finite numbers", d->mean, d->deviation);
  }
  if (!(d->deviation > 0)) {
    return refuse(c, "a deviation of %g: give one above 0, or the number itself, %g", d->deviation,
                  d->mean);
  }
  if (!(d->deviation >= 1e-12 * fabs(d->mean))) {
    return refuse(c,
                  "a deviation of %g is lost in the roundings of a mean of %g: give a larger one",
                  d->deviation, d->mean);
  }
  if (d->kind != TP_DISTRIBUTION_LOGNORMAL) return TP_OK;
  if (!(d->mean > 0)) {
    return refuse(c,
                  "a lognormal variable has a mean above 0, not %g (with deviation %g): give mean "
                  "and deviation of the variable itself, not of its logarithm",
                  d->mean, d->deviation);
  }
  if (!(d->deviation <= 100 * d->mean)) {
    return refuse(c, "a deviation of %g is more than 100 means of %g: give a smaller one",
                  d->deviation, d->mean);
  }
  return TP_OK;
}

static tp_status check_mode(const complaint *c, const tp_distribution *d) {
  const tp_status status = check_ends(c, d);
  if (status != TP_OK) return status;
  if (d->mode < d->low) {
    return refuse(c, "the mode %g lies below the low end %g", d->mode, d->low);
  }
  if (d->mode > d->high) {
    return refuse(c, "the mode %g lies above the high end %g", d->mode, d->high);
  }
  return isnan(d->mode) ? refuse(c, "the mode %g is not a number", d->mode, 0) : TP_OK;
}

static tp_status check_shape(const complaint *c, const tp_distribution *d) {
  const tp_status status = check_ends(c, d);
  if (status != TP_OK) return status;
  const bool fits = d->a >= TP_BETA_LEAST && d->a <= TP_BETA_MOST && d->b >= TP_BETA_LEAST &&
                    d->b <= TP_BETA_MOST;
  return fits ? TP_OK
              : refuse(c, "the parameters a = %g and b = %g of beta must lie from 0.1 to 10000",
                       d->a, d->b);
}

static tp_status check_values(const complaint *c, const tp_distribution *d) {
  const size_t least = d->kind == TP_DISTRIBUTION_EMPIRICAL ? 2 : 1;
  if (d->count < least || d->values == NULL) {
    return refuse(c, "%g values, where there must be at least %g", (double)d->count, (double)least);
  }
  for (size_t k = 0; k < d->count; k++) {
    if (!isfinite(d->values[k])) {
      return refuse(c, "value %g is %g, which is not a finite number", (double)k + 1, d->values[k]);
    }
    if (k > 0 && d->values[k] < d->values[k - 1]) {
      return refuse(c, "the values must rise: %g comes after %g", d->values[k], d->values[k - 1]);
    }
  }
  const double first = d->values[0], last = d->values[d->count - 1];
  if (d->kind == TP_DISTRIBUTION_EMPIRICAL && !(first < last && isfinite(last - first))) {
    return refuse(c, "all values from %g to %g: there is no spread to draw from", first, last);
  }
  return TP_OK;
}

/* Less than that of the whole has too few numbers in double precision to be told apart. */
static const double mass_least = 1e-290;

static tp_status check_truncation(const complaint *c, const tp_distribution *d) {
  const double low = d->truncated_low, high = d->truncated_high;
  const bool range = d->kind == TP_DISTRIBUTION_LIST ? low <= high : low < high;
  if (!range) {
    return refuse(c, "truncated to [%g, %g]: the low end must be below the high one", low, high);
  }
  if (!(d->mass > mass_least)) {
    return refuse(c, "nothing of it lies within [%g, %g]: truncate it less", low, high);
  }
  return TP_OK;
}

tp_status tp_distribution_check(const tp_distribution *d, const char *name, tp_place place,
                                tp_message *message) {
  const complaint c = {name, place, message};
  tp_status status = TP_BAD_INPUT;
  switch (d->kind) {
  case TP_DISTRIBUTION_LIST:
  case TP_DISTRIBUTION_EMPIRICAL:
    status = check_values(&c, d);
    break;
  case TP_DISTRIBUTION_UNIFORM:
    status = check_ends(&c, d);
    break;
  case TP_DISTRIBUTION_NORMAL:
  case TP_DISTRIBUTION_LOGNORMAL:
    status = check_spread(&c, d);
    break;
  case TP_DISTRIBUTION_TRIANGULAR:
    status = check_mode(&c, d);
    break;
  case TP_DISTRIBUTION_BETA:
    status = check_shape(&c, d);
    break;
  }
  return status == TP_OK && d->truncated ? check_truncation(&c, d) : status;
}
