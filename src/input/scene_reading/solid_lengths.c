/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How long a length of a mesh is, of a rock or of its ground: by a unit, or by a length that is
 * known between two points of the mesh. These are the root of a rational apart, which is taken to
 * 2^-200 of itself. */

#include "scene_reading/read.h"

enum { AXES = 3, ROOT_BITS = 200 };

static void set_root(fmpq_t root, const fmpq_t square) {
  fmpz_t top;
  fmpz_init(top);
  const slong shift =
      ROOT_BITS + (slong)fmpz_bits(fmpq_denref(square)); /* so many bits after the point */
  fmpz_mul_2exp(top, fmpq_numref(square), 2 * (ulong)shift);
  fmpz_tdiv_q(top, top, fmpq_denref(square));
  fmpz_sqrt(top, top);
  fmpq_set_fmpz(root, top);
  fmpq_div_2exp(root, root, (ulong)shift);
  fmpz_clear(top);
}

static tp_status read_known_length(const tp_reader *reader, fmpq from[AXES], fmpq to[AXES],
                                   fmpq_t length, const tp_node *node) {
  const tp_node *ends[2] = {NULL}, *known = NULL;
  tp_status status = tp_read_keys(reader, node, &tp_key_map_solid_scale, "scale");
  if (status == TP_OK) {
    status = tp_read_required(reader, ends, node, "from", "from: [0, 0, 0]");
  }
  if (status == TP_OK) status = tp_read_required(reader, ends + 1, node, "to", "to: [0, 0, 1]");
  if (status == TP_OK) status = tp_read_required(reader, &known, node, "length", "length: 1.2");
  if (status == TP_OK) status = tp_read_triple(reader, from, ends[0], "from");
  if (status == TP_OK) status = tp_read_triple(reader, to, ends[1], "to");
  if (status == TP_OK) {
    status = tp_read_by_rule(reader, length, known, "length", TP_RULE_ABOVE_ZERO);
  }
  return status;
}

static tp_status read_scale(const tp_reader *reader, fmpq_t metres, const tp_node *node) {
  fmpq from[AXES], to[AXES];
  fmpq_t square;
  fmpq_init(square);
  for (int k = 0; k < AXES; k++) {
    fmpq_init(from + k);
    fmpq_init(to + k);
  }
  tp_status status = read_known_length(reader, from, to, metres, node);
  if (status == TP_OK) {
    for (int k = 0; k < AXES; k++) {
      fmpq_sub(to + k, to + k, from + k);
      fmpq_addmul(square, to + k, to + k);
    }
    if (fmpq_is_zero(square)) {
      status = tp_read_fail(reader, TP_FAULT_RANGE, node,
                            "'from' and 'to' are one point, which gives no scale");
    }
  }
  if (status == TP_OK) {
    set_root(square, square);
    fmpq_div(metres, metres, square);
    fmpq_mul(metres, metres, reader->scene->metres_per_unit);
  }
  for (int k = 0; k < AXES; k++) {
    fmpq_clear(from + k);
    fmpq_clear(to + k);
  }
  fmpq_clear(square);
  return status;
}

tp_status tp_read_mesh_lengths(const tp_reader *reader, fmpq_t metres, bool *given,
                               const tp_node *node) {
  const tp_scene *scene = reader->scene;
  const tp_node *unit = tp_node_get(node, "unit"), *scale = tp_node_get(node, "scale");
  *given = unit != NULL || scale != NULL;
  if (scale != NULL && unit != NULL) {
    return tp_read_fail(reader, TP_FAULT_KEY, scale,
                        "the lengths of a mesh have a 'unit', or a 'scale' by a known length, not "
                        "both");
  }
  if (scale != NULL) return read_scale(reader, metres, scale);
  const tp_status status = tp_read_mesh_unit(reader, metres, unit);
  fmpq_mul(metres, metres, scene->metres_per_unit);
  return status;
}
