// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/enroll/enroll_session.h"
#include "core/session/enroll/enrollment_storage.h"
#include "core/session/library/library_writes.h"
#include "core/session/tasks/pool.h"

namespace gripscope {

struct EnrollSession::Private {
    /// Something that can be taken back.
    struct Done {
        Act act;
        /// Of a drop: why. Of a rejection: what the squeeze was advised before it; once undone, why it was
        /// rejected.
        QString reason{};
        EnrollSqueeze squeeze{}; ///< once it was taken back
    };

    Private(ConnectSession& session, LibraryService& library)
        : connection(session), service(library), job(session), writes(library)
    {
    }

    ConnectSession& connection;
    LibraryService& service;
    SqueezeJob job;
    Pending<Identification> task;
    PendingCall answer;
    LibraryWrites writes;
    IdentificationOptions options;
    QString operatorName;

    Step step = Step::Name;
    Activity activity = Activity::Waiting;
    QString typeName;
    Recipe recipe = recipeOfNewTypes();
    std::optional<TypeRecord> type; // once it is in the library
    std::vector<EnrollSqueeze> squeezes;
    EnrollSqueeze measured; // what is being identified
    QString part;           // of the next squeeze
    std::optional<Error> error;

    bool keepsDrafts = false;
    QString draftName; // under which the draft is kept
    std::optional<PartPicture> picture;
    bool pictureChosen = false; // in this enrolment, rather than read from the library
    std::vector<Done> done, undone;

    [[nodiscard]] Expected<void> waitingIn(Step wanted) const;
    [[nodiscard]] EnrollSqueeze* pending();
    void identify(EnrollSqueeze squeeze);
    void identified(Identification identification);
    void load(bool whereItStopped);
    void resume(StoredEnrollment stored, bool whereItStopped);
    void takePicture(const StoredEnrollment& stored);
    void fail(const Error& reason, Activity next);
    void remember(Done what);
    void forgetActs();
    void changeSqueeze(std::size_t index, EnrollSqueeze::Decision decision, const QString& reason, Done what);

    void takeSqueezeBack();
    void bringSqueezeAgain();
    void reopenRejected();
    void reopenAccepted();
    void putBackDropped();

    [[nodiscard]] EnrollmentDraft draft() const;
    /// Under which the draft has the squeeze; empty where it has not.
    [[nodiscard]] QString keptDraftId(const EnrollSqueeze& squeeze) const;
    /// The same without a squeeze to decide on.
    [[nodiscard]] EnrollmentDraft decidedDraft(const QString& remark) const;
    void keepDraft(const QString& remark);
    void keepNewDraft();
    void keepMeasured();

    template <typename T>
    void ask(std::function<Expected<T>(Library&)> work, std::function<void(Expected<T>)> then)
    {
        activity = Activity::Storing;
        error.reset();
        answer = PendingCall(service.run<T>(std::move(work)), std::move(then));
    }
};

[[nodiscard]] tl::unexpected<Error> notNow(const QString& why);

} // namespace gripscope
