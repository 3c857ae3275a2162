/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The blocks of a survey as a document: what they come to, the table, what is wrong with rows, and
 * their figures. */

#include "report/batch.h"

#include "common/message.h"
#include "output/encode.h"

#include <stdlib.h>
#include <string.h>

enum { COLUMNS = 8, OF_CASES = 2 };

static void add_table(tp_document *d, const tp_batch *batch) {
  static const char *const heads[COLUMNS + OF_CASES] = {"Block",        "Stands?", "FoS", "against",
                                                        "required",     "margin",  "dip", "line",
                                                        "required/FoS", "case"};
  const unsigned numeric = 1U << 2 | 1U << 4 | 1U << 5 | 1U << 6 | 1U << 7 | 1U << 8;
  const bool cases = tp_batch_has_cases(batch);
  const size_t columns = COLUMNS + (cases ? OF_CASES : 0);
  tp_document_table(d, TP_TABLE_OF_COLUMNS, columns, numeric,
                    "The blocks, the worst first. Margin: by how much the slope may steepen and "
                    "the block is certain to stand; line: of its row in the table");
  for (size_t k = 0; k < columns; k++) tp_document_cell(d, "%s", heads[k]);
  for (size_t k = 0; k < batch->row_count; k++) {
    const tp_batch_row *row = batch->rows + k;
    tp_document_outside_cell(d, row->name);
    tp_document_cell(d, "%s", tp_batch_standing_name(row->standing));
    tp_document_cell(d, "%s", tp_batch_fos(row).text);
    tp_document_cell(d, "%s", tp_batch_against(row));
    tp_document_cell(d, "%s", tp_batch_required(row).text);
    tp_document_cell(d, "%s", tp_batch_margin(row).text);
    tp_document_cell(d, "%s", tp_batch_dip(row).text);
    tp_document_cell(d, "%zu", row->line);
    if (!cases) continue;
    tp_document_cell(d, "%s", tp_batch_utilisation(row).text);
    tp_document_outside_cell(d, row->load_case != NULL ? row->load_case : "");
  }
}

static void add_faults(tp_document *d, const tp_batch *batch) {
  if (batch->fault_count > 0) tp_document_heading(d, 2, "Not solved");
  for (size_t k = 0; k < batch->fault_count; k++) {
    tp_text text = {0};
    tp_encode_plain(&text, batch->faults[k].text);
    tp_document_take(d, TP_PASSAGE_CAUTION, 0, &text);
  }
}

static void add_cautions(tp_document *d, const tp_batch *batch) {
  bool any = false;
  for (size_t k = 0; k < batch->row_count; k++) {
    const tp_batch_row *row = batch->rows + k;
    if (!row->has_case || row->remark[0] == '\0') continue;
    if (!any) tp_document_heading(d, 2, "Cautions");
    any = true;
    tp_text text = {0};
    tp_encode_plain(&text, row->name);
    tp_text_add(&text, ": ");
    tp_encode_plain(&text, row->remark);
    tp_document_take(d, TP_PASSAGE_CAUTION, 0, &text);
  }
}

/* How it stands: "below required 1.300". */
static void add_standing(tp_text *caption, const tp_batch_row *row) {
  if (row->standing == TP_BATCH_BELOW) {
    tp_text_add(caption, ": below required %s", tp_batch_required(row).text);
  } else {
    tp_text_add(caption, ": %s", tp_batch_standing_name(row->standing));
  }
}

/* "Block 7: fails, FoS 0.812 against sliding" */
static void add_figure(tp_document *d, const tp_batch_row *row, tp_picture picture) {
  tp_text caption = {0};
  const tp_batch_cell fos = tp_batch_fos(row);
  char *text = NULL;
  tp_encode_plain(&caption, row->name);
  add_standing(&caption, row);
  if (fos.text[0] != '\0') tp_text_add(&caption, ", FoS %s", fos.text);
  if (row->has_fos_mechanism) tp_text_add(&caption, " against %s", tp_batch_against(row));
  if (row->load_case != NULL) {
    tp_text_add(&caption, ", case ");
    tp_encode_plain(&caption, row->load_case);
  }
  if (tp_text_finish(&caption, &text) != TP_OK) d->failed = true;
  tp_document_figure(d, picture, text != NULL ? text : "",
                     "The block on its base, with its pivots, its forces and the verdict");
  free(text);
}

void tp_batch_build_page(tp_document *d, const tp_batch *batch, tp_picture *pictures) {
  tp_text title = {0}, sum = {0}, foot = {0};
  size_t drawn = 0, solved = 0;
  const char *slash = strrchr(batch->file, '/');
  tp_encode_plain(&title, slash != NULL ? slash + 1 : batch->file);
  tp_text_add(&foot, "topple " TP_VERSION ", of the table ");
  tp_encode_plain(&foot, batch->file);
  tp_document_set_title(d, &title);
  tp_document_set_foot(d, &foot);
  tp_batch_add_sum(&sum, batch);
  tp_document_take(d, TP_PASSAGE_ANSWER, 0, &sum);
  add_faults(d, batch);
  tp_document_heading(d, 2, "Table");
  add_table(d, batch);
  add_cautions(d, batch);
  for (size_t k = 0; k < batch->row_count; k++) {
    solved += batch->rows[k].has_case;
    if (pictures == NULL || pictures[k].svg == NULL) continue;
    if (drawn++ == 0) tp_document_heading(d, 2, "Figures");
    add_figure(d, batch->rows + k, pictures[k]);
    pictures[k] = (tp_picture){0};
  }
  if (pictures != NULL && drawn < solved) {
    tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                    "Figures of the first %zu of the %zu blocks that were solved are shown.", drawn,
                    solved);
  }
}
