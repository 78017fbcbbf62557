// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A list of a few things, without allocation.

#include <array>
#include <cassert>
#include <cstddef>

namespace vcavity {

/// @tparam T default constructible
/// @tparam capacity the largest number of them
template <class T, std::size_t capacity>
class ShortList {
 public:
  /// @param next one more; there must be room for it
  void push_back(const T& next) {
    assert(size_ < capacity);
    items_[size_++] = next;
  }
  std::size_t size() const { return size_; }
  const T& operator[](std::size_t i) const& { return items_[i]; }
  T operator[](std::size_t i) && { return items_[i]; }
  const T* begin() const { return items_.data(); }
  const T* end() const { return items_.data() + size_; }

 private:
  std::array<T, capacity> items_;
  std::size_t size_ = 0;
};

}  // namespace vcavity
