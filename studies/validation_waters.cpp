#include "studies/validation.hpp"

namespace sluice {

std::vector<ValidationCase> water_cases() { return {}; }

}  // namespace sluice
