/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scenes and blocks from arrays, and scenes that are varied, while memory runs out. */

#ifndef TP_TEST_MEMORY_ARRAYS_H
#define TP_TEST_MEMORY_ARRAYS_H

void build_scene(void);
void vary_blocks(void);
void solve_outline(void);
void solve_blocks(void);
void vary_scenes(void);

#endif
