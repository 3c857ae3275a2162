/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A rounded corner at a pivot in symbols (Appendix B; docs/mechanics.md section 4, model `paper`).
 *
 * Rounding moves the axis from the sharp corner along the base facet up-dip by the length l (the
 * paper's r), with the mass kept. l, cos i and sin i are symbols of their own, i the angle of that
 * facet to the mean plane; on a level facet cos i = 1 and sin i = 0. */

#ifndef TP_DERIVE_ROUNDING_H
#define TP_DERIVE_ROUNDING_H

#include "derive/model.h"

/* Indices of the field's symbols. */
typedef struct tp_rounding_symbols {
  long length, sine, cosine;
} tp_rounding_symbols;

typedef struct tp_rounding {
  int slope;         /* of the facet seen up-dip: 1 rises (a valley), -1 falls (a peak), 0 level */
  bool upright_side; /* the block's other edge at the corner is normal to the mean plane */
  fmpz_mpoly_q_t length, sine, cosine;
  fmpz_mpoly_q_t rise, run; /* of the facet: tan i = rise / run, both positive at the values */
} tp_rounding;

/* The corner at the k-th contact point for one direction of tilt. On failure it is cleared. */
TP_MUST_USE tp_status tp_rounding_init(tp_rounding *rounding, const tp_model *model, size_t k,
                                       tp_direction towards, const tp_rounding_symbols *symbols,
                                       tp_message *message);
void tp_rounding_clear(tp_rounding *rounding, const tp_field *field);

/* By how much the axis moves: up-dip, and up. */
void tp_rounding_shift(fmpz_mpoly_q_t along, fmpz_mpoly_q_t up, const tp_rounding *rounding,
                       const tp_field *field);

/* The l at which the block topples at alpha, given its sine and cosine:
 * l = (x cos alpha - y sin alpha) / (cos i cos alpha - slope sin i sin alpha), (x, y) the lever
 * arms about the sharp corner; (A2.4), (A2.10). */
void tp_rounding_critical_length(fmpz_mpoly_q_t value, const tp_rounding *rounding,
                                 const fmpz_mpoly_q_t x, const fmpz_mpoly_q_t y,
                                 const fmpz_mpoly_q_t sine, const fmpz_mpoly_q_t cosine,
                                 const tp_field *field);

/* l to radius: r_c = l tan(theta / 2), theta = 90 - slope i the angle of the corner; (A2.5). */
void tp_rounding_radius(fmpz_mpoly_q_t radius, const tp_rounding *rounding,
                        const fmpz_mpoly_q_t length, const tp_field *field);

#endif
