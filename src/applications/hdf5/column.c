/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Types and data sets of one column with chunks of 8192 rows, deflated; a block is filled row by
 * row and written as one hyperslab. */

#include "hdf5/column.h"

#include <stdlib.h>
#include <string.h>

enum { BLOCK_ROWS = 8192, DEFLATION = 4 };

size_t tp_hdf5_block_rows(uint64_t rows) {
  return rows == 0 ? 1 : rows < BLOCK_ROWS ? (size_t)rows : BLOCK_ROWS;
}

/* ---- open, close -------------------------------------------------------------------------------
 */

static hid_t text_type(size_t size) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  if (type >= 0 && H5Tset_size(type, size) >= 0 && H5Tset_cset(type, H5T_CSET_UTF8) >= 0) {
    return type;
  }
  if (type >= 0) (void)H5Tclose(type);
  return H5I_INVALID_HID;
}

static bool set_type(tp_hdf5_column *column) {
  switch (column->kind) {
  case TP_FIELD_WHOLE:
    column->type = H5Tcopy(H5T_NATIVE_UINT64);
    column->size = sizeof(uint64_t);
    break;
  case TP_FIELD_NUMBER:
    column->type = H5Tcopy(H5T_NATIVE_DOUBLE);
    column->size = sizeof(double);
    break;
  case TP_FIELD_WORDS:
    column->type = text_type(TP_FIELD_WORDS_SIZE);
    column->size = TP_FIELD_WORDS_SIZE;
    break;
  case TP_FIELD_TEXT:
    column->type = text_type(H5T_VARIABLE);
    column->size = sizeof(char *);
    break;
  }
  return column->type >= 0;
}

/* In the byte order of this machine, which HDF5 notes; without times, which would be other bytes
 * each time. */
static hid_t create(const tp_hdf5_column *column, hid_t file, const char *name, uint64_t rows) {
  const hsize_t size[] = {rows}, chunk[] = {tp_hdf5_block_rows(rows)};
  const hid_t space = H5Screate_simple(1, size, NULL);
  const hid_t plan = H5Pcreate(H5P_DATASET_CREATE), access = H5Pcreate(H5P_DATASET_ACCESS);
  hid_t set = H5I_INVALID_HID;
  /* each chunk is written once, as a whole: none is to be kept in memory */
  const bool planned = H5Pset_obj_track_times(plan, false) >= 0 &&
                       H5Pset_chunk(plan, 1, chunk) >= 0 && H5Pset_shuffle(plan) >= 0 &&
                       H5Pset_deflate(plan, DEFLATION) >= 0 &&
                       H5Pset_chunk_cache(access, 0, 0, 1) >= 0;
  if (space >= 0 && planned) {
    set = H5Dcreate2(file, name, column->type, space, H5P_DEFAULT, plan, access);
  }
  if (space >= 0) (void)H5Sclose(space);
  if (plan >= 0) (void)H5Pclose(plan);
  if (access >= 0) (void)H5Pclose(access);
  return set;
}

bool tp_hdf5_column_open(tp_hdf5_column *column, hid_t file, const tp_study *study, size_t field,
                         uint64_t rows) {
  const char *unit = tp_study_field_unit(study, field);
  tp_text name = {0};
  *column = (tp_hdf5_column){.field = field,
                             .kind = tp_study_field_kind_of(study, field),
                             .set = H5I_INVALID_HID,
                             .type = H5I_INVALID_HID};
  tp_study_field_name(&name, study, field);
  if (set_type(column) && !name.failed) column->set = create(column, file, name.data, rows);
  tp_text_drop(&name);
  column->block = calloc(tp_hdf5_block_rows(rows), column->size);
  return column->block != NULL && column->set >= 0 &&
         (unit == NULL || tp_hdf5_note_text(column->set, "unit", unit));
}

static void drop_texts(tp_hdf5_column *column, size_t count) {
  char **texts = (char **)column->block;
  for (size_t k = 0; k < count; k++) {
    free(texts[k]);
    texts[k] = NULL;
  }
}

void tp_hdf5_column_close(tp_hdf5_column *column, size_t filled) {
  if (column->kind == TP_FIELD_TEXT && column->block != NULL) drop_texts(column, filled);
  if (column->set >= 0) (void)H5Dclose(column->set);
  if (column->type >= 0) (void)H5Tclose(column->type);
  free(column->block);
}

/* ---- rows --------------------------------------------------------------------------------------
 */

bool tp_hdf5_column_put(tp_hdf5_column *column, size_t at, tp_study_value value) {
  char *place = column->block + at * column->size;
  const char *words = value.words != NULL ? value.words : "";
  char *copy = NULL;
  switch (column->kind) {
  case TP_FIELD_WHOLE:
    memcpy(place, &value.whole, sizeof value.whole);
    break;
  case TP_FIELD_NUMBER:
    memcpy(place, &value.number, sizeof value.number);
    break;
  case TP_FIELD_WORDS:
    strncpy(place, words, TP_FIELD_WORDS_SIZE - 1); /* and zeros to its end */
    break;
  case TP_FIELD_TEXT:
    copy = strdup(words);
    memcpy(place, &copy, sizeof copy);
    return copy != NULL;
  }
  return true;
}

bool tp_hdf5_column_write(tp_hdf5_column *column, uint64_t first, size_t count) {
  const hsize_t begin[] = {first}, size[] = {count};
  const hid_t there = H5Dget_space(column->set), here = H5Screate_simple(1, size, NULL);
  const bool written =
      there >= 0 && here >= 0 &&
      H5Sselect_hyperslab(there, H5S_SELECT_SET, begin, NULL, size, NULL) >= 0 &&
      H5Dwrite(column->set, column->type, here, there, H5P_DEFAULT, column->block) >= 0;
  if (there >= 0) (void)H5Sclose(there);
  if (here >= 0) (void)H5Sclose(here);
  if (column->kind == TP_FIELD_TEXT) drop_texts(column, count);
  return written;
}

/* ---- packed ------------------------------------------------------------------------------------
 */

/* Of a chunk: which filters HDF5 left out, and its bytes. */
typedef struct chunk_head {
  uint64_t size;
  uint32_t left_out;
} chunk_head;

static bool pack_chunk(const tp_hdf5_column *column, tp_text *packed, uint64_t first) {
  const hsize_t offset[] = {first};
  hsize_t size = 0;
  chunk_head head = {0};
  if (H5Dget_chunk_storage_size(column->set, offset, &size) < 0) return false;
  char *bytes = malloc(size);
  const bool read =
      bytes != NULL && H5Dread_chunk(column->set, H5P_DEFAULT, offset, &head.left_out, bytes) >= 0;
  head.size = size;
  if (read) tp_text_append(packed, (const char *)&head, sizeof head);
  if (read) tp_text_append(packed, bytes, size);
  free(bytes);
  return read && !packed->failed;
}

bool tp_hdf5_column_pack(tp_hdf5_column *column, tp_text *packed, uint64_t first, size_t count) {
  if (column->kind != TP_FIELD_TEXT) {
    return tp_hdf5_column_write(column, first, count) && pack_chunk(column, packed, first);
  }
  char **texts = (char **)column->block;
  for (size_t k = 0; k < count; k++) tp_text_append(packed, texts[k], strlen(texts[k]) + 1);
  drop_texts(column, count);
  return !packed->failed;
}

static bool unpack_chunk(const tp_hdf5_column *column, const char **from, const char *end,
                         uint64_t first) {
  const hsize_t offset[] = {first};
  chunk_head head;
  if ((size_t)(end - *from) < sizeof head) return false;
  memcpy(&head, *from, sizeof head);
  *from += sizeof head;
  if ((size_t)(end - *from) < head.size) return false;
  const char *bytes = *from;
  *from += head.size;
  return H5Dwrite_chunk(column->set, H5P_DEFAULT, head.left_out, offset, head.size, bytes) >= 0;
}

bool tp_hdf5_column_unpack(tp_hdf5_column *column, const char **from, const char *end,
                           uint64_t first, size_t count) {
  if (column->kind != TP_FIELD_TEXT) return unpack_chunk(column, from, end, first);
  for (size_t k = 0; k < count; k++) {
    const size_t length = strnlen(*from, (size_t)(end - *from));
    if (*from + length == end || !tp_hdf5_column_put(column, k, (tp_study_value){.words = *from})) {
      drop_texts(column, k);
      return false;
    }
    *from += length + 1;
  }
  return tp_hdf5_column_write(column, first, count);
}
