/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which block the head of a bolt holds, and where its far end does: in the block that contains its
 * end, or in the one that is named, which its line then meets. Points are rationals; the end of a
 * bolt of a length at an angle is rounded to 256 binary digits. */

#include "block_system/block_loads.h"

#include "common/outside.h"
#include "load/bolt_way.h"
#include "number/ball.h"
#include "scene/anchor.h"

enum { BITS = 256 };

typedef struct bolt {
  const tp_placed_blocks *blocks;
  const tp_anchor_description *anchor;
  fmpq_t x, y, end_x, end_y; /* of its row; the end where it is known */
  bool ends;                 /* it is */
  long head;                 /* the block that its head holds */
  tp_message *message;
} bolt;

static const char *name_of(const bolt *b, long block) {
  return b->blocks->scene->many.blocks[block].name;
}

static void set_end(bolt *b, long row) {
  const tp_anchor_description *a = b->anchor;
  tp_anchor_point(b->x, b->y, a, row);
  b->ends = a->to_x.given || a->length.given;
  if (a->to_x.given) {
    fmpq_sub(b->end_x, b->x, a->x.value);
    fmpq_sub(b->end_y, b->y, a->y.value);
    fmpq_add(b->end_x, b->end_x, a->to_x.value);
    fmpq_add(b->end_y, b->end_y, a->to_y.value);
  } else if (a->length.given) {
    fmpq_t degrees;
    arb_t sine, cosine;
    fmpq_init(degrees);
    arb_init(sine);
    arb_init(cosine);
    tp_anchor_direction(degrees, b->blocks->scene, a);
    tp_ball_sin_cos_degrees(sine, cosine, degrees, BITS);
    arf_get_fmpq(b->end_x, arb_midref(cosine));
    arf_get_fmpq(b->end_y, arb_midref(sine));
    fmpq_mul(b->end_x, b->end_x, a->length.value);
    fmpq_mul(b->end_y, b->end_y, a->length.value);
    fmpq_add(b->end_x, b->end_x, b->x);
    fmpq_add(b->end_y, b->end_y, b->y);
    fmpq_clear(degrees);
    arb_clear(sine);
    arb_clear(cosine);
  }
}

static tp_status find_head(bolt *b) {
  b->head = b->anchor->block;
  if (b->head < 0) {
    return tp_block_find_at(&b->head, b->blocks, b->x, b->y, "bolt", b->anchor->place, b->message);
  }
  if (tp_block_is_near(b->blocks, b->head, b->x, b->y)) return TP_OK;
  return tp_refuse(b->message, TP_FAULT_GEOMETRY, b->anchor->place,
                   "this bolt does not hold block '%s': its head lies outside it",
                   tp_quote_all(name_of(b, b->head)).text);
}

/* The only block but its own in which it ends. */
static tp_status find_end(long *into, const bolt *b) {
  const long own = b->head, count = b->blocks->scene->many.count;
  long first = -1, second = -1;
  if (tp_block_holds(b->blocks, own, b->end_x, b->end_y)) {
    return tp_refuse(b->message, TP_FAULT_GEOMETRY, b->anchor->place,
                     "this bolt lies within block '%s', where its two ends pull against each "
                     "other and do nothing: let it reach into another block, or into ground",
                     tp_quote_all(name_of(b, own)).text);
  }
  for (long k = 0; k < count && second < 0; k++) {
    if (k == own || !tp_block_holds(b->blocks, k, b->end_x, b->end_y)) continue;
    if (first < 0) {
      first = k;
    } else {
      second = k;
    }
  }
  if (first < 0) {
    return tp_refuse(b->message, TP_FAULT_GEOMETRY, b->anchor->place,
                     "this bolt ends where no block is: let its far end lie in a block or in "
                     "ground");
  }
  if (second >= 0) {
    return tp_refuse(b->message, TP_FAULT_GEOMETRY, b->anchor->place,
                     "this bolt ends on the border of '%s' and '%s': let it reach farther",
                     tp_quote_all(name_of(b, first)).text, tp_quote_all(name_of(b, second)).text);
  }
  *into = first;
  return TP_OK;
}

/* Its end, or its line where that is not known, is in the block that the scene names. */
static tp_status check_named(const bolt *b) {
  const tp_anchor_description *a = b->anchor;
  const char *name = name_of(b, a->into);
  if (a->into == b->head) {
    return tp_refuse(b->message, TP_FAULT_KEY, a->place,
                     "this bolt holds in '%s' with both ends, which pull against each other and "
                     "do nothing: 'into' is another block, or ground",
                     tp_quote_all(name).text);
  }
  if (b->ends) {
    if (tp_block_holds(b->blocks, a->into, b->end_x, b->end_y)) return TP_OK;
    return tp_refuse(b->message, TP_FAULT_GEOMETRY, a->place,
                     "this bolt is to hold in '%s', and ends outside it: change its length, or "
                     "'into'",
                     tp_quote_all(name).text);
  }
  fmpq_t degrees;
  arb_t way;
  fmpq_init(degrees);
  arb_init(way);
  tp_anchor_direction(degrees, b->blocks->scene, a);
  const long edge = tp_bolt_way(way, b->blocks->sections[a->into].rings, b->x, b->y, degrees, BITS);
  fmpq_clear(degrees);
  arb_clear(way);
  if (edge >= 0) return TP_OK;
  return tp_refuse(b->message, TP_FAULT_GEOMETRY, a->place,
                   "this bolt does not reach '%s', in which it is to hold: from 'at' along its "
                   "pull it passes it by; change its dip, 'towards' or 'into'",
                   tp_quote_all(name).text);
}

static tp_status find(long *into, bolt *b) {
  const tp_listed_block *all = b->blocks->scene->many.blocks;
  const tp_anchor_description *a = b->anchor;
  tp_status status = find_head(b);
  *into = a->into;
  if (status == TP_OK) status = a->into < 0 ? find_end(into, b) : check_named(b);
  if (status != TP_OK || !all[b->head].fixed || !all[*into].fixed) return status;
  return tp_refuse(b->message, TP_FAULT_KEY, a->place,
                   "both ends of this bolt hold in ground, which it cannot move");
}

tp_status tp_block_bolt_ends(long *head, long *into, const tp_placed_blocks *blocks,
                             const tp_anchor_description *anchor, long row, tp_message *message) {
  bolt b = {.blocks = blocks, .anchor = anchor, .message = message};
  fmpq *const all[] = {b.x, b.y, b.end_x, b.end_y};
  for (int k = 0; k < 4; k++) fmpq_init(all[k]);
  set_end(&b, row);
  const tp_status status = find(into, &b);
  *head = b.head;
  for (int k = 0; k < 4; k++) fmpq_clear(all[k]);
  return status;
}
