// By expat, in pieces, as its lengths are of type int.
#include "io/xml.hpp"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <memory>
#include <type_traits>

#include "io/text.hpp"

namespace lustro {
namespace {

constexpr std::size_t kMostDepth = 256;
constexpr std::size_t kPieceBytes = std::size_t{1} << 20U;

struct Reading {
  XML_Parser parser = nullptr;
  const std::string& where;
  const XmlHandlers& handlers;
  std::size_t depth = 0;
  std::optional<Error> error{};
  std::exception_ptr thrown{};

  [[nodiscard]] std::size_t line() const { return static_cast<std::size_t>(XML_GetCurrentLineNumber(parser)); }
  void stop(Error e) {
    error = std::move(e);
    error->where = at_line(where, line());
    XML_StopParser(parser, XML_FALSE);
  }
  /// No exception goes through expat's C.
  template <class F>
  void guarded(const F& f) {
    if (error || thrown) {  // a stopped parser may still have an end to tell
      return;
    }
    try {
      f();
    } catch (...) {
      thrown = std::current_exception();
      XML_StopParser(parser, XML_FALSE);
    }
  }
};

void begin_element(void* user, const XML_Char* name, const XML_Char** attributes) {
  auto& reading = *static_cast<Reading*>(user);
  reading.guarded([&] {
    if (++reading.depth > kMostDepth) {
      reading.stop({ErrorKind::limit, {}, fmt::format("elements are nested deeper than {}", kMostDepth)});
      return;
    }
    if (std::optional<Error> error = reading.handlers.begin({name, attributes, reading.line()})) {
      reading.stop(*std::move(error));
    }
  });
}
void end_element(void* user, const XML_Char* name) {
  auto& reading = *static_cast<Reading*>(user);
  reading.guarded([&] {
    --reading.depth;
    reading.handlers.end(name);
  });
}
void begin_name_space(void* user, const XML_Char* prefix, const XML_Char* name) {
  auto& reading = *static_cast<Reading*>(user);
  reading.guarded([&] {
    if (reading.handlers.name_space) {
      reading.handlers.name_space(prefix == nullptr ? "" : prefix, name == nullptr ? "" : name);
    }
  });
}
void begin_doctype(void* user, const XML_Char* /*name*/, const XML_Char* /*system*/, const XML_Char* /*public_id*/, int /*has_subset*/) {
  auto& reading = *static_cast<Reading*>(user);
  reading.guarded([&] { reading.stop({ErrorKind::malformed, {}, "a document type declaration, and with it entities, is not allowed"}); });
}

}  // namespace

Result<void> read_xml(std::string_view text, const std::string& where, const XmlHandlers& handlers) {
  const std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> parser(XML_ParserCreateNS(nullptr, '|'), &XML_ParserFree);
  if (parser == nullptr) {
    return fail(ErrorKind::limit, where, "needs more memory than there is");
  }
  Reading reading{parser.get(), where, handlers};
  XML_SetUserData(parser.get(), &reading);
  XML_SetElementHandler(parser.get(), begin_element, end_element);
  XML_SetStartNamespaceDeclHandler(parser.get(), begin_name_space);
  XML_SetStartDoctypeDeclHandler(parser.get(), begin_doctype);
  for (std::size_t at = 0;;) {
    const std::size_t size = std::min(kPieceBytes, text.size() - at);
    const bool is_last = at + size == text.size();
    const XML_Status status = XML_Parse(parser.get(), text.data() + at, static_cast<int>(size), is_last ? XML_TRUE : XML_FALSE);
    if (reading.thrown) {
      std::rethrow_exception(reading.thrown);
    }
    if (reading.error) {
      return tl::unexpected(*std::move(reading.error));
    }
    if (status != XML_STATUS_OK) {
      const XML_Error code = XML_GetErrorCode(parser.get());
      return fail(code == XML_ERROR_NO_MEMORY ? ErrorKind::limit : ErrorKind::malformed, at_line(where, reading.line()),
                  fmt::format("the XML is broken: {}", XML_ErrorString(code)));
    }
    at += size;
    if (is_last) {
      return {};
    }
  }
}

}  // namespace lustro
