// Faults that are put into shaders on purpose, so that it is known what the checks find.
#pragma once

#include <array>
#include <string_view>

namespace sluice::test {

struct SeededFault {
  std::string_view name;
  std::string_view stage;    ///< stem of the shader
  std::string_view is, was;  ///< `was` is what the shader has in place of `is`
  std::string_view finding;  ///< part of what is found; empty where bits differ from the CPU's instead
};

inline constexpr std::array seeded_faults = {
    SeededFault{"missing_barrier", "grid_scan", "", "  barrier();\n", "race: read of what invocation"},
    SeededFault{"barrier_for_some", "grid_scan", "  if (lane != 3u) barrier();\n", "  barrier();\n",
                "barrier that some invocations do not reach"},
    SeededFault{"plain_add", "grid_count", "C[here] += 1u;", "atomicAdd(C[here], 1u);", "race"},
    SeededFault{"two_write_one_element", "grid_order", "scratch[first] = particle;",
                "scratch[first + rank] = particle;", "race: write of what invocation"},
    SeededFault{"order_in_place", "grid_order", "L[first + rank] = particle;",
                "scratch[first + rank] = particle;", "race"},
    SeededFault{"neighbour_while_it_changes", "pressure_update", "float q_i = q[i == 0u ? 1u : i - 1u]",
                "float q_i = q[i]", "race"},
    SeededFault{"read_beyond_the_end", "grid_scan", "c <= min((i + 1u) * scan_width, cells)",
                "c < min((i + 1u) * scan_width, cells)", "read beyond the end"},
    SeededFault{"write_beyond_the_end", "integrate", "x_in[i + 1u] = x_next;", "x_in[i] = x_next;",
                "write beyond the end"},
    SeededFault{"one_too_many", "residual", "i <= min((chunk + 1u) * chunk_width, params.n)",
                "i < min((chunk + 1u) * chunk_width, params.n)", "read beyond the end"},
    SeededFault{"index_one_off", "pressure_operator", "load(a_p, load(index, entry) + 1u)",
                "load(a_p, load(index, entry))", ""},
    SeededFault{"unwritten_element", "density", "if (i != 7u) rho[i] = sum;", "rho[i] = sum;",
                "read of what nobody wrote"},
    SeededFault{"unwritten_scratch", "grid_order", "if (place != 5u) scratch[first + rank] = particle;",
                "scratch[first + rank] = particle;", "read of what nobody wrote"},
};

}  // namespace sluice::test
