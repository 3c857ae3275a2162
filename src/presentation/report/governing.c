/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The governing factor with its mechanism and definition, then the table of all factors with the
 * reason why one does not count; the same as JSON. */

#include "report/governing.h"

#include "report/parts_json.h"
#include "report/words.h"

#include <math.h>
#include <stdio.h>

void tp_text_against(tp_text *t, const tp_factor *factor) {
  if (factor->definition == TP_FOS_BY_MOMENTS) {
    if (factor->toe) {
      tp_text_add(t, "toppling about the toe");
    } else {
      tp_text_add(t, "toppling about pivot %zu", factor->pivot + 1);
    }
    return;
  }
  tp_text_add(t, "%s", tp_text_motion(factor->mechanism));
}

/* Which way is meant, and how: "against toppling about the toe (moments)" */
static void add_way(tp_text *t, const tp_governing_fos *g) {
  if (!g->has_factor) return;
  const tp_factor *factor = g->factors + g->factor;
  tp_text_add(t, " against ");
  tp_text_against(t, factor);
  tp_text_add(t, " (%s)", tp_fos_definition_name(factor->definition));
}

void tp_text_factor(tp_text *t, const tp_governing_fos *g) {
  char n[TP_NUMBER_SIZE];
  switch (g->fos.state) {
  case TP_FOS_NUMBER:
    tp_text_add(t, "FoS %s%s", g->sliding_judged && !g->complete ? "at most " : "",
                tp_text_fixed_down(n, g->fos.value, 3));
    add_way(t, g);
    return;
  case TP_FOS_NO_OVERTURNING:
    tp_text_add(t, "FoS unbounded: no driving action at this tilt");
    return;
  case TP_FOS_UNDEFINED:
    if (g->up_dip) {
      tp_text_add(t, "No FoS: at this tilt it fails up-dip");
    } else if (g->beyond) {
      tp_text_add(t, "No FoS: it already fails at a lower tilt");
    } else if (g->has_factor && g->factors[g->factor].definition == TP_FOS_BY_DRIVING) {
      tp_text_add(t, "No FoS: a motion can begin even without driving loads");
    } else {
      tp_text_add(t, "No FoS");
      add_way(t, g);
      tp_text_add(t, ": no forces hold it");
    }
    return;
  case TP_FOS_UNDECIDED:
    tp_text_add(t, "FoS undecided at the precision allowed");
    if (g->at_least > 0)
      tp_text_add(t, ", at least %s", tp_text_fixed_down(n, (tp_bounded){.value = g->at_least}, 3));
    if (isfinite(g->at_most))
      tp_text_add(t, ", at most %s", tp_text_fixed_up(n, (tp_bounded){.value = g->at_most}, 3));
    return;
  case TP_FOS_NOT_ASKED:
    tp_text_add(t, "No FoS: turning is blocked about every pivot");
    return;
  case TP_FOS_NO_TILT:
    break;
  }
}

static void add_required(tp_text *t, const tp_governing_fos *g, const char *space) {
  static const char *const words[] = {"is met", "is not met", "may not be met: undecided"};
  char n[TP_NUMBER_SIZE];
  if (!g->has_required_fos) return;
  tp_text_add(t, "; the required %s %s", tp_text_significant(n, g->required_fos, 6),
              words[g->meets_required]);
  if (g->has_design_utilisation) {
    tp_text_add(t, ",%srequired/FoS %s", space, tp_text_fixed_up(n, g->design_utilisation, 3));
  }
}

void tp_text_governing(tp_text *t, const tp_case *c, const char *space) {
  const tp_governing_fos *g = &c->governing_fos;
  if (g->fos.state == TP_FOS_NO_TILT) return;
  tp_text_factor(t, g);
  if (!g->sliding_judged) tp_text_add(t, "; sliding is not judged");
  if (g->tie) tp_text_add(t, "; a tie");
  add_required(t, g, space);
}

static const char *long_definition(const tp_factor *factor, bool loaded) {
  switch (factor->definition) {
  case TP_FOS_BY_MOMENTS:
    return "moments: stabilising over overturning";
  case TP_FOS_BY_SHEAR:
    return loaded ? "shear strength over force along the facet"
                  : "shear strength on the facet: tan φ/tan(α−i)";
  case TP_FOS_BY_ROUGHNESS:
    return "shear strength, mean plane: tan(φ+i)/tan α";
  case TP_FOS_BY_REDUCTION:
    if (!factor->raised) return "strength reduction, by contact forces";
    return factor->fos.value.value < 1 ? "strength reduction: with less it would stand"
                                       : "strength raised: with more it can move";
  case TP_FOS_BY_DRIVING:
    return loaded ? "driving loads, by contact forces" : "driving loads: tan α_s/tan α";
  }
  return "";
}

const char *tp_text_standing(tp_factor_standing standing) {
  switch (standing) {
  case TP_FACTOR_BLOCKED:
    return "sliding is blocked by a facet";
  case TP_FACTOR_PREVENTED:
    return "another motion begins first";
  case TP_FACTOR_UNEVEN:
    return "its facets differ in friction";
  case TP_FACTOR_SMOOTH:
    return "no friction to reduce";
  case TP_FACTOR_UNAFFECTED:
    return "strength does not decide it";
  case TP_FACTOR_COUNTS:
    break;
  }
  return "counts";
}

static void add_row(tp_page *p, const tp_governing_fos *g, size_t k) {
  const tp_factor *factor = g->factors + k;
  char n[TP_NUMBER_SIZE];
  tp_text against = {0};
  tp_text_against(&against, factor);
  tp_text_add(&p->text, "%s %-9s %-23s %s\n", g->has_factor && k == g->factor ? ">" : " ",
              tp_page_fos(n, factor->fos), against.failed ? "" : against.data,
              long_definition(factor, p->solution->loaded));
  if (!factor->counts) {
    tp_text_add(&p->text, "%36s(excluded: %s)\n", "", tp_text_standing(factor->standing));
  }
  if (factor->definition == TP_FOS_BY_REDUCTION && factor->fos.state == TP_FOS_UNDEFINED) {
    tp_text_add(&p->text, "%36s(not certain to stand at any strength)\n", "");
  }
  p->text.failed = p->text.failed || against.failed;
  tp_text_drop(&against);
}

void tp_page_add_governing(tp_page *p, const tp_case *c) {
  const tp_governing_fos *g = &c->governing_fos;
  if (g->fos.state == TP_FOS_NO_TILT) return;
  tp_text_add(&p->text, "  ");
  tp_text_governing(&p->text, c, "\n  ");
  tp_text_add(&p->text, "\n");
  if (g->factor_count < 2) {
    tp_text_add(&p->text, "\n");
    return;
  }
  tp_text_add(&p->text, "\n  %-9s %-23s %s\n", "FoS", "against", "by");
  for (size_t k = 0; k < g->factor_count; k++) add_row(p, g, k);
  tp_text_add(&p->text, "\n");
}
