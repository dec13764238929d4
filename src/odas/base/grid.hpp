// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "odas/base/contract.hpp"

namespace odas {

/// A view of rows x cols values, the columns of a row side by side: [mic][bin], [slot][hop], ...
/// Never owns; never to be kept beyond the call that it was given to.
template <class T>
class GridView {
 public:
  GridView() = default;
  GridView(T* data, std::size_t rows, std::size_t cols, std::size_t stride) noexcept
      : data_(data), rows_(rows), cols_(cols), stride_(stride) {}
  GridView(T* data, std::size_t rows, std::size_t cols) noexcept : GridView(data, rows, cols, cols) {}

  /// A view of mutable values is also a view of constant ones.
  template <class U>
  requires(std::is_same_v<T, const U>) GridView(GridView<U> other)
  noexcept  // NOLINT(google-explicit-constructor): as span<const T> from span<T>
      : data_(other.data()), rows_(other.rows()), cols_(other.cols()), stride_(other.stride()) {}

  [[nodiscard]] std::size_t rows() const noexcept { return rows_; }
  [[nodiscard]] std::size_t cols() const noexcept { return cols_; }
  [[nodiscard]] std::size_t stride() const noexcept { return stride_; }
  [[nodiscard]] T* data() const noexcept { return data_; }
  [[nodiscard]] bool empty() const noexcept { return rows_ == 0 || cols_ == 0; }

  [[nodiscard]] std::span<T> operator[](std::size_t row) const noexcept {
    ODAS_EXPECT(row < rows_);
    return {data_ + row * stride_, cols_};
  }

 private:
  T* data_ = nullptr;
  std::size_t rows_ = 0;
  std::size_t cols_ = 0;
  std::size_t stride_ = 0;
};

/// Owns rows x cols values, zero at first. Converts to GridView.
template <class T>
class Grid {
 public:
  Grid() = default;
  Grid(std::size_t rows, std::size_t cols) : values_(rows * cols), rows_(rows), cols_(cols) {}

  [[nodiscard]] std::size_t rows() const noexcept { return rows_; }
  [[nodiscard]] std::size_t cols() const noexcept { return cols_; }
  [[nodiscard]] bool empty() const noexcept { return values_.empty(); }
  [[nodiscard]] T* data() noexcept { return values_.data(); }
  [[nodiscard]] const T* data() const noexcept { return values_.data(); }

  [[nodiscard]] std::span<T> operator[](std::size_t row) noexcept { return view()[row]; }
  [[nodiscard]] std::span<const T> operator[](std::size_t row) const noexcept { return view()[row]; }

  [[nodiscard]] GridView<T> view() noexcept { return {values_.data(), rows_, cols_}; }
  [[nodiscard]] GridView<const T> view() const noexcept { return {values_.data(), rows_, cols_}; }
  operator GridView<T>() noexcept { return view(); }              // NOLINT(google-explicit-constructor)
  operator GridView<const T>() const noexcept { return view(); }  // NOLINT(google-explicit-constructor)
  operator GridView<const T>() noexcept { return view(); }        // NOLINT(google-explicit-constructor)

  void fill(const T& value) noexcept { std::fill(values_.begin(), values_.end(), value); }

 private:
  std::vector<T> values_;
  std::size_t rows_ = 0;
  std::size_t cols_ = 0;
};

}  // namespace odas
