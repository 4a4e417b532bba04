// mtllib and usemtl.
#include "io/obj_materials.hpp"

#include <fmt/format.h>

#include <cctype>
#include <utility>

#include "io/mtl.hpp"
#include "io/text.hpp"

namespace lustro {

namespace {

// Files that a hostile OBJ may make the caller look for.
constexpr std::size_t kMostLibraries = 256;

bool ends_in_mtl(std::string_view text) {
  if (text.size() < 4) {
    return false;
  }
  const std::string_view end = text.substr(text.size() - 4);
  const auto lower = [&](std::size_t i) { return std::tolower(static_cast<unsigned char>(end[i])); };
  return end[0] == '.' && lower(1) == 'm' && lower(2) == 't' && lower(3) == 'l';
}

std::string without_quotes(std::string name) {
  return name.size() > 1 && name.front() == '"' && name.back() == '"' ? name.substr(1, name.size() - 2) : name;
}

}  // namespace

std::vector<std::string> split_library_names(const std::string& line_text) {
  const bool has_suffixes = ends_in_mtl(line_text);
  std::vector<std::string> names;
  std::size_t begin = 0;
  for (std::size_t at = 0; at <= line_text.size(); ++at) {
    const bool is_end = at == line_text.size() || TextCursor::is_blank(line_text[at]);
    if (!is_end || at == begin) {
      begin += is_end ? 1U : 0U;  // a blank in front of a name
      continue;
    }
    if (!has_suffixes || ends_in_mtl(std::string_view(line_text).substr(begin, at - begin))) {
      names.push_back(without_quotes(line_text.substr(begin, at - begin)));
      begin = at + 1;
    }
  }
  return names;
}

ObjMaterials::Outcome ObjMaterials::read_library(const std::string& name) {
  if (read_.contains(name)) {
    return Outcome::read;
  }
  if (missing_.contains(name)) {
    return Outcome::missing;
  }
  if (read_.size() + missing_.size() >= kMostLibraries) {
    return Outcome::missing;
  }
  const Result<std::string> text = options_.read_library ? options_.read_library(name) : fail(ErrorKind::io, name, "no library is at hand");
  if (!text) {
    missing_.emplace(name, text.error().message);
    return Outcome::missing;
  }
  read_.insert(name);
  Result<MtlFile> library = parse_mtl(*text, name, {.transparency_is_tr = options_.transparency_is_tr});
  if (!library) {
    error_ = std::move(library.error());
    return Outcome::failed;
  }
  for (Material& material : library->materials) {
    Slot& slot = slots_[number(material.name, 0)];
    if (slot.is_defined) {
      library_notes_.push_back({name, fmt::format("material {} is stated in another library too: the last one counts", shown(material.name))});
    }
    slot.material = std::move(material);
    slot.is_defined = true;
  }
  library_notes_.insert(library_notes_.end(), library->notes.begin(), library->notes.end());
  return Outcome::read;
}

Result<void> ObjMaterials::read_libraries(const std::string& line_text, std::size_t line, NoteBook& notes) {
  if (line_text.empty()) {
    notes.add(line, "mtllib names no file");
    return {};
  }
  const std::string whole = without_quotes(line_text);
  Outcome outcome = read_library(whole);
  if (outcome == Outcome::missing) {
    const std::vector<std::string> names = split_library_names(line_text);
    if (names.size() < 2) {
      note_missing(whole, line, notes);
      return {};
    }
    for (std::size_t i = 0; i < names.size() && outcome != Outcome::failed; ++i) {
      outcome = read_library(names[i]);
      if (outcome == Outcome::missing) {
        note_missing(names[i], line, notes);
      }
    }
  }
  if (outcome == Outcome::failed) {
    return tl::unexpected(std::move(*error_));
  }
  return {};
}

void ObjMaterials::note_missing(const std::string& name, std::size_t line, NoteBook& notes) const {
  const auto reason = missing_.find(name);
  notes.add(line, reason == missing_.end() ? fmt::format("{} material libraries are named: the others are not read", kMostLibraries)
                                           : fmt::format("the material library {} is not read: {}", shown(name), reason->second));
}

std::uint32_t ObjMaterials::number(std::string name, std::size_t line) {
  const auto [known, is_new] = numbers_.emplace(std::move(name), static_cast<std::uint32_t>(slots_.size()));
  if (is_new) {
    slots_.push_back({});
    slots_.back().material.name = known->first;
    slots_.back().first_line = line;
  }
  return known->second;
}

std::vector<Material> ObjMaterials::take(NoteBook& notes, Notes& library_notes) {
  std::vector<Material> materials;
  materials.reserve(slots_.size());
  for (Slot& slot : slots_) {
    if (!slot.is_defined) {
      notes.add(slot.first_line, fmt::format("material {} is not defined: it has the default coefficients", shown(slot.material.name)));
    }
    materials.push_back(std::move(slot.material));
  }
  library_notes = std::move(library_notes_);
  return materials;
}

}  // namespace lustro
