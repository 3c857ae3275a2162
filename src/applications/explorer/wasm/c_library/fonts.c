/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The fonts of figures and sheets, which are part of the core (fonts.py): without Fontconfig, Cairo
 * finds none by a name. The linker puts this in place of cairo_select_font_face. */

#include <cairo-ft.h>
#include <stdlib.h>
#include <string.h>

#define DECLARE(name)                                                                              \
  extern const unsigned char core_font_##name[]; /* of fonts.py */                                 \
  extern const int core_font_##name##_size;

DECLARE(sans)
DECLARE(sans_bold)
DECLARE(sans_oblique)
DECLARE(serif)
DECLARE(serif_italic)
DECLARE(mono)

/* A font, and its face once it has been asked for: until the run ends, as each run is a new
 * process. */
typedef struct font {
  const char *family;
  cairo_font_slant_t slant;
  cairo_font_weight_t weight;
  const unsigned char *file;
  const int *size;
  cairo_font_face_t *face;
} font;

#define SANS "DejaVu Sans"
#define SERIF "DejaVu Serif"
#define UPRIGHT CAIRO_FONT_SLANT_NORMAL
#define ITALIC CAIRO_FONT_SLANT_ITALIC
#define NORMAL CAIRO_FONT_WEIGHT_NORMAL
#define FILE_OF(name) core_font_##name, &core_font_##name##_size, NULL

static font fonts[] = {
    {SANS, UPRIGHT, NORMAL, FILE_OF(sans)},
    {SANS, UPRIGHT, CAIRO_FONT_WEIGHT_BOLD, FILE_OF(sans_bold)},
    {SANS, ITALIC, NORMAL, FILE_OF(sans_oblique)},
    {SERIF, UPRIGHT, NORMAL, FILE_OF(serif)},
    {SERIF, ITALIC, NORMAL, FILE_OF(serif_italic)},
    {"DejaVu Sans Mono", UPRIGHT, NORMAL, FILE_OF(mono)},
};

void __wrap_cairo_select_font_face(cairo_t *cr, const char *family, cairo_font_slant_t slant,
                                   cairo_font_weight_t weight);

/* FreeType, begun once in a run. */
static FT_Library library(void) {
  static FT_Library begun;
  if (begun == NULL && FT_Init_FreeType(&begun) != 0) abort(); /* no memory: the page begins anew */
  return begun;
}

void __wrap_cairo_select_font_face(cairo_t *cr, const char *family, cairo_font_slant_t slant,
                                   cairo_font_weight_t weight) {
  font *own = fonts;
  while (strcmp(own->family, family) != 0 || own->slant != slant || own->weight != weight) {
    if (++own == fonts + sizeof fonts / sizeof *fonts) abort(); /* a new font: add its file */
  }
  if (own->face == NULL) {
    FT_Face face = NULL;
    if (FT_New_Memory_Face(library(), own->file, *own->size, 0, &face) != 0) abort();
    own->face = cairo_ft_font_face_create_for_ft_face(face, 0);
  }
  cairo_set_font_face(cr, own->face);
}
