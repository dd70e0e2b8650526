// External acceleration: a_n = g - c (x - centre).

void run(uint i) {
  precise vec2 a = params.gravity - params.central_force * (load(x, i) - params.centre);
  a_n[i] = a;
}
