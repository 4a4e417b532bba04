// Rows by name and by what the CPU says of itself.
#include "raster/target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace lustro {
namespace {

constexpr std::array<std::string_view, 7> kNames{"auto", "scalar", "sse4", "avx2", "avx512", "neon", "wasm"};

std::string known_names(std::span<const Target> targets) {
  std::vector<std::string_view> names;
  for (const Target target : targets) {
    names.push_back(target_name(target));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

bool machine_has(Target target) {
#if defined(__x86_64__)
  switch (target) {
    case Target::sse4:
      return __builtin_cpu_supports("sse4.2") != 0;
    case Target::avx2:
      return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("bmi2") != 0;
    case Target::avx512:
      return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
             __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("avx512cd") != 0 && __builtin_cpu_supports("bmi2") != 0;
    default:
      return target == Target::scalar;
  }
#elif defined(__aarch64__)
  return target == Target::neon || target == Target::scalar;
#elif defined(__wasm_simd128__)
  return target == Target::wasm || target == Target::scalar;
#else
  return target == Target::scalar;
#endif
}

std::vector<Target> find_targets() {
  std::vector<Target> targets;
  for (const Target target : {Target::avx512, Target::avx2, Target::sse4, Target::neon, Target::wasm, Target::scalar}) {
    if (machine_has(target)) {
      targets.push_back(target);
    }
  }
  return targets;
}

}  // namespace

std::span<const Target> available_targets() {
  static const std::vector<Target> targets = find_targets();
  return targets;
}

std::string_view target_name(Target target) {
  return kNames[static_cast<std::size_t>(target)];
}

Result<Target> choose_target(Target wanted) {
  const std::span<const Target> available = available_targets();
  if (wanted == Target::automatic) {
    return available.front();
  }
  if (std::find(available.begin(), available.end(), wanted) == available.end()) {
    return fail(ErrorKind::unsupported, "",
                fmt::format("this machine cannot run the target {}; it can run {}", target_name(wanted), known_names(available)));
  }
  return wanted;
}

Result<Target> parse_target(std::string_view name) {
  const auto* const found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) {
    return fail(ErrorKind::usage, "", fmt::format("\"{}\" is no target; known are {}", name, fmt::join(kNames, ", ")));
  }
  const auto target = static_cast<Target>(found - kNames.begin());
  if (target == Target::automatic) {
    return target;
  }
  return choose_target(target);
}

}  // namespace lustro
