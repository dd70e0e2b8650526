// What a source says, what came out here, and whether the two agree.
#pragma once

#include <string>

#include "studies/table.hpp"

namespace sluice::study {

/// A row per claim.
class Verdicts {
 public:
  /// `why` is for people; it may be empty where there is nothing to explain.
  void add(const std::string& claim, const std::string& theirs, const std::string& ours, bool holds,
           const std::string& why = "") {
    table_.rows.push_back({claim, theirs, ours, holds ? "holds" : "does not hold", why});
  }

  const TextTable& table() const { return table_; }

 private:
  TextTable table_{{"claim", "theirs", "ours", "verdict", "why"}, {}};
};

}  // namespace sluice::study
