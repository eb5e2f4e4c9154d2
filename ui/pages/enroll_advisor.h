// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/enrollment_advice.h"

#include <QObject>

#include <optional>

namespace gripscope {

class Workbench;

/// Advice on the enrolment under way, worked out in the pool whenever its squeezes change.
class EnrollAdvisor : public QObject {
    Q_OBJECT
public:
    explicit EnrollAdvisor(Workbench& workbench, QObject* parent = nullptr);
    /// Looks whether the squeezes changed, and asks for advice if they did; cheap if not.
    void follow();
    /// On the squeezes as they are; nothing while it is being worked out.
    [[nodiscard]] const std::optional<EnrollmentAdvice>& advice() const { return m_advice; }

signals:
    void changed();

private:
    void ask();
    Workbench* m_workbench;
    AdviceRequest m_request; ///< what advice() is about, or will be
    bool m_asking = false;
    std::optional<EnrollmentAdvice> m_advice;
};

} // namespace gripscope
