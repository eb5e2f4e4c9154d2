// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLockFile>
#include <QString>

namespace gripscope {

/// A file beside another one that holds other programs off for the milliseconds that writing that one takes.
/// A program that is killed after it made the lock and before it wrote its name into it leaves an empty one,
/// which QLockFile would respect for half a minute; here for less than anybody is patient. A holder that
/// lives is safe however long it takes: QLockFile removes no file on which the system holds a lock.
class BriefLock {
public:
    explicit BriefLock(const QString& file) : m_lock(file) { m_lock.setStaleLockTime(abandoned_ms); }
    /// Waits for others; false where they do not let go. Held until this goes.
    [[nodiscard]] bool take() { return m_lock.tryLock(patience_ms); }

private:
    static constexpr int abandoned_ms = 500;
    static constexpr int patience_ms = 5000;
    QLockFile m_lock;
};

} // namespace gripscope
