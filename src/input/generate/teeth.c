/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Toothed profiles from wavelength, amplitude and skew, each with a uniform scatter per tooth from
 * a counter-based random stream; coordinates are exact, or rounded to ticks where they are
 * scattered (docs/generate.md; docs/mechanics.md section 8). */

#include "generate/generate.h"
#include "generate/random.h"
#include "generate/ticks.h"

#include <math.h>

/* What is scattered has numbers of its own: three a tooth. */
enum { OF_WAVELENGTH, OF_SKEW, OF_AMPLITUDE, EACH };

/* What the chain is made by. */
typedef struct teeth {
  const tp_teeth_options *o;
  uint64_t stream;
  bool moves_x, moves_y;              /* x or y is scattered */
  tp_ticks x, y;                      /* of rounded coordinates; the units of exact ones */
  double wavelength, skew, amplitude; /* the first and the last in ticks */
  double of_wavelength, of_skew, of_amplitude;
  fmpq_t rising, falling; /* runs of the facets where they are all alike */
} teeth;

void tp_teeth_options_init(tp_teeth_options *options) {
  *options = (tp_teeth_options){.left_end_valley = true};
  fmpq_init(options->wavelength);
  fmpq_init(options->amplitude);
  fmpq_init(options->skew);
  fmpq_init(options->wavelength_scatter);
  fmpq_init(options->amplitude_scatter);
  fmpq_init(options->skew_scatter);
  fmpq_init(options->x);
  fmpq_init(options->y);
}

void tp_teeth_options_clear(tp_teeth_options *options) {
  fmpq_clear(options->wavelength);
  fmpq_clear(options->amplitude);
  fmpq_clear(options->skew);
  fmpq_clear(options->wavelength_scatter);
  fmpq_clear(options->amplitude_scatter);
  fmpq_clear(options->skew_scatter);
  fmpq_clear(options->x);
  fmpq_clear(options->y);
}

/* Coordinates in ticks of a millionth of `size`; in them `size` is the result. */
static double begin_ticks(tp_ticks *ticks, const fmpq_t origin, const fmpq_t size, bool scattered) {
  fmpq_t unit;
  fmpq_init(unit);
  if (scattered) {
    tp_ticks_millionth(unit, size);
  } else {
    fmpq_set(unit, size);
  }
  tp_ticks_init(ticks, origin, unit);
  fmpq_div(unit, size, unit);
  const double in_ticks = fmpq_get_d(unit);
  fmpq_clear(unit);
  return in_ticks;
}

static void begin(teeth *t, const tp_teeth_options *o) {
  *t = (teeth){.o = o, .stream = tp_random_stream(o->seed, TP_STREAM_TEETH)};
  t->moves_x = !fmpq_is_zero(o->wavelength_scatter) || !fmpq_is_zero(o->skew_scatter);
  t->moves_y = !fmpq_is_zero(o->amplitude_scatter);
  t->wavelength = begin_ticks(&t->x, o->x, o->wavelength, t->moves_x);
  t->amplitude = begin_ticks(&t->y, o->y, o->amplitude, t->moves_y);
  t->skew = fmpq_get_d(o->skew);
  t->of_wavelength = fmpq_get_d(o->wavelength_scatter);
  t->of_skew = fmpq_get_d(o->skew_scatter);
  t->of_amplitude = fmpq_get_d(o->amplitude_scatter);
  fmpq_init(t->rising);
  fmpq_init(t->falling);
  fmpq_div_2exp(t->falling, o->wavelength, 1);
  fmpq_mul(t->rising, t->falling, o->skew);
  fmpq_sub(t->falling, t->falling, t->rising);
  fmpq_sub(t->rising, o->wavelength, t->falling);
}

static void end(teeth *t) {
  tp_ticks_clear(&t->x);
  tp_ticks_clear(&t->y);
  fmpq_clear(t->rising);
  fmpq_clear(t->falling);
}

static double draw(const teeth *t, long tooth, int what) {
  return tp_random_even((uint32_t)tp_random_bits(t->stream, (uint64_t)tooth * EACH + what));
}

/* The run of a facet in ticks: a whole number, above 2000 as ranges are. */
static int64_t run(const teeth *t, long tooth, bool rises) {
  const double wavelength = t->wavelength * (1 + t->of_wavelength * draw(t, tooth, OF_WAVELENGTH));
  const double skew = t->skew + t->of_skew * draw(t, tooth, OF_SKEW);
  return (int64_t)floor(wavelength * (rises ? 1 + skew : 1 - skew) / 2 + 0.5);
}

static void set_height(fmpq_t y, const teeth *t, long vertex, bool peak) {
  if (!peak) {
    fmpq_set(y, t->o->y);
  } else if (t->moves_y) {
    const double own = t->amplitude * (1 + t->of_amplitude * draw(t, vertex / 2, OF_AMPLITUDE));
    tp_ticks_at(y, &t->y, (int64_t)floor(own + 0.5));
  } else {
    fmpq_add(y, t->o->y, t->o->amplitude);
  }
}

bool tp_generate_teeth(tp_polyline *line, const tp_teeth_options *o) {
  tp_polyline own = {.file = line->file, .mark = line->mark};
  if (!tp_polyline_reserve(&own, o->count + 1)) {
    tp_polyline_clear(&own);
    return false;
  }
  teeth t;
  fmpq_t x, y;
  begin(&t, o);
  fmpq_init(x);
  fmpq_init(y);
  fmpq_set(x, o->x);
  int64_t ticks = 0;
  bool room = true;
  for (long v = 0; v <= o->count && room; v++) {
    const bool peak = (v % 2 == 1) == o->left_end_valley;
    set_height(y, &t, v, peak);
    room = tp_polyline_append(&own, x, y, line->mark);
    if (t.moves_x) {
      ticks += run(&t, v / 2, !peak);
      tp_ticks_at(x, &t.x, ticks);
    } else {
      fmpq_add(x, x, peak ? t.falling : t.rising);
    }
  }
  fmpq_clear(x);
  fmpq_clear(y);
  end(&t);
  if (room) {
    *line = own;
  } else {
    tp_polyline_clear(&own);
  }
  return room;
}
