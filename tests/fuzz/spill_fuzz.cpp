// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/spill/spilled_inspection.h"
#include "core/signal/recording/recording_limits.h"
#include "tests/fuzz/fuzzing.h"

// Inspections that waited to be stored: what is read has a key, a recording in range, and is kept again.
// Inputs are the bytes before they are deflated, or else nothing would get behind zlib.

namespace gripscope {

// The tables of these names come with every estimator and the whole verdict: stand-ins.

namespace {

constexpr const char* estimators[] = {"arx", "arx-mean-force", "arx221", "iv", "oe", "duffing", "periodic"};
constexpr const char* kinds[] = {"type", "unknown", "inconclusive", "invalid"};
constexpr const char* validities[] = {"valid", "suspect", "invalid"};

template <typename Value, std::size_t Count>
std::optional<Value> named(const QString& text, const char* const (&names)[Count])
{
    for (std::size_t i = 0; i < Count; ++i)
        if (text == QLatin1String(names[i]))
            return static_cast<Value>(i);
    return {};
}

} // namespace

QString toString(Estimator estimator)
{
    return QLatin1String(estimators[static_cast<int>(estimator)]);
}

std::optional<Estimator> estimatorFromString(const QString& text)
{
    return named<Estimator>(text, estimators);
}

QString toString(VerdictKind kind)
{
    return QLatin1String(kinds[static_cast<int>(kind)]);
}

std::optional<VerdictKind> verdictKindFromString(const QString& text)
{
    return named<VerdictKind>(text, kinds);
}

QString toString(ValidityVerdict verdict)
{
    return QLatin1String(validities[static_cast<int>(verdict)]);
}

} // namespace gripscope

using namespace gripscope;
using namespace gripscope::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const QByteArray bytes = bytesOf(data, size);
    qint64 memory = mostOfOneFile;
    const Expected<NewInspection> raw = unpackInspection(bytes, memory);
    require(raw || raw.error().code == ErrorCode::StorageCorrupt);
    const Expected<NewInspection> read = unpackInspection(qCompress(bytes, 0), memory);
    if (!read) {
        require(read.error().code == ErrorCode::StorageCorrupt);
        return 0;
    }
    require(!read->id.isEmpty());
    require(!read->grasp.recording || !outOfRange(*read->grasp.recording));
    const Expected<QByteArray> again = packInspection(*read);
    require(again && unpackInspection(*again, memory));
    return 0;
}
