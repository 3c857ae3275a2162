/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A fingerprint of the files that a study rests on, by which a run that goes on, and shards that
 * are merged, know that they are of one study: FNV-1a of 64 bits. It tells files that were changed,
 * not files that were made to deceive. */

#ifndef TP_STUDY_HASH_H
#define TP_STUDY_HASH_H

#include "common/message.h"

#include <stdint.h>

#define TP_HASH_START UINT64_C(0xcbf29ce484222325)

uint64_t tp_hash_bytes(uint64_t hash, const void *bytes, size_t length);

/* And the bytes of a file, with their number. */
TP_MUST_USE tp_status tp_hash_file(uint64_t *hash, const char *path, tp_message *message);

/* The same of a text: that of a file which holds it. */
void tp_hash_text(uint64_t *hash, const char *text);

#endif
