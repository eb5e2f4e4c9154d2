// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/identification_task.h"

#include <QThreadPool>

#include <memory>
#include <utility>

namespace gripscope {

void IdentificationTask::start(Recording recording, IdentificationOptions options)
{
    // A promise rather than std::async: a future of the latter would wait in its destructor.
    auto promise = std::make_shared<std::promise<Identification>>();
    m_future = promise->get_future();
    QThreadPool::globalInstance()->start(
        [promise, recording = std::move(recording), options = std::move(options)] {
            promise->set_value(identify(recording, options));
        });
}

std::optional<Identification> IdentificationTask::take()
{
    if (!isReady(m_future))
        return std::nullopt;
    return m_future.get(); // leaves the future empty
}

} // namespace gripscope
