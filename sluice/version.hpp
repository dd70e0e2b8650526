// Which Sluice this is.
#pragma once

#include <string>

namespace sluice {

/// Version, as numbers with points: what works with 0.2.1 works with every later 0.2, and from 1.0 on with
/// every version of the same first number.
std::string version();

/// The commit that this program was built from, "1a2b3c4" or "1a2b3c4-modified"; empty when it is not known.
std::string commit();

}  // namespace sluice
