/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Many blocks held in arrays: every critical angle of every block against what tp_solve tells of it
 * alone, and against whole numbers of 128 bits, by trying every vertex of the underside against
 * every facet.
 *
 * A filter in doubles that is wrong once in a million blocks is wrong in every study: so each kind
 * of block that it could take for another is drawn, and what it does not decide is counted. */

#include "claim_block.h"
#include "suite.h"

#include "batch/turning.h"

#include <math.h>
#include <string.h>

/* What the whole numbers say. */
typedef struct truth {
  bool known;        /* the underside runs on without an edge that runs back */
  long pivot;        /* or -1 */
  wide x_arm, y_arm; /* times the same number above 0 */
} truth;

/* Does turning about the vertex `at` keep both ends of every facet from entering the base? */
static bool is_admissible(const polygon *p, const long *chain, long count, long at, bool left) {
  for (long k = 0; k + 1 < count; k++) {
    for (long end = k; end <= k + 1; end++) {
      const wide rise = dot(p, at, chain[end], chain[k], chain[k + 1]);
      if (left ? rise < 0 : rise > 0) return false;
    }
  }
  return true;
}

/* Counter-clockwise from the first vertex of the underside to the last. */
static long underside(const random_block *block, long chain[BLOCK_MOST]) {
  const polygon *p = &block->whole;
  long first = 0, last = 0;
  for (long k = 1; k < p->count; k++) {
    const long low = p->x[k] + p->y[k] - p->x[first] - p->y[first];
    const long far = p->x[k] - p->y[k] - p->x[last] + p->y[last];
    if (low < 0 || (low == 0 && p->x[k] < p->x[first])) first = k;
    if (far > 0 || (far == 0 && p->x[k] > p->x[last])) last = k;
  }
  long count = 0;
  const long step = block->counter_clockwise ? 1 : p->count - 1;
  for (long k = first; k != last; k = (k + step) % p->count) chain[count++] = k;
  chain[count++] = last;
  return count;
}

static truth try_all(const random_block *block, bool left) {
  const polygon *p = &block->whole;
  long chain[BLOCK_MOST];
  const long count = underside(block, chain);
  truth t = {.known = count > 1, .pivot = -1};
  for (long k = 0; k + 1 < count; k++) t.known = t.known && p->x[chain[k]] <= p->x[chain[k + 1]];
  wide area = 0, x = 0, y = 0;
  for (long k = 0; k < p->count; k++) {
    const long next = k + 1 == p->count ? 0 : k + 1;
    const wide cross = (wide)p->x[k] * p->y[next] - (wide)p->x[next] * p->y[k];
    area += cross;
    x += cross * (p->x[k] + p->x[next]);
    y += cross * (p->y[k] + p->y[next]);
  }
  const int way = area > 0 ? 1 : -1;
  for (long k = 0; k < count && t.known; k++) {
    if (!is_admissible(p, chain, count, chain[k], left)) continue;
    claim(t.pivot < 0, "two pivots are admissible");
    t.pivot = chain[k];
    t.x_arm = way * (x - 3 * area * p->x[chain[k]]) * (left ? 1 : -1);
    t.y_arm = way * (y - 3 * area * p->y[chain[k]]);
  }
  return t;
}

static void claim_truth(const tp_block_turning *own, tp_status status, const truth *t) {
  claim((status == TP_OK) == (t->pivot >= 0), "a pivot is admissible, or none");
  claim(own->pivot == t->pivot, "the pivot");
  if (t->pivot < 0) return;
  const double degrees = 57.295779513082323 * atan2((double)t->x_arm, (double)t->y_arm);
  claim(fabs(degrees - own->angle_deg) <= own->error_deg + 1e-15 * 180, "the angle");
}

/* Solve it as any scene is; the number of its governing pivot's vertex from the coordinates. */
static tp_status solve_alone(tp_block_turning *own, const random_block *block,
                             tp_direction towards) {
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  *own = (tp_block_turning){.angle_deg = NAN, .error_deg = NAN, .pivot = -1};
  claim(tp_scene_new(&scene, "m", &claim_message) == TP_OK, "a scene");
  tp_status status =
      tp_scene_set_outline(scene, tp_coordinates_of(block->xy, block->count), &claim_message);
  claim(status == TP_OK, "an outline");
  const bool left = towards == TP_TOWARDS_LEFT;
  claim(tp_scene_set_tilt_towards(scene, left, !left, &claim_message) == TP_OK, "a direction");
  tp_solve_options options = tp_solve_options_default();
  options.limit = false;
  status = tp_solve(&solution, scene, &options, &claim_message);
  tp_scene_free(scene);
  if (status != TP_OK) return status;
  const tp_case *one = solution->cases;
  if (one->has_toppling_pivot) {
    const tp_pivot *pivot = one->pivots + one->toppling_pivot;
    *own = (tp_block_turning){.angle_deg = pivot->critical_angle_deg.value,
                              .error_deg = pivot->critical_angle_deg.error,
                              .pivot = -1};
    for (long k = 0; k < block->whole.count; k++) {
      if (block->xy[2 * k] == pivot->x_m.value && block->xy[2 * k + 1] == pivot->y_m.value) {
        own->pivot = k;
      }
    }
  }
  status = one->has_toppling_pivot ? TP_OK : TP_NO_ANSWER;
  tp_solution_free(solution);
  return status;
}

static void claim_alike(const tp_block_turning *own, tp_status status, const random_block *block,
                        tp_direction towards) {
  tp_block_turning alone;
  claim(solve_alone(&alone, block, towards) == status, "the status");
  claim(own->pivot == alone.pivot, "the pivot of tp_solve");
  if (status != TP_OK) return;
  claim(fabs(own->angle_deg - alone.angle_deg) <= own->error_deg + alone.error_deg,
        "the angle of tp_solve");
  claim(own->error_deg <= 1e-9 * fabs(own->angle_deg) || own->angle_deg == 0, "a wide bound");
}

START_TEST(critical_angles_of_random_blocks) {
  const long blocks = 4 * random_scenes_or(500);
  long climbed = 0, plain = 0, without = 0; /* climbed though plain */
  tp_workspace workspace = {0};
  for (long k = 0; k < blocks; k++) {
    seed = random_seed() + (uint64_t)k;
    random_numbers state = random_numbers_from(seed);
    random_block block;
    draw_block(&block, &state);
    const tp_direction towards = k % 2 == 0 ? TP_TOWARDS_LEFT : TP_TOWARDS_RIGHT;
    const tp_outlines outlines = tp_outlines_of(block.xy, 1, block.count);
    tp_blocks_options options = tp_blocks_options_default();
    options.towards = towards;
    tp_block_turning own;
    tp_status status;
    tp_blocks_summary summary;
    const tp_critical_columns columns = {&own.angle_deg, &own.error_deg, &own.pivot, &status};
    claim(tp_blocks_critical_angles(&columns, &summary, &outlines, &options, &claim_message) ==
              TP_OK,
          "the call");
    claim_alike(&own, status, &block, towards);
    const truth t = try_all(&block, towards == TP_TOWARDS_LEFT);
    if (t.known) claim_truth(&own, status, &t);
    plain += t.known;
    climbed += t.known && summary.climbed > 0;
    without += (long)summary.without;
  }
  tp_workspace_clear(&workspace);
  ck_assert_int_lt(plain, blocks);
  ck_assert_int_le(climbed, plain / 1000);
  ck_assert_int_gt(without, 0);
}
END_TEST

/* Every instruction set decides the same blocks and gives the same bits. */
START_TEST(instruction_sets) {
  tp_workspace workspace = {0};
  for (long k = 0; k < 2000; k++) {
    seed = random_seed() + (uint64_t)k;
    random_numbers state = random_numbers_from(seed);
    random_block block;
    draw_block(&block, &state);
    tp_block_turning first;
    tp_status first_status = TP_OK;
    for (int set = TP_INSTRUCTIONS_BASELINE; set < TP_INSTRUCTIONS_COUNT; set++) {
      if (!tp_instructions_present(set)) continue;
      const tp_turning_task task = {TP_TOWARDS_LEFT, k % 2 == 0, tp_scan_kernel_choose(set)};
      tp_block_turning own;
      const tp_status status = tp_turning_filter(
          &own, &workspace, tp_vertices_open(block.xy, block.count), &task, &claim_message);
      if (set == TP_INSTRUCTIONS_BASELINE) {
        first = own;
        first_status = status;
      }
      claim(status == first_status && same_bytes(&own, &first, sizeof own), "instructions");
    }
  }
  tp_workspace_clear(&workspace);
}
END_TEST

SUITE(random_blocks) {
  Suite *suite = suite_create("random blocks");
  TCase *tests = tcase_create("blocks");
  tcase_set_timeout(tests, 0);
  tcase_add_test(tests, critical_angles_of_random_blocks);
  tcase_add_test(tests, instruction_sets);
  suite_add_tcase(suite, tests);
  return suite;
}
