/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The basic shapes of SVG, and its paths, by their attributes. */

#ifndef TP_FORMAT_SVG_SHAPE_H
#define TP_FORMAT_SVG_SHAPE_H

#include "format/svg_path.h"

/* The value of an attribute of a list name, value, …, NULL; NULL: it has none. */
const char *tp_svg_attribute(const char *const *attributes, const char *name);

/* The word of a shape, a static text; NULL: it is none. */
const char *tp_svg_shape_kind(const char *element);

/* Objects of a shape, whose kind the target has. False with the problem set, or with no memory. */
bool tp_svg_shape(tp_svg_target *target, const char *const *attributes, const char **problem);

#endif
