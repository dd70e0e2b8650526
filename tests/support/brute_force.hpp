// One step written straight from the equations of docs/model.md: all pairs, plain double, no grid, no list
// layout, no sharing of code with the solver beyond the scene. What the backends compute is checked against
// this.
#pragma once

#include <map>
#include <vector>

#include "core/model/fields.hpp"
#include "sluice/sampling.hpp"
#include "sluice/scene.hpp"

namespace sluice::test {

struct BruteForce {
  std::vector<Vec2> x, v;  ///< state, advanced by step()
  /// What the last step computed, by the field of the backend that it is compared with.
  std::map<Field, std::vector<double>> reals;
  std::map<Field, std::vector<Vec2>> vectors;
  std::vector<double>& p = reals[Field::p];  ///< the warm start of the next step too
  std::vector<double>&rho = reals[Field::rho], &s = reals[Field::s];
  std::vector<Vec2>&a_n = vectors[Field::a_n], &v_star = vectors[Field::v_star], &a_p = vectors[Field::a_p];
  std::vector<double> A_ii;           ///< with respect to p, and the backend's to p/rho^2
  std::vector<double> boundary_mass;  ///< m with a mirror boundary, else the pseudo-masses
  uint32_t iterations = 0;
  double residual = 0;
  bool converged = true;
  int dropped = 0, gone_back = 0;  ///< first guesses, and solves that went back to their best

  BruteForce(const Scene& scene, const Samples& samples);
  BruteForce(const BruteForce&) = delete;
  BruteForce& operator=(const BruteForce&) = delete;
  void step();

 private:
  struct Neighbour {
    uint32_t j;
    Vec2 x_ij, dW;
    double W;
  };
  double W(double r) const;
  Vec2 dW(Vec2 x_ij) const;
  Vec2 parting(bool ahead) const;
  void compute_boundary_mass();
  void find_neighbours();
  void compute_density();
  void compute_non_pressure();
  void add_viscosity();
  void add_xsph();
  void compute_pressure();
  void compute_pressure_acceleration();
  double divergence(const std::vector<Vec2>& u, uint32_t i) const;
  void set_up_system();
  struct Error {
    double e, squares, source_squares;
  };
  Error error_of(const std::vector<double>& Ap) const;
  double step_of(uint32_t k, const std::vector<double>& Ap) const;
  void solve();

  const Scene& scene_;
  const std::vector<Vec2>& boundary_;
  double h_, H_, m_, rho0_, dt_;
  bool mirror_, symmetric_;
  std::vector<double> p_before_, Ap_before_;
  std::vector<std::vector<Neighbour>> fluid_neighbours_, boundary_neighbours_;
};

}  // namespace sluice::test
