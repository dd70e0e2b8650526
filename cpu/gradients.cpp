// The kernel gradient of every entry of the neighbour list [Hunkler 2022, eq. 5.2]: every later sum over
// neighbours takes it from here, a pressure sweep twice.
#include "cpu/kernel.hpp"
#include "cpu/stages.hpp"
#include "cpu/sums.hpp"

namespace sluice::cpu::SLUICE_SET {

template <class Real>
void gradients(State<Real>& state) {
  const ParamsOf<Real> params = state.params;
  for_each_group(state, [&](const auto& i) {
    const Pair<Vector<Real>> x_i = i(state.x);
    walk(state, i, [&](uint64_t block, const Particles<Real>& j, auto) {
      const auto x_ij = x_i - by_lane::gather(state.x.data(), j.at);  // a gather would wait for the stores
      const auto slope = kernel_slope(params, square_root(dot(x_ij, x_ij)));
      store(slope * x_ij.x, &state.gradient[block]);
      store(slope * x_ij.y, &state.gradient[block + slice_width]);
    });
  });
}

}  // namespace sluice::cpu::SLUICE_SET

SLUICE_INSTANTIATE_STAGE(gradients)
