/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Meshes and their sections; the first byte says which format, the second which plane. */

#include "format/mesh_cut.h"
#include "format/section_take.h"
#include "fuzz.h"

#include <stdlib.h>

static void judge_mesh(const tp_mesh *mesh) {
  FUZZ_EXPECT(mesh->face_count > 0);
  for (long k = 0; k < 3 * mesh->vertex_count; k++) {
    FUZZ_EXPECT(fmpq_is_canonical(mesh->vertices + k));
  }
  for (long k = 0; k < mesh->face_count; k++) {
    const tp_mesh_face *face = mesh->faces + k;
    FUZZ_EXPECT(face->count >= 3 && face->first + face->count <= mesh->corner_count);
    FUZZ_EXPECT(face->object >= 0 && face->object < mesh->object_count);
    for (int c = 0; c < face->count; c++) {
      const int corner = mesh->corners[face->first + c];
      FUZZ_EXPECT(corner >= 0 && corner < mesh->vertex_count);
    }
  }
}

static void take(tp_mesh_section *section, bool closed, bool largest) {
  tp_section_wish wish;
  tp_polyline line;
  tp_polylines holes = {.count = 0};
  tp_notes notes = {0};
  tp_message message = {.text = ""};
  tp_section_wish_init(&wish);
  wish.closed = closed;
  wish.largest = largest;
  wish.unit = "m";
  fmpq_set_si(wish.gap, 1, 2);
  const tp_status status =
      tp_section_take(&line, closed && !largest ? &holes : NULL, section, &wish, &notes, &message);
  if (status == TP_OK) {
    FUZZ_EXPECT(line.count >= 2 && notes.count > 0);
    for (long k = 0; k < line.count; k++) {
      FUZZ_EXPECT(fmpq_is_canonical(line.x + k) && fmpq_is_canonical(line.y + k));
    }
  } else {
    FUZZ_EXPECT(message.text[0] != '\0' && line.count == 0 && holes.count == 0);
  }
  tp_polylines_clear(&holes);
  tp_polyline_clear(&line);
  tp_notes_clear(&notes);
  tp_section_wish_clear(&wish);
}

static void cut(const tp_mesh *mesh, uint8_t choice) {
  tp_section_plane plane;
  tp_mesh_section section;
  tp_message message = {.text = ""};
  fmpq_t x, azimuth;
  fmpq_init(x);
  fmpq_init(azimuth);
  fmpq_set_si(x, choice % 4, 4);
  fmpq_set_si(azimuth, 30L * (choice / 16), 1);
  tp_section_plane_init(&plane);
  plane.y_is_up = choice % 8 >= 4;
  tp_section_plane_at(&plane, x, x, azimuth);
  if (tp_mesh_cut(&section, mesh, -1, &plane, &message) == TP_OK) {
    take(&section, choice % 2 == 0, choice % 3 == 0);
  } else {
    FUZZ_EXPECT(message.text[0] != '\0');
  }
  tp_mesh_section_clear(&section);
  tp_section_plane_clear(&plane);
  fmpq_clear(x);
  fmpq_clear(azimuth);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static const tp_mesh_format formats[] = {TP_MESH_STL, TP_MESH_PLY, TP_MESH_OBJ};
  if (size < 2 || size > 20000) return -1;
  char *bytes = fuzz_text(data + 2, size - 2);
  tp_mesh mesh;
  tp_message message = {.text = ""};
  const tp_status status =
      tp_mesh_read_bytes(&mesh, formats[data[0] % 3], bytes, size - 2, "mesh", &message);
  if (status == TP_OK) {
    judge_mesh(&mesh);
    cut(&mesh, data[1]);
  } else {
    FUZZ_EXPECT(message.text[0] != '\0' && mesh.vertex_count == 0);
  }
  tp_mesh_clear(&mesh);
  free(bytes);
  return 0;
}
