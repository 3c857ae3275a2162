/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The bytes of a mesh file while they are read: words and lines of a text, numbers of a binary one.
 * What stands in the file is not quoted: it may be any file, which the scene names by mistake. */

#ifndef TP_FORMAT_MESH_SOURCE_H
#define TP_FORMAT_MESH_SOURCE_H

#include "format/mesh.h"

#include <stdint.h>

typedef struct tp_mesh_source {
  const char *path;
  const char *at, *end;
  const char *line_start;
  int line; /* from 1 */
  tp_message *message;
} tp_mesh_source;

typedef struct tp_mesh_word {
  const char *text;
  size_t length; /* 0: the line, or the file, holds no more */
  int line, column;
} tp_mesh_word;

/* Past a byte order mark; a file in UTF-16 is refused. */
TP_MUST_USE tp_status tp_mesh_source_init(tp_mesh_source *source, const char *path,
                                          const char *bytes, size_t length, tp_message *message);

/* The next word of this line, and of the file; the rest of the line without blanks around it. */
tp_mesh_word tp_mesh_line_word(tp_mesh_source *source);
tp_mesh_word tp_mesh_file_word(tp_mesh_source *source);
tp_mesh_word tp_mesh_rest_of_line(tp_mesh_source *source);
/* To the beginning of the next line; false where there is none. */
bool tp_mesh_next_line(tp_mesh_source *source);
/* Is it this, in either case? */
bool tp_mesh_word_is(tp_mesh_word word, const char *text);

/* At a word, at the place that is reached, or of the file as a whole. */
tp_status tp_mesh_fail_word(const tp_mesh_source *source, tp_mesh_word word, const char *what);
tp_status tp_mesh_fail_line(const tp_mesh_source *source, const char *what);
tp_status tp_mesh_fail_file(const tp_mesh_source *source, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* A coordinate, and a whole number that a long holds. */
TP_MUST_USE tp_status tp_mesh_read_coordinate(fmpq_t value, const tp_mesh_source *source,
                                              tp_mesh_word word);
bool tp_mesh_read_whole(long *value, tp_mesh_word word);

/* The exact value of a double; false where it is not finite. */
TP_MUST_USE bool tp_mesh_set_double(fmpq_t value, double number);
/* Bytes as a number, the least significant one first or last. */
uint64_t tp_mesh_bits(const char *bytes, int count, bool little);
float tp_mesh_float(uint64_t bits);
double tp_mesh_double(uint64_t bits);

/* The readers of the formats. */
TP_MUST_USE tp_status tp_mesh_read_stl(tp_mesh *mesh, tp_mesh_source *source);
TP_MUST_USE tp_status tp_mesh_read_ply(tp_mesh *mesh, tp_mesh_source *source);
TP_MUST_USE tp_status tp_mesh_read_obj(tp_mesh *mesh, tp_mesh_source *source);

#endif
