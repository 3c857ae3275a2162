/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The table of a survey in Markdown, and written into files. */

#include "report/batch.h"

#include "common/host.h"
#include "common/message.h"
#include "output/file.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

tp_status tp_report_batch_markdown(char **text, const tp_batch *batch) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, batch);
  tp_document document = {0};
  tp_batch_build_page(&document, batch, NULL);
  const tp_status status = tp_document_markdown(text, &document);
  tp_document_clear(&document);
  return status;
}

typedef struct kind {
  const char *ending;
  tp_status (*make)(char **text, const tp_batch *batch); /* NULL: it is written elsewhere */
} kind;

static const kind kinds[] = {{".csv", tp_report_batch_csv},
                             {".json", tp_report_batch_json},
                             {".md", tp_report_batch_markdown},
                             {".html", NULL},
                             {".htm", NULL}};

static const kind *kind_of(const char *path) {
  const char *ending = strrchr(path, '.');
  if (ending == NULL || ending == path || ending[-1] == '/') return NULL;
  for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; k++) {
    if (strcasecmp(ending, kinds[k].ending) == 0) return kinds + k;
  }
  return NULL;
}

bool tp_batch_is_file_name(const char *path) {
  return path != NULL && kind_of(path) != NULL;
}

tp_status tp_batch_write_file(const char *path, const tp_batch *batch, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, path);
  TP_REFUSE_NULL(message, batch);
  const kind *own = kind_of(path);
  if (own == NULL || own->make == NULL) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){path, 0, 0},
                     "a table is of the kind that its name ends in: .csv, .json or .md");
  }
  char *text = NULL;
  tp_status status = own->make(&text, batch);
  if (status != TP_OK) return tp_fail_memory(message, "the table");
  const tp_file_sources sources = {batch->source_count, (const char *const *)batch->sources};
  status = tp_file_write(path, text, strlen(text), sources, message);
  free(text);
  return status;
}
