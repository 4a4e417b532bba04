// The enums of the scene file as words and back: one table an enum, with a line of help for each word. JSON values, flags, completions and the
// schema all come from these tables.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "lustro/material.hpp"
#include "lustro/options.hpp"
#include "lustro/result.hpp"

namespace lustro {

/// One word, the value of its enum, and what it means.
struct Word {
  std::uint8_t value = 0;
  std::string_view word;
  std::string_view help;
};

/// The words of E in the order of its values: Lighting, Interpolation, NormalInterpolation, VertexNormals, Culling, Transfer, ToneOperator,
/// Projection, ViewPreset, LightType, SpotFade, GltfShading, FogMode, Wrap, TextureFilter, MipFilter, TextureChannel, ReflectionShape,
/// AlphaMode.
template <class E>
[[nodiscard]] std::span<const Word> words_of();

/// The names of the terms of the lighting sum; `value` counts them in the order of TermSet's members.
[[nodiscard]] std::span<const Word> term_words();

/// The members of TermSet in the order of term_words().
inline constexpr bool TermSet::*kTermMembers[] = {&TermSet::ambient, &TermSet::diffuse, &TermSet::specular, &TermSet::emission};

/// The entry of that word, or nullptr.
[[nodiscard]] const Word* find_word(std::span<const Word> table, std::string_view text);

/// `unknown word "blin-phong", did you mean "blinn-phong"? (known: constant, lambert, phong, blinn-phong, ggx)`
[[nodiscard]] std::string unknown_word_message(std::span<const Word> table, std::string_view text);

/// `constant, lambert, phong, blinn-phong, ggx`
[[nodiscard]] std::string word_list(std::span<const Word> table);

template <class E>
[[nodiscard]] std::string_view word_of(E value) {
  for (const Word& entry : words_of<E>()) {
    if (entry.value == static_cast<std::uint8_t>(value)) {
      return entry.word;
    }
  }
  return {};
}

/// errors  usage for an unknown word, with the known ones and the nearest
template <class E>
[[nodiscard]] Result<E> parse_word(std::string_view text) {
  const Word* entry = find_word(words_of<E>(), text);
  if (entry == nullptr) {
    return fail(ErrorKind::usage, "", unknown_word_message(words_of<E>(), text));
  }
  return static_cast<E>(entry->value);
}

}  // namespace lustro
