/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the page calls: a run of the program as a process has it, ended by exit, which writes what
 * is buffered; and where the program's own data ends, which the page puts back before each run, but
 * for the fonts in it, which nothing writes to. */

#include <emscripten/emscripten.h>
#include <stdlib.h>

int main(int argc, char **argv);

extern char __data_end;                       /* of the linker */
extern char core_fonts_begin, core_fonts_end; /* of fonts.py */

EMSCRIPTEN_KEEPALIVE void core_run(int argc, char **argv) {
  exit(main(argc, argv));
}

EMSCRIPTEN_KEEPALIVE char *core_data_end(void) {
  return &__data_end;
}

EMSCRIPTEN_KEEPALIVE char *core_fonts(int end) {
  return end ? &core_fonts_end : &core_fonts_begin;
}
