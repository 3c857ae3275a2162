/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a sheet is of: program, date, the files of its input with their hashes, and who signs. */

#include "report/sheet.h"

#include "common/input_file.h"
#include "common/message.h"
#include "output/encode.h"
#include "output/sha256.h"
#include "output/translate.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- files -------------------------------------------------------------------------------------
 */

/* False when memory is exhausted; what cannot be read leaves why. */
static bool read_all(tp_sheet_file *own, FILE *file) {
  size_t room = 1 << 16, more = 0;
  own->bytes = malloc(room);
  if (own->bytes == NULL) return false;
  while ((more = fread(own->bytes + own->length, 1, room - own->length - 1, file)) > 0) {
    own->length += more;
    if (own->length + 1 < room) continue;
    room *= 2;
    char *bytes = realloc(own->bytes, room);
    if (bytes == NULL) return false;
    own->bytes = bytes;
  }
  own->bytes[own->length] = '\0';
  own->why = ferror(file) != 0 ? errno : 0;
  return true;
}

tp_status tp_sheet_files_read(tp_sheet_files *files, const char *const *paths, size_t count,
                              tp_message *message) {
  tp_sheet_files own = {.items = calloc(count + 1, sizeof *own.items)};
  bool done = own.items != NULL;
  for (size_t k = 0; k < count && done; k++) {
    tp_sheet_file *item = own.items + own.count++;
    FILE *file = NULL;
    tp_message unread;
    *item = (tp_sheet_file){.path = paths[k]};
    if (tp_input_open(&file, paths[k], &unread) != TP_OK) {
      item->why = unread.system_error != 0 ? unread.system_error : EINVAL; /* no regular file */
      continue;
    }
    done = read_all(item, file);
    fclose(file);
  }
  if (!done) {
    tp_sheet_files_clear(&own);
    return tp_fail_memory(message, "the files of the scene");
  }
  *files = own;
  return TP_OK;
}

void tp_sheet_files_clear(tp_sheet_files *files) {
  for (size_t k = 0; k < files->count; k++) free(files->items[k].bytes);
  free(files->items);
  *files = (tp_sheet_files){0};
}

static void add_hash(tp_text *t, const tp_sheet_file *file) {
  uint8_t hash[TP_SHA256_SIZE];
  if (file->why != 0) {
    tp_text_add(t, "none: the file cannot be read again (%s)", strerror(file->why));
    return;
  }
  char text[TP_SHA256_TEXT];
  tp_sha256(hash, file->bytes, file->length);
  tp_sha256_text(text, hash);
  tp_text_add(t, "%s", text);
}

void tp_sheet_add_title(tp_document *d, const char *title, const char *otherwise) {
  tp_text text = {0};
  if (title != NULL) tp_encode_plain(&text, title);
  if (text.data == NULL || text.data[strspn(text.data, " ")] == '\0') {
    tp_text_add(&text, "%s", tp_document_say(d, otherwise));
  }
  tp_document_set_title(d, &text);
}

void tp_sheet_add_charts(tp_document *d, const tp_sheet_picture *charts, size_t count) {
  bool any = false;
  for (size_t k = 0; k < count; k++) {
    const tp_picture own = charts[k].picture;
    if (own.svg == NULL && own.png == NULL) continue;
    if (!any) tp_document_heading(d, 2, "Charts");
    any = true;
    tp_document_figure(d, own, charts[k].caption, charts[k].alternative);
  }
}

/* ---- what is told of them ----------------------------------------------------------------------
 */

void tp_sheet_add_settings(tp_document *d, const tp_settings *settings) {
  for (size_t k = 0; k < settings->count; k++) {
    char *text = tp_text_setting(settings->items + k);
    tp_document_word(d, "Set");
    tp_document_outside_cell(d, text != NULL ? text : "");
    d->failed = d->failed || text == NULL;
    free(text);
  }
}

void tp_sheet_add_origin(tp_document *d, const tp_sheet_files *files,
                         const tp_sheet_options *options) {
  tp_document_heading(d, 2, "Document record");
  tp_document_table(d, TP_TABLE_OF_FACTS, 2, 0, "Program, date and input");
  tp_document_cell(d, "Program");
  tp_document_cell(d, "Topple " TP_VERSION);
  if (options->date != NULL) {
    tp_document_cell(d, "Date");
    tp_document_outside_cell(d, options->date);
  }
  for (size_t k = 0; k < files->count; k++) {
    tp_text hash = {0};
    add_hash(&hash, files->items + k);
    tp_document_cell(d, k == 0 ? "Input" : "Read by the program");
    tp_document_outside_cell(d, files->items[k].path);
    tp_document_cell(d, "its SHA-256");
    tp_document_outside_cell(d, hash.data != NULL ? hash.data : "");
    d->failed = d->failed || hash.failed;
    tp_text_drop(&hash);
  }
  if (files->count == 0) {
    tp_document_cell(d, "Input");
    tp_document_cell(d, "built in memory by a program");
  }
}

/* As much of a file as is to be shown, each line made plain; how many lines it has more. */
static size_t add_lines(tp_text *t, const tp_sheet_file *file, size_t most) {
  const char *at = file->bytes, *end = at + file->length;
  size_t count = 0;
  for (; at < end; count++) {
    const char *stop = memchr(at, '\n', (size_t)(end - at));
    const size_t length = (size_t)((stop != NULL ? stop : end) - at);
    const size_t seen = length > 0 && at[length - 1] == '\r' ? length - 1 : length;
    if (count < most) {
      char *line = strndup(at, seen);
      t->failed = t->failed || line == NULL;
      if (line != NULL) tp_encode_plain(t, line);
      free(line);
      tp_text_append(t, "\n", 1);
    }
    at += length + (stop != NULL);
  }
  return count > most ? count - most : 0;
}

/* The logo, meshes, and what is no text, are told by their hash alone. */
static bool is_shown(const tp_sheet_files *files, const tp_sheet_file *file) {
  if (file->why != 0 || memchr(file->bytes, '\0', file->length) != NULL) return false;
  if (files->only_scene && file != files->items) return false;
  return files->logo == NULL || strcmp(files->logo, file->path) != 0;
}

void tp_sheet_add_files(tp_document *d, const tp_sheet_files *files,
                        const tp_sheet_options *options) {
  if (files->count == 0 || options->lines <= 0) return;
  tp_document_heading(d, 2, "Input as read");
  for (size_t k = 0; k < files->count; k++) {
    tp_text name = {0}, lines = {0};
    if (!is_shown(files, files->items + k)) continue;
    const size_t more = add_lines(&lines, files->items + k, (size_t)options->lines);
    tp_encode_plain(&name, files->items[k].path);
    tp_document_take(d, TP_PASSAGE_HEADING, 3, &name);
    tp_document_take(d, TP_PASSAGE_LISTING, 0, &lines);
    if (more > 0) {
      tp_document_add(d, TP_PASSAGE_PARAGRAPH, "… and %zu more lines; the hash above is of all.",
                      more);
    }
  }
}

void tp_sheet_add_signatures(tp_document *d, const tp_sheet_head *head) {
  static const char *const who[] = {"Prepared by", "Checked by", "Approved by"};
  const char *names[] = {head->texts[TP_LETTERHEAD_AUTHOR], head->texts[TP_LETTERHEAD_CHECKER],
                         NULL};
  tp_document_heading(d, 2, "Signatures");
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 4, 0, "Who has prepared, checked and approved it");
  tp_document_word(d, "Role");
  tp_document_word(d, "Name");
  tp_document_word(d, "Date");
  tp_document_word(d, "Signature");
  for (size_t k = 0; k < sizeof who / sizeof who[0]; k++) {
    tp_document_word(d, who[k]);
    tp_document_outside_cell(d, names[k] != NULL && names[k][0] != '\0' ? names[k]
                                                                        : "____________________");
    for (int blank = 0; blank < 2; blank++) tp_document_cell(d, "____________________");
  }
}

void tp_sheet_add_foot(tp_document *d, const tp_sheet_files *files,
                       const tp_sheet_options *options) {
  enum { SHOWN = 16 };
  tp_text foot = {0}, hash = {0};
  tp_text_add(&foot, "Topple " TP_VERSION);
  if (options->date != NULL) {
    tp_text_add(&foot, ", ");
    tp_encode_plain(&foot, options->date);
  }
  if (files->count > 0 && files->items->why == 0) {
    char shown[SHOWN + 1];
    add_hash(&hash, files->items);
    snprintf(shown, sizeof shown, "%s", hash.failed ? "" : hash.data);
    tp_text_add(&foot, ", ");
    tp_text_add(&foot, tp_document_say(d, "input SHA-256 %s…"), shown);
  }
  foot.failed = foot.failed || hash.failed;
  tp_text_drop(&hash);
  tp_document_set_foot(d, &foot);
}

static void add_notes(tp_document *d, const tp_notes *notes, tp_note_kind kind) {
  for (size_t k = 0; k < notes->count; k++) {
    const tp_note *note = notes->items + k;
    if (note->kind != kind) continue;
    tp_text text = {0}, told = {0}, plain = {0};
    tp_encode_plain(&plain, note->text);
    if (plain.data != NULL) tp_translate(&told, d->language, d->comma, plain.data);
    tp_text_add(&text,
                kind == TP_CAUTION ? tp_document_say(d, "Caution: %s")
                                   : tp_document_say(d, "Note: %s"),
                told.data != NULL ? told.data : "");
    text.failed = text.failed || told.failed || plain.failed;
    tp_text_drop(&told);
    tp_text_drop(&plain);
    if (note->place[0] != '\0') {
      tp_text_add(&text, " (");
      tp_encode_plain(&text, note->place);
      tp_text_add(&text, ")");
    }
    tp_document_take(d, kind == TP_CAUTION ? TP_PASSAGE_CAUTION : TP_PASSAGE_PARAGRAPH, 0, &text);
  }
}

void tp_sheet_count_cautions(tp_document *d, const tp_notes *notes, const char *phrase) {
  size_t count = 0;
  for (size_t k = 0; k < notes->count; k++) count += notes->items[k].kind == TP_CAUTION;
  if (count > 0) tp_document_add(d, TP_PASSAGE_CAUTION, phrase, count);
}

void tp_sheet_add_notes(tp_document *d, const tp_notes *notes) {
  if (notes->count == 0) return;
  tp_document_heading(d, 2, "Cautions and notes");
  add_notes(d, notes, TP_CAUTION);
  add_notes(d, notes, TP_NOTE);
}
