/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* FreeType's own options, without packed fonts, the environment and files of old Macintoshes. */

#ifndef TP_WASM_FREETYPE_OPTIONS_H
#define TP_WASM_FREETYPE_OPTIONS_H

#include <freetype/config/ftoption.h>

#undef FT_CONFIG_OPTION_ENVIRONMENT_PROPERTIES
#undef FT_CONFIG_OPTION_MAC_FONTS
#undef FT_CONFIG_OPTION_USE_LZW
#undef FT_CONFIG_OPTION_USE_ZLIB

#endif
