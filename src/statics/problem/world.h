/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene whose coordinates are those of the world, y up, turned into the frame of its base.
 *
 * The mean plane is given by two points, or fitted to the contact (base/mean_plane.h): its
 * direction (p, q) is exact, in whole numbers. All points are turned by -atan(q / p) about one that
 * stays, with the cosine and sine of plane/direction.h: where k is cut off lengths come out too
 * long by less than a share of 1e-77, and all angles, on which verdicts and factors under the
 * weight alone rest, exactly. The dip is rounded up to 256 binary digits, and added to the scene's
 * tilt: the block is never taken for lying flatter than it does.
 *
 * Under an earthquake up-dip the block begins to move against the dip, and the frame is level as it
 * lies: tilts count from there, towards the side up-dip. The contact and what goes on past it are
 * the same. A block that a joint shifts is laid so when it has come to rest, as along its mean
 * plane. Water behind the block would hold it back. What that pushes is left out, and its uplift
 * alone acts, of the height given: no level up to that drives more where the block slides or turns
 * about the upper end of its contact, as the push resists both and the uplift grows with the level.
 *
 * On a slope the dip is given and the coordinates run along the mean plane already: nothing is
 * turned, but for an earthquake up-dip.
 *
 * Where the scene leaves the contact to the default, its ends and the mean plane depend on each
 * other: from the ends that the coordinates themselves have, plane and ends are found in turn until
 * they stay. */

#ifndef TP_PROBLEM_WORLD_H
#define TP_PROBLEM_WORLD_H

#include "problem/sole.h"
#include "problem/world_turn.h"
#include "topple.h"

/* Digits that a number of such a scene can be asked for. */
enum { TP_WORLD_DIGITS = 60 };

typedef struct tp_world {
  tp_scene scene; /* in the frame of the base; shares with the scene what is not turned */
  bool fitted;
  bool unturned; /* a slope: the coordinates run along it, and `scene` shares all with the scene */
  tp_turn turn;
  bool goes_up_dip;      /* under an earthquake */
  bool level;            /* up-dip: x and y are level and upright, as the block lies, */
  tp_turn lay;           /* turned by the scene's tilt alone, or all of it where it was shifted; */
  fmpq_t cosine, sine;   /* the direction of the mean plane there, */
  tp_sole sole;          /* and on a profile the underside, found along that */
  const tp_scene *along; /* a block along its mean plane, shifted or on a slope, borrowed, */
  tp_scene levelled;     /* and as it then lies; else NULL and empty */
} tp_world;

/* On failure `*world` stays NULL. */
TP_MUST_USE tp_status tp_world_init(tp_world **world, const tp_scene *scene, tp_message *message);
/* Lay a block level that goes up-dip and is not shifted: the scene as its coordinates lie. */
TP_MUST_USE tp_status tp_world_lay_up_dip(tp_world *world, const tp_scene *scene,
                                          tp_message *message);
/* The same of one that is shifted or on a slope, after what was to be done along its mean plane:
 * `*scene` is that one, and becomes the world's own. */
TP_MUST_USE tp_status tp_world_level(tp_world *world, const tp_scene **scene, tp_message *message);
void tp_world_free(tp_world *world);

#endif
