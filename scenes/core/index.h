// Arrays and ints. Faces, vertices, edges, patches and pixels are numbered by int, as OpenSubdiv and pictures
// number them; arrays of the standard library take size_t.
#pragma once

#include <cassert>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

namespace plumbline {

/// Element of an array; `index` must be in range.
template <class Array>
decltype(auto) item(Array&& array, int index) {
    assert(index >= 0 && static_cast<size_t>(index) < std::size(array));
    return std::forward<Array>(array)[static_cast<size_t>(index)];
}

/// Length of an array whose elements are numbered by int.
template <class Array>
int countOf(const Array& array) {
    assert(std::size(array) <= static_cast<size_t>(std::numeric_limits<int>::max()));
    return static_cast<int>(std::size(array));
}

/// A number of elements as the standard library counts them; not negative.
inline size_t lengthOf(int count) {
    assert(count >= 0);
    return static_cast<size_t>(count);
}

/// Elements of a table of so many columns and rows, neither negative.
inline size_t areaOf(int columns, int rows) {
    assert(columns >= 0 && rows >= 0);
    return static_cast<size_t>(columns) * static_cast<size_t>(rows);
}

/// Where an element of a table is that is stored row by row.
inline size_t indexIn(int columns, int column, int row) {
    assert(column >= 0 && column < columns && row >= 0);
    return static_cast<size_t>(row) * static_cast<size_t>(columns) + static_cast<size_t>(column);
}

} // namespace plumbline
