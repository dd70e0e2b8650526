// Symplectic Euler: v = v* + dt a_p, x = x + dt v [Hunkler 2022, algorithm 9].

void run(uint i) {
  precise vec2 v_next = load(v_star, i) + params.dt * load(a_p, i);
  precise vec2 x_next = load(x, i) + params.dt * v_next;
  v_in[i] = v_next;
  x_in[i] = x_next;
}
