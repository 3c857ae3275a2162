/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The length of a facet that a contact stands for. */

#ifndef TP_CONTACT_SPRINGS_TRIBUTARY_H
#define TP_CONTACT_SPRINGS_TRIBUTARY_H

#include "contact_springs/meeting.h"

/* Half of what the straight piece of the block and that of the base which meet in the contact have
 * in common, along that of the base, at least `least_m`: of a disc the piece beside it that is
 * nearest to parallel to the other. `least_m` where there are none. */
double tp_tributary_length(const tp_features *of_block, long block_feature,
                           const tp_features *of_base, long base_feature, const tp_placing *placing,
                           double least_m);

#endif
