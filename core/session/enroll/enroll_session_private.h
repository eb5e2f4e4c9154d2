// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library_service.h"
#include "core/session/enroll/enroll_session.h"
#include "core/session/enroll/enrollment_storage.h"
#include "core/session/tasks/pool.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace gripscope {

/// Rows that are being written while the work goes on; the library writes them in the order they were given.
class LibraryWrites {
public:
    explicit LibraryWrites(LibraryService& library) : m_library(&library) {}

    void add(std::function<Expected<void>(Library&)> work)
    {
        m_writes.push_back(m_library->run<void>(std::move(work)));
    }
    [[nodiscard]] bool busy() const { return !m_writes.empty(); }
    /// The first error that came in, once.
    [[nodiscard]] std::optional<Error> poll()
    {
        std::optional<Error> error;
        const auto done = [&error](Pending<Expected<void>>& write) {
            const std::optional<Expected<void>> written = write.take();
            if (written && !*written && !error)
                error = written->error();
            return written.has_value();
        };
        m_writes.erase(std::remove_if(m_writes.begin(), m_writes.end(), done), m_writes.end());
        return error;
    }

private:
    LibraryService* m_library;
    std::vector<Pending<Expected<void>>> m_writes;
};

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
