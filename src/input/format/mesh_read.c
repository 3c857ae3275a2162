/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads a mesh file of at most 1 GiB into memory and calls the reader of its format: STL, PLY or
 * OBJ. */

#include "common/input_file.h"
#include "format/mesh_source.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>

tp_status tp_mesh_read_bytes(tp_mesh *mesh, tp_mesh_format format, const char *bytes, size_t length,
                             const char *name, tp_message *message) {
  tp_mesh_source source;
  *mesh = (tp_mesh){.file = name};
  tp_status status = tp_mesh_source_init(&source, name, bytes, length, message);
  if (status == TP_OK) status = tp_mesh_begin_object(mesh, "", 0, message);
  if (status == TP_OK) {
    status = format == TP_MESH_STL   ? tp_mesh_read_stl(mesh, &source)
             : format == TP_MESH_PLY ? tp_mesh_read_ply(mesh, &source)
                                     : tp_mesh_read_obj(mesh, &source);
  }
  if (status == TP_OK && mesh->face_count == 0) {
    status = tp_mesh_fail_file(&source, mesh->left_out > 0
                                            ? "none of its faces has three different corners"
                                            : "there is no face in it; points alone bound "
                                              "nothing, so make a mesh of them first");
  }
  if (status != TP_OK) tp_mesh_clear(mesh);
  return status;
}

/* All of it; `*bytes` is the caller's to free, also on failure. */
static tp_status read_all(char **bytes, size_t *length, FILE *file, const char *path,
                          tp_message *message) {
  struct stat about;
  if (fstat(fileno(file), &about) != 0) return tp_fail_file(message, path, "read", errno);
  if (!S_ISREG(about.st_mode)) {
    return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){path, 0, 0}, "is not a regular file");
  }
  if (about.st_size > TP_MESH_BYTES) {
    return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){path, 0, 0},
                     "is larger than 1 GiB; thin the mesh out, or cut away what is not needed");
  }
  const size_t room = (size_t)about.st_size;
  *bytes = malloc(room + 1);
  if (*bytes == NULL) return tp_fail_memory(message, "a mesh");
  *length = fread(*bytes, 1, room, file);
  return ferror(file) == 0 ? TP_OK : tp_fail_file(message, path, "read", errno);
}

tp_status tp_mesh_read(tp_mesh *mesh, const char *path, tp_message *message) {
  const tp_mesh_format format = tp_mesh_format_of(path);
  char *bytes = NULL;
  size_t length = 0;
  *mesh = (tp_mesh){.file = path};
  if (format == TP_MESH_NONE) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){path, 0, 0},
                     "a mesh is a file whose name ends in .stl, .ply or .obj");
  }
  FILE *file = NULL;
  tp_status status = tp_input_open(&file, path, message);
  if (status != TP_OK) return status;
  status = read_all(&bytes, &length, file, path, message);
  fclose(file);
  if (status == TP_OK) status = tp_mesh_read_bytes(mesh, format, bytes, length, path, message);
  free(bytes);
  return status;
}
