/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The blocks of a survey as text for a terminal, CSV and JSON. */

#include "report/batch.h"

#include "common/host.h"
#include "common/message.h"
#include "output/encode.h"
#include "report/results.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- cells -------------------------------------------------------------------------------------
 */

const char *tp_text_batch_fos(const tp_batch_row *row) {
  if (!row->has_case) return NULL;
  switch (row->fos.state) {
  case TP_FOS_NO_OVERTURNING:
    return "unbounded";
  case TP_FOS_UNDEFINED:
    return "none";
  case TP_FOS_UNDECIDED:
    return "undecided";
  default:
    return NULL;
  }
}

/* A number where it is known, with what follows it. */
static tp_batch_cell cell_of(bool known, tp_bounded number, int decimals, const char *behind) {
  tp_batch_cell cell = {.text = ""};
  if (known) {
    tp_text_fixed(cell.text, number, decimals);
    strcat(cell.text, behind);
  }
  return cell;
}

/* A factor that is short of what is required by less than a thousandth does not look like it. */
static int decimals_of(const tp_batch_row *row) {
  static const int few = 3, many = 9;
  const double required = row->has_required_fos ? row->required_fos.value : 1;
  return fabs(row->fos.value.value - required) < 1e-3 ? many : few;
}

tp_batch_cell tp_batch_fos(const tp_batch_row *row) {
  tp_batch_cell cell = {.text = ""};
  const char *words = tp_text_batch_fos(row);
  if (row->has_case && row->fos.state == TP_FOS_UNDECIDED && isfinite(row->at_most)) {
    char most[TP_NUMBER_SIZE];
    tp_text_fixed_up(most, (tp_bounded){.value = row->at_most}, 3);
    snprintf(cell.text, sizeof cell.text, "at most %s", most);
  } else if (words != NULL) {
    strcpy(cell.text, words);
  } else if (row->has_case && row->fos.state == TP_FOS_NUMBER) {
    tp_text_fixed_down(cell.text, row->fos.value, decimals_of(row));
  }
  return cell;
}

tp_batch_cell tp_batch_required(const tp_batch_row *row) {
  return cell_of(row->has_required_fos, row->required_fos, 3, "");
}

tp_batch_cell tp_batch_utilisation(const tp_batch_row *row) {
  tp_batch_cell cell = {.text = ""};
  if (row->has_design_utilisation) tp_text_fixed_up(cell.text, row->design_utilisation, 3);
  return cell;
}

bool tp_batch_has_cases(const tp_batch *batch) {
  size_t k = 0;
  while (k < batch->row_count && batch->rows[k].load_case == NULL) k++;
  return k < batch->row_count;
}

tp_batch_cell tp_batch_margin(const tp_batch_row *row) {
  return cell_of(row->has_margin, row->margin_deg, 3, "°");
}

tp_batch_cell tp_batch_dip(const tp_batch_row *row) {
  return cell_of(row->has_case, row->dip_deg, 3, "°");
}

const char *tp_batch_against(const tp_batch_row *row) {
  return row->has_fos_mechanism ? tp_text_motion(row->fos_mechanism) : "";
}

/* ---- what they come to -------------------------------------------------------------------------
 */

static void add_count(tp_text *text, size_t count, const char *one, const char *many) {
  if (count > 0) tp_text_add(text, ", %zu %s", count, count == 1 ? one : many);
}

void tp_batch_add_sum(tp_text *text, const tp_batch *batch) {
  tp_text sum = {0};
  add_count(&sum, batch->counts[TP_BATCH_FAILS], "fails", "fail");
  add_count(&sum, batch->counts[TP_BATCH_BELOW], "is below the factor required",
            "are below the factor required");
  add_count(&sum, batch->counts[TP_BATCH_UNDECIDED], "is undecided", "are undecided");
  add_count(&sum, batch->counts[TP_BATCH_UNSOLVED], "could not be solved", "could not be solved");
  add_count(&sum, batch->counts[TP_BATCH_HOLDS], "holds", "hold");
  tp_text_add(text, "%zu block%s: %s.", batch->row_count, batch->row_count == 1 ? "" : "s",
              sum.length > 2 ? sum.data + 2 : "");
  text->failed = text->failed || sum.failed;
  tp_text_drop(&sum);
}

/* ---- the terminal ------------------------------------------------------------------------------
 */

enum { NAME = 20 };

static void add_row(tp_text *t, const tp_batch_row *row, bool cases) {
  tp_encode_column(t, row->name, NAME);
  tp_text_add(t, "  %-14s  %14s  %-21s  %8s  %9s", tp_batch_standing_name(row->standing),
              tp_batch_fos(row).text, tp_batch_against(row), tp_batch_required(row).text,
              row->has_margin ? tp_batch_margin(row).text : "");
  if (cases)
    tp_text_add(t, "%s  %12s  ", row->has_margin ? "" : " ", tp_batch_utilisation(row).text);
  if (cases && row->load_case != NULL) tp_encode_plain(t, row->load_case);
  tp_text_add(t, "\n");
}

tp_status tp_report_batch(char **text, const tp_batch *batch) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, batch);
  tp_text t = {0};
  tp_batch_add_sum(&t, batch);
  const bool cases = tp_batch_has_cases(batch);
  tp_text_add(&t, "\n\n%-*s  %-14s  %14s  %-21s  %8s  %8s%s\n", NAME, "block", "", "FoS", "against",
              "required", "margin", cases ? "  required/FoS  case" : "");
  for (size_t k = 0; k < batch->row_count; k++) add_row(&t, batch->rows + k, cases);
  for (size_t k = 0; k < batch->row_count; k++) {
    const tp_batch_row *row = batch->rows + k;
    if (row->remark[0] == '\0' || !row->has_case) continue;
    tp_text_add(&t, "\nCaution: ");
    tp_encode_plain(&t, row->name);
    tp_text_add(&t, ": ");
    tp_encode_plain(&t, row->remark);
    tp_text_add(&t, "\n");
  }
  return tp_text_finish(&t, text);
}

/* ---- for programs ------------------------------------------------------------------------------
 */

tp_status tp_report_batch_csv(char **text, const tp_batch *batch) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, batch);
  tp_text t = {0};
  const tp_json_subject x = {.s = NULL};
  tp_text_add(&t, "name,line");
  tp_csv_names_of_batch_result(&t);
  tp_text_add(&t, ",remark\n");
  for (size_t k = 0; k < batch->row_count; k++) {
    const tp_batch_row *row = batch->rows + k;
    tp_encode_csv(&t, row->name);
    tp_text_add(&t, ",%zu", row->line);
    tp_csv_fields_of_batch_result(&t, row, &x);
    tp_text_add(&t, ",");
    tp_encode_csv(&t, row->remark);
    tp_text_add(&t, "\n");
  }
  return tp_text_finish(&t, text);
}

tp_status tp_report_batch_json(char **text, const tp_batch *batch) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, batch);
  tp_json_subject x = {.s = NULL};
  return tp_json_document_of_batch(text, batch, &x);
}
