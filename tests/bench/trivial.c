/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The least a C program does, which bench_process.c compares with. */

int main(void) {
  return 0;
}
