// The sweeps of a backend that is asked after each of them.
#include "core/solver/backend.hpp"

#include <array>

namespace sluice {

void Backend::sweep(const std::vector<Stage>& stages, uint32_t times) {
  for (uint32_t k = 0; k < times; ++k) {
    std::array<uint32_t, 2> sweeps{};
    download(Field::sweeps, sweeps);
    if (static_cast<Solve>(sweeps[1]) != Solve::unfinished) return;
    run_sweep(stages);
  }
}

void Backend::run_sweep(const std::vector<Stage>& stages) {
  for (const Stage stage : stages) run(stage);
}

}  // namespace sluice
