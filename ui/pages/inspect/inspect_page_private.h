// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/device_button.h"
#include "ui/pages/inspect/inspect_page.h"
#include "ui/pages/inspect/inspect_parts.h"
#include "ui/pages/tour_script.h"

#include <QPushButton>
#include <QStringList>

class QLabel;
class QLineEdit;

namespace gripscope {

class FittedLabel;
class InspectAutomatic;
class ScanReader;
class TypeChooser;
class VerdictPanel;

inline constexpr int longestPartNumber = 100;

struct InspectPage::Private {
    TypeChooser* expected = nullptr;
    ElidedLabel* recipe = nullptr;
    VerdictPanel* verdict = nullptr;
    InspectReason* reason = nullptr;
    InspectMeasurement* measurement = nullptr;
    QString expectedNow;
    QStringList shownTypes;            ///< names and how many squeezes
    QLabel* drift = nullptr;           ///< what moved since the enrolment
    ElidedLabel* adjustment = nullptr; ///< that the gripper's squeezes are adjusted by
    QPushButton *squeeze = nullptr, *arm = nullptr, *voidLast = nullptr;
    QLineEdit* part = nullptr;
    FittedLabel* over = nullptr;  ///< that the batch is complete
    std::uint64_t toldVoided = 0; ///< the squeeze of which all were told that it is voided
    QString wholeBatch;   ///< the one that was seen to be complete; what is voided later changes no end
    QString decidedBatch; ///< the one after which parts go on without
    bool recalled = false;
    InspectSummary* summary = nullptr;
    ScanReader* scans = nullptr;
    InspectAutomatic* automatic = nullptr;
    ElidedLabel* automaticWords = nullptr;
    SoundPlayer* sounds = nullptr;
    int listener = 0;
    ButtonWatch button;
    bool buttonPressed = false;
    std::optional<InspectHint> notice; ///< of a code or a button; until something else happens
    bool active = false;
    std::optional<std::uint64_t> past; ///< the squeeze whose verdict is no longer about the part in the jaws
    qint64 shownNumber = 0;
    std::uint64_t heard = 0; ///< the squeeze whose verdict was heard
    InspectSession::State shownState = InspectSession::State::Loading;
    TourScript tour;
};

} // namespace gripscope
