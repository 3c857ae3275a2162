/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Mean plane by two points, by the mated underside or by least squares of the contact; ends and
 * plane are iterated until they no longer change, then all points are turned into its frame. */

#include "problem/world.h"

#include "base/mean_plane.h"
#include "base/underside.h"
#include "problem/as_given.h"
#include "scene/anchor.h"

#include <stdlib.h>
#include <string.h>

/* Ends and plane settle in two or three; a contact that goes to and fro between them is refused. */
enum { MOST_ROUNDS = 16 };

/* Direction of the mean plane, the point that stays, and the ends of the contact where they have to
 * be kept by name. */
typedef struct found {
  fmpq_t u, v, x, y;
  bool up_dip; /* the coordinates stay as they lie: the ends are those along the mean plane */
  bool keeps_ends;
  long first, last;
} found;

static tp_status fail_direction(const tp_scene *scene, tp_message *message) {
  return tp_refuse(
      message, TP_FAULT_GEOMETRY, scene->frame_place,
      "the contact defines no mean plane that runs from left to right; give it: 'frame: "
      "{mean_plane: [[x, y], [x, y]]}'");
}

/* The outline turned by the direction, as large as that makes it. */
static bool turn_ring(tp_polyline *turned, const tp_polyline *ring, const found *f) {
  tp_polyline_clear(turned);
  if (!tp_polyline_copy(turned, ring)) return false;
  fmpq_t x;
  fmpq_init(x);
  for (long k = 0; k < ring->count; k++) {
    fmpq_mul(x, f->u, ring->x + k);
    fmpq_addmul(x, f->v, ring->y + k);
    fmpq_mul(turned->y + k, f->u, ring->y + k);
    fmpq_submul(turned->y + k, f->v, ring->x + k);
    fmpq_swap(turned->x + k, x);
  }
  fmpq_clear(x);
  return true;
}

/* Ends and mean plane in turn, until they stay. */
static tp_status settle(found *f, tp_underside *u, const tp_scene *scene, const tp_section *section,
                        tp_message *message) {
  const tp_polyline *ring = section->rings;
  tp_polyline turned = {0};
  tp_section seen = {.ring_count = 1, .rings = &turned};
  tp_status status = TP_OK;
  bool stays = false;
  for (int round = 0; round < MOST_ROUNDS && !stays && status == TP_OK; round++) {
    if (u->none != NULL) status = tp_underside_fail(u->none, scene, message);
    if (status == TP_OK &&
        (!tp_mean_plane_of_outline(f->u, f->v, ring, u->first, u->last) || fmpq_sgn(f->u) <= 0)) {
      status = fail_direction(scene, message);
    }
    if (status == TP_OK && !turn_ring(&turned, ring, f)) {
      status = tp_fail_memory(message, "the mean plane");
    }
    const long first = u->first, last = u->last;
    if (status == TP_OK) status = tp_underside_find(u, scene, &seen, message);
    stays = first == u->first && last == u->last;
  }
  tp_polyline_clear(&turned);
  if (status != TP_OK || stays) return status;
  return tp_refuse(message, TP_FAULT_GEOMETRY, scene->frame_place,
                   "the ends of the contact and its mean plane depend on each other and do not "
                   "settle; name the ends, 'base: {between: [[x, y], [x, y]]}', or the plane, "
                   "'frame: {mean_plane: [[x, y], [x, y]]}'");
}

/* By the contact with a profile as the coordinates lie. */
static tp_status find_contact(found *f, const tp_scene *scene, const tp_section *section,
                              const tp_base *base, const tp_lattice *lattice, tp_message *message) {
  tp_contact contact;
  tp_status status = tp_contact_init(&contact, section, NULL, base, lattice, message);
  if (status != TP_OK) return status;
  if (!tp_mean_plane_of_contact(f->u, f->v, &contact, lattice)) {
    status = fail_direction(scene, message);
  }
  const long left = contact.points[0].point;
  tp_lattice_metres_x(f->x, lattice, lattice->x + left);
  tp_lattice_metres_y(f->y, lattice, lattice->y + left);
  fmpq_div(f->x, f->x, scene->metres_per_unit);
  fmpq_div(f->y, f->y, scene->metres_per_unit);
  tp_contact_clear(&contact);
  return status;
}

static tp_status find_on_profile(found *f, const tp_scene *scene, const tp_section *section,
                                 tp_message *message) {
  tp_base base;
  tp_lattice lattice = {0};
  tp_status status = tp_base_init(&base, scene, section, message);
  if (status != TP_OK) return status;
  status = tp_as_given_check(&lattice, scene, section, &base.ring, message);
  if (status == TP_OK) {
    status = find_contact(f, scene, section, &base, &lattice, message);
    tp_lattice_clear(&lattice);
  }
  tp_base_clear(&base);
  return status;
}

/* The ends of the contact as seen along a mean plane that the scene gives. */
static tp_status find_ends(found *f, const tp_scene *scene, const tp_section *section,
                           tp_message *message) {
  tp_polyline turned = {0};
  tp_section seen = {.ring_count = 1, .rings = &turned};
  tp_underside u = {0};
  tp_status status = turn_ring(&turned, section->rings, f)
                         ? tp_underside_find(&u, scene, &seen, message)
                         : tp_fail_memory(message, "the mean plane");
  tp_polyline_clear(&turned);
  if (status == TP_OK && u.none != NULL) status = tp_underside_fail(u.none, scene, message);
  f->keeps_ends = true;
  f->first = u.first;
  f->last = u.last;
  return status;
}

static tp_status find_mated(found *f, const tp_scene *scene, const tp_section *section,
                            tp_message *message) {
  const tp_base_description *base = &scene->base;
  const tp_polyline *ring = section->rings;
  tp_underside u;
  tp_lattice lattice;
  const bool stated =
      base->between.count == 2 || base->below.given || base->left_of.given || base->right_of.given;
  const bool given = scene->mean_plane.count == 2;
  tp_status status = tp_as_given_check(&lattice, scene, section, NULL, message);
  if (status != TP_OK) return status;
  tp_lattice_clear(&lattice);
  if (given && !stated) return f->up_dip ? find_ends(f, scene, section, message) : TP_OK;
  status = tp_underside_find(&u, scene, section, message);
  if (status == TP_OK && !stated) status = settle(f, &u, scene, section, message);
  if (status != TP_OK) return status;
  f->keeps_ends = stated || f->up_dip;
  f->first = u.first;
  f->last = u.last;
  if (!given) {
    fmpq_set(f->x, ring->x + u.first);
    fmpq_set(f->y, ring->y + u.first);
  }
  return given || tp_mean_plane_of_outline(f->u, f->v, ring, u.first, u.last)
             ? TP_OK
             : fail_direction(scene, message);
}

static tp_status find(found *f, const tp_scene *scene, tp_message *message) {
  if (scene->mean_plane.count == 2) {
    const tp_polyline *plane = &scene->mean_plane;
    fmpq_sub(f->u, plane->x + 1, plane->x);
    fmpq_sub(f->v, plane->y + 1, plane->y);
    fmpq_set(f->x, plane->x);
    fmpq_set(f->y, plane->y);
  }
  tp_section section;
  tp_status status = tp_section_init(&section, &scene->block, message);
  if (status != TP_OK) return status;
  if (scene->base.mated) {
    status = find_mated(f, scene, &section, message);
  } else if (scene->mean_plane.count == 0) {
    status = find_on_profile(f, scene, &section, message);
  }
  tp_section_clear(&section);
  return status == TP_OK && fmpq_sgn(f->u) <= 0 ? fail_direction(scene, message) : status;
}

/* The scene's tilt is added to the dip: it lies tilted. */
static tp_status set_tilt(tp_world *w, const tp_scene *scene, tp_message *message) {
  tp_quantity *tilt = &w->scene.tilt_angle_deg;
  const char *way = w->turn.rises > 0 ? "left" : "right";
  if (w->turn.rises != 0) {
    const bool along = w->turn.rises > 0 ? scene->towards_left : scene->towards_right;
    if (!along) {
      return tp_refuse(message, TP_FAULT_GEOMETRY, scene->tilt_place,
                       "the mean plane dips to the %s as the coordinates lie, and the scene tilts "
                       "the other way; leave 'towards' out, or say %s: an earthquake is considered "
                       "both ways, or as 'direction' of 'loads.seismic' says",
                       way, way);
    }
    w->scene.towards_left = w->turn.rises > 0;
    w->scene.towards_right = w->turn.rises < 0;
  }
  fmpq_add(tilt->value, scene->tilt_angle_deg.value, w->turn.dip_deg);
  if (!tilt->given) tilt->place = scene->frame_place;
  tilt->given = true;
  if (fmpq_cmp_si(tilt->value, 90) <= 0) return TP_OK;
  return tp_refuse(
      message, TP_FAULT_RANGE, tilt->place,
      "the dip of the mean plane and the tilt make more than 90°; of a block that lies on a slope "
      "the tilt is added to the dip");
}

void tp_world_free(tp_world *w) {
  if (w == NULL) return;
  if (!w->unturned) tp_moved_clear(&w->scene);
  if (w->along != NULL) tp_moved_clear(&w->levelled);
  fmpq_clear(w->scene.tilt_angle_deg.value);
  tp_turn_clear(&w->turn);
  tp_turn_clear(&w->lay);
  fmpq_clear(w->cosine);
  fmpq_clear(w->sine);
  free(w);
}

static tp_world *make(void) {
  tp_world *w = calloc(1, sizeof *w);
  if (w == NULL) return NULL;
  tp_turn_init(&w->turn);
  tp_turn_init(&w->lay);
  fmpq_init(w->cosine);
  fmpq_init(w->sine);
  return w;
}

static tp_status lay_on_slope(tp_world **world, const tp_scene *scene, bool up_dip,
                              tp_message *message) {
  tp_world *w = make();
  if (w == NULL) return tp_fail_memory(message, "the slope");
  w->scene = *scene;
  w->unturned = true;
  fmpq_init(w->scene.tilt_angle_deg.value);
  fmpq_one(w->turn.cosine);
  fmpq_set(w->turn.dip_deg, scene->slope.dip_deg.value);
  if (!fmpq_is_zero(w->turn.dip_deg)) w->turn.rises = scene->slope.left ? 1 : -1;
  w->goes_up_dip = up_dip && w->turn.rises != 0;
  const tp_status status = set_tilt(w, scene, message);
  if (status == TP_OK) {
    *world = w;
  } else {
    tp_world_free(w);
  }
  return status;
}

static tp_status turn(tp_world **world, const tp_scene *scene, const found *f,
                      tp_message *message) {
  tp_world *w = make();
  if (w == NULL) return tp_fail_memory(message, "the mean plane");
  tp_moved_begin(&w->scene, scene);
  fmpq_init(w->scene.tilt_angle_deg.value);
  w->fitted = scene->mean_plane.count == 0;
  fmpq_set(w->turn.x, f->x);
  fmpq_set(w->turn.y, f->y);
  tp_turn_set(&w->turn, f->u, f->v);
  tp_status status = set_tilt(w, scene, message);
  if (status == TP_OK) status = tp_anchors_take_side(&w->scene, scene, w->turn.rises, message);
  w->goes_up_dip = f->up_dip && w->turn.rises != 0;
  if (status == TP_OK && w->goes_up_dip && !tp_scene_is_shifted(scene)) {
    status = tp_world_lay_up_dip(w, scene, message);
  }
  if (status == TP_OK && !tp_turn_scene(&w->scene, w->level ? &w->lay : &w->turn, scene,
                                        f->keeps_ends, f->first, f->last)) {
    status = tp_fail_memory(message, "the turned scene");
  }
  if (status == TP_OK) {
    *world = w;
  } else {
    tp_world_free(w);
  }
  return status;
}

tp_status tp_world_init(tp_world **world, const tp_scene *scene, tp_message *message) {
  const tp_loads_description *loads = &scene->loads;
  const bool up_dip = loads->direction_given && loads->direction == TP_SEISMIC_UP_DIP;
  if (scene->frame == TP_FRAME_SLOPE) return lay_on_slope(world, scene, up_dip, message);
  if (scene->block.form != TP_OUTLINE_VERTICES) {
    return tp_refuse(
        message, TP_FAULT_GEOMETRY, scene->frame_place,
        "'frame: world' is for an outline; the coordinates of teeth, slabs and ellipses "
        "run along their mean plane: say how it dips, 'slope: {dip_deg: 25, towards: "
        "left}'");
  }
  found f = {.up_dip = up_dip};
  fmpq_init(f.u);
  fmpq_init(f.v);
  fmpq_init(f.x);
  fmpq_init(f.y);
  tp_status status = find(&f, scene, message);
  if (status == TP_OK) status = turn(world, scene, &f, message);
  fmpq_clear(f.u);
  fmpq_clear(f.v);
  fmpq_clear(f.x);
  fmpq_clear(f.y);
  return status;
}
