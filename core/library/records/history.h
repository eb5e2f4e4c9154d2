// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "core/identification/model/estimate.h"
#include "core/library/records/clock_step.h"
#include "core/library/records/yield.h"
#include "core/recognition/verdict/inspection_outcome.h"

#include <QDateTime>
#include <QJsonObject>
#include <QMap>
#include <QString>
#include <QStringList>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gripscope {

/// The keys of many squeezes in their order, close together: 40 bytes each, where a QString takes a hundred.
/// A list of them is what lets any page of a history be read at once, however it is ordered.
class HistoryKeys {
public:
    void append(const QString& key)
    {
        m_text += key.toStdString();
        m_ends.push_back(static_cast<std::uint32_t>(m_text.size()));
    }
    [[nodiscard]] std::size_t size() const { return m_ends.size(); }
    [[nodiscard]] bool empty() const { return m_ends.empty(); }
    [[nodiscard]] QString at(std::size_t place) const
    {
        const std::size_t begin = place == 0 ? 0 : m_ends[place - 1];
        return QString::fromUtf8(m_text.data() + begin, static_cast<qsizetype>(m_ends[place] - begin));
    }
    /// Keys `first` to `first + count - 1`, as many of them as there are.
    [[nodiscard]] std::vector<QString> part(std::size_t first, std::size_t count) const
    {
        std::vector<QString> keys;
        for (std::size_t place = first; place < size() && place - first < count; ++place)
            keys.push_back(at(place));
        return keys;
    }
    [[nodiscard]] std::optional<std::size_t> find(const QString& key) const
    {
        const std::string wanted = key.toStdString();
        std::size_t begin = 0;
        for (std::size_t place = 0; place < m_ends.size(); begin = m_ends[place++])
            if (m_ends[place] - begin == wanted.size() && m_text.compare(begin, wanted.size(), wanted) == 0)
                return place;
        return {};
    }

private:
    std::string m_text;
    std::vector<std::uint32_t> m_ends; ///< where each key ends in m_text
};

// Every squeeze of a library, whether it was inspected or enrolled.

enum class SqueezeKind { Inspection, Enrollment };
[[nodiscard]] QString toString(SqueezeKind kind); ///< "inspection", "enrollment"

/// What the page on the history shows in a column each, and what a history can be ordered by; all about them
/// is in history_fields.h.
enum class HistoryColumn {
    Number,
    Time,
    Kind,
    Outcome,
    Validity,
    Expected,
    Type,
    Posterior,
    Mass, ///< m, b and k in SI where the units are known
    Damping,
    Stiffness,
    Fit,
    Seconds,
    Operator,
    Device,
    Batch,
    Estimator,
    Program,
    LibraryVersion,
    Voided,
    Conformity
};

/// Which squeezes, and in which order. What is empty lets everything through.
struct HistoryQuery {
    /// Contained in number, type, expected type, operator, gripper, batch, source, part or part number; case
    /// does not matter (of the letters A to Z).
    QString text = {};
    std::optional<SqueezeKind> kind = {};
    std::optional<InspectionOutcome> outcome = {};
    std::optional<ValidityVerdict> validity = {}; ///< of an inspection's measurement
    QString type = {};                            ///< named, or enrolled in
    QString expected = {};                        ///< an inspection's
    QString operatorName = {};
    QString device = {};          ///< as HistoryChoices has them
    QString batch = {};           ///< by name
    QDateTime from = {}, to = {}; ///< from the first on, before the second
    HistoryColumn order = HistoryColumn::Time;
    bool descending = true; ///< rows without what is ordered by come last either way
    /// Lets everything through.
    [[nodiscard]] bool everything() const;
    friend bool operator==(const HistoryQuery&, const HistoryQuery&) = default;
};

/// What a verdict was held to when it was made. Rows from before hold less: what is empty was not recorded,
/// but for the confidence beside a strangerAccept: the false-reject rate held on average then.
struct HeldTo {
    std::optional<double> falseReject, wrongType, strangerAccept, confidence;
    std::optional<bool> robust;
    friend bool operator==(const HeldTo&, const HeldTo&) = default;
};

/// One squeeze as a list shows it.
struct HistoryEntry {
    QString graspId;
    SqueezeKind kind = SqueezeKind::Inspection;
    QDateTime time;
    QString station;                       ///< whose clock it was
    std::optional<qint64> utcOffset_s;     ///< of that clock then; nothing where that was not recorded
    std::optional<ClockStep> clockSetBack; ///< found since: the time may be one of a wrong clock
    qint64 number = 0;                     ///< of an inspection; 0: none
    qint64 numberThere = 0; ///< of one that was made in the library of another station; 0: it was made here
    QString expectedType, type, nearest;
    Finding reason;
    std::optional<VerdictKind> verdict; ///< of an inspection
    std::optional<double> posterior, distance, gate, seconds;
    HeldTo heldTo;
    /// What the measurement of an inspection is worth; nothing where that was not recorded.
    std::optional<ValidityVerdict> validity;
    QStringList checksFailed; ///< ids of the validity checks
    /// The version of the library whose types it was judged by, or that an enrolled squeeze made.
    std::optional<qint64> libraryVersion;
    /// By which calibration the channel was corrected, for heardCalibration(); empty: by none. Nothing where
    /// that was not recorded. Then their keys in the library.
    std::optional<QString> forceCalibration, positionCalibration;
    QString forceCalibrationId, positionCalibrationId;
    std::optional<MassDampingStiffness> parameters;
    std::optional<Eigen::Vector3d> standardErrors;
    std::optional<double> simulationFitPercent;
    QString estimator, program; ///< as stored with the first estimate; program: the version
    QString forceUnit, positionUnit;
    QString operatorName, device, serial, firmware, source, part;
    QString batch;                                ///< the name of the one that was inspected
    QString partNumber;                           ///< of an inspection, as it was scanned
    QString voided;                               ///< why an inspection does not count; empty: it does
    std::optional<ConformityDecision> conformity; ///< of an inspection whose type had limits
    std::optional<Conformity> conformityValues;   ///< by what that was decided
    bool accepted = true; ///< false once an enrolled squeeze was dropped from its type

    /// What an inspection showed.
    [[nodiscard]] std::optional<InspectionOutcome> outcome() const;
    /// As exported: that of toString(), and "known_type" where a type was named and none was expected; empty
    /// without one.
    [[nodiscard]] QString outcomeName() const;
    /// As a person reads it: "17", of another station "hall-2-17"; empty without one.
    [[nodiscard]] QString numberText() const;
    /// `time` as the station's clock showed it; not valid where its offset was not recorded.
    [[nodiscard]] QDateTime timeThere() const;
    /// There is a verdict, but none to rely on.
    [[nodiscard]] bool suspect() const;
    /// Among the enrolled types only: nothing for a part that is none of them, where it would mislead.
    [[nodiscard]] std::optional<double> tellingPosterior() const;
};

/// A squeeze in a chart over time, in SI where the units are known.
struct HistoryPoint {
    qint64 time_ms = 0; ///< since 1970, UTC
    MassDampingStiffness parameters;
    MassDampingStiffness standardErrors; ///< 0: not known
    int type = -1;                       ///< place in HistoryPoints::types; -1: of none
    std::optional<InspectionOutcome> outcome;
    std::optional<ValidityVerdict> validity; ///< of an inspection's measurement
};

/// Those of a list that have m, b and k, in order of time whatever the order asked for. What was voided is
/// not among them. Of more than a screen can show every so many-th inspection is read, by its number, and all
/// that were enrolled: an even share of the time they took, in which a single outlier may be missing.
struct HistoryPoints {
    std::vector<HistoryPoint> points;
    HistoryKeys keys;  ///< of the squeezes, in the same order
    QStringList types; ///< by name
    /// Of each of them, see TypeRecord::place, whether the type is approved, in use or gone; a name that no
    /// type ever had comes after all of them.
    std::vector<int> places;
    bool si = true;   ///< whether all are in SI; else as they were stored
    qint64 oneIn = 1; ///< of so many inspections one is among them
};

/// How many squeezes came out how.
struct HistoryCounts {
    qint64 inspections = 0, enrolled = 0;
    qint64 asExpected = 0, otherType = 0, unknown = 0, inconclusive = 0, notValid = 0;
    /// Where nothing was expected: a known type, counted in asExpected; known or unknown, so judged.
    qint64 knownType = 0, unasked = 0;
    qint64 suspect = 0; ///< of those with a verdict
    qint64 voided = 0;  ///< of the inspections; in none of the outcomes
    qint64 doesNotConform = 0;
    [[nodiscard]] qint64 total() const { return inspections + enrolled; }
    HistoryCounts& operator+=(const HistoryCounts& other);
    friend bool operator==(const HistoryCounts&, const HistoryCounts&) = default;
};

/// What was in force when the squeezes of a query were made.
struct HistoryInForce {
    struct Rates {
        HeldTo heldTo;
        qint64 inspections = 0;
    };
    std::vector<Rates> rates; ///< the most frequent first
    /// Squeezes by their calibration, see HistoryEntry::forceCalibration; of one gripper.
    struct Calibrations {
        std::map<std::optional<QString>, qint64> force, position;
    };
    std::map<QString, Calibrations> calibrations;    ///< by the serial number of the gripper
    std::optional<qint64> firstVersion, lastVersion; ///< of the library, of those recorded
    qint64 withoutVersion = 0;                       ///< inspections of which it was not recorded
    std::map<QString, qint64> programs;              ///< inspections by version; empty: not recorded
    QMap<QString, qint64> operators, serials;        ///< squeezes of each, but for those that were voided
    QMap<QString, QString> devices;                  ///< the name of the gripper with a serial number
};

/// What there is to choose from, by name.
struct HistoryChoices {
    QStringList types, expected, operators, devices, batches;
};

/// How a squeeze was identified again, and by whom.
struct Reidentification {
    std::optional<ForceHold> hold; ///< empty: as recorded
    InitialState initialState = InitialState::Free;
    bool freeOffset = true;
    QString operatorName;
};

/// One estimate of a squeeze as it is stored.
struct StoredEstimate {
    QString estimator, status, program;
    int rank = 0; ///< 0: the one that stands for the squeeze
    QDateTime stored;
    std::optional<MassDampingStiffness> parameters;
    std::optional<Eigen::Vector3d> standardErrors;
    std::optional<double> simulationFitPercent;
    std::optional<Reidentification> again; ///< of a later one
};

/// All that is known of one squeeze.
struct SqueezeDetails {
    HistoryEntry entry;
    std::vector<StoredEstimate> estimates; ///< by rank
    QMap<QString, QString> provenance;     ///< of its recording; empty without one
    std::size_t samples = 0;               ///< of its recording; 0: there is none
    double sampleTime_s = 0;
    QJsonObject document; ///< the identify document, for the budget; may be empty
};

} // namespace gripscope
