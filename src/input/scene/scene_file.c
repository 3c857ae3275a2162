/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Nodes, file names, meshes and chains of a scene file with an atomic count of users; names are
 * taken relative to the folder of the scene. */

#include "scene/scene_file.h"

#include "common/grow.h"
#include "common/notes.h"

#include <stdlib.h>
#include <string.h>

tp_scene_file *tp_scene_file_make(const char *path, tp_node *root) {
  tp_scene_file *file = calloc(1, sizeof *file);
  if (file == NULL) return NULL;
  file->path = strdup(path);
  if (file->path == NULL) {
    free(file);
    return NULL;
  }
  atomic_init(&file->users, 1);
  file->root = root;
  return file;
}

tp_scene_file *tp_scene_file_share(tp_scene_file *file) {
  atomic_fetch_add(&file->users, 1);
  return file;
}

void tp_scene_file_free(tp_scene_file *file) {
  if (file == NULL || atomic_fetch_sub(&file->users, 1) > 1) return;
  for (long k = 0; k < file->chain_count; k++) {
    tp_polyline_clear(&file->chains[k].line);
    tp_polylines_clear(&file->chains[k].holes);
    tp_notes_clear(&file->chains[k].notes);
  }
  free(file->chains);
  void *kept = atomic_load(&file->kept);
  if (kept != NULL) file->kept_free(kept);
  for (long k = 0; k < file->mesh_count; k++) {
    tp_mesh_clear(file->meshes[k]);
    free(file->meshes[k]);
  }
  free(file->meshes);
  if (file->drawn != NULL) tp_drawn_clear(file->drawn);
  free(file->drawn);
  for (long k = 0; k < file->name_count; k++) free(file->names[k]);
  free(file->names);
  tp_node_free(file->root);
  free(file->load_case);
  free(file->path);
  free(file);
}

/* Bytes of the scene's own path that stand before that of a file that it names. */
static size_t folder_length(const tp_scene_file *file, const char *name) {
  const char *slash = strrchr(file->path, '/');
  return name[0] == '/' || slash == NULL ? 0 : (size_t)(slash - file->path) + 1;
}

const char *tp_scene_file_name(tp_scene_file *file, const char *name) {
  const size_t folder = folder_length(file, name);
  char **names = realloc(file->names, ((size_t)file->name_count + 1) * sizeof *names);
  if (names == NULL) return NULL;
  file->names = names;
  char *path = malloc(folder + strlen(name) + 1);
  if (path == NULL) return NULL;
  memcpy(path, file->path, folder);
  strcpy(path + folder, name);
  names[file->name_count++] = path;
  return path;
}

static bool is_path_of(const tp_scene_file *file, const char *path, const char *name) {
  const size_t folder = folder_length(file, name);
  return strncmp(path, file->path, folder) == 0 && strcmp(path + folder, name) == 0;
}

tp_status tp_scene_file_mesh(const tp_mesh **mesh, tp_scene_file *file, const char *name,
                             tp_message *message) {
  for (long k = 0; k < file->mesh_count; k++) {
    if (!is_path_of(file, file->meshes[k]->file, name)) continue;
    *mesh = file->meshes[k];
    return TP_OK;
  }
  tp_mesh **meshes =
      tp_grow(file->meshes, file->mesh_count, &file->mesh_room, sizeof *file->meshes);
  if (meshes == NULL) return tp_fail_memory(message, "a mesh");
  file->meshes = meshes;
  const char *path = tp_scene_file_name(file, name);
  if (path == NULL) return tp_fail_memory(message, "a mesh");
  tp_mesh *own = malloc(sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "a mesh");
  const tp_status status = tp_mesh_read(own, path, message);
  if (status != TP_OK) {
    free(own);
    return status;
  }
  *mesh = meshes[file->mesh_count++] = own;
  return TP_OK;
}

void *tp_scene_file_keep(tp_scene_file *file, void *made, void (*give_back)(void *made)) {
  void *kept = NULL;
  if (!atomic_compare_exchange_strong(&file->kept, &kept, made)) {
    give_back(made);
    return kept;
  }
  file->kept_free = give_back;
  return made;
}

tp_file_chain *tp_scene_file_add_chain(tp_scene_file *file, const tp_node *node) {
  tp_file_chain *chains =
      tp_grow(file->chains, file->chain_count, &file->chain_room, sizeof *file->chains);
  if (chains == NULL) return NULL;
  file->chains = chains;
  tp_file_chain *chain = chains + file->chain_count++;
  *chain = (tp_file_chain){.node = node};
  return chain;
}
