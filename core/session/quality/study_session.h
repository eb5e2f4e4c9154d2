// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "core/library/library_service.h"
#include "core/library/records/study_record.h"
#include "core/session/connection/connect_session.h"
#include "core/session/quality/study_result.h"

#include <QMap>

#include <memory>

namespace gripscope {

/// A study to be begun.
struct StudyRequest {
    QString name;
    PlanDesign design;
    Recipe recipe;
    StudyOptions options = {};
};

/// A study led through, squeeze by squeeze; each is in the library before the next one is asked for.
///
///     Idle -> Waiting -> Squeezing -> Identifying -> Waiting ... -> Ended
///
/// with Storing in between whenever the library is asked. A squeeze that is not valid is told (refusal()),
/// kept on record, and its row of the plan is to be squeezed again. The gripper is armed by whoever owns the
/// connection; squeezes pass its gate as any other.
///
/// What counts is what the library has: resume() goes on with a study of an earlier run of the program from
/// there, where nothing is lost but a squeeze that was under way.
class StudySession {
public:
    enum class State { Idle, Waiting, Squeezing, Identifying, Storing, Ended };

    StudySession(ConnectSession& connection, LibraryService& library);
    ~StudySession();
    StudySession(const StudySession&) = delete;
    StudySession& operator=(const StudySession&) = delete;

    /// Who leads it, and who squeezes where the plan has no operators.
    void setOperator(const QString& name);
    /// Assessed unless told otherwise: the uncertainties are those of the budget then.
    void setIdentificationOptions(const IdentificationOptions& options);

    /// What parts with these labels are squeezed by, in place of the study's own recipe: of a transfer each
    /// type by its own.
    void setPartRecipes(const QMap<QString, Recipe>& recipes);

    /// Idle or Ended -> Waiting. Errors at once: Usage as designProblem() has; those of the library later.
    [[nodiscard]] Expected<void> begin(const StudyRequest& request);
    /// The same with one that the library has (Library::unfinishedStudies()); one that has ended is Ended
    /// then, with its result.
    [[nodiscard]] Expected<void> resume(const QString& studyId);
    /// What instruction() says. Usage: nothing is left, another gripper than the one it was begun with.
    [[nodiscard]] Expected<void> squeeze();
    /// In place of a squeeze: what a rater says of the part. Usage: not a study of attributes, or no word.
    [[nodiscard]] Expected<void> rate(const QString& rating);
    [[nodiscard]] Expected<void> skip(const QString& reason);
    /// Takes the newest measurement, or what was left out, back.
    [[nodiscard]] Expected<void> undo(const QString& reason = {});
    /// Waiting -> Ended, with a result. Usage: squeezes are left, and no reason is given for ending without
    /// them.
    [[nodiscard]] Expected<void> finish(const QString& reason = {});
    [[nodiscard]] Expected<void> abandon(const QString& reason); ///< Waiting -> Ended, without a result
    void cancel();                                               ///< the squeeze; stops the gripper, too
    /// Waiting or Ended -> Idle: it stays in the library as it is, to be gone on with.
    void leave();
    bool poll(); ///< never waits; true when something changed

    [[nodiscard]] State state() const;
    [[nodiscard]] bool busy() const;
    [[nodiscard]] double squeezeProgress() const; ///< of the one under way, 0 to 1
    [[nodiscard]] const std::optional<KeptStudy>& study() const;
    [[nodiscard]] StudyProgress progress() const; ///< of no rows while Idle
    [[nodiscard]] std::optional<std::size_t> nextRow() const;
    [[nodiscard]] Finding instruction() const; ///< empty where nothing is left
    /// What was measured so far; nothing while a blind study is under way.
    [[nodiscard]] std::vector<StudyMeasurementRecord> shownMeasurements() const;
    /// Why the last squeeze does not count; empty when it does.
    [[nodiscard]] const Findings& refusal() const;
    [[nodiscard]] std::optional<Error> lastError() const;
    /// Once Ended, and worked out; an error where the measurements allow none.
    [[nodiscard]] const std::optional<Expected<StudyResult>>& result() const;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

/// m, b, k of a squeeze for a study, in SI where the channels' units are known, with validity and, where it
/// may not be used, why; the outcome says which. A squeeze is used unless it is invalid or does not determine
/// m, b and k; one that is suspect is used and says so.
///
/// The standard uncertainties are what differs from squeeze to squeeze: the budget's lines of type A where it
/// was assessed, else the estimate's noise. What all squeezes of a gripper have in common (calibration, lag)
/// does not scatter between them, and would hide in a comparison with their repeats.
[[nodiscard]] NewStudyMeasurement squeezeMeasured(const Identification& identification,
                                                  const Recording& recording);

} // namespace gripscope
