/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reader of numbers and of transform lists (translate, scale, rotate, skew, matrix) as exact affine
 * maps. */

#include "format/drawing_work.h"
#include "format/svg_path.h"
#include "number/ratio.h"

#include <string.h>

static bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

static void skip(tp_svg_text *text) {
  while (text->at < text->end && is_blank(*text->at)) text->at++;
  if (text->at == text->end || *text->at != ',') return;
  text->at++;
  while (text->at < text->end && is_blank(*text->at)) text->at++;
}

bool tp_svg_at_number(tp_svg_text *text) {
  skip(text);
  if (text->at == text->end) return false;
  const char c = *text->at;
  return (c >= '0' && c <= '9') || c == '.' || c == '+' || c == '-';
}

bool tp_svg_number(tp_svg_text *text, fmpq_t value) {
  if (text->problem != NULL) return false;
  if (!tp_svg_at_number(text)) {
    text->problem = "a number is missing";
    return false;
  }
  const bool negative = *text->at == '-';
  if (*text->at == '-' || *text->at == '+') text->at++;
  const size_t used =
      tp_ratio_read_decimal(value, text->at, (size_t)(text->end - text->at), &text->problem);
  if (used == 0) {
    text->problem = "has an invalid or implausibly large number";
    return false;
  }
  text->at += used;
  if (negative) fmpq_neg(value, value);
  return true;
}

/* ---- transforms --------------------------------------------------------------------------------
 */

enum { MOST = 6 };

static void set_angle(fmpq_t cosine, fmpq_t sine, const fmpq_t degrees) {
  enum { BITS = 192, HALF = 180 };
  arb_t c, s;
  fmpq_t share;
  arb_init(c);
  arb_init(s);
  fmpq_init(share);
  fmpq_set_si(share, 1, HALF);
  fmpq_mul(share, share, degrees);
  arb_sin_cos_pi_fmpq(s, c, share, BITS);
  tp_curve_decimal(cosine, c);
  tp_curve_decimal(sine, s);
  arb_clear(c);
  arb_clear(s);
  fmpq_clear(share);
}

void tp_svg_turn(tp_affine_map *map, const fmpq_t degrees) {
  fmpq_t cosine, sine;
  fmpq_init(cosine);
  fmpq_init(sine);
  set_angle(cosine, sine, degrees);
  tp_affine_map_turn(map, cosine, sine);
  fmpq_clear(cosine);
  fmpq_clear(sine);
}

static void turn_about(tp_affine_map *map, const fmpq *n, int count) {
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  if (count == 3) tp_affine_map_shift(map, n + 1, n + 2);
  tp_svg_turn(map, n);
  fmpq_neg(x, n + 1);
  fmpq_neg(y, n + 2);
  if (count == 3) tp_affine_map_shift(map, x, y);
  fmpq_clear(x);
  fmpq_clear(y);
}

/* x' = x + tan(angle) y, or y' = y + tan(angle) x; false at 90 degrees, where there is none. */
static bool skew(tp_affine_map *map, const fmpq *degrees, bool along_x) {
  tp_affine_map inner;
  fmpq_t sine;
  tp_affine_map_init(&inner);
  fmpq_init(sine);
  fmpq *tangent = along_x ? inner.c : inner.b;
  set_angle(tangent, sine, degrees);
  const bool done = !fmpq_is_zero(tangent);
  if (done) fmpq_div(tangent, sine, tangent);
  tp_affine_map_compose(map, &inner);
  tp_affine_map_clear(&inner);
  fmpq_clear(sine);
  return done;
}

static bool apply(tp_affine_map *map, const char *word, const fmpq *n, int count,
                  const char **problem) {
  if (strcmp(word, "translate") == 0 && (count == 1 || count == 2)) {
    tp_affine_map_shift(map, n, n + 1); /* what is not given is zero */
  } else if (strcmp(word, "scale") == 0 && (count == 1 || count == 2)) {
    tp_affine_map_scale(map, n, count == 2 ? n + 1 : n);
  } else if (strcmp(word, "rotate") == 0 && (count == 1 || count == 3)) {
    turn_about(map, n, count);
  } else if ((strcmp(word, "skewX") == 0 || strcmp(word, "skewY") == 0) && count == 1) {
    if (skew(map, n, word[4] == 'X')) return true;
    *problem = "is skewed by a quarter of a turn, which no drawing shows";
    return false;
  } else if (strcmp(word, "matrix") == 0 && count == MOST) {
    tp_affine_map inner;
    tp_affine_map_init(&inner);
    fmpq *const places[MOST] = {inner.a, inner.b, inner.c, inner.d, inner.e, inner.f};
    for (int k = 0; k < MOST; k++) fmpq_set(places[k], n + k);
    tp_affine_map_compose(map, &inner);
    tp_affine_map_clear(&inner);
  } else {
    return false;
  }
  return true;
}

/* "rotate(30, 10, 10)", from its word on. */
static bool apply_next(tp_affine_map *map, tp_svg_text *text) {
  enum { WORD = 16 };
  static const char problem[] = "has a transform that is none of SVG's: matrix, translate, scale, "
                                "rotate, skewX, skewY";
  char word[WORD] = "";
  size_t length = 0;
  while (text->at < text->end && !is_blank(*text->at) && *text->at != '(' && length + 1 < WORD) {
    word[length++] = *text->at++;
  }
  skip(text);
  if (text->at == text->end || *text->at != '(') {
    text->problem = problem;
    return false;
  }
  text->at++;
  fmpq numbers[MOST];
  for (int k = 0; k < MOST; k++) fmpq_init(numbers + k);
  int count = 0;
  while (count < MOST && tp_svg_at_number(text) && tp_svg_number(text, numbers + count)) count++;
  skip(text);
  const bool closed = text->problem == NULL && text->at < text->end && *text->at == ')';
  const bool done = closed && apply(map, word, numbers, count, &text->problem);
  if (!done && text->problem == NULL) text->problem = problem;
  for (int k = 0; k < MOST; k++) fmpq_clear(numbers + k);
  if (done) text->at++;
  return done;
}

bool tp_svg_transform(tp_affine_map *map, tp_svg_text *text) {
  for (skip(text); text->at < text->end; skip(text)) {
    if (!apply_next(map, text)) return false;
    text->problem = tp_drawing_map_problem(map);
    if (text->problem != NULL) return false;
  }
  return true;
}
