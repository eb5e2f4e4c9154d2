// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/context/stepped_work.h"

#include "ui/context/background.h"
#include "ui/context/messages.h"
#include "ui/context/workbench.h"

#include <utility>

namespace gripscope {

SteppedWork::SteppedWork(Workbench& workbench, Step step, QObject* parent)
    : QObject(parent), m_workbench(&workbench), m_step(std::move(step))
{
}

void SteppedWork::start()
{
    next();
}

void SteppedWork::cancel()
{
    m_cancelled = true;
}

void SteppedWork::next()
{
    m_workbench->background().ask<Progress>(this, m_step, [this](Expected<Progress> progress) {
        if (!progress) {
            m_workbench->messages().report(progress.error().describe());
            end(false);
            return;
        }
        emit progressed(qsizetype(progress->done), qsizetype(progress->total));
        if (!progress->more)
            end(true);
        else if (m_cancelled)
            end(false);
        else
            next();
    });
}

void SteppedWork::end(bool complete)
{
    m_step = nullptr;
    emit ended(complete);
    deleteLater();
}

} // namespace gripscope
