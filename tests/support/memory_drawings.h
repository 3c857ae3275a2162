/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#ifndef TP_TEST_MEMORY_DRAWINGS_H
#define TP_TEST_MEMORY_DRAWINGS_H

/* Scenes of drawings of every format, with one of their numbers set again. */
void read_drawings(void);

#endif
