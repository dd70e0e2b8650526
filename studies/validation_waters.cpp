// Cases with walls, and what they share.
#include "studies/validation_waters.hpp"

#include "sluice/load.hpp"
#include "studies/csv_table.hpp"

namespace sluice::study {

std::vector<ValidationCase> water_cases() { return {tank_case(), dam_case(), wave_case()}; }

TimeCurve reference_beside(const std::string& scene, const std::string& file) {
  const CsvTable table = read_csv(std::filesystem::path(load_scene(scene).file).parent_path() / file);
  return {table.column("time"), table.column("value")};
}

}  // namespace sluice::study
