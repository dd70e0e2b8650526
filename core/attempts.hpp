// Several things that all have to be tried, though one of them fails.
#pragma once

#include <exception>
#include <utility>

namespace sluice {

class Attempts {
 public:
  /// Does `action`; its failure, if it fails, waits for end().
  template <class Action>
  void operator()(Action&& action) {
    try {
      std::forward<Action>(action)();
    } catch (...) {
      if (!first_) first_ = std::current_exception();
    }
  }

  /// Throws the first failure, if there was one.
  void end() {
    if (first_) std::rethrow_exception(std::exchange(first_, nullptr));
  }

 private:
  std::exception_ptr first_;
};

}  // namespace sluice
