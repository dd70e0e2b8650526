// References that are kept.
#pragma once

namespace sluice {

/// Reference to something that outlives whoever is given it, and so never to a temporary.
template <class T>
class Outliving {
 public:
  Outliving(const T& value) : value_(value) {}
  Outliving(const T&&) = delete;

  operator const T&() const { return value_; }

 private:
  const T& value_;
};

}  // namespace sluice
