/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The overturning spectrum of a block: what shaking of one form overturns it, at one frequency
 * after the other. At each the shaking grows from a PGA of 1/64 g by 2^(1/8) until it overturns the
 * block, at most to 64 g; from there on for two octaves more, in search of islands in which it is
 * spared again. Each change is narrowed by halves. What lies between two of these steps may be
 * missed. At most 113 runs and 17 narrowings a frequency, each ended by the bounds of a run. */

#ifndef TP_TILT_OVERTURNING_SPECTRUM_H
#define TP_TILT_OVERTURNING_SPECTRUM_H

#include "topple_tilt_test.h"

enum { TP_ISLANDS_MAX = 8, TP_FREQUENCIES_MAX = 200 };

/* PGA between two runs, m/s2. */
typedef struct tp_pga_bracket {
  double low_m_s2, high_m_s2;
} tp_pga_bracket;

/* From where on it is spared again, and from where on no more. */
typedef struct tp_spared_island {
  tp_pga_bracket from, to;
  bool open; /* it goes on to the strongest shaking that was tried, and `to` is that */
} tp_spared_island;

typedef struct tp_overturning_point {
  double frequency;  /* of a pulse, in hertz; of a record times its speed */
  double velocity_s; /* PGV over PGA */
  bool overturns;    /* some shaking does: */
  tp_pga_bracket least;
  size_t island_count;
  tp_spared_island islands[TP_ISLANDS_MAX];
  double strongest_m_s2; /* that was tried */
  bool converged;        /* all runs were decided */
} tp_overturning_point;

/* One direction; one alone on level ground. */
typedef struct tp_overturning_case {
  tp_direction towards;
  bool has_static; /* loaded by its weight alone on level ground, it is moved by this PGA, held: */
  double static_m_s2;
  size_t count;
  tp_overturning_point *points;
} tp_overturning_case;

typedef struct tp_overturning_spectrum {
  bool of_record;
  size_t case_count;
  tp_overturning_case cases[2];
} tp_overturning_spectrum;

/* With what is known where options->stop says so. On failure `spectrum` is cleared. */
TP_MUST_USE tp_status tp_overturning_spectrum_init(tp_overturning_spectrum *spectrum,
                                                   const tp_scene *scene,
                                                   const tp_overturning_options *options,
                                                   tp_message *message);
void tp_overturning_spectrum_clear(tp_overturning_spectrum *spectrum);

#endif
