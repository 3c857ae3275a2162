/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* FNV-1a over the bytes of a file and its length. */

#include "study/hash.h"
#include "common/input_file.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

uint64_t tp_hash_bytes(uint64_t hash, const void *bytes, size_t length) {
  const unsigned char *byte = bytes;
  for (size_t k = 0; k < length; k++) hash = (hash ^ byte[k]) * UINT64_C(0x100000001b3);
  return hash;
}

void tp_hash_text(uint64_t *hash, const char *text) {
  const uint64_t total = strlen(text);
  *hash = tp_hash_bytes(*hash, text, total);
  *hash = tp_hash_bytes(*hash, &total, sizeof total);
}

tp_status tp_hash_file(uint64_t *hash, const char *path, tp_message *message) {
  unsigned char bytes[1 << 14];
  uint64_t total = 0;
  FILE *file = NULL;
  const tp_status status = tp_input_open(&file, path, message);
  if (status != TP_OK) return status;
  size_t count = 0;
  while ((count = fread(bytes, 1, sizeof bytes, file)) > 0) {
    *hash = tp_hash_bytes(*hash, bytes, count);
    total += count;
  }
  const bool failed = ferror(file) != 0;
  const int why = errno;
  fclose(file);
  if (failed) return tp_fail_file(message, path, "read", why);
  *hash = tp_hash_bytes(*hash, &total, sizeof total);
  return TP_OK;
}
