// A value of a type that is not complete yet, such as that of a struct which holds its own kind. Copies are deep; a
// moved-from one may only be assigned to or destroyed.
#pragma once

#include <memory>
#include <utility>

namespace shabon {

template <class T>
class Indirect {
 public:
  using value_type = T;

  Indirect() : value_(std::make_unique<T>()) {}
  Indirect(T value) : value_(std::make_unique<T>(std::move(value))) {}
  Indirect(const Indirect& other) : value_(std::make_unique<T>(*other)) {}
  Indirect(Indirect&&) noexcept = default;
  Indirect& operator=(Indirect other) noexcept {
    value_ = std::move(other.value_);
    return *this;
  }
  ~Indirect() = default;

  T& operator*() { return *value_; }
  const T& operator*() const { return *value_; }
  T* operator->() { return value_.get(); }
  const T* operator->() const { return value_.get(); }

 private:
  std::unique_ptr<T> value_;
};

}  // namespace shabon
