// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/context/background.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace gripscope {

Background::~Background()
{
    m_pool.clear();
    m_pool.waitForDone();
}

void Background::poll()
{
    // Taken out first: an answer may ask again.
    const auto come = std::stable_partition(m_awaited.begin(), m_awaited.end(), [](const Awaited& awaited) {
        return awaited.wanted() && !awaited.call.ready();
    });
    std::vector<Awaited> answered(std::make_move_iterator(come), std::make_move_iterator(m_awaited.end()));
    m_awaited.erase(come, m_awaited.end());
    for (Awaited& awaited : answered)
        if (awaited.wanted())
            awaited.call.poll();
}

} // namespace gripscope
