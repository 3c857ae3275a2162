/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One pass over the definitions of blocks collects, with memoised recursion, which roles their
 * objects take and how many objects an insert makes. */

#include "format/dxf_use.h"

#include "format/roles.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* What a layer or a name asks for: USED has a role; NAMED says so that no other can be the block.
 */
enum { USED = 1, NAMED = 2, FOLLOWS = 4 };

/* As many are put where they are, whatever they are: reports list them. */
static const double few = 10000;

tp_dxf_block *tp_dxf_block_find(const tp_dxf_reader *r, const tp_dxf_group *name) {
  for (long k = 0; k < r->block_count; k++) {
    const tp_dxf_group *own = &r->blocks[k].name;
    if (own->length == name->length && strncasecmp(own->text, name->text, name->length) == 0) {
      return r->blocks + k;
    }
  }
  return NULL;
}

long tp_dxf_first_insert(const tp_dxf_reader *r) {
  const tp_dxf_block *last = r->block_count > 0 ? r->blocks + r->block_count - 1 : NULL;
  return last != NULL ? last->first_insert + last->inserts : 0;
}

static int use_of(const tp_dxf_reader *r, const char *layer, const char *name) {
  const tp_drawing_role role = tp_drawing_role_by(r->options->words, layer, name);
  if (role == TP_DRAWING_PART) return USED;
  if (role != TP_DRAWING_UNUSED) return USED | NAMED;
  return strcasecmp(layer, "PART") == 0 ? USED : 0; /* which the scene is to give a weight */
}

static bool is_zero(const char *layer) {
  return strcmp(layer, "0") == 0;
}

/* What `use` of an insert's objects comes to on the layer of a group. */
static int follow(const tp_dxf_reader *r, int use, const tp_dxf_group *layer) {
  if ((use & FOLLOWS) == 0) return use;
  char *own = strndup(layer->text, layer->length);
  if (own == NULL) return use | USED;
  const int here = is_zero(own) ? FOLLOWS : use_of(r, own, "");
  free(own);
  return (use & ~FOLLOWS) | here;
}

static double times(const tp_dxf_insert *insert) {
  const double columns = insert->columns > 1 ? (double)insert->columns : 1;
  return columns * (insert->rows > 1 ? (double)insert->rows : 1);
}

/* Blocks deeper than that are refused where they are put; till then they count as used. */
static void tell_block(tp_dxf_reader *r, tp_dxf_block *block, int depth) {
  if (block->is_told) return;
  block->is_told = true;
  for (long k = 0; k < block->objects; k++) {
    const tp_drawing_object *own = r->parts.objects + block->first_object + k;
    block->use |=
        is_zero(own->layer) ? FOLLOWS | use_of(r, "", own->name) : use_of(r, own->layer, own->name);
    block->puts++;
  }
  for (long k = 0; k < block->inserts; k++) {
    const tp_dxf_insert *insert = r->inserts + block->first_insert + k;
    tp_dxf_block *inner = tp_dxf_block_find(r, &insert->block);
    if (inner == NULL) continue;
    if (depth == TP_DXF_DEEPEST) {
      block->use |= USED;
      continue;
    }
    tell_block(r, inner, depth + 1);
    block->use |= follow(r, inner->use, &insert->layer);
    block->puts += times(insert) * inner->puts;
  }
}

bool tp_dxf_use_tell(tp_dxf_reader *r) {
  if (r->options->words == NULL || r->options->reference != NULL) return true;
  double puts = 0;
  int use = r->options->words->block_chosen ? NAMED : 0;
  for (long k = 0; k < r->drawing->count; k++) {
    use |= use_of(r, r->drawing->objects[k].layer, r->drawing->objects[k].name);
  }
  for (long k = tp_dxf_first_insert(r); k < r->insert_count; k++) {
    const tp_dxf_insert *insert = r->inserts + k;
    tp_dxf_block *block = tp_dxf_block_find(r, &insert->block);
    if (block == NULL) continue;
    tell_block(r, block, 1);
    use |= follow(r, block->use, &insert->layer);
    puts += times(insert) * block->puts;
  }
  r->named = (use & NAMED) != 0;
  r->sparing = r->named && puts > few;
  if (!r->sparing) return true;
  r->status =
      tp_notes_add(&r->drawing->notes, r->message, TP_NOTE, (tp_place){r->drawing->path, 0, 0},
                   "inserted blocks come to %.6g objects; those on layers that are neither "
                   "block, base, hole nor part are left out",
                   puts);
  return r->status == TP_OK;
}

bool tp_dxf_use_insert(const tp_dxf_reader *r, const tp_dxf_block *block, const char *layer) {
  if (!r->sparing || (block->use & USED) != 0) return true;
  return (block->use & FOLLOWS) != 0 && (is_zero(layer) || (use_of(r, layer, "") & USED) != 0);
}

bool tp_dxf_use_object(const tp_dxf_reader *r, const char *layer, const char *name) {
  return !r->named || (use_of(r, layer, name) & USED) != 0;
}
