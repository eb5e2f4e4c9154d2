// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gripscope {

/// Which stretch of time the Live page shows, in device time: the newest seconds while it runs; any part of
/// what is kept while it is held.
class LiveView {
public:
    /// The time that was chosen; what was zoomed or moved is forgotten.
    void setSpan(double seconds);
    void follow(double newest_s); ///< nothing while held
    /// From now on `oldest_s` to `newest_s` is what there is to see. `least_s`: no zoom goes below.
    void hold(double oldest_s, double newest_s, double least_s);
    void release();

    // While held; nothing otherwise.
    /// `factor` above 1 shows less time; `share` of the width (0 left, 1 right) stays where it is.
    void zoom(double factor, double share);
    void pan(double share);   ///< by that share of the width; above 0: to later times
    void show(double time_s); ///< moved, if need be, until that time is in view
    void reset();             ///< the span that was chosen, up to the newest

    [[nodiscard]] bool held() const { return m_held; }
    [[nodiscard]] bool changed() const; ///< zoomed or moved
    [[nodiscard]] double from_s() const { return m_until_s - m_seconds; }
    [[nodiscard]] double until_s() const { return m_until_s; }
    [[nodiscard]] double seconds() const { return m_seconds; }
    /// What times are told from: now, or the moment since which it is held.
    [[nodiscard]] double reference_s() const { return m_newest_s; }

private:
    [[nodiscard]] double allowed(double seconds) const;
    void place(double until_s, double seconds);
    bool m_held = false;
    double m_span = 10, m_seconds = 10, m_least_s = 0.01;
    double m_oldest_s = 0, m_newest_s = 0, m_until_s = 0;
};

} // namespace gripscope
