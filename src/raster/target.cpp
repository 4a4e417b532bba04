// Rows by name and by what the CPU says of itself.
#include "raster/target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace lustro {

const Kernels& kernels_scalar();
const Kernels& kernels_sse4();
const Kernels& kernels_avx2();
const Kernels& kernels_avx512();
const Kernels& kernels_neon();
const Kernels& kernels_wasm();

namespace {

constexpr std::array<std::string_view, 7> kNames{"auto", "scalar", "sse4", "avx2", "avx512", "neon", "wasm"};

std::string known_names(std::span<const Target> targets) {
  std::vector<std::string_view> names;
  for (const Target target : targets) {
    names.push_back(target_name(target));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

// A row that this build has, and whether this machine can run it.
struct Row {
  Target target;
  const Kernels& (*kernels)();
  bool (*can_run)();
};

constexpr auto kAlways = [] { return true; };

// The widest first.
constexpr std::array kRows{
#ifdef LUSTRO_HAS_AVX512
    Row{Target::avx512, kernels_avx512,
        [] {
          return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
                 __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("bmi2");
        }},
#endif
#ifdef LUSTRO_HAS_AVX2
    Row{Target::avx2, kernels_avx2,
        [] {
          return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") &&
                 __builtin_cpu_supports("fma");
        }},
#endif
#ifdef LUSTRO_HAS_SSE4
    Row{Target::sse4, kernels_sse4, [] { return __builtin_cpu_supports("sse4.2") != 0; }},
#endif
#ifdef LUSTRO_HAS_NEON
    Row{Target::neon, kernels_neon, kAlways},
#endif
#ifdef LUSTRO_HAS_WASM
    Row{Target::wasm, kernels_wasm, kAlways},
#endif
    Row{Target::scalar, kernels_scalar, kAlways},
};

std::vector<Target> find_targets() {
  std::vector<Target> targets;
  for (const Row& row : kRows) {
    if (row.can_run()) {
      targets.push_back(row.target);
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

const Kernels& kernels_of(Target target) {
  return std::find_if(kRows.begin(), kRows.end(), [target](const Row& row) { return row.target == target; })->kernels();
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
