// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <initializer_list>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

namespace gripscope {

/// Plain values that only become more. A copy shares those that are there and takes as long as a pointer.
/// Who appends to a copy leaves the others as they are: what is new stands behind what they see. Copied are
/// the values only where their room is full, which then doubles, or where another copy has grown first.
/// Copies may be read, and one of them appended to, in several threads.
template <typename T>
class SharedColumn {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    SharedColumn() = default;
    SharedColumn(std::initializer_list<T> values) { append({values.begin(), values.size()}); }
    explicit SharedColumn(const std::vector<T>& values) { append(values); }

    [[nodiscard]] std::size_t size() const { return m_size; }
    [[nodiscard]] bool empty() const { return m_size == 0; }
    [[nodiscard]] const T* data() const { return m_room ? m_room->values.get() : nullptr; }
    [[nodiscard]] const T* begin() const { return data(); }
    [[nodiscard]] const T* end() const { return data() + m_size; }
    [[nodiscard]] const T& operator[](std::size_t place) const { return data()[place]; }
    [[nodiscard]] const T& front() const { return data()[0]; }
    [[nodiscard]] const T& back() const { return data()[m_size - 1]; }
    [[nodiscard]] std::vector<T> toVector() const { return {begin(), end()}; }
    [[nodiscard]] bool sharesWith(const SharedColumn& other) const { return data() == other.data(); }

    void push_back(T value) { append({&value, 1}); }
    void append(std::span<const T> values)
    {
        if (values.empty())
            return;
        if (!claim(values.size()))
            move(std::max(2 * m_size, m_size + values.size()), values.size());
        std::copy(values.begin(), values.end(), m_room->values.get() + m_size);
        m_size += values.size();
    }

private:
    struct Room {
        std::unique_ptr<T[]> values;
        std::size_t capacity = 0;
        std::atomic<std::size_t> used = 0; ///< by the longest of the copies
    };
    /// The places behind the own ones, where they are there and nobody else's.
    bool claim(std::size_t count)
    {
        std::size_t own = m_size;
        return m_room && m_room->capacity - m_size >= count &&
               m_room->used.compare_exchange_strong(own, m_size + count);
    }
    void move(std::size_t capacity, std::size_t count)
    {
        auto room = std::make_shared<Room>();
        room->values.reset(new T[capacity]);
        room->capacity = capacity;
        room->used = m_size + count;
        std::copy(begin(), end(), room->values.get());
        m_room = std::move(room);
    }

    std::shared_ptr<Room> m_room;
    std::size_t m_size = 0; ///< own values, the first of the room
};

} // namespace gripscope
