// What holds of every scene file, however broken. Without gtest: the fuzz target uses it too.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "sluice/scene.hpp"

namespace sluice::test {

/// What became of a file. `broken` says which claim does not hold of it; empty when all do.
struct Judgement {
  bool loaded = false;   ///< else refused
  bool sampled = false;  ///< loaded, small enough, and no samples were refused
  double seconds = 0;    ///< of this thread's processor
  std::string broken;
};

/// Loads `text` as the file "mutant.toml", and samples it when that takes at most `memory` bytes. Claims: it
/// is loaded or refused with an InputError of one line that begins with the file's name, or with "--set" when
/// there are overrides; every number of a loaded scene and every sample is finite; nothing takes longer than
/// `seconds`.
Judgement judge_scene(std::string_view text, std::span<const std::string> overrides, double memory,
                      double seconds);

/// Whether a message is one line that begins so.
bool is_refusal_of(std::string_view message, std::string_view beginning);

/// The path in Scene or its settings of a number that is not finite; empty when there is none.
std::string not_finite(const Scene& scene);

/// Seconds of processor time that this thread has taken.
double thread_seconds();

/// What a file may take: enough to tell a hang from a busy machine, and for the sanitizers.
#ifdef SLUICE_SANITIZED
inline constexpr double most_seconds = 5;
#else
inline constexpr double most_seconds = 1;
#endif

}  // namespace sluice::test
