/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "json_events.h"

#include "guard.hpp"

#include <rapidjson/error/en.h>
#include <rapidjson/memorystream.h>
#include <rapidjson/reader.h>

namespace {

class Handler {
public:
  Handler(const rapidjson::MemoryStream &stream, tp_json_visitor visitor, void *context)
      : stream(stream), visitor(visitor), context(context) {
  }

  bool Null() {
    return tell(TP_JSON_EVENT_OTHER);
  }
  bool Bool(bool) {
    return tell(TP_JSON_EVENT_OTHER);
  }
  bool Int(int) {
    return tell(TP_JSON_EVENT_OTHER);
  } /* never: numbers are texts */
  bool Uint(unsigned) {
    return tell(TP_JSON_EVENT_OTHER);
  }
  bool Int64(int64_t) {
    return tell(TP_JSON_EVENT_OTHER);
  }
  bool Uint64(uint64_t) {
    return tell(TP_JSON_EVENT_OTHER);
  }
  bool Double(double) {
    return tell(TP_JSON_EVENT_OTHER);
  }
  bool RawNumber(const char *text, rapidjson::SizeType length, bool) {
    return tell(TP_JSON_EVENT_NUMBER, text, length);
  }
  bool String(const char *text, rapidjson::SizeType length, bool) {
    return tell(TP_JSON_EVENT_STRING, text, length);
  }
  bool Key(const char *text, rapidjson::SizeType length, bool) {
    return tell(TP_JSON_EVENT_KEY, text, length);
  }
  bool StartObject() {
    return tell(TP_JSON_EVENT_OBJECT);
  }
  bool EndObject(rapidjson::SizeType) {
    return tell(TP_JSON_EVENT_OBJECT_END);
  }
  bool StartArray() {
    return tell(TP_JSON_EVENT_ARRAY);
  }
  bool EndArray(rapidjson::SizeType) {
    return tell(TP_JSON_EVENT_ARRAY_END);
  }

private:
  bool tell(tp_json_event_kind kind, const char *text = "", size_t length = 0) {
    const tp_json_event event = {kind, text, length, stream.Tell()};
    return visitor(context, &event);
  }

  const rapidjson::MemoryStream &stream;
  tp_json_visitor visitor;
  void *context;
};

} // namespace

bool tp_json_events_are_there(void) {
  return true;
}

tp_geom_status tp_json_visit(const char *text, size_t length, tp_json_visitor visitor,
                             void *context, const char **problem, size_t *at) {
  return tp::guard([&] {
    constexpr unsigned flags = rapidjson::kParseIterativeFlag |
                               rapidjson::kParseNumbersAsStringsFlag |
                               rapidjson::kParseValidateEncodingFlag;
    rapidjson::MemoryStream stream(text, length); /* ends there, also within a character */
    Handler handler(stream, visitor, context);
    rapidjson::Reader reader;
    const rapidjson::ParseResult result = reader.Parse<flags>(stream, handler);
    const bool ended = result.Code() == rapidjson::kParseErrorTermination;
    *problem = result.IsError() && !ended ? rapidjson::GetParseError_En(result.Code()) : nullptr;
    *at = result.Offset();
    return TP_GEOM_OK;
  });
}
