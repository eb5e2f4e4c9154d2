// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/context/navigator.h"

#include <utility>

namespace gripscope {

void Navigator::showInFit(FitSubject subject)
{
    setFitSubject(std::move(subject));
    showPage(QStringLiteral("fit"));
}

void Navigator::setFitSubject(FitSubject subject)
{
    m_fitSubject = std::move(subject);
    emit fitSubjectChanged();
}

} // namespace gripscope
