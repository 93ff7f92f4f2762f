// Indexing arrays with int. Faces, vertices, edges, patches and pixels are numbered by int, as in OpenSubdiv
// and in images, whereas the standard library's arrays take size_t.
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

/// A non-negative element count as size_t.
inline size_t lengthOf(int count) {
    assert(count >= 0);
    return static_cast<size_t>(count);
}

/// Number of elements of a table with `columns` × `rows` elements, both non-negative.
inline size_t areaOf(int columns, int rows) {
    assert(columns >= 0 && rows >= 0);
    return static_cast<size_t>(columns) * static_cast<size_t>(rows);
}

/// Index of an element of a table stored row by row.
inline size_t indexIn(int columns, int column, int row) {
    assert(column >= 0 && column < columns && row >= 0);
    return static_cast<size_t>(row) * static_cast<size_t>(columns) + static_cast<size_t>(column);
}

} // namespace plumbline
