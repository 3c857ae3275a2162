/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rays of K are across two rows a_n; rays along which a contact sticks across its rows a_n and a_t.
 * Of two rays of one face those contacts stay closed that both keep closed. */

#include "solid_contacts/solid_section_modes.h"

#include <stdlib.h>
#include <string.h>

/* ---- rays --------------------------------------------------------------------------------------
 */

static bool is_in_cone(const tp_solid_section *s, const fmpq twist[3]) {
  for (int k = 0; k < s->count; k++) {
    if (tp_rational3_sign(s->contacts[k].normal, twist) < 0) return false;
  }
  return true;
}

static bool has_ray(const tp_solid_section *s, const fmpq twist[3]) {
  fmpq across[3];
  bool found = false;
  tp_rational3_init(across);
  for (long k = 0; k < s->ray_count && !found; k++) {
    tp_rational3_cross(across, s->rays[k].twist, twist);
    found = tp_rational3_is_zero(across) && tp_rational3_sign(s->rays[k].twist, twist) > 0;
  }
  tp_rational3_clear(across);
  return found;
}

static bool add_ray(tp_solid_section *s, const fmpq twist[3]) {
  if (s->ray_count == s->ray_room) {
    const long room = s->ray_room > 0 ? 2 * s->ray_room : 16;
    tp_solid_section_ray *rays = realloc(s->rays, (size_t)room * sizeof *rays);
    if (rays == NULL) return false;
    s->rays = rays;
    s->ray_room = room;
  }
  tp_solid_section_ray *entry = s->rays + s->ray_count++;
  tp_rational3_init(entry->twist);
  tp_rational3_init(entry->wrench);
  tp_rational3_set(entry->twist, twist);
  for (int k = 0; k < 3; k++) fmpq_mul(entry->wrench + k, s->mass + k, twist + k);
  return true;
}

/* Both ways across two rows, where they are in K and new. */
static bool add_rays(tp_solid_section *s, const fmpq a[3], const fmpq b[3]) {
  fmpq twist[3];
  bool done = true;
  tp_rational3_init(twist);
  tp_rational3_cross(twist, a, b);
  for (int way = 0; way < 2 && done && !tp_rational3_is_zero(twist); way++) {
    if (is_in_cone(s, twist) && !has_ray(s, twist)) done = add_ray(s, twist);
    for (int k = 0; k < 3; k++) fmpq_neg(twist + k, twist + k);
  }
  tp_rational3_clear(twist);
  return done;
}

static bool find_rays(tp_solid_section *s) {
  bool done = true;
  for (int i = 0; i < s->count && done; i++) {
    done = add_rays(s, s->contacts[i].normal, s->contacts[i].slip);
    for (int j = 0; j < i && done; j++) {
      done = add_rays(s, s->contacts[i].normal, s->contacts[j].normal);
    }
  }
  return done;
}

/* ---- modes -------------------------------------------------------------------------------------
 */

static tp_solid_section_mode *add_mode(tp_solid_section *s) {
  if (s->mode_count == s->mode_room) {
    const long room = s->mode_room > 0 ? 2 * s->mode_room : 16;
    tp_solid_section_mode *modes = realloc(s->modes, (size_t)room * sizeof *modes);
    if (modes == NULL) return NULL;
    s->modes = modes;
    s->mode_room = room;
  }
  tp_solid_section_mode *entry = s->modes + s->mode_count++;
  memset(entry, 0, sizeof *entry);
  return entry;
}

static void add_force(tp_solid_section_mode *mode, int contact, int slip) {
  mode->forces[mode->force_count++] = (tp_solid_section_force){contact, slip};
}

/* Against a slip along axis x n; both edges where it sticks. */
static void add_forces(tp_solid_section_mode *mode, const tp_solid_section *s, int contact,
                       int slip) {
  if (fmpq_is_zero(&s->contacts[contact].friction)) {
    add_force(mode, contact, 0);
    return;
  }
  if (slip <= 0) add_force(mode, contact, 1);
  if (slip >= 0) add_force(mode, contact, -1);
}

static bool is_closed(const tp_solid_section *s, int contact, long ray) {
  return tp_rational3_sign(s->contacts[contact].normal, s->rays[ray].twist) == 0;
}

static bool add_ray_mode(tp_solid_section *s, long ray) {
  tp_solid_section_mode *entry = add_mode(s);
  if (entry == NULL) return false;
  entry->rays[entry->ray_count++] = (int)ray;
  for (int k = 0; k < s->count; k++) {
    if (is_closed(s, k, ray)) {
      add_forces(entry, s, k, tp_rational3_sign(s->contacts[k].slip, s->rays[ray].twist));
    }
  }
  return true;
}

/* Where both are on a face, and no contact slips one way along one and the other way along the
 * other. */
static bool add_sector(tp_solid_section *s, long a, long b) {
  tp_solid_section_mode *entry = add_mode(s);
  if (entry == NULL) return false;
  bool fits = true;
  entry->rays[entry->ray_count++] = (int)a;
  entry->rays[entry->ray_count++] = (int)b;
  for (int k = 0; k < s->count && fits; k++) {
    if (!is_closed(s, k, a) || !is_closed(s, k, b)) continue;
    const int one = tp_rational3_sign(s->contacts[k].slip, s->rays[a].twist);
    const int other = tp_rational3_sign(s->contacts[k].slip, s->rays[b].twist);
    fits = one * other >= 0 && (one != 0 || other != 0);
    if (fits) add_forces(entry, s, k, one != 0 ? one : other);
  }
  if (!fits || entry->force_count == 0) s->mode_count--;
  return true;
}

bool tp_solid_section_find_modes(tp_solid_section *section) {
  bool done = find_rays(section);
  for (long a = 0; a < section->ray_count && done; a++) {
    done = add_ray_mode(section, a);
    for (long b = 0; b < a && done; b++) done = add_sector(section, a, b);
  }
  return done;
}
