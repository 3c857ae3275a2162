/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Units in which reports print, a row each. To be reviewed without knowing C.
 *
 *   X(kind, name, numerator, denominator)
 *
 * One of the unit is numerator/denominator of the SI unit of its kind: m, N, N m, Pa. Both are
 * whole numbers below 2^53, so that a double holds them, and the factor is exact by definition:
 * - NIST Special Publication 811 (2008), appendix B: the international foot is 0.3048 m and the
 * inch 0.0254 m exactly, the avoirdupois pound 0.45359237 kg exactly, standard gravity 9.80665 m/s2
 *   exactly. So lbf = 0.45359237 * 9.80665 N = 4.4482216152605 N, kgf = 9.80665 N; kip = 1000 lbf,
 *   tf = 1000 kgf; psi = lbf/in2, psf = lbf/ft2, ksf = 1000 psf. */

#ifndef TP_SCENE_UNITS_TABLE_H
#define TP_SCENE_UNITS_TABLE_H

#define TP_RESULT_UNITS(X)                                                                         \
  X(LENGTH, "mm", 1, 1000)                                                                         \
  X(LENGTH, "cm", 1, 100)                                                                          \
  X(LENGTH, "m", 1, 1)                                                                             \
  X(LENGTH, "km", 1000, 1)                                                                         \
  X(LENGTH, "in", 127, 5000)                                                                       \
  X(LENGTH, "ft", 381, 1250)                                                                       \
  X(FORCE, "N", 1, 1)                                                                              \
  X(FORCE, "kN", 1000, 1)                                                                          \
  X(FORCE, "MN", 1000000, 1)                                                                       \
  X(FORCE, "kgf", 196133, 20000)                                                                   \
  X(FORCE, "tf", 196133, 20)                                                                       \
  X(FORCE, "lbf", 8896443230521, 2000000000000)                                                    \
  X(FORCE, "kip", 8896443230521, 2000000000)                                                       \
  X(MOMENT, "N m", 1, 1)                                                                           \
  X(MOMENT, "kN m", 1000, 1)                                                                       \
  X(MOMENT, "MN m", 1000000, 1)                                                                    \
  X(MOMENT, "tf m", 196133, 20)                                                                    \
  X(MOMENT, "lbf ft", 3389544870828501, 2500000000000000)                                          \
  X(MOMENT, "kip ft", 3389544870828501, 2500000000000)                                             \
  X(STRESS, "Pa", 1, 1)                                                                            \
  X(STRESS, "kPa", 1000, 1)                                                                        \
  X(STRESS, "MPa", 1000000, 1)                                                                     \
  X(STRESS, "kgf/cm2", 196133, 2)                                                                  \
  X(STRESS, "psi", 8896443230521, 1290320000)                                                      \
  X(STRESS, "psf", 8896443230521, 185806080000)                                                    \
  X(STRESS, "ksf", 8896443230521, 185806080)

#endif
