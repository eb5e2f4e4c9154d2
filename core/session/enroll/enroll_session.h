// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/result/determined_parameters.h"
#include "core/library/library_service.h"
#include "core/library/records/enrollment_draft.h"
#include "core/session/squeeze/squeeze_job.h"

#include <memory>
#include <optional>
#include <vector>

namespace gripscope {

/// A squeeze during an enrolment, with what was found and what is to become of it. One taken over from the
/// library has the stored estimate and no recording; Library::recording(graspId) has that.
struct EnrollSqueeze {
    enum class Decision { Pending, Accepted, Rejected };
    Recording recording;
    Identification identification;
    Decision decision = Decision::Pending;
    QString reason;       ///< why it was rejected, or is advised to be
    QString graspId;      ///< once it is in the library
    QString part = {};    ///< which part of the type was squeezed, see setPart()
    QString source = {};  ///< file or device it came from
    QString draftId = {}; ///< under which the draft has it, see keepDrafts()
    /// What it determines besides m, b and k, or in their place.
    std::optional<DeterminedQuantities> determined = {};
};

/// What is known of it, as a person is told: the identification's where it is of this session, else what the
/// library kept.
[[nodiscard]] std::vector<DeterminedParameter> determinedParameters(const EnrollSqueeze& squeeze);

/// Enrolment of one type, step by step. An accepted squeeze is in the library before accept() is reported
/// done; starting again under the same name goes on where it stopped.
///
///     Name -> Recipe -> Squeeze -> Review -> Approved
///
/// The squeeze step has an activity of its own: Waiting, Squeezing, Identifying, Deciding, Storing. Whatever
/// reads or writes the library (setRecipe, accept, drop, approve) is Storing until a later poll() has the
/// answer; the step or the decision changes then, or lastError() says why not.
///
/// The accepted squeezes of this session tell together how a gripper holds its force (hold_evidence.h).
///
/// A name that the library knows is resumed, with the recipe it has. A new type comes into the library with
/// its first accepted squeeze, in the units of that squeeze.
///
/// With keepDrafts() the library has every step from the name on, and every squeeze before anybody decides on
/// it: an enrolment that ends before its time (restart(), a crash) is gone on with by resumeDraft(), or by
/// its name.
///
/// undo() takes back what was done in this session, one by one, and redo() does it again; in the library both
/// are rows that correct earlier ones.
class EnrollSession {
public:
    enum class Step { Name, Recipe, Squeeze, Review, Approved };
    enum class Activity { Waiting, Squeezing, Identifying, Deciding, Storing };
    static constexpr int suggestedSqueezes = 10;
    static constexpr int leastSqueezes = 3;

    /// What can be undone.
    struct Act {
        enum class Kind { Name, Recipe, Squeeze, Accept, Reject, Drop, Review };
        Kind kind = Kind::Name;
        int squeeze = -1; ///< its place among squeezes()
        friend bool operator==(const Act&, const Act&) = default;
    };

    EnrollSession(ConnectSession& connection, LibraryService& library);
    ~EnrollSession();
    EnrollSession(const EnrollSession&) = delete;
    EnrollSession& operator=(const EnrollSession&) = delete;

    void setOperator(const QString& name);
    void keepDrafts(bool keep);                                ///< off at first
    [[nodiscard]] Expected<void> setName(const QString& name); ///< Name -> Recipe
    /// Recipe -> Squeeze; resumes the type when the library has one of that name.
    [[nodiscard]] Expected<void> setRecipe(const Recipe& recipe);
    /// Name -> where it stopped, with what it had; the squeeze that waits for a decision is identified again.
    [[nodiscard]] Expected<void> resumeDraft(const QString& name);
    /// Of the part; none takes it away. For the draft, and for the type once it is in the library.
    void setPicture(std::optional<PartPicture> picture);
    [[nodiscard]] const std::optional<PartPicture>& picture() const;
    /// Which part the next squeezes are of, as the operator calls it; empty (as at first): each of another
    /// one. A part that is squeezed again tells how much of the scatter is the grip and how much the part.
    void setPart(const QString& part);
    [[nodiscard]] QString part() const;
    [[nodiscard]] Expected<void> squeeze(); ///< from the connected gripper
    [[nodiscard]] Expected<void> addRecording(Recording recording, const QString& source); ///< from a file
    [[nodiscard]] Expected<void> accept();                      ///< the pending squeeze; not an invalid one
    [[nodiscard]] Expected<void> reject(const QString& reason); ///< the pending squeeze
    [[nodiscard]] Expected<void> drop(int index, const QString& reason); ///< an accepted one, later
    [[nodiscard]] Expected<void> review();                               ///< Squeeze -> Review
    [[nodiscard]] Expected<void> back();                              ///< Review -> Squeeze, Recipe -> Name
    [[nodiscard]] Expected<void> approve(const QString& reason = {}); ///< Review -> Approved
    void restart();                      ///< a new enrolment; nothing stored is lost, and the draft stays
    [[nodiscard]] Expected<void> undo(); ///< undoable()
    [[nodiscard]] Expected<void> redo(); ///< redoable()
    [[nodiscard]] std::optional<Act> undoable() const; ///< nothing while work is under way
    [[nodiscard]] std::optional<Act> redoable() const;
    /// Moves everything on; never waits. True when something changed.
    bool poll();

    [[nodiscard]] Step step() const;
    [[nodiscard]] Activity activity() const;
    [[nodiscard]] QString typeName() const;
    [[nodiscard]] const Recipe& recipe() const;
    [[nodiscard]] const std::vector<EnrollSqueeze>& squeezes() const;
    [[nodiscard]] int acceptedCount() const;
    [[nodiscard]] double progress() const; ///< of the squeeze under way
    [[nodiscard]] std::optional<Error> lastError() const;
    void setIdentificationOptions(const IdentificationOptions& options);

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
