// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/squeeze_record.h"
#include "core/recognition/verdict/inspection_outcome.h"

#include <QMap>

namespace gripscope {

struct NewInspection {
    NewGrasp grasp;
    Verdict verdict;
    VerdictOptions rates;
    QString expectedType; ///< name; empty when nothing was expected
    double seconds = 0;   ///< length of the squeeze
    QString batchId = {}; ///< empty: of no batch
    /// newTimeOrderedId(), so that one that is asked for again, after an answer that nobody got, is stored
    /// once. Empty: it is not asked for again.
    QString id = {};
    /// The version of the library whose types it was judged by.
    std::optional<qint64> libraryVersion = {};
    QString partNumber = {};   ///< as it was scanned; empty: none
    QString adjustmentId = {}; ///< by which its gripper was adjusted to the types'; empty: by none
};

struct InspectionRecord {
    QString id, graspId, expectedType;
    qint64 number = 0; ///< 1, 2, 3... in this library
    QDateTime inspected;
    VerdictKind verdict = VerdictKind::Invalid;
    QString type, nearest, operatorName;
    Finding reason;
    std::optional<double> posterior, distance, gate;
    std::optional<MassDampingStiffness> parameters;
    QString forceUnit, positionUnit;
    double seconds = 0;
    QString batch = {};   ///< the name of its batch; empty: of none
    bool suspect = false; ///< so was its measurement
    QString partNumber = {};
    QString voided = {};                               ///< why it does not count; empty: it does
    std::optional<ConformityDecision> conformity = {}; ///< absent: its type had no limits
    QString adjustmentId = {};                         ///< as in NewInspection
    QString gripperSerial = {}, station = {};
    [[nodiscard]] PartJudged judged() const { return {verdict, conformity}; }
};

struct HistoryFilter {
    int limit = 200;
    int offset = 0;
};

/// Valid squeezes of parts that were said to be of one type.
struct ExpectedCounts {
    qint64 squeezes = 0, otherType = 0, unknown = 0, inconclusive = 0, doesNotConform = 0;
    [[nodiscard]] qint64 judged() const { return squeezes - inconclusive; }
    [[nodiscard]] qint64 asExpected() const { return judged() - otherType - unknown - doesNotConform; }
};

/// Those that were voided are counted as that, and as nothing else.
struct InspectionCounts {
    qint64 total = 0, asExpected = 0, otherType = 0, unknown = 0, inconclusive = 0, invalid = 0;
    QMap<QString, ExpectedCounts> expected = {}; ///< by the type that was expected
    qint64 voided = 0;
    /// Where nothing was expected: a known type, counted in asExpected; known or unknown, so judged.
    qint64 knownType = 0, unasked = 0;
    qint64 doesNotConform = 0; ///< of a known type, and of the one that was expected
    /// Parts that were judged: neither inconclusive nor not valid.
    [[nodiscard]] qint64 judged() const { return asExpected + otherType + unknown + doesNotConform; }
};

} // namespace gripscope
