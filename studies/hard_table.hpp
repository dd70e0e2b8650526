// Rows of the table of hard cases.
#pragma once

#include <string>
#include <vector>

#include "studies/run_case.hpp"

namespace sluice::study {

/// The columns of the CSV file, and those of the page for people.
const std::vector<std::string>& hard_columns();
const std::vector<std::string>& hard_page_columns();

/// The cells of a result, as many as hard_columns(). The cell "verdict" is "as expected" or how it differs.
std::vector<std::string> hard_row(const HardCase& hard, const CaseResult& result);
/// The cells of a case that ended without a result, `how`.
std::vector<std::string> hard_row_without(const HardCase& hard, const std::string& backend,
                                          const std::string& how);
/// Whether the row is that of a case that came out as expected.
bool is_as_expected(const std::vector<std::string>& row);

/// A number for the bits of a state.
uint64_t digest(const Snapshot& state);

}  // namespace sluice::study
