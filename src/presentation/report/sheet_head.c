/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Letterhead and language of a sheet, from options and scene, with the logo read. */

#include "report/sheet_head.h"

#include "common/outside.h"
#include "terms/phrases.h"

#include <string.h>

static void take_texts(tp_sheet_head *own, const tp_letterhead *scene,
                       const tp_sheet_options *options) {
  const char *const asked[TP_LETTERHEAD_TEXTS] = {options->company, options->project,
                                                  options->job,     options->author,
                                                  options->checker, options->issued};
  for (int k = 0; k < TP_LETTERHEAD_TEXTS; k++) {
    own->texts[k] = asked[k] != NULL ? asked[k] : scene != NULL ? scene->texts[k] : NULL;
  }
}

static tp_status take_language(tp_sheet_head *own, const tp_letterhead *scene,
                               const tp_sheet_options *options, tp_message *message) {
  tp_decimal_sign sign = scene != NULL ? scene->decimal : TP_DECIMAL_OF_LANGUAGE;
  own->language = scene != NULL && scene->language != NULL ? scene->language : tp_languages;
  if (options->language != NULL) {
    own->language = tp_language_find(options->language);
    if (own->language == NULL) {
      return tp_refuse(message, TP_FAULT_KEY, (tp_place){"language", 0, 0},
                       "'%s' is no language of reports; known are: %s",
                       tp_quote_all(options->language).text, tp_language_codes);
    }
  }
  if (options->decimal != NULL && !tp_decimal_sign_read(&sign, options->decimal)) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){"decimal", 0, 0},
                     "the sign before decimals must be point or comma, not '%s'",
                     tp_quote_all(options->decimal).text);
  }
  own->comma = sign == TP_DECIMAL_OF_LANGUAGE ? own->language->comma : sign == TP_DECIMAL_COMMA;
  return TP_OK;
}

static tp_status take_logo(tp_sheet_head *own, const tp_letterhead *scene,
                           const tp_sheet_options *options, bool paper, tp_message *message) {
  const bool asked = options->logo != NULL;
  const char *path = asked ? options->logo : scene != NULL ? scene->logo : NULL;
  if (path == NULL) return TP_OK;
  const tp_place place = asked ? (tp_place){path, 0, 0} : scene->logo_place;
  const tp_status status = tp_logo_read(&own->logo, path, place, message);
  if (status != TP_OK || !paper || own->logo.kind != TP_LOGO_SVG) return status;
  tp_logo_clear(&own->logo);
  return tp_refuse(
      message, TP_FAULT_FORMAT, place,
      "a PDF can have a PNG or a JPEG as its logo, no SVG: give one of these, or write "
      "the report as .html");
}

tp_status tp_sheet_head_make(tp_sheet_head *head, const tp_letterhead *scene,
                             const tp_sheet_options *options, bool paper, tp_message *message) {
  tp_sheet_head own = {0};
  take_texts(&own, scene, options);
  tp_status status = take_language(&own, scene, options, message);
  if (status == TP_OK) status = take_logo(&own, scene, options, paper, message);
  if (status == TP_OK) *head = own;
  return status;
}

const char *tp_sheet_languages(void) {
  return tp_language_codes;
}

bool tp_sheet_is_language(const char *code) {
  return code != NULL && tp_language_find(code) != NULL;
}
