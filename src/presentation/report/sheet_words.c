/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The words and numbers of a sheet are those of the page for a terminal, set otherwise. */

#include "report/sheet.h"

#include "report/account_units.h"
#include "report/words.h"

#include <stdio.h>
#include <string.h>

/* Columns of a label. */
enum { LABEL = 9 };

/* Words of a line, with one blank between them and what is there already. */
static void add_words(tp_text *t, const char *line, size_t length) {
  size_t from = 0;
  while (from < length) {
    while (from < length && line[from] == ' ') from++;
    size_t to = from;
    while (to < length && line[to] != ' ') to++;
    if (to > from && t->length > 0) tp_text_append(t, " ", 1);
    tp_text_append(t, line + from, to - from);
    from = to;
  }
}

static void end_paragraph(tp_document *d, tp_passage_kind kind, tp_text *paragraph) {
  if (paragraph->length > 0) tp_document_tell(d, kind, 0, paragraph);
  tp_text_drop(paragraph);
  *paragraph = (tp_text){0};
}

void tp_sheet_prose(tp_document *d, tp_passage_kind kind, tp_text *text) {
  tp_text paragraph = {0};
  const char *at = text->data != NULL ? text->data : "";
  d->failed = d->failed || text->failed;
  while (*at != '\0') {
    const size_t length = strcspn(at, "\n");
    if (strspn(at, " ") >= length) end_paragraph(d, kind, &paragraph);
    add_words(&paragraph, at, length);
    at += length + (at[length] == '\n');
  }
  end_paragraph(d, kind, &paragraph);
  tp_text_drop(text);
}

/* A caution is a sentence of its own. */
static void end_before_caution(tp_text *value, const char *line) {
  static const char caution[] = "Caution:";
  const bool open = value->length > 0 && value->data[value->length - 1] != '.';
  if (open && strncmp(line + strspn(line, " "), caution, strlen(caution)) == 0) {
    tp_text_add(value, ".");
  }
}

void tp_sheet_facts(tp_document *d, tp_text *text) {
  tp_text value = {0};
  char label[LABEL + 1] = "";
  const char *at = text->data != NULL ? text->data : "";
  d->failed = d->failed || text->failed;
  while (*at != '\0') {
    const size_t length = strcspn(at, "\n");
    const bool begins = length > 0 && *at != ' ';
    if (begins && value.length > 0) {
      tp_document_word(d, label);
      tp_document_told_cell(d, value.data);
      tp_text_drop(&value);
      value = (tp_text){0};
    }
    const size_t named = begins ? strcspn(at, " ") : 0;
    if (!begins) end_before_caution(&value, at);
    if (begins) snprintf(label, sizeof label, "%.*s", (int)named, at);
    add_words(&value, at + named, length - named);
    at += length + (at[length] == '\n');
  }
  if (value.length > 0) {
    tp_document_word(d, label);
    tp_document_told_cell(d, value.data);
  }
  tp_text_drop(&value);
  tp_text_drop(text);
}

void tp_sheet_fact_lines(tp_document *d, tp_text *text) {
  const char *at = text->data != NULL ? text->data : "";
  d->failed = d->failed || text->failed;
  while (*at != '\0') {
    const size_t length = strcspn(at, "\n");
    const size_t named = *at != ' ' ? strcspn(at, " \n") : 0;
    char label[LABEL + 1];
    tp_text value = {0};
    snprintf(label, sizeof label, "%.*s", (int)named, at);
    add_words(&value, at + named, length - named);
    tp_document_word(d, label);
    tp_document_told_cell(d, value.data != NULL ? value.data : "");
    d->failed = d->failed || value.failed;
    tp_text_drop(&value);
    at += length + (at[length] == '\n');
  }
  tp_text_drop(text);
}

static tp_sheet_number number_of(const char *text) {
  tp_sheet_number own;
  const bool alone = *text != '-' && strchr(text, ' ') == NULL;
  snprintf(own.text, sizeof own.text, alone ? "%s" : "(%s)", text);
  return own;
}

tp_sheet_number tp_sheet_moment(const tp_sheet *s, tp_bounded moment) {
  char n[TP_NUMBER_SIZE];
  const tp_page page = {.solution = s->solution};
  const tp_account_units units = tp_account_units_of(s->solution);
  return number_of(tp_account_moment(&page, n, moment, &units));
}

tp_sheet_number tp_sheet_coordinate(const tp_sheet *s, tp_bounded metres) {
  char n[TP_NUMBER_SIZE];
  const tp_page page = {.solution = s->solution};
  return number_of(tp_page_coordinate(&page, n, metres));
}

tp_sheet_number tp_sheet_angle(tp_bounded degrees) {
  char n[TP_NUMBER_SIZE], angle[TP_NUMBER_SIZE + 2];
  tp_page_degrees(n, degrees);
  snprintf(angle, sizeof angle, "%s°", n);
  return number_of(angle);
}

tp_sheet_number tp_sheet_factor(tp_bounded factor) {
  char n[TP_NUMBER_SIZE];
  return number_of(tp_text_fixed_down(n, factor, 3));
}

tp_sheet_number tp_sheet_share(tp_bounded share) {
  char n[TP_NUMBER_SIZE];
  return number_of(tp_text_fixed(n, share, 6));
}

void tp_sheet_add_heads(tp_document *d, const char *const *heads, size_t count) {
  for (size_t k = 0; k < count; k++) tp_document_word(d, heads[k]);
}

void tp_sheet_add_number(tp_document *d, tp_bounded number, int digits) {
  char n[TP_NUMBER_SIZE];
  tp_document_cell(d, "%s", tp_text_significant(n, number, digits));
}

void tp_sheet_add_number_if(tp_document *d, bool has, tp_bounded number, int digits) {
  if (has) {
    tp_sheet_add_number(d, number, digits);
  } else {
    tp_document_word(d, "–");
  }
}

void tp_sheet_add_factor_if(tp_document *d, bool has, tp_bounded factor, int digits) {
  char n[TP_NUMBER_SIZE];
  if (has) {
    tp_document_cell(d, "%s", tp_text_significant_down(n, factor, digits));
  } else {
    tp_document_word(d, "–");
  }
}

void tp_sheet_add_rest(tp_document *d, size_t rows, size_t most) {
  if (rows <= most) return;
  tp_document_add(d, TP_PASSAGE_PARAGRAPH, "And %zu more, which topple solve --json has.",
                  rows - most);
}

void tp_sheet_take_lines(tp_document *document, tp_text *lines) {
  const size_t empty = lines->data != NULL ? strspn(lines->data, "\n") : 0;
  if (empty > 0) {
    memmove(lines->data, lines->data + empty, lines->length - empty + 1);
    lines->length -= empty;
  }
  tp_document_take(document, TP_PASSAGE_LISTING, 0, lines);
}

tp_bounded tp_sheet_force(const tp_sheet *s, tp_bounded newtons) {
  const tp_result_unit unit = s->solution->result_units.force;
  return unit.name != NULL ? tp_page_in(newtons, unit) : tp_text_over(newtons, 1e3);
}

const char *tp_sheet_force_unit(const tp_sheet *s) {
  const char *name = s->solution->result_units.force.name;
  return name != NULL ? name : "kN";
}

tp_sheet_number tp_sheet_force_number(const tp_sheet *s, tp_bounded newtons) {
  char n[TP_NUMBER_SIZE];
  return number_of(tp_text_significant(n, tp_sheet_force(s, newtons), 6));
}

tp_bounded tp_sheet_turning(const tp_sheet *s, tp_bounded newton_metres) {
  const tp_result_unit unit = s->solution->result_units.moment;
  return unit.name != NULL ? tp_page_in(newton_metres, unit) : tp_text_over(newton_metres, 1e3);
}

const char *tp_sheet_turning_unit(const tp_sheet *s) {
  const char *name = s->solution->result_units.moment.name;
  return name != NULL ? name : "kN m";
}

static void add_way(tp_text *t, const tp_sheet *s, const tp_factor *factor) {
  const tp_document *d = &s->document;
  if (factor->definition != TP_FOS_BY_MOMENTS) {
    tp_text_add(t, "%s", tp_document_say(d, tp_text_motion(factor->mechanism)));
  } else if (factor->toe) {
    tp_text_add(t, "%s", tp_document_say(d, "toppling about the toe"));
  } else {
    tp_text_add(t, tp_document_say(d, "toppling about pivot %zu"), factor->pivot + 1);
  }
}

void tp_sheet_add_against(tp_sheet *s, const tp_factor *factor) {
  tp_text t = {0};
  add_way(&t, s, factor);
  tp_document_take_cell(&s->document, &t);
}

tp_sheet_turn tp_sheet_turn_of(const tp_sheet *s, const tp_case *c) {
  tp_sheet_turn turn = {.degrees = s->solution->frame.turned_deg, .letter = ""};
  if (turn.degrees.value == 0) return turn;
  if (c->towards == TP_TOWARDS_RIGHT) turn.degrees.value = -turn.degrees.value;
  turn.letter = "δ + ";
  snprintf(turn.number, sizeof turn.number, "%s + ", tp_sheet_angle(turn.degrees).text);
  return turn;
}

bool tp_sheet_tilts_are_dips(const tp_sheet *s) {
  return s->solution->frame.world && !s->solution->frame.level;
}
