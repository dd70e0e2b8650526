// A look at every particle, when their number has changed.
#include "core/solver/losses.hpp"

#include <algorithm>

namespace sluice {

void Losses::know(const Params& params, std::span<const Vec2> x) {
  known_.resize(x.size());
  for (size_t i = 0; i < x.size(); ++i) known_[i] = is_lost(params, x[i]);
}

void Losses::note(const StepReport& report, const Params& params, std::span<const uint32_t> id,
                  std::span<const Vec2> x) {
  known_.resize(id.size());
  const size_t before = all_.size();
  for (size_t i = 0; i < id.size(); ++i) {
    if (known_[id[i]] || !is_lost(params, x[i])) continue;
    known_[id[i]] = true;
    all_.push_back({report.step, report.time, id[i], params.origin + x[i]});
  }
  std::sort(all_.begin() + static_cast<std::ptrdiff_t>(before), all_.end(),
            [](const Loss& a, const Loss& b) { return a.id < b.id; });
}

}  // namespace sluice
