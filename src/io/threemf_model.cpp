// The elements of a model part, each read where it begins. Elements and attributes of other namespaces are passed over.
#include "io/threemf_model.hpp"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "io/limits.hpp"
#include "io/text.hpp"
#include "io/xml.hpp"

namespace lustro {
namespace {

constexpr std::string_view kCore = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
constexpr std::string_view kMaterial = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02";
constexpr std::string_view kProduction = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
constexpr std::string_view kPath = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06|path";
constexpr std::string_view kRelationship = "http://schemas.openxmlformats.org/package/2006/relationships|Relationship";

struct Unit {
  std::string_view name;
  double millimetres;
};
constexpr std::array<Unit, 6> kUnits{
    {{"micron", 0.001}, {"millimeter", 1}, {"centimeter", 10}, {"inch", 25.4}, {"foot", 304.8}, {"meter", 1000}}};

std::optional<Error> malformed(std::string message) {
  return Error{ErrorKind::malformed, {}, std::move(message)};
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view() : text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

template <class T>
std::optional<T> number(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) {
    text.remove_prefix(1);
  }
  T value{};
  const auto [end, code] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
  return code == std::errc() && end == text.data() + text.size() && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<std::uint32_t> whole_number(std::string_view text) {
  text = trimmed(text);
  std::uint64_t value = 0;
  for (const char c : text) {
    if (c < '0' || c > '9' || value > 0xFFFFFFFFU) {
      return std::nullopt;
    }
    value = value * 10 + static_cast<std::uint64_t>(c - '0');
  }
  return text.empty() || value >= 0xFFFFFFFFU ? std::nullopt : std::optional(static_cast<std::uint32_t>(value));
}

/// `#rrggbb` or `#rrggbbaa`.
bool read_color(std::string_view text, Vec3f& color, float& alpha) {
  text = trimmed(text);
  if ((text.size() != 7 && text.size() != 9) || text.front() != '#') {
    return false;
  }
  std::array<float, 4> channels{0, 0, 0, 1};
  for (std::size_t i = 0; 2 * i + 1 < text.size(); ++i) {
    unsigned value = 0;
    for (const char c : text.substr(2 * i + 1, 2)) {
      const char lower = static_cast<char>(c | 0x20);
      const bool is_digit = c >= '0' && c <= '9';
      if (!is_digit && !(lower >= 'a' && lower <= 'f')) {
        return false;
      }
      value = value * 16 + static_cast<unsigned>(is_digit ? c - '0' : lower - 'a' + 10);
    }
    channels[i] = static_cast<float>(value) / 255.0F;
  }
  color = {channels[0], channels[1], channels[2]};
  alpha = channels[3];
  return true;
}

class ModelReader {
 public:
  ModelReader(ThreeMfModel& model, NoteBook& notes) : model_(model), notes_(notes) {}

  std::optional<Error> begin(const XmlElement& element);
  void end(std::string_view name);
  void name_space(std::string_view prefix, std::string_view name) { name_spaces_[std::string(prefix)] = name; }

 private:
  using Read = std::optional<Error> (ModelReader::*)(const XmlElement&);

  std::optional<Error> read_model(const XmlElement& element);
  std::optional<Error> read_object(const XmlElement& element);
  std::optional<Error> read_vertex(const XmlElement& element);
  std::optional<Error> read_triangle(const XmlElement& element);
  std::optional<Error> read_component(const XmlElement& element);
  std::optional<Error> read_item(const XmlElement& element);
  std::optional<Error> read_group(const XmlElement& element, ThreeMfGroup::Kind kind);
  std::optional<Error> read_property(const XmlElement& element, const char* attribute, ThreeMfGroup::Kind kind);
  static std::optional<Error> read_use(const XmlElement& element, ThreeMfUse& use);

  static std::optional<Error> read_id(const XmlElement& element, std::string_view name, std::uint32_t& id);
  static std::optional<Error> read_optional_id(const XmlElement& element, std::string_view name, std::uint32_t& id);

  ThreeMfModel& model_;
  NoteBook& notes_;
  std::map<std::string, std::string, std::less<>> name_spaces_;
  bool is_in_model_ = false;
  ThreeMfObject* object_ = nullptr;
  ThreeMfGroup* group_ = nullptr;
};

std::string_view local_name(std::string_view name) {
  return name.substr(name.rfind('|') + 1);
}
bool is_of(std::string_view name_space, std::string_view name) {
  return name.size() > name_space.size() && name[name_space.size()] == '|' && name.starts_with(name_space);
}

std::optional<Error> ModelReader::begin(const XmlElement& element) {
  const std::string_view local = local_name(element.name);
  if (is_of(kCore, element.name)) {
    // clang-format off
    if (local == "vertex")        { return read_vertex(element); }
    if (local == "triangle")      { return read_triangle(element); }
    if (local == "object")        { return read_object(element); }
    if (local == "component")     { return read_component(element); }
    if (local == "item")          { return read_item(element); }
    if (local == "basematerials") { return read_group(element, ThreeMfGroup::Kind::base); }
    if (local == "base")          { return read_property(element, "displaycolor", ThreeMfGroup::Kind::base); }
    if (local == "model")         { return read_model(element); }
    // clang-format on
  } else if (is_of(kMaterial, element.name)) {
    if (local == "colorgroup") {
      return read_group(element, ThreeMfGroup::Kind::color);
    }
    if (local == "color") {
      return read_property(element, "color", ThreeMfGroup::Kind::color);
    }
    if (local == "texture2dgroup" || local == "compositematerials" || local == "multiproperties") {
      notes_.add(element.line, fmt::format("properties of the kind {} are ignored", local));
      return read_group(element, ThreeMfGroup::Kind::other);
    }
  }
  return is_in_model_ ? std::nullopt : malformed(fmt::format("expected the element model of 3MF, found {}", shown(local)));
}

void ModelReader::end(std::string_view name) {
  if (is_of(kCore, name) && local_name(name) == "object") {
    object_ = nullptr;
  } else if (local_name(name) == "basematerials" || local_name(name) == "colorgroup") {
    group_ = nullptr;
  }
}

std::optional<Error> ModelReader::read_id(const XmlElement& element, std::string_view name, std::uint32_t& id) {
  const auto text = element.attribute(name);
  const auto value = text ? whole_number(*text) : std::nullopt;
  if (!value) {
    return malformed(fmt::format("{} needs {}, a whole number, found {}", local_name(element.name), name, text ? shown(*text) : "nothing"));
  }
  id = *value;
  return std::nullopt;
}
std::optional<Error> ModelReader::read_optional_id(const XmlElement& element, std::string_view name, std::uint32_t& id) {
  return element.attribute(name) ? read_id(element, name, id) : std::nullopt;
}

std::optional<Error> ModelReader::read_model(const XmlElement& element) {
  is_in_model_ = true;
  if (const auto unit = element.attribute("unit")) {
    const auto known = std::find_if(kUnits.begin(), kUnits.end(), [&](const Unit& u) { return u.name == *unit; });
    if (known == kUnits.end()) {
      return malformed(fmt::format("unit {} is none of micron, millimeter, centimeter, inch, foot, meter", shown(*unit)));
    }
    model_.millimetres = known->millimetres;
    model_.unit = known->name;
  }
  std::string_view required = element.attribute("requiredextensions").value_or("");
  while (!(required = trimmed(required)).empty()) {
    const std::string_view prefix = required.substr(0, required.find_first_of(" \t\r\n"));
    required.remove_prefix(prefix.size());
    const auto declared = name_spaces_.find(prefix);
    if (declared == name_spaces_.end()) {
      return malformed(fmt::format("the required extension {} is not declared", shown(prefix)));
    }
    if (declared->second != kCore && declared->second != kMaterial && declared->second != kProduction) {
      return Error{ErrorKind::unsupported, {}, fmt::format("requires the extension {}, which is not read", shown(declared->second))};
    }
  }
  return std::nullopt;
}

std::optional<Error> ModelReader::read_object(const XmlElement& element) {
  std::uint32_t id = 0;
  ThreeMfObject object;
  if (auto error = read_id(element, "id", id)) {
    return error;
  }
  if (auto error = read_optional_id(element, "pid", object.group)) {
    return error;
  }
  if (auto error = read_optional_id(element, "pindex", object.property)) {
    return error;
  }
  object.name = element.attribute("name").value_or("");
  const auto [place, is_new] = model_.objects.emplace(id, std::move(object));
  if (!is_new) {
    return malformed(fmt::format("object {} is there twice", id));
  }
  object_ = &place->second;
  return std::nullopt;
}

std::optional<Error> ModelReader::read_vertex(const XmlElement& element) {
  if (object_ == nullptr) {
    return malformed("a vertex outside of an object");
  }
  if (object_->positions.size() == kMostElements) {
    return Error{ErrorKind::limit, {}, fmt::format("more than {} vertices", kMostElements)};
  }
  Vec3f position;
  for (const auto& [name, value] : {std::pair("x", &position.x), std::pair("y", &position.y), std::pair("z", &position.z)}) {
    const auto text = element.attribute(name);
    const auto found = text ? number<float>(*text) : std::nullopt;
    if (!found) {
      return malformed(fmt::format("vertex needs {}, a number, found {}", name, text ? shown(*text) : "nothing"));
    }
    *value = *found;
  }
  object_->positions.push_back(position);
  return std::nullopt;
}

std::optional<Error> ModelReader::read_triangle(const XmlElement& element) {
  if (object_ == nullptr) {
    return malformed("a triangle outside of an object");
  }
  if (object_->triangles.size() == kMostElements) {
    return Error{ErrorKind::limit, {}, fmt::format("more than {} triangles", kMostElements)};
  }
  ThreeMfTriangle triangle;
  constexpr std::array<std::string_view, 3> kCorners{"v1", "v2", "v3"};
  for (std::size_t i = 0; i < 3; ++i) {
    if (auto error = read_id(element, kCorners[i], triangle.corner[i])) {
      return error;
    }
    if (triangle.corner[i] >= object_->positions.size()) {
      return malformed(object_->positions.empty()
                           ? fmt::format("vertex index {}, but the object has no vertices before its triangles", triangle.corner[i])
                           : fmt::format("vertex index {} is outside 0..{}", triangle.corner[i], object_->positions.size() - 1));
    }
  }
  triangle.group = object_->group;
  triangle.property.fill(object_->property);
  if (auto error = read_optional_id(element, "pid", triangle.group)) {
    return error;
  }
  if (element.attribute("p1")) {
    if (auto error = read_id(element, "p1", triangle.property[0])) {
      return error;
    }
    triangle.property[1] = triangle.property[2] = triangle.property[0];
    for (const auto& [name, i] : {std::pair("p2", 1), std::pair("p3", 2)}) {
      if (auto error = read_optional_id(element, name, triangle.property[static_cast<std::size_t>(i)])) {
        return error;
      }
    }
  }
  object_->triangles.push_back(triangle);
  return std::nullopt;
}

std::optional<Error> ModelReader::read_use(const XmlElement& element, ThreeMfUse& use) {
  use.line = element.line;
  if (auto error = read_id(element, "objectid", use.object)) {
    return error;
  }
  use.part = element.attribute(kPath).value_or("");
  if (use.part.starts_with('/')) {
    use.part.erase(0, 1);
  }
  if (const auto text = element.attribute("transform")) {
    std::string_view rest = trimmed(*text);
    for (std::size_t i = 0; i < 12; ++i) {
      const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r\n"));
      const auto value = number<double>(word);
      if (!value) {
        return malformed(fmt::format("transform needs 12 numbers, found {}", shown(*text)));
      }
      // Rows of the text are columns of the matrix: 3MF has row vectors.
      use.matrix(static_cast<int>(i % 3), static_cast<int>(i / 3)) = *value;
      rest = trimmed(rest.substr(word.size()));
    }
    if (!rest.empty()) {
      return malformed(fmt::format("transform needs 12 numbers, found {}", shown(*text)));
    }
  }
  return std::nullopt;
}

std::optional<Error> ModelReader::read_component(const XmlElement& element) {
  if (object_ == nullptr) {
    return malformed("a component outside of an object");
  }
  return read_use(element, object_->components.emplace_back());
}

std::optional<Error> ModelReader::read_item(const XmlElement& element) {
  return read_use(element, model_.build.emplace_back());
}

std::optional<Error> ModelReader::read_group(const XmlElement& element, ThreeMfGroup::Kind kind) {
  std::uint32_t id = 0;
  if (auto error = read_id(element, "id", id)) {
    return error;
  }
  const auto [place, is_new] = model_.groups.emplace(id, ThreeMfGroup{kind, {}, {}, {}});
  if (!is_new) {
    return malformed(fmt::format("the group of properties {} is there twice", id));
  }
  group_ = kind == ThreeMfGroup::Kind::other ? nullptr : &place->second;
  return std::nullopt;
}

std::optional<Error> ModelReader::read_property(const XmlElement& element, const char* attribute, ThreeMfGroup::Kind kind) {
  if (group_ == nullptr || group_->kind != kind) {
    return malformed(fmt::format("{} outside of its group", local_name(element.name)));
  }
  if (group_->colors.size() == kMostMaterials) {
    return Error{ErrorKind::limit, {}, fmt::format("more than {} properties of a group", kMostMaterials)};
  }
  const auto text = element.attribute(attribute);
  Vec3f color;
  float alpha = 1;
  if (!text || !read_color(*text, color, alpha)) {
    return malformed(
        fmt::format("{} needs {}, #rrggbb or #rrggbbaa, found {}", local_name(element.name), attribute, text ? shown(*text) : "nothing"));
  }
  group_->colors.push_back(color);
  group_->alphas.push_back(alpha);
  if (kind == ThreeMfGroup::Kind::base) {
    group_->names.emplace_back(element.attribute("name").value_or(""));
  }
  return std::nullopt;
}

}  // namespace

Result<ThreeMfModel> parse_threemf_model(std::string_view xml, const std::string& part, NoteBook& notes) {
  ThreeMfModel model;
  ModelReader reader(model, notes);
  const Result<void> read =
      read_xml(xml, part,
               {[&](const XmlElement& element) { return reader.begin(element); }, [&](std::string_view name) { reader.end(name); },
                [&](std::string_view prefix, std::string_view name) { reader.name_space(prefix, name); }});
  if (!read) {
    return tl::unexpected(read.error());
  }
  return model;
}

Result<std::string> parse_threemf_relationships(std::string_view xml, const std::string& part) {
  std::string target;
  const Result<void> read =
      read_xml(xml, part,
               {[&](const XmlElement& element) -> std::optional<Error> {
                  if (element.name == kRelationship && target.empty() && element.attribute("Type").value_or("").ends_with("/3dmodel")) {
                    target = element.attribute("Target").value_or("");
                  }
                  return std::nullopt;
                },
                [](std::string_view) {},
                {}});
  if (!read) {
    return tl::unexpected(read.error());
  }
  if (target.starts_with('/')) {
    target.erase(0, 1);
  }
  return target;
}

}  // namespace lustro
