/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the headers of columns of points mean, a row each. To be reviewed without knowing C.
 *
 *   ROW(kind, word)
 *
 * A header is read in small letters, with single blanks for all that is neither letter nor digit,
 * without a unit at its end or in brackets: "Chainage_(m)" is "chainage". It is a word of this
 * table, or begins with one ("x coordinate", "distance along the section"); the longest counts.
 * Words of one letter other than x, y and z stand alone.
 *
 *   X, Y, Z       the axes; Z is up, and beside X and Y no section unless it stays the same
 *   ALONG         horizontal, along a line of section
 *   HEIGHT        vertical, upwards
 *   DEPTH         vertical, downwards: refused in place of a height
 *   EAST, NORTH   of a plan: both together need a line of section
 *   DEGREES       on the globe: refused */

#ifndef TP_FORMAT_COLUMN_WORDS_TABLE_H
#define TP_FORMAT_COLUMN_WORDS_TABLE_H

#define TP_COLUMN_WORDS(ROW)                                                                       \
  ROW(X, "x")                                                                                      \
  ROW(Y, "y")                                                                                      \
  ROW(Z, "z")                                                                                      \
  ROW(ALONG, "distance")                                                                           \
  ROW(ALONG, "dist")                                                                               \
  ROW(ALONG, "horizontal distance")                                                                \
  ROW(ALONG, "cumulative distance")                                                                \
  ROW(ALONG, "profile distance")                                                                   \
  ROW(ALONG, "section distance")                                                                   \
  ROW(ALONG, "chainage")                                                                           \
  ROW(ALONG, "chain")                                                                              \
  ROW(ALONG, "ch")                                                                                 \
  ROW(ALONG, "station")                                                                            \
  ROW(ALONG, "stationing")                                                                         \
  ROW(ALONG, "sta")                                                                                \
  ROW(ALONG, "offset")                                                                             \
  ROW(ALONG, "horizontal")                                                                         \
  ROW(ALONG, "abscissa")                                                                           \
  ROW(HEIGHT, "elevation")                                                                         \
  ROW(HEIGHT, "elev")                                                                              \
  ROW(HEIGHT, "el")                                                                                \
  ROW(HEIGHT, "height")                                                                            \
  ROW(HEIGHT, "level")                                                                             \
  ROW(HEIGHT, "reduced level")                                                                     \
  ROW(HEIGHT, "ground level")                                                                      \
  ROW(HEIGHT, "ground elevation")                                                                  \
  ROW(HEIGHT, "surface elevation")                                                                 \
  ROW(HEIGHT, "rl")                                                                                \
  ROW(HEIGHT, "mrl")                                                                               \
  ROW(HEIGHT, "altitude")                                                                          \
  ROW(HEIGHT, "alt")                                                                               \
  ROW(HEIGHT, "vertical")                                                                          \
  ROW(HEIGHT, "ordinate")                                                                          \
  ROW(DEPTH, "depth")                                                                              \
  ROW(EAST, "easting")                                                                             \
  ROW(EAST, "eastings")                                                                            \
  ROW(EAST, "east")                                                                                \
  ROW(EAST, "e")                                                                                   \
  ROW(EAST, "rechtswert")                                                                          \
  ROW(NORTH, "northing")                                                                           \
  ROW(NORTH, "northings")                                                                          \
  ROW(NORTH, "north")                                                                              \
  ROW(NORTH, "n")                                                                                  \
  ROW(NORTH, "hochwert")                                                                           \
  ROW(DEGREES, "longitude")                                                                        \
  ROW(DEGREES, "long")                                                                             \
  ROW(DEGREES, "lon")                                                                              \
  ROW(DEGREES, "lng")                                                                              \
  ROW(DEGREES, "latitude")                                                                         \
  ROW(DEGREES, "lat")

/* Units of lengths as headers write them: X(unit of Topple, word). Pixels are those of clicks on a
 * picture, and no scene's. */
#define TP_COLUMN_UNITS(X)                                                                         \
  X("mm", "mm")                                                                                    \
  X("mm", "millimetre")                                                                            \
  X("mm", "millimetres")                                                                           \
  X("mm", "millimeter")                                                                            \
  X("mm", "millimeters")                                                                           \
  X("cm", "cm")                                                                                    \
  X("cm", "centimetre")                                                                            \
  X("cm", "centimetres")                                                                           \
  X("cm", "centimeter")                                                                            \
  X("cm", "centimeters")                                                                           \
  X("m", "m")                                                                                      \
  X("m", "metre")                                                                                  \
  X("m", "metres")                                                                                 \
  X("m", "meter")                                                                                  \
  X("m", "meters")                                                                                 \
  X("km", "km")                                                                                    \
  X("km", "kilometre")                                                                             \
  X("km", "kilometres")                                                                            \
  X("km", "kilometer")                                                                             \
  X("km", "kilometers")                                                                            \
  X("in", "in")                                                                                    \
  X("in", "inch")                                                                                  \
  X("in", "inches")                                                                                \
  X("ft", "ft")                                                                                    \
  X("ft", "foot")                                                                                  \
  X("ft", "feet")                                                                                  \
  X("px", "px")                                                                                    \
  X("px", "pixel")                                                                                 \
  X("px", "pixels")

/* Units that Topple takes no lengths in: X(word). */
#define TP_COLUMN_OTHER_UNITS(X)                                                                   \
  X("um")                                                                                          \
  X("\xc2\xb5m")                                                                                   \
  X("\xce\xbcm")                                                                                   \
  X("micron")                                                                                      \
  X("microns")                                                                                     \
  X("dm")                                                                                          \
  X("yd")                                                                                          \
  X("yard")                                                                                        \
  X("yards")                                                                                       \
  X("mile")                                                                                        \
  X("miles")                                                                                       \
  X("deg")                                                                                         \
  X("degree")                                                                                      \
  X("degrees")                                                                                     \
  X("rad")

#endif
