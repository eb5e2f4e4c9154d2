// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connect_session.h"
#include "core/session/enroll_session.h"
#include "core/session/inspect_session.h"
#include "core/store/library_service.h"
#include "devices/gripper_factory.h"
#include "ui/live_estimate.h"
#include "ui/live_history.h"
#include "ui/stored_rates.h"

#include <QObject>
#include <QString>

#include <functional>
#include <future>
#include <memory>

class QTimer;

namespace gripscope {

class Settings;
class SignIn;

/// A squeeze with what was found in it: what the Fit page shows.
struct FitSubject {
    QString title; ///< "Inspection 12", "A, squeeze 3"
    Recording recording;
    Identification identification;
};

/// All that the pages share: the sessions, the library, the live history, and the one timer (every 16 ms)
/// that drives them. Lives on the screen's thread and never waits.
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
    [[nodiscard]] LibraryService& library();
    [[nodiscard]] Settings& settings();
    [[nodiscard]] const LiveHistory& liveHistory() const;
    [[nodiscard]] const LiveEstimate& liveEstimate() const;
    [[nodiscard]] SignIn& signIn(); ///< who has shown who they are
    [[nodiscard]] QString operatorName() const;
    void setOperatorName(const QString& name);

    /// What verdicts are held to, and whether squeezes end early.
    [[nodiscard]] StoredRates rates() const;
    void setRates(const StoredRates& rates);

    /// Whether the raw reports of sessions are kept, and how, from the next connection on.
    [[nodiscard]] bool keepsSessions() const;
    [[nodiscard]] const KeepSessions& keeping() const;
    void setKeeping(const KeepSessions& how, bool on);

    /// These word the errors of the connection in the message bar.
    void connectTo(const QString& address);
    void arm(); ///< only where a person asked for it
    /// Stop and disarm, from any page, whatever else is going on.
    void stop();
    [[nodiscard]] bool squeezing() const; ///< the gripper is busy with a squeeze, whoever asked for it
    void setTrialRunning(bool running);   ///< a squeeze that belongs to no session

    /// Asks the library on its own thread, and calls `done` on the screen's thread with the answer, unless
    /// `context` is gone by then.
    template <typename T>
    void ask(QObject* context, std::function<Expected<T>(Library&)> work,
             std::function<void(Expected<T>)> done)
    {
        auto future = std::make_shared<std::future<Expected<T>>>(library().run<T>(std::move(work)));
        whenReady(
            context,
            [future] { return future->wait_for(std::chrono::seconds(0)) == std::future_status::ready; },
            [future, done = std::move(done)] { done(future->get()); });
    }
    /// Runs `work` (identification, clustering) in the thread pool, and `done` on the screen's thread.
    template <typename T>
    void compute(QObject* context, std::function<T()> work, std::function<void(T)> done)
    {
        auto promise = std::make_shared<std::promise<T>>();
        auto future = std::make_shared<std::future<T>>(promise->get_future());
        runInPool([promise, work = std::move(work)] { promise->set_value(work()); });
        whenReady(
            context,
            [future] { return future->wait_for(std::chrono::seconds(0)) == std::future_status::ready; },
            [future, done = std::move(done)] { done(future->get()); });
    }

    /// Puts a squeeze on the Fit page and shows that page.
    void showInFit(FitSubject subject);
    /// Puts a squeeze on the Fit page without leaving this one.
    void setFitSubject(FitSubject subject);
    [[nodiscard]] const std::optional<FitSubject>& fitSubject() const;
    /// Brings another page into view, by its id.
    void showPage(const QString& id) { emit pageRequested(id); }
    /// Types or squeezes in the library were changed by a page.
    void tellLibraryChanged();
    /// A calibration of the connected gripper was stored, and is in force.
    void tellCalibrationChanged() { emit connectionChanged(); }
    /// Shows a message (errors, mostly) in the window's message bar.
    void report(const QString& message) { emit reported(message); }

signals:
    void ticked();            ///< after every poll; pages refresh what moved
    void connectionChanged(); ///< state, identity or armed state
    void libraryChanged();    ///< types, squeezes or inspections were added
    void inspectionChanged();
    void enrollmentChanged();
    void fitSubjectChanged(); ///< a new one; the page need not be in view
    void fitRequested();      ///< showInFit() was called: bring the Fit page into view
    void reported(const QString& message);
    void operatorChanged();
    void ratesChanged();
    void keepingChanged();
    void pageRequested(const QString& id);
    void stopped(); ///< by a person, through stop()

private:
    void whenReady(QObject* context, std::function<bool()> ready, std::function<void()> then);
    void runInPool(std::function<void()> work);
    void tick();
    void noticeConnection();
    void noticeCapture();
    void noticeReferenceCheck(); ///< of the connected gripper: due, or failed
    void applyCalibrations(const QString& serial);
    void applyMeasuringChain(const QString& serial); ///< what the library knows of this gripper
    void noticeEnrollment();
    void noticeInspection();
    void noticeError(std::optional<Error>& known, const std::optional<Error>& now);
    void answerWaiting();
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
