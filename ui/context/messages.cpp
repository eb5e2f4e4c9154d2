// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/context/messages.h"

#include <algorithm>
#include <utility>

namespace gripscope {

void Messages::report(const QString& message, Condition holds)
{
    const auto same = [&](const Standing& standing) { return standing.message == message; };
    m_standing.erase(std::remove_if(m_standing.begin(), m_standing.end(), same), m_standing.end());
    if (holds)
        m_standing.push_back({message, std::move(holds)});
    emit reported(message);
}

void Messages::poll()
{
    // Taken out first: who is told may report again.
    const auto gone = std::stable_partition(m_standing.begin(), m_standing.end(),
                                            [](const Standing& standing) { return standing.holds(); });
    const std::vector<Standing> over(std::make_move_iterator(gone),
                                     std::make_move_iterator(m_standing.end()));
    m_standing.erase(gone, m_standing.end());
    for (const Standing& standing : over)
        emit withdrawn(standing.message);
}

} // namespace gripscope
