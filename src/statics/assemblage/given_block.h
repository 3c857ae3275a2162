/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What an assemblage is made of. */

#ifndef TP_ASSEMBLAGE_GIVEN_BLOCK_H
#define TP_ASSEMBLAGE_GIVEN_BLOCK_H

#include "block/section.h"

/* Given: borrowed, and all in the same scene lengths. */
typedef struct tp_given_block {
  const tp_section *section;
  TP_OUTSIDE const char *name;
  tp_place place;
  bool fixed; /* ground */
} tp_given_block;

#endif
