/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Layout of panels and legend in millimetres, then gnuplot commands for terminal, styles, axes,
 * labels and inline data. */

#include "chart/script.h"

#include "chart/log_ticks.h"
#include "output/encode.h"

#include <math.h>
#include <string.h>

/* Sizes in mm; letters of 7 points, about the least that journals take. */
static const double left_mm = 16, right_mm = 4, top_mm = 7, bottom_mm = 10.5, foot_mm = 1;
static const double between_columns_mm = 12, between_rows_mm = 7, between_titles_mm = 4,
                    between_names_mm = 5;
static const double legend_row_mm = 3.8, letter_mm = 1.3, sample_mm = 8, after_sample_mm = 1.5,
                    after_text_mm = 4;
static const double letter_points = 7;
static const double points_per_mm = 72 / 25.4, pixels_per_mm = 96 / 25.4, dots_per_mm = 300 / 25.4;

/* The colours of Okabe and Ito, which the colour-blind tell apart; grey for guides. */
static const char *const colours[] = {"#000000", "#E69F00", "#56B4E9", "#009E73", "#F0E442",
                                      "#0072B2", "#D55E00", "#CC79A7", "#8C8C8C"};
/* The same mixed with white, for regions; of different lightness in grey. */
static const char *const tints[] = {"#E8E8E8", "#F9DFA8", "#E8F5FC", "#B5DDCF", "#FCF9D9",
                                    "#CCE3F0", "#F7DFCC", "#DDB8CE", "#BDBDBD"};
static const char *const dashes[] = {"solid", "(6,3)", "(2,3)", "(8,3,1.5,3)", "(14,4)"};

enum { LEGEND_COLUMNS_MAX = 6 };

typedef struct sheet {
  const tp_chart *chart;
  tp_chart_format format;
  double width_mm, height_mm;
  size_t rows, legend_columns, legend_rows;
  double legend_at_mm[LEGEND_COLUMNS_MAX];
} sheet;

/* Letters as they are drawn: without markup, a letter of several bytes once. */
static size_t letters(const char *text) {
  size_t count = 0;
  for (; *text != '\0'; text++) {
    if (strncmp(text, "{/:Italic ", 10) == 0) text += 10;
    const bool markup = *text == '{' || *text == '}' || *text == '_';
    count += !markup && ((unsigned char)*text & 0xc0) != 0x80;
  }
  return count;
}

/* The legend in so many columns, each as wide as its longest text, amid the sheet; false where the
 * sheet is too narrow for it. */
static bool lay_out_legend(sheet *s, size_t columns) {
  const tp_chart *chart = s->chart;
  s->legend_columns = columns;
  s->legend_rows = (chart->legend_count + columns - 1) / columns;
  double width = 0;
  for (size_t c = 0; c < columns; c++) {
    size_t longest = 0;
    for (size_t r = 0; r < s->legend_rows && c * s->legend_rows + r < chart->legend_count; r++) {
      const size_t length = letters(chart->legend[c * s->legend_rows + r].text);
      if (length > longest) longest = length;
    }
    s->legend_at_mm[c] = width;
    if (longest > 0) {
      width += sample_mm + after_sample_mm + (double)longest * letter_mm + after_text_mm;
    }
  }
  width -= after_text_mm;
  for (size_t c = 0; c < columns; c++) s->legend_at_mm[c] += (s->width_mm - width) / 2;
  return width <= s->width_mm - 2 * foot_mm;
}

static double between_rows(const tp_chart *chart) {
  return between_rows_mm + between_titles_mm + (chart->rows_are_named ? between_names_mm : 0);
}

static sheet lay_out(const tp_chart *chart, tp_chart_format format) {
  sheet s = {.chart = chart,
             .format = format,
             .rows = (chart->panel_count + chart->columns - 1) / chart->columns};
  s.width_mm = left_mm + right_mm + (double)chart->columns * chart->panel_width_mm +
               (double)(chart->columns - 1) * between_columns_mm;
  size_t columns =
      chart->legend_count < LEGEND_COLUMNS_MAX ? chart->legend_count : LEGEND_COLUMNS_MAX;
  while (columns > 1 && !lay_out_legend(&s, columns)) columns--;
  if (columns == 1) (void)lay_out_legend(&s, 1);
  s.height_mm = top_mm + bottom_mm + foot_mm + (double)s.rows * chart->panel_height_mm +
                (double)(s.rows - 1) * between_rows(chart) + (double)s.legend_rows * legend_row_mm;
  return s;
}

static void add_terminal(tp_text *t, const sheet *s) {
  const double w = s->width_mm, h = s->height_mm;
  tp_text_add(t, "set encoding utf8\n%s", s->chart->comma ? "set decimalsign ','\n" : "");
  if (s->format == TP_CHART_SVG) {
    tp_text_add(t,
                "set terminal svg size %.0f,%.0f enhanced font 'Arial,%.2f' linewidth 1 "
                "background rgb 'white'\n",
                w * pixels_per_mm, h * pixels_per_mm,
                letter_points * pixels_per_mm / points_per_mm);
  } else if (s->format == TP_CHART_PDF) {
    /* gnuplot halves the letters of a PDF, and takes a point for a 72nd of 96 pixels elsewhere */
    tp_text_add(t,
                "set terminal pdfcairo size %.4fcm,%.4fcm enhanced font 'Arial,%g' fontscale 0.75 "
                "linewidth 1.5\n",
                w / 10, h / 10, letter_points);
  } else {
    const double scale = dots_per_mm / points_per_mm;
    tp_text_add(t,
                "set terminal pngcairo size %.0f,%.0f enhanced font 'Arial,%g' fontscale %.4f "
                "linewidth %.4f pointscale %.4f background rgb 'white'\n",
                w * dots_per_mm, h * dots_per_mm, letter_points, dots_per_mm / pixels_per_mm,
                0.75 * scale, scale);
  }
}

static void add_data(tp_text *t, const tp_chart *chart) {
  for (size_t k = 0; k < chart->series_count; k++) {
    const tp_chart_series *s = chart->series + k;
    tp_text_add(t, "$s%zu << E\n", k);
    for (size_t p = 0; p < s->count; p++) {
      const double x = s->points[p].x.value, y = s->points[p].y.value;
      if (isnan(x)) {
        tp_text_add(t, "\n");
      } else {
        tp_text_add(t, "%.8g %.8g\n", x, y);
      }
    }
    tp_text_add(t, "E\n");
  }
}

static double line_width(const tp_chart_style *style) {
  return style->width > 0 ? style->width : 1.2;
}

/* Circles, but for one colour: grey print tells them apart. */
static int symbol(const tp_chart_style *style) {
  if (style->dash == TP_DASH_DASHED) return 5;
  if (style->dash == TP_DASH_DOTTED) return 6;
  return style->colour == TP_COLOUR_VERMILLION ? 9 : 7;
}

static void add_style(tp_text *t, const tp_chart_style *style) {
  switch (style->mark) {
  case TP_MARK_LINE:
    tp_text_add(t, "with lines lc rgb '%s' lw %.2f dt %s", colours[style->colour],
                line_width(style), dashes[style->dash]);
    break;
  case TP_MARK_POINTS:
    tp_text_add(t, "with points lc rgb '%s' pt %d ps 0.4", colours[style->colour], symbol(style));
    break;
  case TP_MARK_REGION:
    /* edged with itself, or hair lines would show between neighbours */
    tp_text_add(t, "with filledcurves closed fc rgb '%s' fs solid border lc rgb '%s' lw 0.3",
                tints[style->colour], tints[style->colour]);
    break;
  case TP_MARK_NONE:
    break;
  }
}

static void add_axis(tp_text *t, const tp_panel_axis *axis, char name) {
  tp_text_add(t, "%s logscale %c\n", axis->logarithmic ? "set" : "unset", name);
  tp_text_add(t, "set %crange [%.12g:%.12g]\n", name, axis->range.from, axis->range.to);
  if (axis->tick > 0 && axis->logarithmic) {
    tp_script_log_ticks(t, axis, name);
  } else if (axis->tick > 0) {
    tp_text_add(t, "set %ctics %.12g\n", name, axis->tick);
  } else {
    tp_text_add(t, "set %ctics autofreq\n", name);
  }
  tp_text_add(t, "set %clabel ", name);
  tp_encode_gnuplot(t, axis->label != NULL ? axis->label : "");
  tp_text_add(t, "%s\n", axis->plain ? " noenhanced" : "");
}

static void add_label(tp_text *t, const tp_chart_label *label) {
  static const char *const sides[] = {"center",
                                      "center boxed",
                                      "right offset character -0.7,0",
                                      "left offset character 0.7,0",
                                      "left offset character 0.6,-0.5",
                                      "center offset character 0,0.6",
                                      "left offset character 0,0.6"};
  tp_text_add(t, "set label ");
  tp_encode_gnuplot(t, label->text);
  tp_text_add(t, " at %.8g,%.8g %s front%s\n", label->x, label->y, sides[label->side],
              label->plain ? " noenhanced" : "");
}

/* The margins of a panel, shares of the sheet. */
static void add_margins(tp_text *t, const sheet *s, size_t panel) {
  const tp_chart *c = s->chart;
  const double column = (double)(panel % c->columns);
  const size_t rows_above = panel / c->columns;
  const double left = left_mm + column * (c->panel_width_mm + between_columns_mm);
  const double top =
      s->height_mm - top_mm - (double)rows_above * (c->panel_height_mm + between_rows(c));
  tp_text_add(t, "set lmargin at screen %.6f\nset rmargin at screen %.6f\n", left / s->width_mm,
              (left + c->panel_width_mm) / s->width_mm);
  tp_text_add(t, "set tmargin at screen %.6f\nset bmargin at screen %.6f\n", top / s->height_mm,
              (top - c->panel_height_mm) / s->height_mm);
}

/* A sample of a style at a point of the sheet. In an SVG gnuplot joins arrows of one colour and
 * width into one path of one dash: `apart` makes their widths differ, by less than is seen. */
static void add_sample(tp_text *t, const sheet *s, const tp_chart_style *style, double x, double y,
                       double apart) {
  const double w = s->width_mm, h = s->height_mm;
  const char *colour = colours[style->colour];
  switch (style->mark) {
  case TP_MARK_LINE:
    tp_text_add(t,
                "set arrow from screen %.6f,%.6f to screen %.6f,%.6f nohead lc rgb '%s' lw %.2f "
                "dt %s\n",
                x / w, y / h, (x + sample_mm) / w, y / h, colour, line_width(style) + apart,
                dashes[style->dash]);
    break;
  case TP_MARK_POINTS:
    tp_text_add(t, "set label '' at screen %.6f,%.6f point lc rgb '%s' pt %d ps 0.4\n",
                (x + sample_mm / 2) / w, y / h, colour, symbol(style));
    break;
  case TP_MARK_REGION:
    tp_text_add(t,
                "set object rectangle from screen %.6f,%.6f to screen %.6f,%.6f fc rgb '%s' "
                "fs solid border lc rgb 'black' lw 0.4\n",
                x / w, (y - 1) / h, (x + sample_mm) / w, (y + 1) / h, tints[style->colour]);
    break;
  case TP_MARK_NONE:
    break;
  }
}

/* Under all panels. */
static void add_legend(tp_text *t, const sheet *s) {
  for (size_t k = 0; k < s->chart->legend_count && s->legend_rows > 0; k++) {
    const tp_chart_legend *entry = s->chart->legend + k;
    const double x = s->legend_at_mm[k / s->legend_rows];
    const double rows_below = (double)(s->legend_rows - k % s->legend_rows) - 0.5;
    const double y = foot_mm + rows_below * legend_row_mm;
    add_sample(t, s, &entry->style, x, y, 0.01 * (double)k);
    tp_text_add(t, "set label ");
    tp_encode_gnuplot(t, entry->text);
    tp_text_add(t, " at screen %.6f,%.6f left\n", (x + sample_mm + after_sample_mm) / s->width_mm,
                y / s->height_mm);
  }
}

static void add_plot(tp_text *t, const sheet *s, size_t panel) {
  const tp_chart *c = s->chart;
  bool any = false;
  static const tp_chart_mark order[] = {TP_MARK_REGION, TP_MARK_LINE, TP_MARK_POINTS};
  tp_text_add(t, "plot ");
  for (int pass = 0; pass < 3; pass++) {
    for (size_t k = 0; k < c->series_count; k++) {
      const tp_chart_series *series = c->series + k;
      if (series->panel != panel || series->style.mark != order[pass]) continue;
      tp_text_add(t, "%s$s%zu using 1:2 ", any ? ", \\\n  " : "", k);
      add_style(t, &series->style);
      tp_text_add(t, " notitle");
      any = true;
    }
  }
  tp_text_add(t, "\n");
}

static void add_panel(tp_text *t, const sheet *s, size_t panel) {
  const tp_chart *c = s->chart;
  const tp_chart_panel *p = c->panels + panel;
  const bool own = p->title != NULL;
  const char *title = own ? p->title : panel == 0 ? c->title : NULL;
  add_margins(t, s, panel);
  tp_text_add(t, "unset label\n");
  tp_text_add(t, "set title ");
  tp_encode_gnuplot(t, title != NULL ? title : "");
  tp_text_add(t, " offset 0,-0.4%s\n", own ? "" : " noenhanced");
  add_axis(t, &p->x, 'x');
  add_axis(t, &p->y, 'y');
  for (size_t k = 0; k < c->label_count; k++) {
    if (c->labels[k].panel == panel) add_label(t, c->labels + k);
  }
  if (panel + 1 == c->panel_count) add_legend(t, s);
  add_plot(t, s, panel);
}

tp_status tp_chart_script(char **text, const tp_chart *chart, tp_chart_format format) {
  tp_text t = {0};
  const sheet s = lay_out(chart, format);
  add_terminal(&t, &s);
  add_data(&t, chart);
  tp_text_add(
      &t, "set style textbox opaque noborder margins 0.3,0.2 fillcolor rgb 'white'\n"
          "set border 3 front lw 0.6\nset minussign\nset format '%%h'\nset multiplot\nunset key\n"
          "set tics front out nomirror scale 0.5\nset xtics offset 0,0.35\n"
          "set ytics offset 0.5,0\nset xlabel offset 0,0.7\nset ylabel offset 0.6,0\n");
  for (size_t k = 0; k < chart->panel_count; k++) add_panel(&t, &s, k);
  tp_text_add(&t, "unset multiplot\n");
  return tp_text_finish(&t, text);
}
