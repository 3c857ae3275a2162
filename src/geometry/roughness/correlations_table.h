/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* JRC by correlations with a profile's shape, as they were published: a row each. To be reviewed
 * without knowing C.
 *
 *   X(authors, equation as text, input, form, a, b, c, step as text, step from, step to, length
 * from, length to, JRC from, JRC to)
 *
 * Forms: POWER is JRC = a P^b + c, LOGARITHM is JRC = a log10(P) + c. Inputs P: Z2, root mean
 * square of the slope; FACING, the mean of theta*max/(C+1) in degrees in both directions;
 * AMPLITUDE, in mm; AMPLITUDE_OVER_LENGTH; EQ_11, k A/L with k = 450 + 50 log10(L in m), which is
 * 400, 450 and 500 at the paper's 0.1, 1 and 10 m; EQ_12, A in mm over (L in m)^0.917. Steps and
 * lengths in mm, 0 where any will do; the JRC are those that the row was fitted to.
 *
 * Where the numbers are from:
 * - Eqs. (11), (12), (14): Alejano et al.; (11) is Barton (1981), (14) Tse and Cruden, Int. J. Rock
 *   Mech. Min. Sci. 16 (1979) 303-307, who read the ten standard profiles, enlarged 2.5 times,
 * every 1.27 mm, which is 0.508 mm. Their 37.28 + 16.58 log10(SF) is not here: the unit of SF is
 *   not told, and at an even step SF is Z2^2 step^2, so that it would add nothing.
 * - Yu and Vayssade, Int. J. Rock Mech. Min. Sci. 28 (1991) 333-336. The row of 0.25 mm was
 * compared with a second text; those of 0.5 and 1 mm were not, but lie within 1.2 of Tatone and
 * Grasselli's at the same step wherever these give 2 to 18 (tests/program/test_profile_jrc.py).
 * - Tatone and Grasselli, Int. J. Rock Mech. Min. Sci. 47 (2010) 1391-1400: ten profiles of JRC 0.4
 *   to 18.7, read every 0.5 mm.
 * - Jang et al., Rock Mech. Rock Eng. 47 (2014) 2061-2073: the same ten, 96 to 101 mm long.
 * - Li et al., Bull. Eng. Geol. Environ. 76 (2017) 1153-1165: 112 profiles, 68 to 167.8 mm long,
 *   JRC 0.4 to 20 by shear tests, steps of 0.1 to 3.2 mm. */

#ifndef TP_ROUGHNESS_CORRELATIONS_TABLE_H
#define TP_ROUGHNESS_CORRELATIONS_TABLE_H

/* clang-format off */
#define TP_JRC_CORRELATIONS(X)                                                                     \
  X("Barton 1981, Eq. (11)", "k A/L", EQ_11, POWER, 1, 1, 0, "", 0, 0, 100, 10000, 0, 20)          \
  X("Alejano et al., Eq. (12)", "A/(2.05 L^0.917)", EQ_12, POWER, 1 / 2.05, 1, 0,                  \
    "", 0, 0, 100, 10000, 0, 20)                                                                   \
  X("Tse, Cruden 1979, Eq. (14)", "32.2 + 32.47 log10 Z2", Z2, LOGARITHM, 32.47, 0, 32.2,       \
    "0.5 mm", 0.495, 0.515, 0, 0, 0.4, 18.7)                                                       \
  X("Yu, Vayssade 1991", "60.32 Z2 - 4.51", Z2, POWER, 60.32, 1, -4.51,                         \
    "0.25 mm", 0.2475, 0.2525, 0, 0, 0.4, 18.7)                                                    \
  X("Yu, Vayssade 1991", "61.79 Z2 - 3.47", Z2, POWER, 61.79, 1, -3.47,                         \
    "0.5 mm", 0.495, 0.505, 0, 0, 0.4, 18.7)                                                       \
  X("Yu, Vayssade 1991", "64.22 Z2 - 2.31", Z2, POWER, 64.22, 1, -2.31,                         \
    "1 mm", 0.99, 1.01, 0, 0, 0.4, 18.7)                                                           \
  X("Tatone, Grasselli 2010", "51.85 Z2^0.6 - 10.37", Z2, POWER, 51.85, 0.6, -10.37,            \
    "0.5 mm", 0.495, 0.505, 0, 0, 0.4, 18.7)                                                       \
  X("Tatone, Grasselli 2010", "55.03 Z2^0.74 - 6.1", Z2, POWER, 55.03, 0.74, -6.1,              \
    "1 mm", 0.99, 1.01, 0, 0, 0.4, 18.7)                                                           \
  X("Tatone, Grasselli 2010", "3.95 (theta*/(C+1))^0.7 - 7.98", FACING, POWER,                  \
    3.95, 0.7, -7.98, "0.5 mm", 0.495, 0.505, 0, 0, 0.4, 18.7)                                     \
  X("Tatone, Grasselli 2010", "2.4 (theta*/(C+1))^0.85 - 4.42", FACING, POWER,                  \
    2.40, 0.85, -4.42, "1 mm", 0.99, 1.01, 0, 0, 0.4, 18.7)                                        \
  X("Jang et al. 2014", "51.16 Z2^0.531 - 11.44", Z2, POWER, 51.16, 0.531, -11.44,                 \
    "0.5 mm", 0.495, 0.505, 0, 0, 0.4, 18.7)                                                       \
  X("Li et al. 2017", "80.37 (A/L)^0.6238", AMPLITUDE_OVER_LENGTH, POWER, 80.37, 0.6238, 0,        \
    "0.1-3.2 mm", 0.1, 3.2, 68, 167.8, 0.4, 20)                                                 \
  X("Li et al. 2017", "4.6836 A^0.6106", AMPLITUDE, POWER, 4.6836, 0.6106, 0,                      \
    "0.1-3.2 mm", 0.1, 3.2, 68, 167.8, 0.4, 20)
/* clang-format on */

#endif
