// Columns of the sweeps.
#include <fmt/format.h>

#include "core/output/step_file.hpp"

namespace sluice {

StepFile sweeps_file(const std::filesystem::path& path) {
  return {path, "step,sweep,mean_compression,residual,step_length", [](const StepReport& report) {
            std::string rows;
            for (size_t k = 0; k < report.sweeps.size(); ++k) {
              const SweepReport& sweep = report.sweeps[k];
              rows += fmt::format("{},{},{:.9g},{:.9g},{:.9g}\n", report.step, k + 1, sweep.mean_compression,
                                  sweep.residual, sweep.step_length);
            }
            return rows;
          }};
}

}  // namespace sluice
