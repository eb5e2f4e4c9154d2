// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/ledger/library_witness.h"
#include "core/library/library.h"
#include "tests/core/library/test_server.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <optional>

namespace gripscope::test {

using namespace Qt::StringLiterals;

/// The value, or the end of the test function's sense: prints why and stops the program.
template <typename T>
T valueOf(Expected<T> result)
{
    if (!result)
        qFatal("%s", qPrintable(result.error().describe()));
    if constexpr (!std::is_void_v<T>)
        return std::move(*result);
}

/// A recording with everything that can be in one, and numbers that only a bit for bit copy keeps.
inline Recording awkwardRecording(std::size_t samples = 500)
{
    Recording recording;
    recording.sampleTime_s = 0.0005;
    recording.forceUnit = u"N"_s;
    recording.positionUnit = u"µm"_s;
    recording.hold = ForceHold::Zero;
    recording.forceLag_s = 1.0 / 3e4;
    for (std::size_t i = 0; i < samples; ++i) {
        recording.time_s.push_back(double(i) / 2000 + 1e-17);
        recording.force.push_back(std::sin(double(i)) * 1e-300);
        recording.position.push_back(i % 2 ? -0.0 : 5e-324);
        recording.sequence.push_back(i + 0xfffffffffffff000u);
        recording.status.push_back(std::uint16_t(0xff00 + i));
    }
    recording.provenance = {
        {u"device"_s, u"virtual:"_s}, {u"operator"_s, u"Zoë \"Z\", ünïcode"_s}, {u""_s, u""_s}};
    return recording;
}

inline Estimate anEstimate(double m = 0.04, double b = 43, double k = 9990)
{
    Estimate estimate;
    estimate.estimator = Estimator::OutputError;
    estimate.status = EstimateStatus::Converged;
    estimate.parameters = MassDampingStiffness{m, b, k};
    Eigen::Matrix3d covariance;
    covariance << 1e-8, 1e-6, 1e-5, 1e-6, 1e-2, 0.1, 1e-5, 0.1, 1.0 / 3;
    estimate.covariance = covariance;
    estimate.fit.simulationPercent = 91.25;
    return estimate;
}

inline NewGrasp aGrasp(const QString& typeId, double k = 9990)
{
    NewGrasp grasp;
    grasp.typeId = typeId;
    grasp.recording = awkwardRecording();
    grasp.estimates = {anEstimate(0.04, 43, k), anEstimate(0.02, 22, 5000)};
    grasp.forceUnit = u"N"_s;
    grasp.positionUnit = u"m"_s;
    grasp.source = u"virtual:"_s;
    grasp.operatorName = u"Ada"_s;
    grasp.identification = {{u"recommended"_s, u"oe"_s}};
    return grasp;
}

/// k, k1/k and tau, without a mass, with numbers that only a copy keeps.
inline DeterminedQuantities someQuantities()
{
    DeterminedQuantities determined{
        {{TypeQuantity::Stiffness, TypeQuantity::RelaxingShare, TypeQuantity::RelaxationTime}},
        LogVector(3),
        {}};
    determined.log << 1.0 / 3, -1e-17, -3.0000000000000004;
    determined.covariance = LogMatrix::Identity(3, 3) / 7;
    (*determined.covariance)(0, 1) = (*determined.covariance)(1, 0) = -1e-300;
    return determined;
}

inline NewInspection anInspection(VerdictKind kind = VerdictKind::Type, const QString& type = u"A"_s)
{
    NewInspection inspection;
    inspection.grasp = aGrasp({});
    inspection.verdict.kind = kind;
    inspection.verdict.type = kind == VerdictKind::Type ? type : QString();
    inspection.verdict.nearest = type;
    inspection.verdict.posterior = {{u"A"_s, 0.75}, {u"B"_s, 0.25}};
    inspection.verdict.distance = 1.5;
    inspection.verdict.gate = 14.25;
    inspection.verdict.samplesUsed = 500;
    inspection.verdict.reasons = {u"First."_s, u"Second."_s};
    inspection.expectedType = u"A"_s;
    inspection.seconds = 1.0;
    return inspection;
}

/// A library file in a folder that goes away with it; or a database of its own on the server that the tests
/// run on: empty where its address is asked for first, a copy of one that was just made where it is opened.
struct LibraryFolder {
    LibraryFolder() = default;
    ~LibraryFolder()
    {
        if (!onServer() || m_database)
            QFile::remove(witnessFile(file()));
    }
    LibraryFolder(const LibraryFolder&) = delete;
    LibraryFolder& operator=(const LibraryFolder&) = delete;

    QTemporaryDir folder;
    [[nodiscard]] QString file() const
    {
        return onServer() ? database([] { return u"template0"_s; }) : folder.filePath(u"library.db"_s);
    }
    std::unique_ptr<Library> open() const
    {
        const auto prepared = [] {
            return preparedDatabase([](const QString& place) { valueOf(Library::open(place)); });
        };
        return valueOf(Library::open(onServer() ? database(prepared) : file()));
    }

private:
    template <typename Name>
    [[nodiscard]] QString database(const Name& copyOf) const
    {
        if (!m_database)
            m_database.emplace(copyOf());
        return m_database->place();
    }
    mutable std::optional<TestDatabase> m_database;
};

inline void writeBytes(const QString& name, const QByteArray& bytes)
{
    QFile file(name);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("%s", qPrintable(file.errorString()));
}

inline QByteArray bytesOf(const QString& name)
{
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace gripscope::test
