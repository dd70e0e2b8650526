// Numbers and names as people and files see them.
#pragma once

#include <string>
#include <string_view>

#include "sluice/choices.hpp"

namespace sluice {

/// Digits with which a number of this precision reads back as the same number: %.9g or %.17g.
std::string round_trip(double value, Precision precision);

std::string title_of(PressureMethod method);  ///< "SSPH", "WCSPH", "IISPH"

/// Bytes for people: "1.2 GB", "340 kB".
std::string bytes_text(double bytes);

/// Durations for people: "12 s", "3 min 20 s", "2 h 5 min".
std::string duration_text(double seconds);

}  // namespace sluice
