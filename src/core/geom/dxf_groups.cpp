/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Adapter of dxflib's reader: groups that were read already are handed to it, and complete entities
 * are reported to a visitor; counts that a file states are replaced by the counts found. */

#include "geom/dxf_groups.h"

#include "geom/guard.hpp"

#include <dl_creationadapter.h>
#include <dl_dxf.h>

#include <map>
#include <memory>
#include <new>
#include <string>

namespace {

bool is(const tp_dxf_group &group, const char *word) {
  return std::string(group.text, group.length) == word;
}

/* What dxflib is shown, besides the beginnings of all else. */
bool is_wanted(const tp_dxf_group &name) {
  static const char *const wanted[] = {"SECTION",   "ENDSEC",   "EOF",     "BLOCK",      "ENDBLK",
                                       "LINE",      "VERTEX",   "SEQEND",  "LWPOLYLINE", "POLYLINE",
                                       "ARC",       "CIRCLE",   "ELLIPSE", "SPLINE",     "INSERT",
                                       "$INSUNITS", "$ACADVER", "LAYER"};
  for (const char *word : wanted) {
    if (is(name, word)) return true;
  }
  return false;
}

class Reader : public DL_CreationAdapter {
public:
  Reader(const tp_dxf_group *groups, size_t count, tp_dxf_visitor visitor, void *context)
      : groups(groups), count(count), visitor(visitor), context(context) {
  }

  void read() {
    /* Its constructor leaves members open that it decides by: they are what the memory was. */
    alignas(DL_Dxf) unsigned char memory[sizeof(DL_Dxf)] = {};
    const std::unique_ptr<DL_Dxf, void (*)(DL_Dxf *)> dxf(new (memory) DL_Dxf,
                                                          [](DL_Dxf *own) { own->~DL_Dxf(); });
    bool wanted = false;
    for (size_t k = 0; k < count && going; k++) {
      const tp_dxf_group &group = groups[k];
      if (group.code == 0 || group.code == 9) {
        begin = next;
        end = k;
        next = k;
        wanted = is_wanted(group);
        dxf->processDXFGroup(this, group.code,
                             wanted ? std::string(group.text, group.length) : "OTHER");
      } else if (wanted) {
        dxf->processDXFGroup(this, group.code, value(k));
      }
    }
  }

  void addLayer(const DL_LayerData &) override {
    tell(TP_DXF_LAYER);
  }
  void addBlock(const DL_BlockData &) override {
    tell(TP_DXF_BLOCK);
  }
  void endBlock() override {
    tell(TP_DXF_BLOCK_END);
  }
  void addLine(const DL_LineData &) override {
    tell(TP_DXF_LINE);
  }
  void addArc(const DL_ArcData &) override {
    tell(TP_DXF_ARC);
  }
  void addCircle(const DL_CircleData &) override {
    tell(TP_DXF_CIRCLE);
  }
  void addEllipse(const DL_EllipseData &) override {
    tell(TP_DXF_ELLIPSE);
  }
  void addPolyline(const DL_PolylineData &) override {
    tell(is(groups[begin], "LWPOLYLINE") ? TP_DXF_LWPOLYLINE : TP_DXF_POLYLINE);
  }
  void addVertex(const DL_VertexData &) override {
    if (is(groups[begin], "VERTEX")) tell(TP_DXF_VERTEX);
  }
  void endSequence() override {
    tell(TP_DXF_SEQUENCE_END);
  }
  void addSpline(const DL_SplineData &) override {
    tell(TP_DXF_SPLINE);
  }
  void addInsert(const DL_InsertData &) override {
    tell(TP_DXF_INSERT);
  }
  void setVariableString(const std::string &, const std::string &, int) override {
    tell(TP_DXF_VARIABLE);
  }
  void setVariableInt(const std::string &, int, int) override {
    tell(TP_DXF_VARIABLE);
  }

private:
  void tell(tp_dxf_event event) {
    if (going) going = visitor(context, event, groups + begin, end - begin);
  }

  /* How many groups of a code the entity has that is being read. */
  std::string counted(int code) {
    if (counted_of != next) {
      of_code.clear();
      for (size_t k = next + 1; k < count && groups[k].code != 0; k++) {
        const int own = groups[k].code;
        if (own == 10 || own == 11 || own == 40) of_code[own]++;
      }
      counted_of = next;
    }
    return std::to_string(of_code[code]);
  }

  /* dxflib makes room for as many as the file says, and trusts it. */
  std::string value(size_t k) {
    const int code = groups[k].code;
    if (is(groups[next], "LWPOLYLINE") && code == 90) return counted(10);
    if (is(groups[next], "SPLINE")) {
      if (code == 72) return counted(40);
      if (code == 73) return counted(10);
      if (code == 74) return counted(11);
    }
    return std::string(groups[k].text, groups[k].length);
  }

  const tp_dxf_group *groups;
  size_t count;
  tp_dxf_visitor visitor;
  void *context;
  bool going = true;
  size_t begin = 0, end = 0, next = 0; /* what is complete, and where the next one begins */
  std::map<int, size_t> of_code;
  size_t counted_of = SIZE_MAX; /* the entity whose groups are counted */
};

} // namespace

bool tp_dxf_is_there(void) {
  return true;
}

tp_geom_status tp_dxf_visit(const tp_dxf_group *groups, size_t count, tp_dxf_visitor visitor,
                            void *context) {
  return tp::guard([&] {
    Reader(groups, count, visitor, context).read();
    return TP_GEOM_OK;
  });
}
