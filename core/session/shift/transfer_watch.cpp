// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/shift/transfer_watch.h"

#include "core/session/inspect/inspected_squeezes.h"
#include "core/session/tasks/pool.h"

#include <algorithm>
#include <utility>

namespace gripscope {

void TransferWatch::forget()
{
    m_study.clear();
    m_planned.clear();
    m_wanted.clear();
    m_known.clear();
    m_models.reset();
    m_look.reset();
    m_error.reset();
    m_loading = m_reading = m_identifying = m_looking = PendingCall();
    m_changed = false;
}

void TransferWatch::follow(const KeptStudy& study)
{
    if (m_study != study.record.id) {
        forget();
        m_study = study.record.id;
        m_planned = study.plan.design.parts;
        loadModels();
    }
    std::vector<Wanted> wanted;
    for (const StudyMeasurementRecord* const one : study.counted())
        wanted.push_back({one->id, study.plan.part(std::size_t(one->measured.row)), one->squeezeId});
    m_changed = m_changed ||
                !std::ranges::equal(wanted, m_wanted, {}, &Wanted::measurementId, &Wanted::measurementId);
    m_wanted = std::move(wanted);
}

void TransferWatch::loadModels()
{
    m_changed = true;
    m_loading =
        PendingCall(m_library.run<TypeModels>([](Library& library) { return approvedModels(library); }),
                    [this](Expected<TypeModels> models) {
                        if (models)
                            m_models = std::move(*models);
                        else
                            m_error = models.error();
                    });
}

const TransferWatch::Known* TransferWatch::known(const QString& measurementId) const
{
    const auto found = std::ranges::find(m_known, measurementId, &Known::measurementId);
    return found == m_known.end() ? nullptr : &*found;
}

bool TransferWatch::busy() const
{
    return !m_study.isEmpty() && !m_error &&
           (m_changed || m_loading.waiting() || m_reading.waiting() || m_identifying.waiting() ||
            m_looking.waiting());
}

void TransferWatch::next()
{
    const auto missing = std::ranges::find_if(
        m_wanted, [this](const Wanted& one) { return known(one.measurementId) == nullptr; });
    if (missing == m_wanted.end())
        return lookAgain();
    StudyMeasurementRecord measured;
    measured.squeezeId = missing->squeezeId;
    m_reading = PendingCall(
        m_library.run<Recording>(
            [measured](Library& library) { return transferRecording(library, measured); }),
        [this, wanted = *missing](Expected<Recording> recording) { take(wanted, std::move(recording)); });
}

void TransferWatch::take(const Wanted& wanted, Expected<Recording> recording)
{
    if (!recording) {
        m_error = recording.error();
        m_known.push_back({wanted.measurementId, {}});
        return;
    }
    m_identifying =
        PendingCall(inPool([type = wanted.type, recording = std::move(*recording), options = m_options] {
                        return transferSqueeze(type, recording, options);
                    }),
                    [this, id = wanted.measurementId](std::optional<TypeSqueeze> squeeze) {
                        m_known.push_back({id, std::move(squeeze)});
                    });
}

void TransferWatch::lookAgain()
{
    if (!m_models || !std::exchange(m_changed, false))
        return;
    std::vector<TransferSqueeze> squeezes;
    for (const Wanted& wanted : m_wanted)
        if (const Known* const one = known(wanted.measurementId); one != nullptr && one->squeeze)
            squeezes.push_back({wanted.measurementId, *one->squeeze});
    m_looking = PendingCall(inPool([models = *m_models, squeezes = std::move(squeezes), planned = m_planned] {
                                return lookAtTransfer(models, squeezes, planned);
                            }),
                            [this](TransferLook look) { m_look = std::move(look); });
}

bool TransferWatch::poll()
{
    if (m_study.isEmpty())
        return false;
    bool told = m_loading.poll() && m_error.has_value();
    told = (m_reading.poll() && m_error.has_value()) || told;
    m_identifying.poll();
    told = m_looking.poll() || told;
    if (!m_loading.waiting() && !m_reading.waiting() && !m_identifying.waiting() && !m_looking.waiting())
        next();
    return told;
}

} // namespace gripscope
