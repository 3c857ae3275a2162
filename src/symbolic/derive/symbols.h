/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The section of a block in symbols: the same rings, vertex by vertex, as rational functions of the
 * scene's parameters. Coordinates that the scene gives by numbers are constants. */

#ifndef TP_DERIVE_SYMBOLS_H
#define TP_DERIVE_SYMBOLS_H

#include "block/section.h"
#include "derive/field.h"

typedef struct tp_symbolic_chain {
  long count;
  fmpz_mpoly_q_struct *x, *y;
} tp_symbolic_chain;

typedef struct tp_symbols {
  tp_field field;
  long ring_count;
  tp_symbolic_chain *rings;  /* as those of the section, in the same order and sense */
  tp_symbolic_chain profile; /* of a base with a profile of its own; else empty */
  tp_symbolic_chain corners; /* of the elements of Appendix A, as in the section; else empty */
} tp_symbols;

void tp_symbolic_chain_clear(tp_symbolic_chain *chain, const fmpz_mpoly_ctx_t ring);

/* Width a, height b and depth c of the teeth of a scene by whichever keys it gives them
 * (section 5.1 of the paper), and their number N: the count symbol, or dx / a where the scene gives
 * dx. A slab is one tooth of depth 0. */
typedef struct tp_teeth_formulas {
  fmpz_mpoly_q_t a, b, c, count;
} tp_teeth_formulas;

void tp_teeth_formulas_init(tp_teeth_formulas *formulas, const tp_field *field);
void tp_teeth_formulas_clear(tp_teeth_formulas *formulas, const tp_field *field);
TP_MUST_USE tp_status tp_teeth_formulas_read(tp_teeth_formulas *formulas, const tp_symbols *symbols,
                                             const tp_scene *scene, tp_message *message);

/* The outline for the count and the left end that `teeth` says; false when memory is exhausted. */
TP_MUST_USE bool tp_teeth_formulas_outline(tp_symbolic_chain *outline,
                                           const tp_teeth_formulas *formulas, const tp_teeth *teeth,
                                           const tp_field *field);

/* `more` as for tp_field_init. On failure `symbols` is cleared. */
TP_MUST_USE tp_status tp_symbols_init(tp_symbols *symbols, const tp_scene *scene,
                                      const tp_section *section, const tp_symbol_names *more,
                                      tp_message *message);
void tp_symbols_clear(tp_symbols *symbols);

#endif
