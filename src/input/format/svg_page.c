/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Width of the page in metres by the unit of its width (96 px, 72 pt, 6 pc to the inch) over the
 * width of the viewBox. */

#include "format/svg_page.h"

#include "format/svg_shape.h"
#include "number/ratio.h"

#include <string.h>

static const double inch_m = 0.0254, pixels = 96; /* of an inch */

/* The number at the beginning of a text, and how long it is; 0 where there is none. */
static double number_at(const char *text, size_t *length) {
  const char *problem = NULL;
  fmpq_t value;
  fmpq_init(value);
  *length = strspn(text, "+-.0123456789");
  const double number =
      *length > 0 && tp_ratio_read_field(value, text, *length, &problem) ? fmpq_get_d(value) : 0;
  fmpq_clear(value);
  return number;
}

/* Metres of a length with its unit; 0: it is none, as a share of the window is. */
static double length_of(const char *text) {
  static const struct {
    const char *name;
    double per_inch;
  } units[] = {{"", 96}, {"px", 96}, {"in", 1}, {"mm", 25.4}, {"cm", 2.54}, {"pt", 72}, {"pc", 6}};
  size_t length = 0;
  text += strspn(text, " \t\r\n");
  const double number = number_at(text, &length);
  const char *unit = text + length;
  const size_t size = strcspn(unit, " \t\r\n");
  for (size_t k = 0; k < sizeof units / sizeof units[0] && number > 0; k++) {
    if (strlen(units[k].name) == size && memcmp(units[k].name, unit, size) == 0) {
      return number / units[k].per_inch * inch_m;
    }
  }
  return 0;
}

/* The third of its four numbers. */
static double width_of(const char *view_box) {
  static const char between[] = " ,\t\r\n";
  double number = 0;
  for (int k = 0; k < 3; k++) {
    size_t length = 0;
    view_box += strspn(view_box, between);
    number = number_at(view_box, &length);
    if (length == 0) return 0;
    view_box += length;
  }
  return number;
}

double tp_svg_page_unit(const char *const *attributes) {
  const char *width = tp_svg_attribute(attributes, "width");
  const char *view_box = tp_svg_attribute(attributes, "viewBox");
  const double page_m = width != NULL ? length_of(width) : 0;
  if (page_m <= 0) return 0;
  if (view_box == NULL) return inch_m / pixels;
  const double units = width_of(view_box);
  return units > 0 ? page_m / units : 0;
}
