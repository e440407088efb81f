// Result<T>: a value, or the diagnostics that say why there is none. The library throws nothing across its rooms.
#pragma once

#include <utility>
#include <variant>
#include <vector>

#include "shabon/base/diagnostic.h"

namespace shabon {

using Diagnostics = std::vector<Diagnostic>;

// One error without a place. Makes `return fail(Failure::file, "...")` possible from any function returning a Result.
inline Diagnostics fail(Failure failure, std::string message) {
  Diagnostic diagnostic;
  diagnostic.failure = failure;
  diagnostic.message = std::move(message);
  return {std::move(diagnostic)};
}

template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
  Result(Diagnostics errors) : content_(std::in_place_index<1>, std::move(errors)) {}

  bool ok() const { return content_.index() == 0; }
  explicit operator bool() const { return ok(); }

  // Only when ok().
  T& value() & { return std::get<0>(content_); }
  const T& value() const& { return std::get<0>(content_); }
  T&& value() && { return std::get<0>(std::move(content_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  // Only when not ok(); never empty then.
  const Diagnostics& errors() const { return std::get<1>(content_); }

 private:
  std::variant<T, Diagnostics> content_;
};

struct Done {};  // the value of a Result whose success carries nothing else
using Status = Result<Done>;

}  // namespace shabon
