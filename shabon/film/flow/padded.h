// Numbers at the grid's cells, edges or triangles, with room before the first and after the last: a sweep with constant
// offsets (sweeps.h) may read, never use, what lies a row of cells beyond the ends.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

// Before a loop whose steps do not depend on each other, although the compiler cannot know.
#if defined(__GNUC__) && !defined(__clang__)
#define SHABON_INDEPENDENT _Pragma("GCC ivdep")
#else
#define SHABON_INDEPENDENT
#endif

namespace shabon::film {

template <class T>
class Padded {
 public:
  Padded() = default;
  Padded(std::size_t size, std::size_t pad, T value = T(0)) : content_(size + 2 * pad, value), pad_(pad), size_(size) {}

  T* data() { return content_.data() + pad_; }
  const T* data() const { return content_.data() + pad_; }
  std::size_t size() const { return size_; }
  T& operator[](std::size_t i) { return content_[pad_ + i]; }
  const T& operator[](std::size_t i) const { return content_[pad_ + i]; }
  std::span<const T> values() const { return {data(), size_}; }
  void fill(T value) { std::fill(content_.begin(), content_.end(), value); }

 private:
  std::vector<T> content_;
  std::size_t pad_ = 0, size_ = 0;
};

using Numbers = Padded<double>;

}  // namespace shabon::film
