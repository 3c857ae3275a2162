/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Profiles while memory runs out. */

#ifndef TP_TEST_MEMORY_PROFILES_H
#define TP_TEST_MEMORY_PROFILES_H

void measure_profile(void);
void solve_solid(void);
void solve_cut_solid(void);
void solve_thinned_solid(void);
void solve_solid_on_ground(void);
void solve_wedge(void);
void make_profiles(void);
void build_profiles(void);
void measure_base(void);

#endif
