/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Loads of many blocks besides weights and an earthquake, and the support that is asked for, on
 * their page. */

#include "report/system_page.h"
#include "report/system_words.h"
#include "terms/names.h"

#include <stdio.h>

static const double kilo = 1e3;

/* No motion can begin with strength divided by the factor, as the blocks lie. */
static bool stands_without(const tp_system_case *c) {
  const double wanted = c->support.fos.value;
  if (c->verdict != TP_SYSTEM_STANDS) return false;
  return wanted <= 1 || (c->has_standing_fos && c->standing_fos >= wanted);
}

/* Forces for which nothing can move are rounded towards these, and others away. */
static const char *force_up(char n[TP_NUMBER_SIZE], double force_n_m) {
  return tp_text_significant_up(n, (tp_bounded){.value = force_n_m / kilo}, 5);
}

static const char *force_down(char n[TP_NUMBER_SIZE], double force_n_m) {
  return tp_text_significant_down(n, (tp_bounded){.value = force_n_m / kilo}, 5);
}

/* A motion is proven with as much as the method has. */
static bool moves_with_method(const tp_system_support *own) {
  return own->has_moving && own->goodman_bray_n_m <= own->moving_n_m;
}

void tp_text_system_design_support(tp_text *t, const tp_system_case *c) {
  const tp_system_support *own = &c->support;
  char n[TP_NUMBER_SIZE];
  if (stands_without(c)) {
    tp_text_add(t, "none needed: no motion can begin");
  } else if (own->state == TP_SYSTEM_SUPPORT_NONE) {
    tp_text_add(t, "no such force holds the blocks");
  } else if (own->has_goodman_bray && own->goodman_bray_n_m > 0 && !moves_with_method(own)) {
    tp_text_add(t, "%.5g kN/m, by Goodman and Bray", own->goodman_bray_n_m / kilo);
  } else if (own->has_standing) {
    tp_text_add(t, "%s kN/m: no motion can begin", force_up(n, own->standing_n_m));
  } else if (own->has_goodman_bray && own->goodman_bray_n_m > 0) {
    tp_text_add(t, "no design value: with %.5g kN/m, by Goodman and Bray, a motion can begin",
                own->goodman_bray_n_m / kilo);
  } else if (own->has_goodman_bray && c->verdict != TP_SYSTEM_MAY_MOVE && !own->has_moving) {
    tp_text_add(t, "none needed, by Goodman and Bray");
  } else if (own->has_goodman_bray) {
    tp_text_add(t, "no design value: by Goodman and Bray none is needed, but a motion can begin");
  } else {
    tp_text_add(t, "no design value: that no motion can begin is not proven");
  }
}

bool tp_text_system_optimistic_support(tp_text *t, const tp_system_case *c) {
  if (stands_without(c)) return false;
  switch (c->support.state) {
  case TP_SYSTEM_SUPPORT_NUMBER:
    tp_text_add(t, "%.5g kN/m", c->support.force_n_m.value / kilo);
    return true;
  case TP_SYSTEM_SUPPORT_NOT_NEEDED:
    tp_text_add(t, "none");
    return true;
  case TP_SYSTEM_SUPPORT_UNDECIDED:
    tp_text_add(t, "undecided");
    return true;
  case TP_SYSTEM_SUPPORT_NONE:
    break;
  }
  return false;
}

bool tp_text_system_standing_support(tp_text *t, const tp_system_case *c) {
  const tp_system_support *own = &c->support;
  char n[3][TP_NUMBER_SIZE];
  if (!own->was_sought || stands_without(c)) return false;
  const char *moving = own->has_moving ? force_down(n[2], own->moving_n_m) : "";
  if (own->has_standing && own->has_moving) {
    tp_text_add(t, "%s to %s kN/m; a motion can begin with %s kN/m",
                force_up(n[0], own->standing_n_m), force_down(n[1], own->standing_to_n_m), moving);
  } else if (own->has_standing) {
    tp_text_add(t, "%s to %s kN/m", force_up(n[0], own->standing_n_m),
                force_down(n[1], own->standing_to_n_m));
  } else if (own->has_moving) {
    tp_text_add(t, "undecided; a motion can begin with %s kN/m", moving);
  } else {
    tp_text_add(t, "undecided");
  }
  return true;
}

void tp_text_system_support(tp_text *t, const tp_block_system *s, const tp_system_case *c) {
  enum { LABEL = 64 };
  const tp_system_support *own = &c->support;
  const int digits = tp_text_system_digits(s) + 1;
  char label[LABEL], n[TP_NUMBER_SIZE], name[LABEL];
  tp_text optimistic = {0}, standing = {0};
  if (!c->has_support) return;
  snprintf(label, sizeof label, "support for a factor of %s", tp_text_significant(n, own->fos, 5));
  tp_text_system_label(t, label);
  tp_text_system_design_support(t, c);
  tp_plain_text(name, sizeof name, s->blocks[own->block].name);
  tp_text_add(t, "\n    on '%s' at (%.*g, %.*g), towards %.5g° from x towards y\n", name, digits,
              own->x_m.value / s->metres_per_unit, digits, own->y_m.value / s->metres_per_unit,
              own->direction_deg.value);
  if (tp_text_system_standing_support(&standing, c) && !standing.failed) {
    tp_text_system_label(t, "no motion can begin with");
    tp_text_add(t, "%s\n", standing.data);
  }
  if (tp_text_system_optimistic_support(&optimistic, c) && !optimistic.failed) {
    tp_text_system_label(t, "optimistic: forces can hold with");
    tp_text_add(t, "%s, but a motion may begin\n", optimistic.data);
  }
  t->failed = t->failed || optimistic.failed || standing.failed;
  tp_text_drop(&optimistic);
  tp_text_drop(&standing);
}

void tp_text_system_loads(tp_text *t, const tp_block_system *s, const tp_system_case *c,
                          int width) {
  enum { KIND = 16 };
  if (c->load_count == 0) return;
  tp_text_add(t, "\n  Loads besides weights%s, with moments about centroids:\n",
              c->tilt_angle_deg.value != 0 ? ", in the axes of the scene" : "");
  tp_text_add(t, "  %-*s  %-*s  %10s  %10s  %10s\n", KIND, "load", width, "on", "x kN/m", "y kN/m",
              "M kNm/m");
  for (size_t k = 0; k < c->load_count && k < TP_SYSTEM_ROWS; k++) {
    const tp_system_load *own = c->loads + k;
    tp_text_add(t, "  %-*s  ", KIND, tp_system_load_kind_name(own->kind));
    tp_text_system_name(t, s->blocks[own->block].name, width);
    tp_text_add(t, "  %10.4g  %10.4g  %10.4g\n", own->force_x_n_m.value / kilo,
                own->force_y_n_m.value / kilo, own->moment_n.value / kilo);
  }
  tp_text_more_rows(t, c->load_count);
}

bool tp_system_case_is_wet(const tp_system_case *c) {
  for (size_t k = 0; k < c->force_count; k++) {
    if (c->forces[k].water_n_m.value != 0) return true;
  }
  return false;
}
