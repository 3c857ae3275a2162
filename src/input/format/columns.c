/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Header fields reduced to words in lower case with a unit, looked up in the tables of
 * format/column_words_table.h; two columns are chosen by their kinds, plans of two map coordinates
 * are refused. */

#include "format/columns.h"

#include "format/column_words_table.h"
#include "number/ratio.h"

#include <ctype.h>
#include <string.h>

typedef enum kind { X, Y, Z, ALONG, HEIGHT, DEPTH, EAST, NORTH, DEGREES, KINDS, NONE } kind;

static const struct {
  kind kind;
  const char *word;
} words[] = {
#define ROW(of, word) {of, word},
    TP_COLUMN_WORDS(ROW)
#undef ROW
};

static const struct {
  const char *unit, *word; /* unit NULL: none that Topple takes */
} units[] = {
#define ROW(unit, word) {unit, word},
    TP_COLUMN_UNITS(ROW)
#undef ROW
#define ROW(word) {NULL, word},
        TP_COLUMN_OTHER_UNITS(ROW)
#undef ROW
};

enum { WORDS = sizeof words / sizeof words[0], UNITS = sizeof units / sizeof units[0] };

const char tp_columns_plan[] =
    "x and y with a height that changes are a plan, not a section: a line of section is needed; "
    "give distances along it and heights, 'distance,elevation', or cut a mesh by 'section'";

/* ---- one field ---------------------------------------------------------------------------------
 */

enum { TEXT = 96 };

/* In small letters, with single blanks for what is neither letter nor digit. */
typedef struct phrase {
  char text[TEXT];
  size_t length;
} phrase;

static void add(phrase *p, char c) {
  const bool letter = isalnum((unsigned char)c) || (unsigned char)c >= 0x80;
  if (p->length + 1 >= TEXT) return;
  if (!letter && (p->length == 0 || p->text[p->length - 1] == ' ')) return;
  p->text[p->length++] = (char)(letter ? tolower((unsigned char)c) : ' ');
}

static void finish(phrase *p) {
  while (p->length > 0 && p->text[p->length - 1] == ' ') p->length--;
  p->text[p->length] = '\0';
}

/* The row of units that the text is; -1. */
static int find_unit(const char *text) {
  for (int k = 0; k < UNITS; k++) {
    if (strcmp(text, units[k].word) == 0) return k;
  }
  return -1;
}

/* The longest word that the phrase is or begins with, as a row; -1. */
static int find_word(const phrase *p) {
  int found = -1;
  size_t longest = 0;
  for (int k = 0; k < WORDS; k++) {
    const size_t length = strlen(words[k].word);
    if (length <= longest || strncmp(p->text, words[k].word, length) != 0) continue;
    const bool alone = length == 1 && words[k].kind > Z;
    if (p->text[length] != '\0' && (alone || p->text[length] != ' ')) continue;
    found = k;
    longest = length;
  }
  return found;
}

/* The whole of a phrase, or one of its words behind the first: "elevation m ahd". That of inches is
 * a plain word, too, unless it comes last. */
static int unit_of_words(const phrase *p) {
  char own[TEXT];
  int found = find_unit(p->text);
  for (const char *at = strchr(p->text, ' '); at != NULL && found < 0; at = strchr(at, ' ')) {
    const size_t length = strcspn(++at, " ");
    memcpy(own, at, length);
    own[length] = '\0';
    if (at[length] == '\0' || strcmp(own, "in") != 0) found = find_unit(own);
  }
  return found;
}

typedef struct field {
  int word, unit; /* rows; -1: none */
} field;

/* What stands in brackets is a unit, or says more closely what it is: "X (Easting)". */
static field read_field(const tp_csv_row *row, int number) {
  const tp_csv_field f = row->fields[number];
  phrase outer = {"", 0}, inner = {"", 0};
  int depth = 0;
  for (size_t k = 0; k < f.length; k++) {
    const char c = row->text[f.at + k];
    const bool closes = c == ')' || c == ']';
    depth += c == '(' || c == '[';
    add(depth > 0 ? &inner : &outer, (char)(closes ? ' ' : c));
    if (depth == 0) continue;
    if (closes) depth--;
    if (depth == 0) add(&outer, ' ');
  }
  finish(&outer);
  finish(&inner);
  field found = {-1, find_unit(inner.text)};
  if (found.unit < 0) found.unit = unit_of_words(&outer);
  found.word = find_word(&inner);
  if (found.word < 0) found.word = find_word(&outer);
  return found;
}

/* ---- all of them -------------------------------------------------------------------------------
 */

typedef struct choosing {
  const tp_csv_row *row;
  tp_place line;
  tp_message *message;
  field fields[TP_CSV_FIELDS];
  int at[KINDS]; /* the first column of a kind; -1: none */
  int twice[KINDS];
} choosing;

static tp_place place_of(const choosing *c, int column) {
  tp_place place = c->line;
  place.column = column < 0 ? 1 : (int)c->row->fields[column].at + 1;
  return place;
}

static tp_status refuse(const choosing *c, int column, const char *what) {
  return tp_refuse(c->message, TP_FAULT_FORMAT, place_of(c, column), "%s", what);
}

static bool has(const choosing *c, kind k) {
  return c->at[k] >= 0;
}

static const char *word_at(const choosing *c, int column) {
  return words[c->fields[column].word].word;
}

static tp_status check_twice(const choosing *c, kind k) {
  if (k == NONE || c->twice[k] < 0) return TP_OK;
  if (k <= Z) {
    return tp_refuse(c->message, TP_FAULT_KEY, place_of(c, c->twice[k]),
                     "the header names two columns %s", word_at(c, c->at[k]));
  }
  return tp_refuse(c->message, TP_FAULT_KEY, place_of(c, c->twice[k]),
                   "the header names two columns alike, '%s' and '%s'; name one of them otherwise",
                   word_at(c, c->at[k]), word_at(c, c->twice[k]));
}

static kind height_of(const choosing *c) {
  return has(c, HEIGHT) ? HEIGHT : has(c, Z) ? Z : NONE;
}

/* Which are x and y; NONE where there is no such. */
static void pair_up(const choosing *c, kind *x, kind *y) {
  const kind height = height_of(c);
  *x = *y = NONE;
  if (has(c, ALONG) && has(c, HEIGHT)) {
    *x = ALONG;
    *y = HEIGHT;
  } else if (has(c, X) && has(c, Y)) {
    *x = X;
    *y = Y;
  } else if (has(c, X) || has(c, ALONG)) {
    *x = has(c, X) ? X : ALONG;
    *y = height != NONE ? height : has(c, Y) ? Y : NONE;
  } else if (has(c, EAST) != has(c, NORTH)) {
    *x = has(c, EAST) ? EAST : NORTH;
    *y = height;
  }
}

static tp_status refuse_half(const choosing *c, kind x) {
  static const kind known[] = {X, Y, ALONG, HEIGHT, Z, EAST, NORTH};
  if (has(c, DEGREES)) {
    return refuse(c, c->at[DEGREES],
                  "degrees on the globe are not lengths: give distances along a line of section "
                  "and heights, 'distance,elevation'");
  }
  if (has(c, EAST) && has(c, NORTH)) {
    return refuse(c, c->at[EAST] < c->at[NORTH] ? c->at[EAST] : c->at[NORTH],
                  "east and north are a plan, not a section: a line of section is needed; give "
                  "distances along it and heights, 'distance,elevation', or cut a mesh by "
                  "'section'");
  }
  if (has(c, DEPTH)) {
    return refuse(c, c->at[DEPTH],
                  "depths run downwards: give heights, 'elevation', of which a depth is the "
                  "negative");
  }
  int own = x == NONE ? -1 : c->at[x];
  for (size_t k = 0; k < sizeof known / sizeof known[0] && own < 0; k++) own = c->at[known[k]];
  const kind given = words[c->fields[own].word].kind;
  const char *other = given == X                      ? "y"
                      : given == Y                    ? "x"
                      : given == HEIGHT || given == Z ? "of distances along the section"
                                                      : "of heights";
  return tp_refuse(c->message, TP_FAULT_FORMAT, place_of(c, own),
                   "the header names a column %s, but none %s; name both, as 'x,y' or "
                   "'distance,elevation'",
                   word_at(c, own), other);
}

static tp_status check_unit(const choosing *c, tp_columns *columns) {
  for (int axis = 0; axis < 2; axis++) {
    const int row = c->fields[columns->at[axis]].unit;
    if (row < 0) continue;
    if (units[row].unit == NULL) {
      return refuse(c, columns->at[axis],
                    "a unit that no lengths are taken in; convert them to mm, cm, m, km, in or ft");
    }
    if (columns->unit != NULL && strcmp(columns->unit, units[row].unit) != 0) {
      return refuse(c, columns->at[axis], "x and y are in units that differ; convert one of them");
    }
    columns->unit = units[row].unit;
  }
  return TP_OK;
}

static tp_status read_names(tp_columns *columns, const choosing *c) {
  kind x = NONE, y = NONE;
  pair_up(c, &x, &y);
  if (y == NONE) return refuse_half(c, x);
  tp_status status = check_twice(c, x);
  if (status == TP_OK) status = check_twice(c, y);
  if (status != TP_OK) return status;
  if (has(c, X) && has(c, ALONG) && !has(c, Y)) {
    return refuse(c, c->at[ALONG],
                  "the header names two columns along the section; name one of them otherwise");
  }
  const kind height = x == X && y == Y ? height_of(c) : NONE;
  *columns = (tp_columns){.count = c->row->count,
                          .at = {c->at[x], c->at[y]},
                          .words = {word_at(c, c->at[x]), word_at(c, c->at[y])},
                          .of_plan = x == EAST || x == NORTH,
                          .level = height != NONE ? c->at[height] : -1};
  return check_unit(c, columns);
}

/* "Block E, seen from the east": words between blanks, some of which happen to stand in the table.
 */
static bool is_title(const choosing *c) {
  kind x = NONE, y = NONE;
  pair_up(c, &x, &y);
  bool all = true;
  for (int k = 0; k < c->row->count; k++) all = all && c->fields[k].word >= 0;
  return y == NONE && !all && c->row->separator == ' ' && !has(c, X) && !has(c, Y);
}

tp_status tp_columns_read(tp_columns *columns, tp_header *header, const tp_csv_row *row,
                          tp_place line, tp_message *message) {
  choosing c = {.row = row, .line = line, .message = message};
  int known = 0, of_units = 0;
  for (int k = 0; k < KINDS; k++) c.at[k] = c.twice[k] = -1;
  for (int k = 0; k < row->count; k++) {
    c.fields[k] = read_field(row, k);
    of_units += c.fields[k].unit >= 0;
    if (c.fields[k].word < 0) continue;
    const kind own = words[c.fields[k].word].kind;
    known++;
    if (c.at[own] < 0) {
      c.at[own] = k;
    } else if (c.twice[own] < 0) {
      c.twice[own] = k;
    }
  }
  *header = known > 0                ? TP_HEADER_NAMES
            : of_units == row->count ? TP_HEADER_UNITS
                                     : TP_HEADER_TITLE;
  if (known > 0 && is_title(&c)) *header = TP_HEADER_TITLE;
  if (*header == TP_HEADER_NAMES) return read_names(columns, &c);
  if (*header == TP_HEADER_TITLE || columns->at[0] >= row->count || columns->at[1] >= row->count) {
    return TP_OK;
  }
  return check_unit(&c, columns);
}

tp_status tp_columns_note(const tp_columns *columns, tp_place line, tp_notes *notes,
                          tp_message *message) {
  const bool plain = strcmp(columns->words[0], "x") == 0 && strcmp(columns->words[1], "y") == 0;
  if (columns->of_plan) {
    return tp_notes_add(notes, message, TP_CAUTION, line,
                        "heights over '%s' alone are the section only where it runs that way; else "
                        "give distances along it",
                        columns->words[0]);
  }
  if (columns->count == 2 && columns->at[0] == 0) return TP_OK;
  if (plain) {
    return tp_notes_add(notes, message, TP_NOTE, line,
                        "columns %d and %d of %d are read as x and y, as the header names them",
                        columns->at[0] + 1, columns->at[1] + 1, columns->count);
  }
  return tp_notes_add(notes, message, TP_NOTE, line,
                      "columns %d ('%s') and %d ('%s') of %d are read as x and y, as the header "
                      "names them",
                      columns->at[0] + 1, columns->words[0], columns->at[1] + 1, columns->words[1],
                      columns->count);
}

void tp_column_level_init(tp_column_level *level) {
  level->given = false;
  fmpq_init(level->value);
}

void tp_column_level_clear(tp_column_level *level) {
  fmpq_clear(level->value);
}

bool tp_column_level_stays(tp_column_level *level, const tp_columns *columns,
                           const tp_csv_row *row) {
  const int column = columns->level;
  if (column < 0 || column >= row->count) return true;
  const tp_csv_field f = row->fields[column];
  const char *problem = NULL;
  fmpq_t own;
  fmpq_init(own);
  const bool known = tp_ratio_read_field(own, row->text + f.at, f.length, &problem);
  const bool stays = !known || !level->given || fmpq_equal(own, level->value);
  if (known) {
    level->given = true;
    fmpq_swap(own, level->value);
  }
  fmpq_clear(own);
  return stays;
}
