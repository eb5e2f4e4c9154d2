// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/people/permission.h"
#include "core/session/connection/connect_session.h"
#include "core/session/enroll/enroll_session.h"
#include "core/session/inspect/inspect_session.h"
#include "core/session/quality/study_session.h"
#include "devices/factory/gripper_factory.h"
#include "ui/context/background.h"
#include "ui/context/messages.h"
#include "ui/context/navigator.h"
#include "ui/feed/live_feed.h"
#include "ui/settings/values/stored_rates.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>

class QWidget;

namespace gripscope {

class Settings;
class SignIn;

/// All that the pages share: the sessions, the library, the services beside this header, and the one timer
/// (every 16 ms) that drives them. Lives on the screen's thread and never waits.
class Workbench : public QObject {
    Q_OBJECT
public:
    /// Without a file of settings, what persons set holds for this run only.
    explicit Workbench(const QString& libraryFile, const QString& settingsFile = {},
                       QObject* parent = nullptr);
    ~Workbench() override;

    [[nodiscard]] ConnectSession& connection();
    [[nodiscard]] EnrollSession& enrollment();
    [[nodiscard]] InspectSession& inspection();
    [[nodiscard]] StudySession& study();
    [[nodiscard]] LibraryService& library();
    [[nodiscard]] Settings& settings();
    [[nodiscard]] const LiveFeed& live() const;
    [[nodiscard]] Background& background(); ///< the library and the pool, without waiting
    [[nodiscard]] Messages& messages();     ///< to the person, in the window's message bar
    [[nodiscard]] Navigator& navigator();   ///< from page to page
    [[nodiscard]] SignIn& signIn();         ///< who has shown who they are
    [[nodiscard]] QString operatorName() const;
    void setOperatorName(const QString& name);

    /// What verdicts are held to, and whether squeezes end early.
    [[nodiscard]] StoredRates rates() const;
    void setRates(const StoredRates& rates);

    /// What is not judged though it could be; and, where `onlySignedIn` and the library has people, nothing
    /// while nobody is signed in.
    void setJudgingPolicy(const JudgingPolicy& policy, bool onlySignedIn);

    /// Whether the raw reports of sessions are kept, and how, from the next connection on.
    [[nodiscard]] bool keepsSessions() const;
    [[nodiscard]] const KeepSessions& keeping() const;
    void setKeeping(const KeepSessions& how, bool on);

    /// How long the link to a gripper waits for what, from the next connection on. For tests on busy
    /// computers.
    void setLinkLimits(const LinkLimits& limits);
    /// These word the errors of the connection in the message bar.
    void connectTo(const QString& address);
    void arm(); ///< only where a person asked for it
    /// Stop and disarm, from any page, whatever else is going on.
    void stop();
    [[nodiscard]] bool squeezing() const; ///< the gripper is busy with a squeeze, whoever asked for it
    /// Whether it is; then also says so, until it is no longer.
    [[nodiscard]] bool busyWithSqueeze();
    void setTrialRunning(bool running); ///< a squeeze that belongs to no session

    /// Types or squeezes in the library were changed by a page.
    void tellLibraryChanged();
    /// Types, calibrations or limits came from another station.
    void tellPlantChanged();
    /// A calibration of the connected gripper was stored, and is in force.
    void tellCalibrationChanged()
    {
        tellLibraryChanged(); // an adjustment of the gripper may be older than its calibration now
        emit connectionChanged();
    }

signals:
    void ticked();            ///< after every poll; pages refresh what moved
    void connectionChanged(); ///< state, identity or armed state
    void libraryChanged();    ///< types, squeezes or inspections were added
    void inspectionChanged();
    void enrollmentChanged();
    void studyChanged();
    void operatorChanged();
    void ratesChanged();
    void keepingChanged();
    void stopped(); ///< by a person, through stop()
    /// Somebody has to sign in, or a supervisor to allow `then`, before what was asked for is done; see
    /// answerForPeople().
    void signInNeeded(QWidget* parent);
    void consentNeeded(QWidget* parent, Permission permission, const std::function<void()>& then);

private:
    void tick();
    void lookForTheEnd();
    void noticeConnection();
    [[nodiscard]] Messages::Condition untilConnected() const;
    void noticeCapture();
    void noticeReferenceCheck();            ///< of the connected gripper: due, or failed
    void applyKnown(const QString& serial); ///< what the library knows of this gripper
    void askAgain(const QString& serial, const Error& reason);
    void noticeEnrollment();
    void noticeInspection();
    void noticeStudy();
    void tellInspection();
    void applyPolicy();
    void noticeError(std::optional<Error>& known, const std::optional<Error>& now);
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
