// SPDX-License-Identifier: GPL-3.0-or-later
// A message's column of numbers: its own, or where they stand in the frame that brought them. C++17.
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace blockweir::wire {

/// Reads as a const std::vector does. Who writes into one that is viewed gets a copy of its own first.
template <class T>
class Column {
 public:
  using value_type = T;
  using const_iterator = const T*;
  using iterator = const_iterator;

  Column() = default;
  Column(std::initializer_list<T> values) : own_(values) {}
  Column(std::vector<T> values) : own_(std::move(values)) {}

  /// `size` values from `first` on, which stay where they are as long as `frame` does.
  void view(const T* first, std::size_t size, std::shared_ptr<const void> frame) {
    first_ = first;
    size_ = size;
    frame_ = std::move(frame);
  }

  /// A copy.
  [[nodiscard]] std::vector<T> values() const { return {begin(), end()}; }

  /// Lets go of the frame, and with it of the values in it.
  void release() { frame_.reset(); }

  /// The values, to be written.
  std::vector<T>& own() {
    if (frame_) {
      own_.assign(begin(), end());
      frame_.reset();
    }
    return own_;
  }

  [[nodiscard]] std::size_t size() const { return frame_ ? size_ : own_.size(); }
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] const T* data() const { return frame_ ? first_ : own_.data(); }
  [[nodiscard]] const T* begin() const { return data(); }
  [[nodiscard]] const T* end() const { return data() + size(); }
  const T& operator[](std::size_t i) const { return data()[i]; }

  void push_back(const T& value) { own().push_back(value); }
  void assign(std::size_t size, const T& value) {
    release();
    own_.assign(size, value);
  }
  void clear() {
    release();
    own_.clear();
  }

  friend bool operator==(const Column& a, const Column& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }
  friend bool operator!=(const Column& a, const Column& b) { return !(a == b); }

  template <class Archive>
  void save(Archive& archive) const {
    archive(values());
  }
  template <class Archive>
  void load(Archive& archive) {
    release();
    archive(own_);
  }

 private:
  std::vector<T> own_;  ///< while no frame is viewed
  const T* first_ = nullptr;
  std::size_t size_ = 0;
  std::shared_ptr<const void> frame_;
};

}  // namespace blockweir::wire
