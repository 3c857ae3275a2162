/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Parts of a workbook, unpacked within bounds and read by expat. A part may come from anybody: its
 * size is known before it is unpacked, and no more than that is taken; a document type, by which
 * XML names entities and other files, stops the reading. */

#include "common/message.h"
#include "xlsx/book.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_BYTES = 128 << 20, MOST_RATIO = 1000, SMALL = 1 << 20 };

const char *tp_book_attribute(const char **attributes, const char *name) {
  for (size_t k = 0; attributes[k] != NULL; k += 2) {
    const char *colon = strchr(attributes[k], ':');
    if (strcmp(colon != NULL ? colon + 1 : attributes[k], name) == 0) return attributes[k + 1];
  }
  return NULL;
}

static const char *local(const char *name) {
  const char *colon = strchr(name, ':');
  return colon != NULL ? colon + 1 : name;
}

void tp_parse_stop(tp_parse *p, const char *problem) {
  if (p->status != TP_OK) return;
  p->status = problem != NULL ? TP_BAD_INPUT : TP_OUT_OF_MEMORY;
  p->problem = problem;
  XML_StopParser(p->parser, XML_FALSE);
}

static void XMLCALL start(void *context, const char *name, const char **attributes) {
  tp_parse *p = context;
  p->start(p, local(name), attributes);
}

static void XMLCALL end(void *context, const char *name) {
  tp_parse *p = context;
  p->end(p, local(name));
}

static void XMLCALL text(void *context, const char *bytes, int length) {
  tp_parse *p = context;
  if (!p->collects) return;
  tp_text_append(&p->text, bytes, (size_t)length);
  if (p->text.failed) tp_parse_stop(p, NULL);
}

static void XMLCALL doctype(void *context, const char *name, const char *system, const char *public,
                            int internal) {
  (void)name;
  (void)system;
  (void)public;
  (void)internal;
  tp_parse_stop(context, "declares a document type, as no workbook does");
}

static tp_status fail(const tp_book *book, const char *part, const char *what) {
  return tp_refuse(book->message, TP_FAULT_FORMAT, (tp_place){book->path, 0, 0},
                   "its part %s %s; save it again as .xlsx, or as CSV", part, what);
}

static tp_status parse_bytes(tp_parse *p, const char *part, const char *bytes, size_t length) {
  p->parser = XML_ParserCreate(NULL);
  if (p->parser == NULL) return tp_fail_memory(p->book->message, "a worksheet");
  XML_SetUserData(p->parser, p);
  XML_SetElementHandler(p->parser, start, end);
  XML_SetCharacterDataHandler(p->parser, text);
  XML_SetStartDoctypeDeclHandler(p->parser, doctype);
  const enum XML_Status parsed = XML_Parse(p->parser, bytes, (int)length, XML_TRUE);
  const enum XML_Error error = XML_GetErrorCode(p->parser);
  XML_ParserFree(p->parser);
  tp_text_drop(&p->text);
  if (p->status == TP_BAD_INPUT) return fail(p->book, part, p->problem);
  if (p->status != TP_OK || error == XML_ERROR_NO_MEMORY) {
    return tp_fail_memory(p->book->message, "a worksheet");
  }
  return parsed == XML_STATUS_OK ? TP_OK : fail(p->book, part, "is no XML");
}

/* All of it, to be freed. */
static tp_status unpack(char **bytes, size_t *length, tp_book *book, const char *part,
                        const zip_stat_t *told) {
  if (told->size > MOST_BYTES ||
      (told->size > SMALL && told->size / MOST_RATIO > told->comp_size)) {
    return fail(book, part, "unpacks to more than a table of blocks can be");
  }
  zip_file_t *file = zip_fopen_index(book->zip, told->index, 0);
  if (file == NULL) return fail(book, part, "cannot be unpacked");
  char *own = malloc(told->size + 1);
  const zip_int64_t got = own != NULL ? zip_fread(file, own, told->size) : 0;
  zip_fclose(file);
  if (own == NULL) return tp_fail_memory(book->message, "a worksheet");
  if (got < 0 || (zip_uint64_t)got != told->size) {
    free(own);
    return fail(book, part, "cannot be unpacked");
  }
  *bytes = own;
  *length = told->size;
  return TP_OK;
}

tp_status tp_book_parse(tp_parse *p, const char *part, bool needed) {
  zip_stat_t told;
  char *bytes = NULL;
  size_t length = 0;
  if (p->book->zip == NULL) return parse_bytes(p, part, p->book->bytes, p->book->length);
  const zip_uint64_t known = ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_INDEX;
  if (zip_stat(p->book->zip, part, ZIP_FL_NOCASE, &told) != 0) {
    return needed ? fail(p->book, part, "is missing") : TP_OK;
  }
  if ((told.valid & known) != known) return fail(p->book, part, "cannot be unpacked");
  tp_status status = unpack(&bytes, &length, p->book, part, &told);
  if (status == TP_OK) status = parse_bytes(p, part, bytes, length);
  free(bytes);
  return status;
}
