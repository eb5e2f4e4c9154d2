// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gripscope {

/// The keys of many squeezes in their order, close together: 40 bytes each, where a QString takes a hundred.
/// A list of them is what lets any page of a history be read at once, however it is ordered.
class HistoryKeys {
public:
    void append(const QString& key)
    {
        m_text += key.toStdString();
        m_ends.push_back(static_cast<std::uint32_t>(m_text.size()));
    }
    [[nodiscard]] std::size_t size() const { return m_ends.size(); }
    [[nodiscard]] bool empty() const { return m_ends.empty(); }
    [[nodiscard]] QString at(std::size_t place) const
    {
        const std::size_t begin = place == 0 ? 0 : m_ends[place - 1];
        return QString::fromUtf8(m_text.data() + begin, static_cast<qsizetype>(m_ends[place] - begin));
    }
    /// Keys `first` to `first + count - 1`, as many of them as there are.
    [[nodiscard]] std::vector<QString> part(std::size_t first, std::size_t count) const
    {
        std::vector<QString> keys;
        for (std::size_t place = first; place < size() && place - first < count; ++place)
            keys.push_back(at(place));
        return keys;
    }
    [[nodiscard]] std::optional<std::size_t> find(const QString& key) const
    {
        const std::string wanted = key.toStdString();
        std::size_t begin = 0;
        for (std::size_t place = 0; place < m_ends.size(); begin = m_ends[place++])
            if (m_ends[place] - begin == wanted.size() && m_text.compare(begin, wanted.size(), wanted) == 0)
                return place;
        return {};
    }

private:
    std::string m_text;
    std::vector<std::uint32_t> m_ends; ///< where each key ends in m_text
};

} // namespace gripscope
