/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads and writes the progress file as YAML: fingerprints, shard, chunks, bytes, hash and counts
 * of the rows, with messages that name which input changed. */

#define _GNU_SOURCE /* asprintf */
#include "study/progress.h"

#include "output/file.h"
#include "output/sha256.h"
#include "output/text.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

char *tp_progress_path(const char *rows) {
  char *path = NULL;
  return asprintf(&path, "%s.progress", rows) >= 0 ? path : NULL;
}

static const char unknown[] =
    "this is not a progress file of a study; name another file for the rows";

enum { MOST_SHARDS = 1000000 }; /* as a run takes */

static bool read_whole(uint64_t *number, const tp_node *node, int base) {
  if (node == NULL || node->kind != TP_NODE_SCALAR) return false;
  char *end = NULL;
  errno = 0;
  *number = strtoull(node->text, &end, base);
  return end != node->text && *end == '\0' && errno == 0;
}

static bool read_count(uint64_t *count, const tp_node *root, const char *key, int base) {
  return read_whole(count, tp_node_get(root, key), base);
}

/* Which of them changed is told by the first fingerprint that differs. */
static tp_status check_files(const tp_node *root, const tp_study *study, tp_place place,
                             tp_message *message) {
  uint64_t file = 0, scene = 0, all = 0;
  if (!read_count(&file, root, "study", 16) || !read_count(&scene, root, "scene", 16) ||
      !read_count(&all, root, "files", 16)) {
    return tp_refuse(message, TP_FAULT_FORMAT, place, unknown);
  }
  if (all == study->hash) return TP_OK;
  const char *what = file != study->hash_of_file ? "these rows are of another study, or the study"
                     : scene != study->hash_of_scene
                         ? "the scene of these rows, or a file that it names,"
                         : "a file of numbers that the study of these rows names";
  return tp_refuse(message, TP_FAULT_FORMAT, place,
                   "%s has changed since; restart, or name another file", what);
}

/* As tp_sha256_text has written it. */
static bool read_hash(tp_row_counts *counts, const tp_node *root) {
  const tp_node *node = tp_node_get(root, "sha256");
  char text[TP_SHA256_TEXT];
  uint8_t hash[TP_SHA256_SIZE];
  if (node == NULL || node->kind != TP_NODE_SCALAR || strlen(node->text) != sizeof text - 1) {
    return false;
  }
  for (size_t k = 0; k < TP_SHA256_SIZE; k++) {
    unsigned byte = 0;
    if (sscanf(node->text + 2 * k, "%2x", &byte) != 1) return false;
    hash[k] = (uint8_t)byte;
  }
  for (size_t k = 0; k < TP_ROWS_HASH; k++) counts->hash[k] = 0;
  for (size_t k = 0; k < TP_SHA256_SIZE; k++) {
    counts->hash[k / 8] |= (uint64_t)hash[k] << 8 * (k % 8);
  }
  tp_sha256_text(text, hash);
  return strcmp(node->text, text) == 0;
}

static void write_hash(char text[TP_SHA256_TEXT], const tp_row_counts *counts) {
  uint8_t hash[TP_SHA256_SIZE];
  for (size_t k = 0; k < TP_SHA256_SIZE; k++) {
    hash[k] = (uint8_t)(counts->hash[k / 8] >> 8 * (k % 8));
  }
  tp_sha256_text(text, hash);
}

/* A list of so many whole numbers. */
static bool read_numbers(uint64_t *numbers, size_t count, const tp_node *root, const char *key) {
  const tp_node *list = tp_node_get(root, key);
  if (list == NULL || list->kind != TP_NODE_SEQUENCE || list->count != (long)count) return false;
  for (const tp_node *node = list->first; node != NULL; node = node->next, numbers++) {
    if (!read_whole(numbers, node, 10)) return false;
  }
  return true;
}

static void write_numbers(tp_text *text, const uint64_t *numbers, size_t count, const char *key) {
  tp_text_add(text, "%s: [", key);
  for (size_t k = 0; k < count; k++) tp_text_add(text, "%s%" PRIu64, k > 0 ? "," : "", numbers[k]);
  tp_text_add(text, "]\n");
}

/* Are they the numbers of a stretch of rows? */
static bool adds_up(const tp_row_counts *counts, const tp_study *study) {
  for (size_t k = 0; k <= study->tilt_count; k++) {
    uint64_t samples = 0;
    for (size_t j = 0; j < TP_STUDY_OUTCOMES; j++) samples += counts->outcomes[k][j];
    if (samples != counts->samples) return false;
  }
  return true;
}

/* What is not kept with the rows, or has a key of its own, is 0 in the list. */
static tp_row_counts listed(const tp_row_counts *counts) {
  tp_row_counts own = *counts;
  own.bytes = own.doubles_nanoseconds = own.ladder_nanoseconds = 0;
  memset(own.hash, 0, sizeof own.hash);
  return own;
}

static bool read_counts(tp_progress *progress, const tp_node *root, const tp_study *study) {
  tp_row_counts own;
  tp_row_counts_begin(&own, study);
  if (!read_numbers((uint64_t *)&own, tp_row_counts_numbers(study), root, "counts") ||
      !read_numbers(progress->invalid.places, TP_STUDY_BAD, root, "invalid") ||
      !adds_up(&own, study)) {
    return false;
  }
  own = listed(&own);
  progress->counts = own;
  return true;
}

static tp_status take(tp_progress *progress, const tp_node *root, const char *path,
                      const tp_study *study, tp_message *message) {
  uint64_t shard = 0, shards = 0, bytes = 0;
  const tp_node *version = tp_node_get(root, "topple");
  const tp_place place = {path, 0, 0};
  if (!read_count(&shard, root, "shard", 10) || !read_count(&shards, root, "shards", 10) ||
      !read_count(&progress->chunks, root, "chunks", 10) ||
      !read_count(&bytes, root, "bytes", 10) || version == NULL ||
      version->kind != TP_NODE_SCALAR || shard < 1 || shard > shards || shards > MOST_SHARDS) {
    return tp_refuse(message, TP_FAULT_FORMAT, place, unknown);
  }
  const tp_status status = check_files(root, study, place, message);
  if (status != TP_OK) return status;
  if (strcmp(version->text, TP_VERSION) != 0 || tp_node_get(root, "sha256") == NULL) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, place,
                     "these rows are by another version of this program; restart, or name another "
                     "file");
  }
  tp_row_counts hash;
  if (!read_hash(&hash, root) || !read_counts(progress, root, study)) {
    return tp_refuse(message, TP_FAULT_FORMAT, place, unknown);
  }
  memcpy(progress->counts.hash, hash.hash, sizeof hash.hash);
  progress->counts.bytes = bytes;
  progress->shard = (size_t)shard;
  progress->shards = (size_t)shards;
  return TP_OK;
}

static tp_status fail_link(const char *path, tp_message *message) {
  return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){path, 0, 0},
                   "this is a link, and what it leads to would be lost; remove it, or name another "
                   "file for the rows");
}

/* What is there, no link. */
static tp_status check_there(const char *path, tp_message *message) {
  tp_node *root = NULL;
  uint64_t number = 0;
  tp_message ignored = {.text = ""};
  const tp_status status = tp_node_read(&root, path, &ignored);
  const bool known = status == TP_OK && read_count(&number, root, "files", 16) &&
                     read_count(&number, root, "chunks", 10) &&
                     read_count(&number, root, "bytes", 10);
  tp_node_free(root);
  if (known) return TP_OK;
  if (status == TP_OUT_OF_MEMORY) return tp_fail_memory(message, "the progress of a study");
  return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){path, 0, 0},
                   "this is not a progress file of a study, and would be lost; remove it, or "
                   "name another file for the rows");
}

bool tp_progress_is_there(const char *rows) {
  char *path = tp_progress_path(rows);
  const bool there = path != NULL && access(path, F_OK) == 0;
  free(path);
  return there;
}

tp_status tp_progress_check(const char *rows, tp_message *message) {
  struct stat state;
  char *path = tp_progress_path(rows);
  if (path == NULL) return tp_fail_memory(message, "the progress of a study");
  const bool there = lstat(path, &state) == 0;
  const tp_status status = !there                   ? TP_OK
                           : S_ISLNK(state.st_mode) ? fail_link(path, message)
                                                    : check_there(path, message);
  free(path);
  return status;
}

tp_status tp_progress_read(tp_progress *progress, bool *there, const char *rows,
                           const tp_study *study, tp_message *message) {
  char *path = tp_progress_path(rows);
  if (path == NULL) return tp_fail_memory(message, "the progress of a study");
  tp_node *root = NULL;
  *there = access(path, F_OK) == 0;
  tp_status status = *there ? tp_node_read(&root, path, message) : TP_OK;
  if (status == TP_OK && *there) status = take(progress, root, path, study, message);
  tp_node_free(root);
  free(path);
  return status;
}

tp_status tp_progress_write(const tp_progress *progress, const char *rows, const tp_study *study,
                            tp_message *message) {
  char hash[TP_SHA256_TEXT];
  tp_text text = {0};
  char *path = tp_progress_path(rows);
  if (path == NULL) return tp_fail_memory(message, "the progress of a study");
  const tp_row_counts counts = listed(&progress->counts);
  write_hash(hash, &progress->counts);
  tp_text_add(&text,
              "# Progress of the rows beside this file. The study continues "
              "from here; shards are merged by it.\n"
              "topple: %s\nstudy: %016" PRIx64 "\nscene: %016" PRIx64 "\nfiles: %016" PRIx64
              "\nshard: %zu\nshards: %zu\n"
              "chunks: %" PRIu64 "\nbytes: %" PRIu64 "\nsha256: %s\n",
              TP_VERSION, study->hash_of_file, study->hash_of_scene, study->hash, progress->shard,
              progress->shards, progress->chunks, progress->counts.bytes, hash);
  write_numbers(&text, (const uint64_t *)&counts, tp_row_counts_numbers(study), "counts");
  write_numbers(&text, progress->invalid.places, TP_STUDY_BAD, "invalid");
  const tp_status status =
      text.failed ? tp_fail_memory(message, "the progress of a study")
                  : tp_file_write(path, text.data, text.length, (tp_file_sources){0}, message);
  tp_text_drop(&text);
  free(path);
  return status;
}
