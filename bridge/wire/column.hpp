// SPDX-License-Identifier: GPL-3.0-or-later
// A message's column of numbers: its own, or where they stand in the frame that brought them. Copies share the numbers,
// and so does a line that sends them from where they stand. C++17.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace blockweir::wire {

/// Reads as a const std::vector does. Who writes into one that is viewed or shared gets a copy of its own first.
template <class T>
class Column {
 public:
  using value_type = T;
  using const_iterator = const T*;
  using iterator = const_iterator;

  Column() = default;
  Column(std::initializer_list<T> values) : Column(std::vector<T>(values)) {}
  Column(std::vector<T> values) : own_(std::make_shared<std::vector<T>>(std::move(values))) {}

  /// `size` values from `first` on, which stay where they are as long as `frame` does.
  void view(const T* first, std::size_t size, std::shared_ptr<const void> frame) {
    own_.reset();
    first_ = first;
    size_ = size;
    frame_ = std::move(frame);
  }

  /// A copy.
  [[nodiscard]] std::vector<T> values() const { return {begin(), end()}; }

  /// Lets go of the frame, and with it of the values in it: empty where it was viewed.
  void release() { frame_.reset(); }

  /// What keeps the values where they are, unchanged, for as long as somebody has it.
  [[nodiscard]] std::shared_ptr<const void> keeper() const { return frame_ ? frame_ : own_; }

  /// The values, to be written.
  std::vector<T>& own() {
    if (frame_) {
      own_ = std::make_shared<std::vector<T>>(begin(), end());
      frame_.reset();
    } else if (!own_) {
      own_ = std::make_shared<std::vector<T>>();
    } else if (own_.use_count() > 1) {
      own_ = std::make_shared<std::vector<T>>(*own_);
    } else {
      std::atomic_thread_fence(std::memory_order_acquire);  // who else had them has read them
    }
    return *own_;
  }

  [[nodiscard]] std::size_t size() const { return frame_ ? size_ : own_ ? own_->size() : 0; }
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] const T* data() const { return frame_ ? first_ : own_ ? own_->data() : nullptr; }
  [[nodiscard]] const T* begin() const { return data(); }
  [[nodiscard]] const T* end() const { return data() + size(); }
  const T& operator[](std::size_t i) const { return data()[i]; }

  void push_back(const T& value) { own().push_back(value); }
  void assign(std::size_t size, const T& value) {
    discard();
    own().assign(size, value);
  }
  void clear() {
    discard();
    if (own_) own().clear();
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
    discard();
    archive(own());
  }

 private:
  /// Nobody's values are to be copied that are about to be replaced.
  void discard() {
    frame_.reset();
    if (own_.use_count() > 1) own_.reset();
  }

  std::shared_ptr<std::vector<T>> own_;  ///< while no frame is viewed
  const T* first_ = nullptr;
  std::size_t size_ = 0;
  std::shared_ptr<const void> frame_;
};

}  // namespace blockweir::wire
