// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/feed/live_view.h"

#include <algorithm>

namespace gripscope {

void LiveView::setSpan(double seconds)
{
    m_span = seconds;
    reset();
}

void LiveView::follow(double newest_s)
{
    if (m_held)
        return;
    m_newest_s = newest_s;
    reset();
}

void LiveView::hold(double oldest_s, double newest_s, double least_s)
{
    m_held = true;
    m_oldest_s = oldest_s;
    m_newest_s = newest_s;
    m_least_s = least_s;
    reset();
}

void LiveView::release()
{
    m_held = false;
    reset();
}

double LiveView::allowed(double seconds) const
{
    const double longest_s = std::max(m_span, m_newest_s - m_oldest_s);
    return std::clamp(seconds, std::min(m_least_s, longest_s), longest_s);
}

void LiveView::place(double until_s, double seconds)
{
    m_seconds = allowed(seconds);
    // Where the time chosen reaches back to before there was anything, it may still be shown whole.
    const double earliest_s = std::min(m_oldest_s, m_newest_s - m_span) + m_seconds;
    m_until_s = std::clamp(until_s, std::min(earliest_s, m_newest_s), m_newest_s);
}

void LiveView::zoom(double factor, double share)
{
    if (!m_held || !(factor > 0))
        return;
    const double fixed_s = from_s() + share * m_seconds;
    const double seconds = allowed(m_seconds / factor);
    place(fixed_s + (1 - share) * seconds, seconds);
}

void LiveView::pan(double share)
{
    if (m_held)
        place(m_until_s + share * m_seconds, m_seconds);
}

void LiveView::show(double time_s)
{
    if (m_held && (time_s < from_s() || time_s > m_until_s))
        place(time_s + m_seconds / 2, m_seconds);
}

void LiveView::reset()
{
    m_seconds = m_span;
    m_until_s = m_newest_s;
}

bool LiveView::changed() const
{
    return m_seconds != m_span || m_until_s != m_newest_s;
}

} // namespace gripscope
