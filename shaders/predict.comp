// Velocity without pressure: v* = v + dt a_n [Hunkler 2022, algorithm 9].

void run(uint i) {
  precise vec2 v_without_pressure = load(v, i) + params.dt * load(a_n, i);
  v_star[i] = v_without_pressure;
}
