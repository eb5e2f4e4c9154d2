// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/spill/spilled_inspection.h"

#include "core/base/byte_writer.h"
#include "core/base/json_value.h"
#include "core/base/words.h"
#include "core/library/packing/inflate.h"
#include "core/library/records/determined_text.h"
#include "core/library/tables/packed_recording.h"
#include "core/quality/conformity/conformity_json.h"
#include "core/recognition/verdict/rates_json.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtEndian>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr qint64 mostUnpacked = 100'000'000; ///< a hundred times an inspection of ten seconds
constexpr int quickly = 1;                   ///< of zlib: this is to be on the disk at once
constexpr int mostEstimates = 100;
constexpr qint64 bytesOfSample = 3 * sizeof(double) + sizeof(std::uint64_t) + sizeof(std::uint16_t);
const auto spilledTime = Qt::ISODateWithMs;

QJsonArray numbersOf(const Eigen::Matrix3d& matrix)
{
    QJsonArray array;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            array.append(matrix(i, j));
    return array;
}

QJsonValue numbersOf(const std::optional<MassDampingStiffness>& p)
{
    return p ? QJsonValue(QJsonArray{p->m, p->b, p->k}) : QJsonValue();
}

QJsonArray sentencesOf(const Findings& findings)
{
    QJsonArray array;
    for (const Finding& finding : findings)
        array.append(finding.toJson());
    return array;
}

std::optional<double> optionalIn(const QJsonObject& object, const QString& key)
{
    const QJsonValue value = object.value(key);
    return value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
}

std::optional<MassDampingStiffness> parametersIn(const QJsonValue& value)
{
    const QJsonArray numbers = value.toArray();
    if (numbers.size() != 3)
        return {};
    return MassDampingStiffness{numbers[0].toDouble(), numbers[1].toDouble(), numbers[2].toDouble()};
}

std::optional<Eigen::Matrix3d> matrixIn(const QJsonValue& value)
{
    const QJsonArray numbers = value.toArray();
    if (numbers.size() != 9)
        return {};
    Eigen::Matrix3d matrix;
    for (int i = 0; i < 9; ++i)
        matrix(i / 3, i % 3) = numbers[i].toDouble();
    return matrix;
}

Findings sentencesIn(const QJsonValue& value)
{
    Findings findings;
    for (const QJsonValue sentence : value.toArray())
        if (std::optional<Finding> finding = Finding::fromJson(sentence))
            findings.push_back(*std::move(finding));
    return findings;
}

/// The one of `values` that is written `text`.
template <typename Value>
std::optional<Value> writtenAs(const QString& text, std::initializer_list<Value> values)
{
    for (const Value value : values)
        if (toString(value) == text)
            return value;
    return {};
}

QJsonObject toDocument(const Estimate& estimate)
{
    const Nuisance& nuisance = estimate.nuisance;
    const ResidualSummary& residuals = estimate.residuals;
    QJsonObject document{{u"estimator"_s, toString(estimate.estimator)},
                         {u"status"_s, toString(estimate.status)},
                         {u"message"_s, estimate.message.toJson()},
                         {u"parameters"_s, numbersOf(estimate.parameters)},
                         {u"x0"_s, jsonNumber(nuisance.x0)},
                         {u"v0"_s, jsonNumber(nuisance.v0)},
                         {u"offset"_s, jsonNumber(nuisance.offset)},
                         {u"simulation_percent"_s, jsonNumber(estimate.fit.simulationPercent)},
                         {u"prediction_percent"_s, jsonNumber(estimate.fit.predictionPercent)},
                         {u"sse"_s, jsonNumber(residuals.sse)},
                         {u"degrees_of_freedom"_s, jsonNumber(residuals.degreesOfFreedom)},
                         {u"whiteness_p"_s, jsonNumber(residuals.whitenessP)},
                         {u"input_independence_p"_s, jsonNumber(residuals.inputIndependenceP)},
                         {u"iterations"_s, estimate.iterations}};
    if (estimate.covariance)
        document.insert(u"covariance"_s, numbersOf(*estimate.covariance));
    if (const auto& c = estimate.coefficients)
        document.insert(u"coefficients"_s, QJsonObject{{u"a1"_s, c->a1},
                                                       {u"a2"_s, c->a2},
                                                       {u"b1"_s, c->b1},
                                                       {u"b2"_s, jsonNumber(c->b2)},
                                                       {u"constant"_s, jsonNumber(c->constant)}});
    return document;
}

std::optional<Estimate> toEstimate(const QJsonObject& document)
{
    using Status = EstimateStatus;
    const auto estimator = estimatorFromString(document.value(u"estimator"_s).toString());
    const auto status = writtenAs(document.value(u"status"_s).toString(),
                                  {Status::Converged, Status::NotConverged, Status::NotIdentifiable,
                                   Status::NoPhysicalMapping, Status::TooFewSamples, Status::NotApplicable});
    if (!estimator || !status)
        return {};
    Estimate estimate;
    estimate.estimator = *estimator;
    estimate.status = *status;
    estimate.message = Finding::fromJson(document.value(u"message"_s)).value_or(Finding());
    estimate.parameters = parametersIn(document.value(u"parameters"_s));
    estimate.covariance = matrixIn(document.value(u"covariance"_s));
    estimate.nuisance = {optionalIn(document, u"x0"_s), optionalIn(document, u"v0"_s),
                         optionalIn(document, u"offset"_s)};
    estimate.fit = {optionalIn(document, u"simulation_percent"_s),
                    optionalIn(document, u"prediction_percent"_s)};
    estimate.residuals.sse = document.value(u"sse"_s).toDouble();
    estimate.residuals.degreesOfFreedom = document.value(u"degrees_of_freedom"_s).toDouble();
    estimate.residuals.whitenessP = optionalIn(document, u"whiteness_p"_s);
    estimate.residuals.inputIndependenceP = optionalIn(document, u"input_independence_p"_s);
    estimate.iterations = document.value(u"iterations"_s).toInt();
    if (const QJsonValue value = document.value(u"coefficients"_s); value.isObject()) {
        const QJsonObject c = value.toObject();
        estimate.coefficients = {c.value(u"a1"_s).toDouble(), c.value(u"a2"_s).toDouble(),
                                 c.value(u"b1"_s).toDouble(), optionalIn(c, u"b2"_s),
                                 optionalIn(c, u"constant"_s)};
    }
    return estimate;
}

QJsonObject toDocument(const VerdictOptions& rates)
{
    QJsonObject document = toJson(rates);
    document.insert(u"si_units"_s, rates.siUnits);
    document.insert(u"stranger_share"_s, rates.strangerShare);
    if (rates.range) {
        document.insert(u"lowest"_s, numbersOf(std::optional(rates.range->lowest)));
        document.insert(u"highest"_s, numbersOf(std::optional(rates.range->highest)));
    }
    return document;
}

VerdictOptions toRates(const QJsonObject& document)
{
    VerdictOptions rates;
    rates.falseReject = document.value(u"false_reject"_s).toDouble();
    rates.wrongType = document.value(u"wrong_type"_s).toDouble();
    rates.siUnits = document.value(u"si_units"_s).toBool();
    rates.strangerAccept = document.value(u"stranger_accept"_s).toDouble();
    rates.confidence = optionalIn(document, u"confidence"_s);
    rates.robust = document.value(u"robust"_s).toBool();
    rates.strangerShare = document.value(u"stranger_share"_s).toDouble();
    const auto lowest = parametersIn(document.value(u"lowest"_s));
    const auto highest = parametersIn(document.value(u"highest"_s));
    if (lowest && highest)
        rates.range = InstrumentRange{*lowest, *highest};
    return rates;
}

QJsonObject toDocument(const Verdict& verdict)
{
    QJsonObject posterior;
    for (auto type = verdict.posterior.cbegin(); type != verdict.posterior.cend(); ++type)
        posterior.insert(type.key(), type.value());
    return {{u"kind"_s, toString(verdict.kind)},
            {u"type"_s, verdict.type},
            {u"nearest"_s, verdict.nearest},
            {u"posterior"_s, posterior},
            {u"distance"_s, jsonNumber(verdict.distance)},
            {u"gate"_s, jsonNumber(verdict.gate)},
            {u"samples_used"_s, static_cast<qint64>(verdict.samplesUsed)},
            {u"reasons"_s, sentencesOf(verdict.reasons)},
            {u"rival"_s, verdict.rival},
            {u"held_for_stranger"_s, verdict.heldForStranger},
            {u"times_longer"_s, jsonNumber(verdict.timesLonger)},
            {u"stranger_posterior"_s, jsonNumber(verdict.strangerPosterior)},
            {u"stranger_accept"_s, jsonNumber(verdict.strangerAccept)},
            {u"validity"_s, toString(verdict.validity.verdict)},
            {u"checks_failed"_s, QJsonArray::fromStringList(verdict.validity.checksFailed)},
            {u"validity_reasons"_s, sentencesOf(verdict.validity.reasons)},
            {u"conformity"_s,
             verdict.conformity ? QJsonValue(conformityJson(*verdict.conformity)) : QJsonValue()}};
}

std::optional<Verdict> toVerdict(const QJsonObject& document)
{
    const auto kind = verdictKindFromString(document.value(u"kind"_s).toString());
    const auto validity =
        writtenAs(document.value(u"validity"_s).toString(),
                  {ValidityVerdict::Valid, ValidityVerdict::Suspect, ValidityVerdict::Invalid});
    if (!kind || !validity)
        return {};
    Verdict verdict;
    verdict.kind = *kind;
    verdict.type = document.value(u"type"_s).toString();
    verdict.nearest = document.value(u"nearest"_s).toString();
    const QJsonObject posterior = document.value(u"posterior"_s).toObject();
    for (auto type = posterior.begin(); type != posterior.end(); ++type)
        verdict.posterior.insert(type.key(), type.value().toDouble());
    verdict.distance = optionalIn(document, u"distance"_s);
    verdict.gate = optionalIn(document, u"gate"_s);
    verdict.samplesUsed =
        static_cast<std::size_t>(std::max<qint64>(0, document.value(u"samples_used"_s).toInteger()));
    verdict.reasons = sentencesIn(document.value(u"reasons"_s));
    verdict.rival = document.value(u"rival"_s).toString();
    verdict.heldForStranger = document.value(u"held_for_stranger"_s).toBool();
    verdict.timesLonger = optionalIn(document, u"times_longer"_s);
    verdict.strangerPosterior = optionalIn(document, u"stranger_posterior"_s);
    verdict.strangerAccept = optionalIn(document, u"stranger_accept"_s);
    verdict.validity.verdict = *validity;
    for (const QJsonValue check : document.value(u"checks_failed"_s).toArray())
        verdict.validity.checksFailed.append(check.toString());
    verdict.validity.reasons = sentencesIn(document.value(u"validity_reasons"_s));
    verdict.conformity = conformityFromJson(document.value(u"conformity"_s).toObject());
    return verdict;
}

QJsonValue toDocument(const std::optional<DeterminedQuantities>& determined)
{
    const auto text = determined ? determinedText(*determined) : std::nullopt;
    return text ? QJsonValue(QJsonArray{text->quantities, text->logarithms, text->covariance}) : QJsonValue();
}

std::optional<DeterminedQuantities> determinedIn(const QJsonValue& value)
{
    const QJsonArray texts = value.toArray();
    return determinedQuantities(
        DeterminedText{texts.at(0).toString(), texts.at(1).toString(), texts.at(2).toString()});
}

QJsonObject toDocument(const NewGrasp& grasp)
{
    QJsonArray estimates;
    for (const Estimate& estimate : grasp.estimates)
        estimates.append(toDocument(estimate));
    return {
        {u"estimates"_s, estimates},
        {u"force_unit"_s, grasp.forceUnit},
        {u"position_unit"_s, grasp.positionUnit},
        {u"source"_s, grasp.source},
        {u"operator"_s, grasp.operatorName},
        {u"part"_s, grasp.part},
        {u"recorded"_s, grasp.recorded.isValid() ? grasp.recorded.toUTC().toString(spilledTime) : QString()},
        {u"utc_offset_s"_s, grasp.utcOffset_s ? QJsonValue(*grasp.utcOffset_s) : QJsonValue()},
        {u"program"_s, grasp.program},
        {u"determined"_s, toDocument(grasp.determined)},
        {u"identification"_s, grasp.identification}};
}

/// Without its recording.
std::optional<NewGrasp> toGrasp(const QJsonObject& document)
{
    const QJsonArray estimates = document.value(u"estimates"_s).toArray();
    if (estimates.size() > mostEstimates)
        return {};
    NewGrasp grasp;
    for (const QJsonValue value : estimates) {
        const std::optional<Estimate> estimate = toEstimate(value.toObject());
        if (!estimate)
            return {};
        grasp.estimates.push_back(*estimate);
    }
    grasp.forceUnit = document.value(u"force_unit"_s).toString();
    grasp.positionUnit = document.value(u"position_unit"_s).toString();
    grasp.source = document.value(u"source"_s).toString();
    grasp.operatorName = document.value(u"operator"_s).toString();
    grasp.part = document.value(u"part"_s).toString();
    grasp.recorded = QDateTime::fromString(document.value(u"recorded"_s).toString(), spilledTime);
    if (const QJsonValue offset = document.value(u"utc_offset_s"_s); offset.isDouble())
        grasp.utcOffset_s = offset.toInteger();
    grasp.program = document.value(u"program"_s).toString();
    grasp.determined = determinedIn(document.value(u"determined"_s));
    grasp.identification = document.value(u"identification"_s).toObject();
    return grasp;
}

tl::unexpected<Error> noInspection()
{
    return failure(ErrorCode::StorageCorrupt, {Words::say("An inspection that waited to be stored"),
                                               Words::say("its bytes are not those that were stored")});
}

} // namespace

Expected<QByteArray> packInspection(const NewInspection& inspection)
{
    const QJsonObject document{{u"id"_s, inspection.id},
                               {u"expected_type"_s, inspection.expectedType},
                               {u"seconds"_s, jsonNumber(inspection.seconds)},
                               {u"batch"_s, inspection.batchId},
                               {u"part_number"_s, inspection.partNumber},
                               {u"adjustment"_s, inspection.adjustmentId},
                               {u"library_version"_s, inspection.libraryVersion
                                                          ? QJsonValue(*inspection.libraryVersion)
                                                          : QJsonValue()},
                               {u"rates"_s, toDocument(inspection.rates)},
                               {u"verdict"_s, toDocument(inspection.verdict)},
                               {u"grasp"_s, toDocument(inspection.grasp)}};
    QByteArray recording;
    if (inspection.grasp.recording) {
        ASSIGN_OR_RETURN(recording, encodeInSeries(*inspection.grasp.recording));
    }
    const QByteArray bytes =
        ByteWriter().counted(QJsonDocument(document).toJson(QJsonDocument::Compact)).plain(recording).bytes();
    if (bytes.size() > mostUnpacked)
        return failure(ErrorCode::Usage,
                       {Words::say("The recording can't be kept: %1.")
                            .arg(Words::say("it is larger than %1 MB").arg(mostUnpacked / 1'000'000))});
    return qCompress(bytes, quickly);
}

Expected<NewInspection> unpackInspection(const QByteArray& bytes, qint64& memory)
{
    constexpr qsizetype countBytes = sizeof(quint64);
    const QByteArray plain = inflated(bytes, std::min(mostUnpacked, memory));
    if (plain.size() < countBytes)
        return noInspection();
    memory -= plain.size();
    const auto counted = qFromBigEndian<quint64>(plain.constData());
    if (counted > static_cast<quint64>(plain.size() - countBytes))
        return noInspection();
    const auto length = static_cast<qsizetype>(counted);
    const QJsonObject document = QJsonDocument::fromJson(plain.mid(countBytes, length)).object();
    NewInspection inspection;
    inspection.id = document.value(u"id"_s).toString();
    inspection.expectedType = document.value(u"expected_type"_s).toString();
    inspection.seconds = document.value(u"seconds"_s).toDouble();
    inspection.batchId = document.value(u"batch"_s).toString();
    inspection.partNumber = document.value(u"part_number"_s).toString();
    inspection.adjustmentId = document.value(u"adjustment"_s).toString();
    if (const QJsonValue version = document.value(u"library_version"_s); version.isDouble())
        inspection.libraryVersion = version.toInteger();
    inspection.rates = toRates(document.value(u"rates"_s).toObject());
    std::optional<Verdict> verdict = toVerdict(document.value(u"verdict"_s).toObject());
    std::optional<NewGrasp> grasp = toGrasp(document.value(u"grasp"_s).toObject());
    // Without a key it could be stored again and again.
    if (inspection.id.isEmpty() || !verdict || !grasp)
        return noInspection();
    inspection.verdict = *std::move(verdict);
    inspection.grasp = *std::move(grasp);
    if (const QByteArray recording = plain.mid(countBytes + length); !recording.isEmpty()) {
        ASSIGN_OR_RETURN(inspection.grasp.recording, decodeRecording(recording));
        memory -= static_cast<qint64>(inspection.grasp.recording->size()) * bytesOfSample;
    }
    return inspection;
}

} // namespace gripscope
