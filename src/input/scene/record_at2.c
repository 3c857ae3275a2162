/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* PEER's files of acceleration: some lines of text, then "NPTS= 4000, DT= .0100 SEC", as the NGA
 * database writes it, or "4000 0.0100 NPTS, DT", as older files have it, then the numbers. */

#define _GNU_SOURCE
#include "scene/record_at2.h"

#include "number/ratio.h"

#include <ctype.h>
#include <string.h>

enum { MOST_HEADER_LINES = 10 };

typedef struct header {
  bool accelerations, of_g;
  long count;
  fmpq_t step;
} header;

/* Without regard to case. */
static bool says(const tp_record_source *source, const char *words) {
  return strcasestr(source->line, words) != NULL;
}

/* A dash within a word is no sign. */
static bool begins_number(const char *line, size_t at) {
  const char *text = line + at;
  const bool within = at > 0 && isalnum((unsigned char)line[at - 1]);
  if ((text[0] == '-' || text[0] == '+') && !within) text++;
  return (text[0] >= '0' && text[0] <= '9') || (text[0] == '.' && text[1] >= '0' && text[1] <= '9');
}

/* The next number of the line from `*at` on, with its sign; false where there is none. */
static bool next_number(fmpq_t value, size_t *at, const tp_record_source *source) {
  const char *problem = NULL;
  while (*at < source->length && !begins_number(source->line, *at)) (*at)++;
  if (*at == source->length) return false;
  const bool negative = source->line[*at] == '-';
  if (negative || source->line[*at] == '+') (*at)++;
  const size_t used =
      tp_ratio_read_decimal(value, source->line + *at, source->length - *at, &problem);
  if (negative) fmpq_neg(value, value);
  *at += used;
  return used > 0;
}

/* How many samples, and their step: in this order, wherever their names stand. */
static tp_status read_sampling(header *h, const tp_record_source *source) {
  size_t at = 0, of_step = 0;
  fmpq_t count;
  fmpq_init(count);
  bool both = next_number(count, &at, source);
  const size_t of_count = at > 0 ? at - 1 : 0; /* its last digit */
  both = both && next_number(h->step, &at, source);
  of_step = at > 0 ? at - 1 : 0;
  const bool whole = both && fmpz_is_one(fmpq_denref(count)) && fmpq_cmp_ui(count, 2) >= 0 &&
                     fmpz_cmp_si(fmpq_numref(count), TP_RECORD_MOST) <= 0;
  h->count = whole ? fmpz_get_si(fmpq_numref(count)) : 0;
  fmpq_clear(count);
  if (!both) return tp_record_fail(source, 0, "NPTS and DT are named here, but not both given");
  if (!whole)
    return tp_record_fail(source, of_count, "NPTS must be a whole number from 2 to 10 million");
  if (fmpq_sgn(h->step) > 0) return TP_OK;
  return tp_record_fail(source, of_step, "DT, the step in seconds, must be above zero");
}

static tp_status read_header(header *h, tp_record_source *source) {
  bool more = true, named = false;
  tp_status status = TP_OK;
  while (status == TP_OK && more && !named && source->number < MOST_HEADER_LINES) {
    status = tp_record_next(source, &more);
    if (status != TP_OK || !more) break;
    h->accelerations = h->accelerations || says(source, "ACCEL");
    h->of_g = h->of_g || says(source, "UNITS OF G") || says(source, "(G)");
    named = says(source, "NPTS") && says(source, "DT");
  }
  if (status != TP_OK) return status;
  if (!named) {
    return tp_record_fail(
        source, 0, "no line with NPTS and DT among the first 10: this is not an .at2 file of PEER");
  }
  if (!h->accelerations || !h->of_g) {
    return tp_record_fail(source, 0,
                          "the header above does not say ACCELERATION … IN UNITS OF G: this is not "
                          "an acceleration in shares of gravity, and other units are not guessed; "
                          "write a CSV file with a header such as 'time_s,acceleration_m_s2'");
  }
  return read_sampling(h, source);
}

/* The numbers of a line. */
static tp_status read_line(tp_polyline *record, const header *h, const tp_record_source *source) {
  static const char blanks[] = " \t";
  tp_status status = TP_OK;
  fmpq_t time, value;
  fmpq_init(time);
  fmpq_init(value);
  for (size_t at = strspn(source->line, blanks); at < source->length && status == TP_OK;) {
    const size_t length = strcspn(source->line + at, blanks);
    if (record->count == h->count) {
      status = tp_record_fail(source, at, "more numbers than NPTS says");
    }
    if (status == TP_OK) status = tp_record_value(value, source, at, length);
    if (status == TP_OK) {
      fmpq_mul_si(time, h->step, record->count);
      status = tp_record_append(record, source, time, value, at);
    }
    at += length;
    at += strspn(source->line + at, blanks);
  }
  fmpq_clear(time);
  fmpq_clear(value);
  return status;
}

static tp_status read_numbers(tp_polyline *record, const header *h, tp_record_source *source) {
  bool more = true;
  tp_status status = TP_OK;
  while (status == TP_OK && more) {
    status = tp_record_next(source, &more);
    if (status == TP_OK && more) status = read_line(record, h, source);
  }
  if (status != TP_OK || record->count == h->count) return status;
  return tp_refuse(source->message, TP_FAULT_FORMAT, (tp_place){source->path, source->number, 0},
                   "the file ends after %ld numbers, of %ld that NPTS says", record->count,
                   h->count);
}

tp_status tp_record_read_at2(tp_polyline *record, tp_record_source *source) {
  header h = {.count = 0};
  fmpq_init(h.step);
  tp_status status = read_header(&h, source);
  if (status == TP_OK) status = read_numbers(record, &h, source);
  fmpq_clear(h.step);
  return status;
}
