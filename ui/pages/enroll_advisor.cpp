// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/enroll_advisor.h"

#include "ui/workbench.h"

namespace gripscope {

EnrollAdvisor::EnrollAdvisor(Workbench& workbench, QObject* parent) : QObject(parent), m_workbench(&workbench)
{
}

void EnrollAdvisor::follow()
{
    const EnrollSession& session = m_workbench->enrollment();
    AdviceRequest request = adviceRequest(session.typeName(), session.squeezes());
    if (request == m_request)
        return;
    m_request = std::move(request);
    m_advice.reset();
    emit changed();
    if (!m_asking) // else once the answer is there
        ask();
}

void EnrollAdvisor::ask()
{
    using Squeezes = std::vector<TypeSqueeze>;
    m_asking = true;
    const AdviceRequest asked = m_request;
    const auto compute = [this, asked](const Squeezes& library) {
        m_workbench->compute<EnrollmentAdvice>(
            this, [asked, library] { return advise(asked, library); },
            [this, asked](EnrollmentAdvice advice) {
                m_asking = false;
                if (!(asked == m_request))
                    return ask();
                m_advice = std::move(advice);
                emit changed();
            });
    };
    m_workbench->ask<Squeezes>(
        this, [](Library& library) { return library.enrolledSqueezes(); },
        [this, compute](const Expected<Squeezes>& library) {
            if (library)
                return compute(*library);
            m_asking = false;
            m_workbench->report(library.error().describe());
        });
}

} // namespace gripscope
