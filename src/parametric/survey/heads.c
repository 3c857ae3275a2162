/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the head of a column names: a short name of heads_table.h, or a key of a scene; with a unit
 * in brackets, or behind an _ at its end. A head that is neither is refused, as numbers that are
 * left out by mistake would make a block look as the scene below it has it. */

#include "common/outside.h"
#include "scene/unit.h"
#include "survey/heads_table.h"
#include "survey/survey.h"
#include "terms/table.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WORD = 80, UNIT = 16 };

/* A head without its unit. */
typedef struct head {
  char word[WORD], unit[UNIT];
} head;

static const struct {
  tp_column_kind kind;
  const char *word, *key;
} short_names[] = {
#define TP_COLUMN_PLANE_REVERSED TP_COLUMN_PLANE /* its word has the order */
#define HEAD_ROW(kind, word, key) {TP_COLUMN_##kind, word, key},
    TP_SURVEY_HEADS(HEAD_ROW)
#undef HEAD_ROW
#undef TP_COLUMN_PLANE_REVERSED
};

enum { SHORT_NAMES = sizeof short_names / sizeof short_names[0] };

static const struct {
  const char *name, *metres;
} lengths[] = {
#define LENGTH_ROW(name, metres) {name, metres},
    TP_SURVEY_LENGTHS(LENGTH_ROW)
#undef LENGTH_ROW
};

static const struct {
  const char *of_key, *of_head, *factor;
} conversions[] = {
#define UNIT_ROW(of_key, of_head, factor) {of_key, of_head, factor},
    TP_SURVEY_UNITS(UNIT_ROW)
#undef UNIT_ROW
};

static const char *length_unit(const char *unit) {
  for (size_t k = 0; k < sizeof lengths / sizeof lengths[0]; k++) {
    if (strcmp(lengths[k].name, unit) == 0) return lengths[k].name;
  }
  return NULL;
}

/* ---- words -------------------------------------------------------------------------------------
 */

/* "dip_/_dip_direction" without what is around the slash. */
static void close_slash(char *word) {
  char *to = word;
  for (const char *at = word; *at != '\0'; at++) {
    const bool before = *at == '_' && at[strspn(at, "_")] == '/';
    if (before || (*at == '_' && to > word && to[-1] == '/')) continue;
    *to++ = *at;
  }
  *to = '\0';
}

/* Small letters, _ for blanks and hyphens, and what stands in brackets at the end apart; false: it
 * is too long. */
static bool split(head *own, const char *text) {
  const size_t length = strlen(text);
  const char *bracket = strpbrk(text, "([");
  if (length >= WORD) return false;
  *own = (head){.word = ""};
  size_t size = bracket != NULL && bracket > text ? (size_t)(bracket - text) : length;
  for (size_t k = size; k < length; k++) {
    const char c = text[k];
    const size_t at = strlen(own->unit);
    if (strchr("()[] ", c) != NULL) continue;
    if (at + 1 >= UNIT) return false;
    own->unit[at] = (char)tolower((unsigned char)c);
  }
  while (size > 0 && strchr(" _", text[size - 1]) != NULL) size--;
  for (size_t k = 0; k < size; k++) {
    const char c = text[k];
    own->word[k] = (char)(c == ' ' || c == '-' ? '_' : tolower((unsigned char)c));
  }
  close_slash(own->word);
  return true;
}

/* One spelling of a unit: "°" is deg, "m³" m3. */
static void spell(char unit[UNIT]) {
  static const struct {
    const char *is, *to;
  } others[] = {{"\xc2\xb0", "deg"},
                {"degrees", "deg"},
                {"degree", "deg"},
                {"deg/deg", "deg"},
                {"\xc2\xb0/\xc2\xb0", "deg"},
                {"kn/m\xc2\xb3", "kn/m3"},
                {"kn/m^3", "kn/m3"},
                {"kn_m3", "kn/m3"},
                {"mn/m\xc2\xb3", "mn/m3"},
                {"g", ""},
                {"-", ""},
                {"share of the weight", ""}};
  for (size_t k = 0; k < sizeof others / sizeof others[0]; k++) {
    if (strcmp(unit, others[k].is) == 0) strcpy(unit, others[k].to);
  }
}

/* A unit behind the last _ goes apart; false: there is none. */
static bool split_ending(head *own) {
  static const char *const endings[] = {"_deg", "_kn_m3", "_kpa", "_mpa", "_kn", "_mm",
                                        "_cm",  "_m",     "_km",  "_in",  "_ft"};
  const size_t length = strlen(own->word);
  for (size_t k = 0; k < sizeof endings / sizeof endings[0]; k++) {
    const size_t size = strlen(endings[k]);
    if (length <= size || strcmp(own->word + length - size, endings[k]) != 0) continue;
    strcpy(own->unit, endings[k] + 1);
    own->word[length - size] = '\0';
    return true;
  }
  return false;
}

/* Which short name it is; SHORT_NAMES: none. */
static size_t find_short(const char *word) {
  size_t k = 0;
  while (k < SHORT_NAMES && strcmp(short_names[k].word, word) != 0) k++;
  return k;
}

/* Is it a key of a scene: its path in the table, with [] for the number of an item, or a parameter?
 */
static bool is_key(const char *word) {
  char path[2 * WORD] = "";
  size_t length = 0;
  if (strncmp(word, "parameters.", strlen("parameters.")) == 0) return true;
  for (const char *at = word; *at != '\0';) {
    const size_t size = strcspn(at, ".");
    if (at != word && size > 0 && strspn(at, "0123456789") >= size) {
      length += (size_t)sprintf(path + length, "[]");
    } else {
      length += (size_t)sprintf(path + length, "%s%.*s", at != word ? "." : "", (int)size, at);
    }
    at += size + (at[size] == '.');
  }
  for (size_t k = 0; k < tp_file_key_count; k++) {
    const size_t own = strlen(tp_file_keys[k].path);
    if (strcmp(tp_file_keys[k].file, "scene") != 0 || strncmp(tp_file_keys[k].path, path, own) != 0)
      continue;
    if (path[own] == '\0' || strcmp(path + own, "[]") == 0) return true;
  }
  return false;
}

/* ---- a column ----------------------------------------------------------------------------------
 */

static tp_status refuse(const tp_survey *survey, size_t column, tp_fault fault, const char *what,
                        tp_message *message) {
  const tp_place place = {survey->path, (int)survey->cells.rows[0].line, 0};
  return tp_refuse(message, fault, place, "column %zu, '%s': %s", column + 1,
                   tp_quote_all(tp_cells_text(&survey->cells, 0, column)).text, what);
}

static tp_status refuse_unknown(const tp_survey *survey, size_t column, const char *word,
                                tp_message *message) {
  const char *words[SHORT_NAMES + 1] = {NULL};
  char what[400];
  for (size_t k = 0; k < SHORT_NAMES; k++) words[k] = short_names[k].word;
  const char *nearest = tp_nearest(word, words);
  snprintf(what, sizeof what,
           "no column is called so%s%s%s; give a short name (name, outline, width, height, dip, "
           "friction, water, unit weight, cohesion, k_h, required_fos) or a key of a scene, as "
           "loads.water.height, or call it notes",
           nearest != NULL ? "; did you mean '" : "", nearest != NULL ? nearest : "",
           nearest != NULL ? "'" : "");
  return refuse(survey, column, TP_FAULT_KEY, what, message);
}

/* The unit of the head against that of the key. */
static tp_status take_unit(tp_column *own, const head *h, const tp_survey *survey, size_t column,
                           tp_message *message) {
  char unit[UNIT], what[300];
  strcpy(unit, h->unit);
  spell(unit);
  own->is_length = tp_key_is_length(own->key);
  if (unit[0] == '\0') return TP_OK;
  if (own->is_length) {
    own->unit = length_unit(unit);
    if (own->unit != NULL) return TP_OK;
    return refuse(survey, column, TP_FAULT_UNIT,
                  "it is a length; its unit is mm, cm, m, km, in or ft", message);
  }
  const bool parameter = strncmp(own->key, "parameters.", strlen("parameters.")) == 0;
  const char *of_key = parameter ? NULL : tp_key_unit(NULL, own->key);
  if (of_key == NULL) {
    return refuse(survey, column, TP_FAULT_UNIT,
                  "it is a number without a unit; leave out the one in brackets", message);
  }
  for (size_t k = 0; k < sizeof conversions / sizeof conversions[0]; k++) {
    if (strcmp(conversions[k].of_key, of_key) != 0) continue;
    if (strcmp(conversions[k].of_head, unit) == 0) own->factor = conversions[k].factor;
  }
  if (own->factor != NULL || strcasecmp(of_key, unit) == 0) return TP_OK;
  snprintf(what, sizeof what, "it is given in %s, not in '%s'; write (%s) and numbers of that unit",
           of_key, tp_quote_all(unit).text, of_key);
  return refuse(survey, column, TP_FAULT_UNIT, what, message);
}

static tp_status read_column(tp_column *own, const tp_survey *survey, size_t column,
                             tp_message *message) {
  head h;
  own->head = tp_cells_text(&survey->cells, 0, column);
  if (own->head[0] == '\0') {
    own->kind = TP_COLUMN_PASSED; /* must be empty below, too */
    return TP_OK;
  }
  if (!split(&h, own->head)) {
    return refuse(survey, column, TP_FAULT_KEY, "the name is too long for one", message);
  }
  size_t k = find_short(h.word);
  const bool key = k == SHORT_NAMES && is_key(h.word);
  if (k == SHORT_NAMES && !key && h.unit[0] == '\0' && split_ending(&h)) k = find_short(h.word);
  if (k == SHORT_NAMES && !key) return refuse_unknown(survey, column, h.word, message);
  own->kind = key ? TP_COLUMN_KEY : short_names[k].kind;
  own->key = strdup(key ? h.word : short_names[k].key);
  if (own->key == NULL) return tp_fail_memory(message, "a table");
  if (own->kind != TP_COLUMN_KEY && own->kind != TP_COLUMN_PLANE) return TP_OK;
  tp_column_take_rule(own);
  own->reversed = own->kind == TP_COLUMN_PLANE && strncmp(h.word, "dip/", strlen("dip/")) != 0;
  return take_unit(own, &h, survey, column, message);
}

const char tp_plane_direction_key[] = "slope.dip_direction_deg";

/* Does the column give the number of the key? */
static bool is_of_key(const tp_column *column, const char *key) {
  if (column->kind != TP_COLUMN_KEY && column->kind != TP_COLUMN_PLANE) return false;
  return strcmp(column->key, key) == 0 ||
         (column->kind == TP_COLUMN_PLANE && strcmp(tp_plane_direction_key, key) == 0);
}

/* Two columns that say the same. */
static tp_status check_once(const tp_survey *survey, size_t column, tp_message *message) {
  const tp_column *own = survey->columns + column;
  for (size_t k = 0; k < column; k++) {
    const tp_column *other = survey->columns + k;
    const bool keyed = own->kind == TP_COLUMN_KEY || own->kind == TP_COLUMN_PLANE;
    const bool plane = own->kind == TP_COLUMN_PLANE;
    const bool same =
        keyed ? is_of_key(other, own->key) || (plane && is_of_key(other, tp_plane_direction_key))
              : own->kind != TP_COLUMN_PASSED && own->kind == other->kind;
    if (!same) continue;
    return refuse(survey, column, TP_FAULT_KEY,
                  "an earlier column says the same; leave out one of the two", message);
  }
  return TP_OK;
}

tp_status tp_survey_read(tp_survey *survey, const char *path, const char *text,
                         tp_message *message) {
  survey->path = path;
  tp_status status = tp_cells_read(&survey->cells, path, text, message);
  if (status != TP_OK) return status;
  const size_t count = survey->cells.rows[0].count;
  survey->columns = calloc(count, sizeof *survey->columns);
  if (survey->columns == NULL) return tp_fail_memory(message, "a table");
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    survey->column_count = k + 1;
    status = read_column(survey->columns + k, survey, k, message);
    if (status == TP_OK) status = check_once(survey, k, message);
  }
  if (status == TP_OK && survey->scene != NULL) {
    /* what is wrong with it each row tells that is over it */
    tp_message own;
    const tp_status read = tp_node_read(&survey->root, survey->scene, &own);
    if (read == TP_OUT_OF_MEMORY) return tp_fail_memory(message, "a table");
  }
  return status;
}

void tp_survey_clear(tp_survey *survey) {
  for (size_t k = 0; k < survey->column_count; k++) free(survey->columns[k].key);
  free(survey->columns);
  tp_cells_clear(&survey->cells);
  tp_node_free(survey->root);
  *survey = (tp_survey){0};
}

const char *tp_survey_cell(const tp_survey *survey, size_t row, tp_column_kind kind) {
  for (size_t k = 0; k < survey->column_count; k++) {
    if (survey->columns[k].kind != kind) continue;
    const char *text = tp_cells_text(&survey->cells, row, k);
    return text[0] != '\0' ? text : NULL;
  }
  return NULL;
}
