/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A call that sets takes the place of those before it, and some drop what others set: the base what
 * narrowed or widened it, two vertices of the contact its bounds, and the other way round. */

#include "build_calls.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct file {
  FILE *out;
  const build_call *last[SLOTS]; /* of the calls that are done */
  const build_call *calls;
  const bool *done;
  size_t count;
} file;

static void settle(file *f) {
  for (size_t k = 0; k < f->count; k++) {
    const build_call *call = f->calls + k;
    if (!f->done[k]) continue;
    const build_slot slot = call->kind->slot;
    if (slot == SLOT_BASE) f->last[SLOT_BEYOND] = NULL;
    if (slot == SLOT_BASE || slot == SLOT_BOUND) f->last[SLOT_BETWEEN] = NULL;
    if (slot == SLOT_BASE || slot == SLOT_BETWEEN) {
      for (int bound = 0; bound < 3; bound++) f->last[SLOT_BOUND + bound] = NULL;
    }
    f->last[slot == SLOT_BOUND ? SLOT_BOUND + call->choice : (int)slot] = call;
  }
}

/* A double is the fraction that it is; the 53 bits of it are a whole number. */
static void put_number(FILE *out, tp_exact number) {
  int exponent = 0;
  if (number.text != NULL) {
    fputs(number.text, out);
    return;
  }
  if (fabs(number.value) < 1e9 && number.value == floor(number.value)) {
    fprintf(out, "%.0f", number.value + 0); /* not -0 */
    return;
  }
  const double mantissa = ldexp(frexp(number.value, &exponent), 53);
  exponent -= 53;
  fprintf(out, "%.0f%c2^%d", mantissa, exponent < 0 ? '/' : '*',
          exponent < 0 ? -exponent : exponent);
}

static void put_points(FILE *out, tp_coordinates points) {
  fputc('[', out);
  for (size_t k = 0; k < 2 * points.count; k++) {
    fputs(k == 0 ? "[" : k % 2 == 0 ? "], [" : ", ", out);
    put_number(out,
               points.texts != NULL ? tp_exact_text(points.texts[k]) : tp_exact_of(points.xy[k]));
  }
  fputs(points.count > 0 ? "]]" : "]", out);
}

static void put_call(FILE *out, const build_call *call) {
  static const char *const words[] = {"false", "true"};
  for (const char *at = call->kind->file; *at != '\0'; at++) {
    if (*at != '$') {
      fputc(*at, out);
      continue;
    }
    switch (*++at) {
    case 'p':
      put_points(out, call->points);
      break;
    case 'c':
      fprintf(out, "%ld", call->count);
      break;
    case 'e':
      fputs(call->kind->names[call->choice], out);
      break;
    case 'y':
      fputs(words[call->choice & 1], out);
      break;
    case 'z':
      fputs(words[(call->choice & 2) != 0], out);
      break;
    default:
      put_number(out, call->numbers[*at - '0']);
    }
  }
}

static void put_slot(const file *f, int slot) {
  if (f->last[slot] == NULL) return;
  put_call(f->out, f->last[slot]);
  fputs(", ", f->out);
}

static void put_list(const file *f, build_slot slot, const char *key) {
  if (f->last[slot] == NULL) return;
  fprintf(f->out, "%s: [", key);
  for (size_t k = 0; k < f->count; k++) {
    if (!f->done[k] || f->calls[k].kind->slot != slot) continue;
    put_call(f->out, f->calls + k);
    fputs(", ", f->out);
  }
  fputs("], ", f->out);
}

static void put_block(const file *f) {
  fputs("block: {", f->out);
  put_slot(f, SLOT_SHAPE);
  put_list(f, SLOT_HOLES, "holes");
  put_list(f, SLOT_PARTS, "parts");
  put_list(f, SLOT_ARCS, "arcs");
  if (f->last[SLOT_CORNERS] != NULL) {
    fputs("rounded: {", f->out);
    if (f->last[SLOT_MODEL] != NULL) put_call(f->out, f->last[SLOT_MODEL]);
    put_list(f, SLOT_CORNERS, "corners");
    fputs("}, ", f->out);
  }
  for (int slot = SLOT_REPAIR; slot <= SLOT_UNIT_WEIGHT; slot++) put_slot(f, slot);
  fputs("}\n", f->out);
}

static void put_base(const file *f) {
  fputs("base: {", f->out);
  if (f->last[SLOT_BASE] == NULL) fputs("mated: true, ", f->out);
  put_slot(f, SLOT_BASE);
  put_slot(f, SLOT_BETWEEN);
  put_slot(f, SLOT_BEYOND);
  bool bounds = false;
  for (int k = SLOT_BOUND; k < SLOT_BEYOND; k++) bounds = bounds || f->last[k] != NULL;
  if (bounds) {
    fputs("between: {", f->out);
    for (int k = SLOT_BOUND; k < SLOT_BEYOND; k++) put_slot(f, k);
    fputc('}', f->out);
  }
  fputs("}\n", f->out);
}

static void put_loads(const file *f) {
  bool any = false;
  for (int k = SLOT_HORIZONTAL; k <= SLOT_COHESION; k++) any = any || f->last[k] != NULL;
  if (!any) return;
  fputs("loads: {", f->out);
  if (f->last[SLOT_HORIZONTAL] != NULL || f->last[SLOT_VERTICAL] != NULL) {
    fputs("seismic: {", f->out);
    put_slot(f, SLOT_HORIZONTAL);
    put_slot(f, SLOT_VERTICAL);
    fputs("}, ", f->out);
  }
  put_slot(f, SLOT_WATER);
  put_list(f, SLOT_PRESSURES, "pressures");
  put_list(f, SLOT_SURCHARGES, "surcharges");
  put_list(f, SLOT_SUPPORTS, "support_pressures");
  put_list(f, SLOT_ANCHORS, "anchors");
  put_slot(f, SLOT_BOND);
  put_slot(f, SLOT_COHESION);
  fputs("}\n", f->out);
}

/* A law takes facets into its map; an angle stands beside theirs. */
static void put_friction(const file *f) {
  const build_call *own = f->last[SLOT_FRICTION];
  const bool law = own != NULL && strncmp(own->kind->file, "friction: ", 10) == 0;
  const bool facets = f->last[SLOT_FACETS] != NULL;
  if (own != NULL) put_call(f->out, own);
  fputs(law ? ", " : facets ? "\nfriction: {" : "\n", f->out);
  put_list(f, SLOT_FACETS, "facets");
  if (law || facets) fputs("}\n", f->out);
}

char *build_file(const char *length_unit, const build_call *calls, const bool *done, size_t count) {
  char *text = NULL;
  size_t length = 0;
  file f = {.out = open_memstream(&text, &length), .calls = calls, .done = done, .count = count};
  FUZZ_EXPECT(f.out != NULL);
  settle(&f);
  fprintf(f.out, "topple: 1\nlength_unit: %s\n", length_unit);
  if (f.last[SLOT_TITLE] != NULL) {
    put_call(f.out, f.last[SLOT_TITLE]);
    fputc('\n', f.out);
  }
  put_block(&f);
  put_base(&f);
  put_loads(&f);
  put_friction(&f);
  if (f.last[SLOT_FRAME] != NULL) {
    put_call(f.out, f.last[SLOT_FRAME]);
    fputc('\n', f.out);
  }
  if (f.last[SLOT_TOWARDS] != NULL || f.last[SLOT_ANGLE] != NULL) {
    fputs("tilt: {", f.out);
    put_slot(&f, SLOT_TOWARDS);
    put_slot(&f, SLOT_ANGLE);
    fputs("}\n", f.out);
  }
  fclose(f.out);
  return text;
}
