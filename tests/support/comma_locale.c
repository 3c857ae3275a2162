/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Its sources are written here, since Debian's come with a package that need not be there;
 * localedef comes with the C library. */

#define _GNU_SOURCE
#include "comma_locale.h"

#include <check.h>
#include <stdio.h>
#include <stdlib.h>

void comma_locale_make(const char *folder) {
  char path[64], command[400];
  snprintf(path, sizeof path, "%s/comma", folder);
  FILE *file = fopen(path, "w");
  ck_assert_ptr_nonnull(file);
  fputs("comment_char %\nescape_char /\nLC_NUMERIC\ndecimal_point \",\"\nthousands_sep \".\"\n"
        "grouping 3;3\nEND LC_NUMERIC\n",
        file);
  fclose(file);
  snprintf(path, sizeof path, "%s/ascii", folder);
  file = fopen(path, "w");
  ck_assert_ptr_nonnull(file);
  fputs("<code_set_name> ANSI_X3.4-1968\n<comment_char> %\n<escape_char> /\n<mb_cur_min> 1\n"
        "<mb_cur_max> 1\nCHARMAP\n",
        file);
  for (unsigned k = 0; k < 128; k++) fprintf(file, "<U%04X> /x%02x\n", k, k);
  fputs("END CHARMAP\n", file);
  fclose(file);
  /* it warns of the categories that are left out, and makes the locale all the same */
  snprintf(command, sizeof command,
           "localedef -c --no-archive -i '%s/comma' -f '%s/ascii' '%s/" COMMA_LOCALE
           "' 2>'%s/complaints'",
           folder, folder, folder, folder);
  const int ended = system(command);
  (void)ended;
  setenv("LOCPATH", folder, 1);
}
