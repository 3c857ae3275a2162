/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The words of a chart in another language: titles of panels, axes, labels and the legend, but what
 * is a user's; what no phrase has stays English. */

#include "chart/chart.h"
#include "output/text.h"
#include "output/translate.h"

#include <stdlib.h>

static bool tell(char **words, const tp_language *language, bool comma) {
  tp_text own = {0};
  if (*words == NULL || **words == '\0') return true;
  tp_translate(&own, language, comma, *words);
  char *told = NULL;
  if (tp_text_finish(&own, &told) != TP_OK) return false;
  free(*words);
  *words = told;
  return true;
}

static bool tell_axis(tp_panel_axis *axis, const tp_language *language, bool comma) {
  char *label = (char *)axis->label; /* the chart's own copy */
  const bool done = axis->plain || tell(&label, language, comma);
  axis->label = label;
  return done;
}

bool tp_chart_tell(tp_chart *chart, const tp_language *language, bool comma) {
  bool done = true;
  chart->comma = comma;
  for (size_t k = 0; k < chart->panel_count; k++) {
    tp_chart_panel *panel = chart->panels + k;
    done = done && tell(&panel->title, language, comma) && tell_axis(&panel->x, language, comma) &&
           tell_axis(&panel->y, language, comma);
  }
  for (size_t k = 0; k < chart->label_count; k++) {
    tp_chart_label *label = chart->labels + k;
    done = done && (label->plain || tell(&label->text, language, comma));
  }
  for (size_t k = 0; k < chart->legend_count; k++) {
    done = done && tell(&chart->legend[k].text, language, comma);
  }
  return done;
}
