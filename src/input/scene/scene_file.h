/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene file as it was read: its nodes, the names of files in it, and its chains of points. All
 * scenes that are read out of it, with the numbers that stand there or with others, share it, in
 * whichever thread they are: once read it is not changed any more. */

#ifndef TP_SCENE_SCENE_FILE_H
#define TP_SCENE_SCENE_FILE_H

#include "common/message.h"
#include "format/mesh.h"
#include "plane/polyline.h"
#include "scene/drawn.h"
#include "scene/node.h"

#include <stdatomic.h>

/* A chain of points, in the order in which they are read. */
typedef struct tp_file_chain {
  const tp_node *node;
  bool fixed; /* no parameter bears upon it: the points are kept, */
  tp_polyline line;
  tp_polylines holes; /* of an outline that a mesh has cavities in */
  tp_notes notes;     /* and what was noted as they were read */
} tp_file_chain;

typedef struct tp_scene_file {
  atomic_long users;
  char *path;
  tp_node *root;
  char *load_case; /* the name of the case that it was made of; NULL: it was read as it is */
  long name_count; /* of files that the scene names */
  char **names;
  long chain_count, chain_room;
  tp_file_chain *chains;
  long mesh_count, mesh_room; /* that its sections are cut through */
  tp_mesh **meshes;
  tp_drawn *drawn;      /* what its drawing gives; NULL: it has none, or that varies */
  _Atomic(void *) kept; /* what higher rooms made of it once for all its scenes; NULL: nothing */
  void (*kept_free)(void *kept);
} tp_scene_file;

/* Of one user. It takes the nodes over, but for where memory is exhausted: then it is NULL. */
tp_scene_file *tp_scene_file_make(const char *path, tp_node *root);
tp_scene_file *tp_scene_file_share(tp_scene_file *file);
void tp_scene_file_free(tp_scene_file *file);

/* The path of a file that the scene names, relative to the scene's folder; kept here. NULL when
 * memory is exhausted. */
const char *tp_scene_file_name(tp_scene_file *file, const char *name);
/* The mesh of a name that the scene gives, read once. */
TP_MUST_USE tp_status tp_scene_file_mesh(const tp_mesh **mesh, tp_scene_file *file,
                                         const char *name, tp_message *message);
/* Keep what was made of the file, or give it back where another thread was faster; what is kept. */
void *tp_scene_file_keep(tp_scene_file *file, void *made, void (*give_back)(void *made));
/* Room for the next chain; NULL when memory is exhausted. */
tp_file_chain *tp_scene_file_add_chain(tp_scene_file *file, const tp_node *node);

#endif
