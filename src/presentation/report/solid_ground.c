/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solid on a mesh of the ground: its bands as text. */

#include "output/encode.h"
#include "report/results.h"
#include "report/solid_page.h"
#include "terms/names.h"

#include <string.h>

static const char *name_of(const char *file) {
  const char *slash = strrchr(file, '/');
  return slash != NULL ? slash + 1 : file;
}

static void add_number(tp_text *t, bool has, tp_bounded number, const char *unit) {
  char n[TP_NUMBER_SIZE];
  tp_text_add(t, "  %11s%s", has ? tp_text_significant(n, number, 7) : "–", has ? unit : "");
}

static void add_ground_factor(tp_text *t, bool has, tp_bounded factor) {
  char n[TP_NUMBER_SIZE];
  tp_text_add(t, "  %11s", has ? tp_text_significant_down(n, factor, 7) : "–");
}

static void add_band(tp_text *t, const tp_solid_ground_band *b) {
  tp_text_add(t, "  %10.6g  %7zu  %8zu  %8.3g m  %7.4g°", b->band, b->found, b->contacts,
              b->widest_m, b->normals_deg);
  add_number(t, b->has_critical, b->critical_deg, "°");
  add_ground_factor(t, b->has_fos, b->fos);
  tp_text_add(t, "  %s\n", tp_mechanism_name(b->verdict));
  if (!b->has_smooth || b->normals_deg == 0) return;
  tp_text_add(t, "  %42s  %8s ", "with the mean of all normals", "");
  add_number(t, b->has_smooth_critical, b->smooth_critical_deg, "°");
  add_ground_factor(t, b->has_smooth_fos, b->smooth_fos);
  tp_text_add(t, "  %s\n", tp_mechanism_name(b->smooth_verdict));
}

void tp_text_solid_ground(tp_text *t, const tp_solid *s) {
  const tp_solid_ground *g = &s->ground;
  char band[TP_SOLID_BAND_SIZE];
  if (!s->has_ground) return;
  tp_text_add(t, "\nOn the ground of ");
  tp_encode_plain(t, name_of(g->file));
  tp_text_add(t, ", %zu triangles; ", g->triangles);
  if (g->entered_m > 0) {
    tp_text_add(t, "the rock enters it by %.3g m at the most\n", g->entered_m);
  } else {
    tp_text_add(t, "the rock does not enter it\n");
  }
  tp_text_add(t, "  %10s  %7s  %8s  %10s  %8s  %12s  %11s  %s\n", tp_text_solid_band(band, s),
              "found", "contacts", "widest gap", "normals", "held up to", "factor", "at its tilt");
  for (size_t k = 0; k < g->band_count; k++) add_band(t, g->bands + k);
  const tp_solid_ground_band *least = g->bands + g->governing;
  tp_text_add(t,
              "  The least band, %.6g %s, governs: with a wider one more counts as touching, and "
              "more is held.\n  All that follows is of its contacts.\n",
              least->band, s->length_unit);
  if (least->normals_deg > 0) {
    tp_text_add(t,
                "  Normals are those of single triangles and edges, and differ by up to %.3g°: of "
                "a rough survey a part of\n  that is noise, and what is held between them may not "
                "be. With the mean of all normals nothing is wedged:\n  the lesser of both is the "
                "cautious answer.\n",
                least->normals_deg);
  }
}
