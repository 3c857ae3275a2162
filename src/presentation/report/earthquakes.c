/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One line, or one JSON object, for each combination of direction and vertical part, with its
 * mechanism and factor of safety. */

#include "report/earthquakes.h"

#include "report/parts_json.h"
#include "report/words.h"
#include "terms/names.h"

void tp_text_earthquake(tp_text *t, const tp_solution *s, const tp_earthquake *own) {
  bool vertical = false;
  for (size_t k = 0; k < s->earthquake_count; k++) vertical |= s->earthquakes[k].vertical;
  const char *part = !vertical ? "" : own->vertical ? ", with k_v" : ", without k_v";
  tp_text_add(t, "to the %s, %s%s", tp_direction_name(own->towards),
              own->up_dip ? "up-dip" : "down-dip", part);
}

static void add_factor(tp_text *t, tp_fos fos) {
  char n[TP_NUMBER_SIZE];
  if (fos.state == TP_FOS_NUMBER) {
    tp_text_add(t, ", FoS %s", tp_text_fixed_down(n, fos.value, 3));
  } else if (tp_text_fos(fos) != NULL) {
    tp_text_add(t, ", FoS: %s", tp_text_fos(fos));
  }
}

void tp_page_add_earthquakes(tp_page *p) {
  const tp_solution *s = p->solution;
  for (size_t k = 0; k < s->earthquake_count; k++) {
    const tp_earthquake *own = s->earthquakes + k;
    tp_text_add(&p->text, k == 0 ? "Seismic  shaken " : "         shaken ");
    tp_text_earthquake(&p->text, s, own);
    tp_text_add(&p->text, ": %s", tp_mechanism_name(own->mechanism));
    if (own->fails_against) {
      tp_text_add(&p->text, " %s all the same", own->up_dip ? "down-dip" : "up-dip");
    } else {
      add_factor(&p->text, own->fos);
    }
    tp_text_add(&p->text, k + 1 < s->earthquake_count ? ";\n" : ".\n");
  }
  if (s->earthquake_count > 0) {
    tp_text_add(&p->text, "         The first of them governs, and what follows is of it.\n");
  }
}
