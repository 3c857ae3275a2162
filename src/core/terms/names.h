/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Words for enumerations of the public headers, besides those that they declare: one for one thing,
 * in every text that the program writes. They stand in words.csv, of which the functions are made;
 * of a number that is none of them "unknown". */

#ifndef TP_TERMS_NAMES_H
#define TP_TERMS_NAMES_H

#include "topple.h"

const char *tp_check_verdict_name(tp_check_verdict verdict);
const char *tp_contact_end_name(tp_contact_end end);
const char *tp_contact_state_name(tp_contact_state state);
const char *tp_design_name(tp_design design);
const char *tp_direction_name(tp_direction direction);
const char *tp_element_kind_name(tp_element_kind kind);
const char *tp_limit_kind_name(tp_limit_kind kind);
const char *tp_load_side_name(tp_load_side side);
const char *tp_onset_kind_name(tp_onset_kind kind);
const char *tp_pivot_kind_name(tp_pivot_kind kind);
const char *tp_profile_origin_name(tp_profile_origin origin);
const char *tp_profile_series_name(tp_profile_series series);
const char *tp_study_end_name(tp_study_end end);
const char *tp_tilt_place_name(tp_tilt_place place);

#endif
