// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/inspect_session.h"

#include <QWidget>

class QLabel;

namespace gripscope {

class ElidedLabel;

/// Under the verdict: what it rests on in numbers, the reason in one sentence, and the rates it is held to.
class InspectReason : public QWidget {
    Q_OBJECT
public:
    explicit InspectReason(QWidget* parent = nullptr);
    void showResult(const InspectSession::Result* result); ///< null: there is none
    void showRates(const VerdictOptions& rates);

private:
    ElidedLabel *m_facts, *m_rates;
    QLabel* m_reason;
};

} // namespace gripscope
