/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Room for labels: off the block always, off each other always, off arrows where possible. */

#include "figure/figure.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void tp_label_room_clear(tp_label_room *room) {
  free(room->sides);
  memset(room, 0, sizeof *room);
}

/* The sides of a flattened path; with `sides` NULL only their number. */
static size_t collect_sides(tp_spot (*sides)[2], const cairo_path_t *path) {
  size_t count = 0;
  tp_spot last = {0, 0}, first = {0, 0};
  for (int k = 0; k < path->num_data; k += path->data[k].header.length) {
    const cairo_path_data_t *data = path->data + k;
    tp_spot next = first;
    if (data->header.type != CAIRO_PATH_CLOSE_PATH) {
      next = (tp_spot){data[1].point.x, data[1].point.y};
    }
    if (data->header.type == CAIRO_PATH_MOVE_TO) {
      first = next;
    } else {
      if (sides != NULL) {
        sides[count][0] = last;
        sides[count][1] = next;
      }
      count++;
    }
    last = next;
  }
  return count;
}

bool tp_label_room_init(tp_label_room *room, cairo_t *cr, const tp_figure *figure,
                        const tp_view *view, tp_box area) {
  memset(room, 0, sizeof *room);
  room->area = area;
  tp_view_path(cr, view, &figure->shape.outline);
  cairo_path_t *path = cairo_copy_path_flat(cr);
  cairo_new_path(cr);
  if (path->status == CAIRO_STATUS_SUCCESS) {
    const size_t count = collect_sides(NULL, path);
    room->sides = calloc(count + 1, sizeof *room->sides);
    if (room->sides != NULL) room->side_count = collect_sides(room->sides, path);
  }
  cairo_path_destroy(path);
  return room->sides != NULL;
}

void tp_label_room_line(tp_label_room *room, tp_spot from, tp_spot to) {
  if (room->line_count == TP_LABEL_ROOM_MAX) return;
  room->lines[room->line_count][0] = from;
  room->lines[room->line_count++][1] = to;
}

/* Does the segment enter the box? Clipped against its four sides one by one. */
static bool crosses(const tp_spot side[2], const tp_box *box) {
  const double dx = side[1].x - side[0].x, dy = side[1].y - side[0].y;
  const double steps[4] = {-dx, dx, -dy, dy};
  const double rooms[4] = {side[0].x - box->x0, box->x1 - side[0].x, side[0].y - box->y0,
                           box->y1 - side[0].y};
  double begin = 0, end = 1;
  for (int k = 0; k < 4; k++) {
    if (steps[k] == 0) {
      if (rooms[k] < 0) return false;
      continue;
    }
    const double t = rooms[k] / steps[k];
    if (steps[k] < 0) begin = fmax(begin, t);
    if (steps[k] > 0) end = fmin(end, t);
  }
  return begin <= end;
}

tp_box_place tp_box_among_sides(const tp_box *box, const tp_spot (*sides)[2], size_t count) {
  const double x = (box->x0 + box->x1) / 2, y = (box->y0 + box->y1) / 2;
  bool inside = false;
  for (size_t k = 0; k < count; k++) {
    const tp_spot *side = sides[k];
    if (crosses(side, box)) return TP_BOX_ACROSS;
    if ((side[0].y > y) == (side[1].y > y)) continue;
    const double t = (y - side[0].y) / (side[1].y - side[0].y);
    if (side[0].x + t * (side[1].x - side[0].x) > x) inside = !inside;
  }
  return inside ? TP_BOX_INSIDE : TP_BOX_OUTSIDE;
}

static bool is_free(const tp_label_room *room, const tp_box *box, bool off_lines) {
  const tp_box *a = &room->area;
  if (box->x0 < a->x0 || box->x1 > a->x1 || box->y0 < a->y0 || box->y1 > a->y1) return false;
  for (size_t k = 0; k < room->label_count; k++) {
    const tp_box *other = room->labels + k;
    if (box->x0 < other->x1 && other->x0 < box->x1 && box->y0 < other->y1 && other->y0 < box->y1) {
      return false;
    }
  }
  for (size_t k = 0; k < room->line_count && off_lines; k++) {
    if (crosses(room->lines[k], box)) return false;
  }
  return tp_box_among_sides(box, (const tp_spot(*)[2])room->sides, room->side_count) ==
         TP_BOX_OUTSIDE;
}

bool tp_label_room_find(tp_box *box, tp_label_room *room, tp_spot anchor, tp_spot direction,
                        double width, double height, double reach, bool strict) {
  enum { TURNS = 13, STEP = 3 };
  const double turn = atan(1) / 3; /* 15 degrees */
  for (int off_lines = 1; off_lines >= (strict ? 1 : 0); off_lines--) {
    for (int step = 0; 3 + STEP * step <= reach; step++) {
      for (int k = 0; k < TURNS && room->label_count < TP_LABEL_ROOM_MAX; k++) {
        const int turns = (k + 1) / 2; /* to either side by turns */
        const double angle = turn * (k % 2 == 0 ? turns : -turns);
        const tp_spot d = {direction.x * cos(angle) - direction.y * sin(angle),
                           direction.x * sin(angle) + direction.y * cos(angle)};
        /* the box's half-width in that direction, so that its edge is what is near */
        const double half =
            fmin(width / 2 / fmax(fabs(d.x), 1e-9), height / 2 / fmax(fabs(d.y), 1e-9));
        const double away = 3 + STEP * step + fmin(half, hypot(width, height) / 2);
        const double x = anchor.x + away * d.x, y = anchor.y + away * d.y;
        const tp_box candidate = {x - width / 2, y - height / 2, x + width / 2, y + height / 2};
        if (!is_free(room, &candidate, off_lines == 1)) continue;
        *box = room->labels[room->label_count++] = candidate;
        return true;
      }
    }
  }
  return false;
}
