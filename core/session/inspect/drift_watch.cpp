// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/inspect/inspect_session_private.h"
#include "core/session/inspect/inspected_squeezes.h"
#include "core/session/tasks/pool.h"

#include <utility>
#include <vector>

namespace gripscope {

void DriftWatch::load(const TypeModels& models)
{
    m_models = models;
    m_loading = PendingCall(m_library.run<InspectedSqueezes>([](Library& library) {
        return inspectedSqueezes(library, {newest, true});
    }),
                            [this](Expected<InspectedSqueezes> found) {
                                // A library that cannot be read is told of by whoever has to read it.
                                if (found)
                                    m_squeezes = {found->squeezes.begin(), found->squeezes.end()};
                                m_isNew = true;
                            });
}

void DriftWatch::add(const TypeSqueeze& squeeze)
{
    m_squeezes.push_back(squeeze);
    if (m_squeezes.size() > std::size_t(newest))
        m_squeezes.pop_front();
    m_isNew = true;
}

void DriftWatch::look()
{
    std::vector<TypeSqueeze> squeezes(m_squeezes.begin(), m_squeezes.end());
    m_looking = PendingCall(
        inPool([models = m_models, squeezes = std::move(squeezes)] { return findDrift(models, squeezes); }),
        [this](Expected<DriftReport> found) {
            if (found)
                m_report = std::move(*found);
        });
}

bool DriftWatch::poll()
{
    m_loading.poll();
    const bool answered = m_looking.poll();
    if (!m_loading.waiting() && !m_looking.waiting() && std::exchange(m_isNew, false))
        look();
    return answered;
}

} // namespace gripscope
