/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the harnesses share: an entry each for libFuzzer or for replay.c, and what must hold of
 * every call whatever its input. Inputs are bounded so that one takes well under a second. */

#ifndef TP_TEST_FUZZ_H
#define TP_TEST_FUZZ_H

#include "topple.h"

#include <stdint.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Abort, which counts as a finding, unless this holds. */
#define FUZZ_EXPECT(condition) fuzz_expect(condition, #condition, __FILE__, __LINE__)
void fuzz_expect(bool condition, const char *what, const char *file, int line);

/* The input as a text of just its size, so that reading on is noticed; the caller's to free. */
char *fuzz_text(const uint8_t *data, size_t size);

/* A call that is done has an output; one that failed says why and leaves its output NULL. */
void fuzz_judge(tp_status status, const void *output, const tp_message *message);

/* JSON that has a word for what is no number is a finding. */
void fuzz_judge_json(const char *json);

/* Print a solution in every way; no number is NaN, and every bound is a bound. */
void fuzz_report(const tp_solution *solution);
void fuzz_report_derivation(const tp_derivation *derivation);

/* What an input decides, byte after byte; zeros after its end. */
typedef struct fuzz_bytes {
  const uint8_t *at, *end;
} fuzz_bytes;

/* From 0 to count - 1, count at most 256. */
unsigned fuzz_pick(fuzz_bytes *bytes, unsigned count);

/* A scene drawn from the bytes, as the text of its file: any form of block and base, loads,
 * friction and tilt, most of them valid; the caller's to free. */
char *fuzz_scene(fuzz_bytes *bytes);

#endif
