// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMetaObject>
#include <QObject>

#include <functional>
#include <memory>
#include <mutex>

namespace gripscope {

/// Rung on any thread, answered on the screen's: soon, and once for all that rang meanwhile. A button may
/// outlive the bell; then it does nothing.
class Doorbell {
public:
    /// `answer` runs on the thread of `owner`, which outlives this.
    Doorbell(QObject* owner, std::function<void()> answer) : m_wire(std::make_shared<Wire>())
    {
        m_wire->owner = owner;
        m_wire->answer = std::move(answer);
    }
    ~Doorbell()
    {
        const std::lock_guard guard(m_wire->mutex);
        m_wire->owner = nullptr;
    }
    Doorbell(const Doorbell&) = delete;
    Doorbell& operator=(const Doorbell&) = delete;

    [[nodiscard]] std::function<void()> button() const
    {
        return [wire = m_wire] { ring(wire); };
    }

private:
    struct Wire {
        std::mutex mutex;
        QObject* owner = nullptr;
        std::function<void()> answer;
        bool rung = false;
    };
    static void ring(const std::shared_ptr<Wire>& wire)
    {
        const std::lock_guard guard(wire->mutex);
        if (wire->owner == nullptr || wire->rung)
            return;
        wire->rung = true;
        QMetaObject::invokeMethod(
            wire->owner,
            [wire] {
                {
                    const std::lock_guard inner(wire->mutex);
                    wire->rung = false;
                    if (wire->owner == nullptr)
                        return;
                }
                wire->answer();
            },
            Qt::QueuedConnection);
    }
    std::shared_ptr<Wire> m_wire;
};

} // namespace gripscope
