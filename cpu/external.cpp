// External acceleration: a_n = g - c (x - centre). c is 0 in all scenes but those of a drop held together by
// a central force [Monaghan and Rafiee 2013].
#include "cpu/stages.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void external(State<Real>& state) {
  const ParamsOf<Real>& params = state.params;
  for_each_index(params.n, state.threads, [&](size_t i) {
    state.a_n[i] = params.gravity - params.central_force * (state.x[i] - params.centre);
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(external)
