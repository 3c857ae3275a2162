/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Faces of a mesh as triangles, and their points in whole numbers over the common denominator of
 * all coordinates. */

#include "solid/surface.h"

#include "number/ball.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Bits of one coordinate, and of all: what moments in whole numbers take grows with their square.
 */
static const double most_bits = 8192, most_bits_in_all = 4e9;

void tp_surface_clear(tp_surface *surface) {
  if (surface->whole != NULL) {
    for (long k = 0; k < 3 * surface->vertex_count; k++) fmpz_clear(surface->whole + k);
    fmpz_clear(surface->divisor);
    for (int k = 0; k < 3; k++) fmpz_clear(surface->origin[k]);
  }
  for (long k = 0; surface->weights != NULL && k < surface->vertex_count; k++) {
    fmpz_clear(surface->weights + k);
  }
  free(surface->whole);
  free(surface->weights);
  free(surface->near);
  free(surface->given);
  free(surface->sources);
  free(surface->triangles);
  free(surface->faces);
  memset(surface, 0, sizeof *surface);
}

const char *tp_surface_name(char name[TP_SURFACE_NAME], const tp_surface *surface, long triangle) {
  const tp_mesh_face *face = surface->mesh->faces + surface->faces[triangle];
  if (face->number < 0) { /* of a repair */
    snprintf(name, TP_SURFACE_NAME, "a triangle that closes gap %d", -face->number);
    return name;
  }
  snprintf(name, TP_SURFACE_NAME, "%s %d", face->count == 3 ? "triangle" : "face", face->number);
  return name;
}

tp_place tp_surface_place(const tp_surface *surface, long triangle) {
  const tp_mesh_face *face = surface->mesh->faces + surface->faces[triangle];
  const char *own = surface->mesh->objects[face->object].file;
  return (tp_place){own != NULL ? own : surface->mesh->file, face->line, 0};
}

int tp_surface_object(const tp_surface *surface, long triangle) {
  return surface->mesh->faces[surface->faces[triangle]].object;
}

/* A coordinate, of all of them in a row, as the mesh has it. */
static const fmpq *source(const tp_surface *surface, long k) {
  return surface->mesh->vertices + 3L * surface->sources[k / 3] + k % 3;
}

double tp_surface_nearest(const fmpq_t number) {
  arf_t quotient, bottom;
  arf_init(quotient);
  arf_init(bottom);
  arf_set_fmpz(quotient, fmpq_numref(number));
  arf_set_fmpz(bottom, fmpq_denref(number));
  arf_div(quotient, quotient, bottom, DBL_MANT_DIG, ARF_RND_NEAR);
  const double nearest = tp_ball_nearest(quotient);
  arf_clear(quotient);
  arf_clear(bottom);
  return nearest;
}

double tp_surface_given(const tp_surface *surface, long vertex, int axis) {
  if (surface->sources[vertex] >= 0) return tp_surface_nearest(source(surface, 3 * vertex + axis));
  fmpq_t at;
  fmpq_init(at);
  fmpq_set_fmpz_frac(at, surface->whole + 3 * vertex + axis, surface->weights + vertex);
  fmpq_add_fmpz(at, at, surface->origin[axis]);
  fmpq_div_fmpz(at, at, surface->divisor);
  const double given = tp_surface_nearest(at);
  fmpq_clear(at);
  return given;
}

void tp_surface_way(fmpz *way, const tp_surface *surface, long from, long to) {
  const fmpz *one = surface->whole + 3 * from, *other = surface->whole + 3 * to;
  const fmpz *weights = surface->weights;
  for (int k = 0; k < 3; k++) {
    if (weights == NULL) {
      fmpz_sub(way + k, other + k, one + k);
    } else {
      fmpz_mul(way + k, other + k, weights + from);
      fmpz_submul(way + k, one + k, weights + to);
    }
  }
}

void tp_surface_weight(fmpz_t weight, const tp_surface *surface, long one, long other) {
  if (surface->weights == NULL) {
    fmpz_one(weight);
  } else {
    fmpz_mul(weight, surface->weights + one, surface->weights + other);
  }
}

/* ---- coordinates -------------------------------------------------------------------------------
 */

/* D: the least common multiple of all denominators; false where it has too many bits. */
static bool find_divisor(tp_surface *surface) {
  fmpz_one(surface->divisor);
  for (long k = 0; k < 3 * surface->vertex_count; k++) {
    const fmpz *own = fmpq_denref(source(surface, k));
    if (fmpz_divisible(surface->divisor, own)) continue;
    fmpz_lcm(surface->divisor, surface->divisor, own);
    if ((double)fmpz_bits(surface->divisor) > most_bits) return false;
  }
  return true;
}

static void scale(fmpz_t whole, const tp_surface *surface, const fmpq *coordinate) {
  fmpz_divexact(whole, surface->divisor, fmpq_denref(coordinate));
  fmpz_mul(whole, whole, fmpq_numref(coordinate));
}

/* All of them, as far as they go; how many bits the largest has. */
static long set_whole(tp_surface *surface) {
  long bits = 1;
  for (int k = 0; k < 3; k++) scale(surface->origin[k], surface, source(surface, k));
  for (long k = 0; k < 3 * surface->vertex_count; k++) {
    fmpz *own = surface->whole + k;
    scale(own, surface, source(surface, k));
    fmpz_sub(own, own, surface->origin[k % 3]);
    const long size = (long)fmpz_bits(own);
    if (size > bits) bits = size;
    if ((double)bits > most_bits) break;
  }
  return bits;
}

/* Products of five differences of coordinates are to stay within the range of doubles. */
static const long least_shift = -140;

/* The number times 2^-exponent; is it that exactly? */
static bool set_near(double *near, const fmpz_t whole, long exponent) {
  slong own = 0;
  const double mantissa = fmpz_get_d_2exp(&own, whole);
  const long shift = own - exponent < -2000 ? -2000 : own - exponent;
  *near = ldexp(mantissa, (int)shift);
  if (fmpz_is_zero(whole)) return true;
  return shift > least_shift && (long)(fmpz_bits(whole) - fmpz_val2(whole)) <= DBL_MANT_DIG;
}

/* Binary files have doubles, of sizes so unlike at times that their differences are none. */
static bool take_given(tp_surface *surface) {
  const long count = 3 * surface->vertex_count;
  double *given = malloc((size_t)count * sizeof *given);
  if (given == NULL) return false;
  bool are_doubles = true;
  for (long k = 0; k < count && are_doubles; k++) {
    const fmpq *own = source(surface, k);
    const fmpz *top = fmpq_numref(own), *bottom = fmpq_denref(own);
    given[k] = fmpq_get_d(own);
    are_doubles = fmpz_is_zero(top) || ((long)(fmpz_bits(top) - fmpz_val2(top)) <= DBL_MANT_DIG &&
                                        fmpz_bits(bottom) == fmpz_val2(bottom) + 1 &&
                                        fabs(given[k]) > 1e-60 && fabs(given[k]) < 1e60);
  }
  if (are_doubles) {
    surface->given = given;
  } else {
    free(given);
  }
  return true;
}

static tp_status set_coordinates(tp_surface *surface, tp_message *message) {
  const long count = 3 * surface->vertex_count;
  surface->whole = calloc((size_t)count, sizeof *surface->whole);
  if (surface->whole == NULL) return tp_fail_memory(message, "a solid");
  fmpz_init(surface->divisor);
  for (int k = 0; k < 3; k++) fmpz_init(surface->origin[k]);
  surface->near = malloc((size_t)count * sizeof *surface->near);
  if (surface->near == NULL) return tp_fail_memory(message, "a solid");
  const bool fits = find_divisor(surface);
  surface->exponent = fits ? set_whole(surface) : 0;
  if (!fits || (double)surface->exponent > most_bits ||
      (double)surface->exponent * (double)count > most_bits_in_all) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){surface->mesh->file, 0, 0},
                     "coordinates with too many digits for the size of the solid: written as whole "
                     "numbers they have more than %.0f bits; round them",
                     fits ? fmin(most_bits, most_bits_in_all / (double)count) : most_bits);
  }
  surface->is_exact = true;
  for (long k = 0; k < count; k++) {
    if (!set_near(surface->near + k, surface->whole + k, surface->exponent)) {
      surface->is_exact = false;
    }
  }
  return surface->is_exact || take_given(surface) ? TP_OK : tp_fail_memory(message, "a solid");
}

tp_geom_points tp_surface_points(const tp_surface *surface) {
  return (tp_geom_points){.count = (size_t)surface->vertex_count,
                          .near = surface->given != NULL ? surface->given : surface->near,
                          .whole = surface->whole,
                          .weights = surface->weights,
                          .small = surface->is_exact || surface->given != NULL};
}

/* ---- triangles ---------------------------------------------------------------------------------
 */

/* How many triangles the faces of an object, or of all, make. */
static long count_triangles(const tp_mesh *mesh, long object) {
  long count = 0;
  for (long f = 0; f < mesh->face_count; f++) {
    if (object < 0 || mesh->faces[f].object == object) count += mesh->faces[f].count - 2;
  }
  return count;
}

/* The vertex of the surface that is one of the mesh: `places` has one more, or 0 where it was not
 * met before. */
static int place_of(tp_surface *surface, int *places, int vertex) {
  if (places[vertex] == 0) {
    surface->sources[surface->vertex_count++] = vertex;
    places[vertex] = (int)surface->vertex_count;
  }
  return places[vertex] - 1;
}

static void add_triangles(tp_surface *surface, int *places, long object) {
  const tp_mesh *mesh = surface->mesh;
  for (long f = 0; f < mesh->face_count; f++) {
    const tp_mesh_face *face = mesh->faces + f;
    if (object >= 0 && face->object != object) continue;
    const int *corners = mesh->corners + face->first;
    if (face->count > 3) surface->split++;
    for (int k = 2; k < face->count; k++) {
      int *own = surface->triangles + 3 * surface->triangle_count;
      own[0] = place_of(surface, places, corners[0]);
      own[1] = place_of(surface, places, corners[k - 1]);
      own[2] = place_of(surface, places, corners[k]);
      surface->faces[surface->triangle_count++] = (int)f;
    }
  }
}

static tp_status set_triangles(tp_surface *surface, long object, tp_message *message) {
  const size_t count = (size_t)count_triangles(surface->mesh, object);
  if (count == 0) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, (tp_place){surface->mesh->file, 0, 0},
                     "there is no face in it: a solid is the inside of a closed surface");
  }
  if (count > TP_MESH_MOST) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){surface->mesh->file, 0, 0},
                     "its faces make more than 20 million triangles; thin the mesh out");
  }
  int *places = calloc((size_t)surface->mesh->vertex_count, sizeof *places);
  surface->sources = malloc((size_t)surface->mesh->vertex_count * sizeof *surface->sources);
  surface->triangles = malloc(3 * count * sizeof *surface->triangles);
  surface->faces = malloc(count * sizeof *surface->faces);
  const bool done = places != NULL && surface->sources != NULL && surface->triangles != NULL &&
                    surface->faces != NULL;
  if (done) add_triangles(surface, places, object);
  free(places);
  return done ? TP_OK : tp_fail_memory(message, "a solid");
}

tp_status tp_surface_init(tp_surface *surface, const tp_mesh *mesh, long object,
                          tp_message *message) {
  *surface = (tp_surface){.mesh = mesh};
  tp_status status = set_triangles(surface, object, message);
  if (status == TP_OK) status = set_coordinates(surface, message);
  if (status != TP_OK) tp_surface_clear(surface);
  return status;
}

tp_surface tp_surface_of_object(const tp_surface *surface, int object) {
  tp_surface own = *surface;
  long first = 0, end = 0;
  while (first < surface->triangle_count && tp_surface_object(surface, first) != object) first++;
  for (end = first; end < surface->triangle_count; end++) {
    if (tp_surface_object(surface, end) != object) break;
  }
  own.triangles += 3 * first;
  own.faces += first;
  own.triangle_count = end - first;
  own.vertex_count = 0;
  for (long k = 0; k < 3 * own.triangle_count; k++) {
    if (own.triangles[k] >= own.vertex_count) own.vertex_count = own.triangles[k] + 1L;
  }
  return own;
}
