/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* List of the loads that a scene names, with the call that evaluates each as a wrench
 * (docs/mechanics.md section 5) and the time it takes. */

#include "load/loads.h"
#include "common/clock.h"
#include "scene/anchor.h"

const char *tp_load_name(tp_load_kind kind) {
  static const char *const names[] = {"weight", "seismic",  "water",     "uplift",
                                      "ice",    "pressure", "surcharge", "support pressure",
                                      "anchor"};
  return names[kind];
}

static bool is_seismic(const tp_loads_description *loads) {
  return loads->horizontal.given || loads->vertical.given;
}

static bool pushes(const tp_water_description *water) {
  return water->given && !water->lifts_alone;
}

static bool is_iced(const tp_loads_description *loads) {
  return tp_water_is_sited(&loads->water) && !fmpq_is_zero(loads->water.ice_kpa.value);
}

/* Sited water may press on faces whichever way the block goes. */
static bool presses(const tp_water_description *water) {
  return pushes(water) || tp_water_is_sited(water);
}

/* Each row of bolts is a load. */
static long anchor_count(const tp_loads_description *loads) {
  long count = 0;
  for (long k = 0; k < loads->anchor_count; k++) count += tp_anchor_rows(loads->anchors + k);
  return count;
}

long tp_loads_count(const tp_loads_description *loads) {
  return 1 + is_seismic(loads) + presses(&loads->water) +
         (loads->water.given && loads->water.uplift) + is_iced(loads) + loads->pressure_count +
         loads->surcharge_count + loads->support_count + anchor_count(loads);
}

bool tp_loads_are_called_for(const tp_loads_description *loads) {
  return tp_loads_count(loads) > 1 || loads->bond_kpa.given || loads->cohesion_kpa.given;
}

static tp_load *next(tp_load **loads, tp_load_kind kind, tp_place place) {
  tp_load *own = (*loads)++;
  own->kind = kind;
  own->place = place;
  own->began = tp_clock_now();
  return own;
}

static void evaluate_water(tp_load **loads, const tp_load_setting *s) {
  const tp_water_description *water = &s->scene->loads.water;
  if (presses(water)) {
    tp_load *own = next(loads, TP_LOAD_WATER, water->place);
    if (s->wetted != NULL) {
      tp_load_wet_lines(&own->wrench, &s->wetted->faces, s);
    } else {
      tp_load_water(&own->wrench, s);
    }
  }
  if (water->given && water->uplift) {
    tp_load *own = next(loads, TP_LOAD_UPLIFT, water->place);
    if (s->wetted != NULL) {
      tp_load_wet_lines(&own->wrench, &s->wetted->joint, s);
    } else {
      tp_load_uplift(&own->wrench, s);
    }
  }
  if (is_iced(&s->scene->loads)) {
    tp_load_wet_lines(&next(loads, TP_LOAD_ICE, water->ice_kpa.place)->wrench, &s->wetted->ice, s);
  }
}

static tp_load *next_line(tp_load **loads, tp_load_kind kind, const tp_line_load *line) {
  tp_load *own = next(loads, kind, line->place);
  own->line = line;
  return own;
}

static void evaluate_rows(tp_load **loads, const tp_anchor_description *anchor,
                          const tp_load_setting *s) {
  for (long row = 0; row < tp_anchor_rows(anchor); row++) {
    tp_load *own = next(loads, TP_LOAD_ANCHOR, anchor->place);
    own->anchor = anchor;
    own->row = row;
    own->active = !anchor->passive;
    own->passive = anchor->passive;
    tp_load_anchor(&own->wrench, anchor, row, s);
  }
}

void tp_loads_evaluate(tp_load *loads, const tp_load_setting *s) {
  const tp_loads_description *d = &s->scene->loads;
  tp_load_weight(&next(&loads, TP_LOAD_WEIGHT, s->scene->block.place)->wrench, s);
  if (is_seismic(d)) tp_load_seismic(&next(&loads, TP_LOAD_SEISMIC, d->seismic_place)->wrench, s);
  evaluate_water(&loads, s);
  for (long k = 0; k < d->pressure_count; k++) {
    const tp_line_load *load = d->pressures + k;
    tp_load_pressure(&next_line(&loads, TP_LOAD_PRESSURE, load)->wrench, load, s);
  }
  for (long k = 0; k < d->surcharge_count; k++) {
    const tp_line_load *load = d->surcharges + k;
    tp_load_surcharge(&next_line(&loads, TP_LOAD_SURCHARGE, load)->wrench, load, s);
  }
  for (long k = 0; k < d->support_count; k++) {
    const tp_line_load *load = d->supports + k;
    tp_load *own = next_line(&loads, TP_LOAD_SUPPORT, load);
    own->active = !load->passive;
    own->passive = load->passive;
    tp_load_pressure(&own->wrench, load, s);
  }
  for (long k = 0; k < d->anchor_count; k++) evaluate_rows(&loads, d->anchors + k, s);
}
