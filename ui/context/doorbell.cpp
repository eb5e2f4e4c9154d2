// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/context/doorbell.h"

#include <QMetaObject>
#include <QObject>

#include <mutex>
#include <utility>

namespace gripscope {

struct Doorbell::Wire {
    std::mutex mutex;
    QObject* owner = nullptr;
    std::function<void()> answer;
    bool rung = false;

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
};

Doorbell::Doorbell(QObject* owner, std::function<void()> answer) : m_wire(std::make_shared<Wire>())
{
    m_wire->owner = owner;
    m_wire->answer = std::move(answer);
}

Doorbell::~Doorbell()
{
    const std::lock_guard guard(m_wire->mutex);
    m_wire->owner = nullptr;
}

std::function<void()> Doorbell::button() const
{
    return [wire = m_wire] { Wire::ring(wire); };
}

} // namespace gripscope
