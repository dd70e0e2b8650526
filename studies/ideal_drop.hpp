// The exact motion of an elliptic drop of an ideal incompressible fluid without surface tension.
#pragma once

namespace sluice::study {

/// The drop is a disc at t = 0, moves with the velocity s (x, -y), and is drawn to its centre by -Omega² x.
/// It stays an ellipse x²/A² + y²/B² = 1 of the same area [Monaghan & Rafiee 2013]:
///   ds/dt = (s² + Omega²) (B² - A²) / (B² + A²),  dA/dt = s A,  dB/dt = -s B
/// With Omega = 0 this is the drop of [Monaghan 1994].
struct IdealDrop {
  double radius = 1;
  double rate = 0;  ///< s at t = 0
  double omega_squared = 0;

  struct State {
    double rate = 0;      ///< s
    double a = 0, b = 0;  ///< semi-axes along x and y
  };
  /// At a time from 0 on. The error is below 1e-9 where |s| and Omega times t are 10 or less.
  State at(double time) const;

  /// The first time from which all repeats. Only with Omega and s other than 0.
  double period() const;
};

}  // namespace sluice::study
