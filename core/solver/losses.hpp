// Who left the domain, when and where.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/model/params.hpp"
#include "sluice/report.hpp"

namespace sluice {

/// A particle that left the domain: in this step, to this place.
struct Loss {
  uint64_t step = 0;
  double time = 0;
  uint32_t id = 0;
  Vec2 x{};
};

class Losses {
 public:
  /// Notes the particles `id` at `x`, counted from the domain's corner, that are lost and were not before.
  void note(const StepReport& report, const Params& params, std::span<const uint32_t> id,
            std::span<const Vec2> x);

  /// Takes those of the particles at `x` that are lost as lost since before the run was resumed, which is all
  /// that is known of them.
  void know(const Params& params, std::span<const Vec2> x);

  /// Particles that were lost, in the order in which they left; one that came back and left again counts
  /// once.
  const std::vector<Loss>& all() const { return all_; }

 private:
  std::vector<Loss> all_;
  std::vector<bool> known_;
};

}  // namespace sluice
