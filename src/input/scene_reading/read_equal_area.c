/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads the key columns.equal_area: columns that have the area of a slope (jointing/equal_area.h),
 * whose dip is that of their bases. */

#include "jointing/equal_area.h"
#include "scene_reading/read.h"

#include <flint/fmpq_vec.h>
#include <string.h>

/* The dip of the scene's slope, along which x runs from the toe on the left. */
static tp_status read_dip(const tp_reader *reader, tp_quantity *dip, const tp_node *node,
                          const tp_node *root) {
  const tp_node *slope = tp_node_get(root, "slope");
  const tp_node *found = slope != NULL ? tp_node_get(slope, "dip_deg") : NULL;
  const tp_node *towards = slope != NULL ? tp_node_get(slope, "towards") : NULL;
  if (found == NULL || towards == NULL || towards->kind != TP_NODE_SCALAR ||
      strcmp(towards->text, "left") != 0) {
    return tp_read_fail(reader, TP_FAULT_KEY, found == NULL || towards == NULL ? node : towards,
                        "columns of equal_area have their toe on the left of a slope, whose dip is "
                        "that of their bases: say 'slope: {dip_deg: 30, towards: left}'");
  }
  return tp_read_quantity(reader, dip, found, "dip_deg", TP_RULE_ANGLE_BELOW_90);
}

static tp_status make_heights(const tp_reader *reader, fmpq **heights, long *count,
                              const tp_quantity *dip) {
  tp_columns_description *columns = &reader->scene->many.columns;
  tp_equal_area area;
  fmpz_t all;
  tp_status status = tp_equal_area_init(&area, columns, dip, reader->message);
  if (status != TP_OK) return status;
  fmpz_init(all);
  tp_equal_area_count(all, &area);
  if (fmpz_cmp_si(all, TP_MOST_COLUMNS) > 0) {
    status = tp_refuse(reader->message, TP_FAULT_RANGE, columns->width.place,
                       "these would be more than %d columns: give a greater 'width', or a smaller "
                       "height",
                       TP_MOST_COLUMNS);
  }
  if (status == TP_OK) {
    *count = fmpz_get_si(all);
    *heights = _fmpq_vec_init(*count);
    if (*heights == NULL) status = tp_fail_memory(reader->message, "the columns");
  }
  for (long k = 0; status == TP_OK && k < *count; k++) {
    tp_equal_area_height(*heights + k, &area, k);
  }
  if (status == TP_OK) fmpq_set(columns->step.value, area.step);
  fmpz_clear(all);
  tp_equal_area_clear(&area);
  return status;
}

tp_status tp_read_equal_area(const tp_reader *reader, fmpq **heights, long *count,
                             const tp_node *columns, const tp_node *root) {
  static const char *const others[] = {"step",        "rise",    "fall", "below_crest",
                                       "above_crest", "heights", NULL};
  const tp_node *other = tp_node_first_of(columns, others);
  if (other != NULL) {
    return tp_read_fail(reader, TP_FAULT_KEY, other,
                        "of columns of 'equal_area' heights and steps follow of the slope: leave "
                        "out '%s'",
                        other->key);
  }
  const tp_node *node = tp_node_get(columns, "equal_area");
  tp_quantity dip = {.given = false};
  fmpq_init(dip.value);
  tp_status status =
      tp_read_map(reader, reader->scene, node, &tp_key_map_columns_equal_area, "equal_area");
  if (status == TP_OK) status = read_dip(reader, &dip, node, root);
  if (status == TP_OK) status = make_heights(reader, heights, count, &dip);
  fmpq_clear(dip.value);
  return status;
}
