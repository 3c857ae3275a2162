/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Names and factors of force and moment in the account: the units that the scene asks for, newtons
 * and scene lengths, or multiples of the weight W. */

#include "report/account_units.h"
#include "report/words.h"

#include <stdio.h>

tp_account_units tp_account_units_of(const tp_solution *s) {
  tp_account_units own = {.weight = "W"};
  if (s->block.has_weight) {
    own.force = s->result_units.force;
    own.whole_moment = s->result_units.moment;
    snprintf(own.weight, sizeof own.weight, "%s", own.force.name != NULL ? own.force.name : "N");
  }
  if (own.whole_moment.name != NULL) {
    snprintf(own.moment, sizeof own.moment, "%s", own.whole_moment.name);
  } else {
    snprintf(own.moment, sizeof own.moment, "%s %s", s->block.has_weight ? "N" : "W",
             s->length_unit);
  }
  return own;
}

const char *tp_account_moment(const tp_page *page, char out[TP_NUMBER_SIZE], tp_bounded moment,
                              const tp_account_units *units) {
  return units->whole_moment.name != NULL
             ? tp_text_significant(out, tp_page_in(moment, units->whole_moment), 6)
             : tp_page_length(page, out, moment, 6);
}
