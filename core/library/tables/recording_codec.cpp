// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/packing/number_series.h"
#include "core/library/tables/packed_recording.h"
#include "core/signal/recording/recording_limits.h"

#include <QtEndian>

#include <cstring>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr QByteArrayView plainMagic = "GSRB";  ///< columns number by number, in little-endian bytes
constexpr QByteArrayView seriesMagic = "GSRP"; ///< columns as packedSeries()
constexpr std::uint16_t plainVersion = 1;
constexpr std::uint16_t chainVersion = 2;
constexpr std::uint16_t forceNoiseVersion = 3; ///< the chain states the noise of the force as well
constexpr std::uint16_t frictionVersion = 4;   ///< and the friction of the gripper itself
enum Columns : std::uint8_t { HasSequence = 1, HasStatus = 2 };

class Writer {
public:
    template <typename T>
    void put(T value)
    {
        char raw[sizeof(T)];
        qToLittleEndian(value, raw);
        m_bytes.append(raw, sizeof(T));
    }
    void put(const QString& text)
    {
        const QByteArray utf8 = text.toUtf8();
        put(std::uint32_t(utf8.size()));
        m_bytes.append(utf8);
    }
    template <typename T>
    void put(const std::vector<T>& values)
    {
        if (values.empty()) // it has no address to copy from
            return;
        const qsizetype start = m_bytes.size();
        m_bytes.resize(start + qsizetype(values.size() * sizeof(T)));
        qToLittleEndian<T>(values.data(), qsizetype(values.size()), m_bytes.data() + start);
    }
    void raw(QByteArrayView bytes) { m_bytes.append(bytes); }
    [[nodiscard]] QByteArray take() { return std::move(m_bytes); }

private:
    QByteArray m_bytes;
};

/// Reads as long as there are bytes; after the first shortage everything is zero and ok() is false.
class Reader {
public:
    explicit Reader(const QByteArray& bytes) : m_bytes(bytes) {}
    template <typename T>
    T get()
    {
        if (!has(sizeof(T)))
            return T{};
        const T value = qFromLittleEndian<T>(m_bytes.constData() + m_at);
        m_at += qsizetype(sizeof(T));
        return value;
    }
    QString text()
    {
        const auto size = get<std::uint32_t>();
        if (!has(size))
            return {};
        m_at += size;
        return QString::fromUtf8(m_bytes.constData() + m_at - size, size);
    }
    template <typename T>
    void get(std::vector<T>& values, std::uint64_t count)
    {
        // The division keeps a damaged count from overflowing or from asking for more memory than there are
        // bytes.
        if (!m_ok || count > std::uint64_t(m_bytes.size() - m_at) / sizeof(T)) {
            m_ok = false;
            return;
        }
        values.resize(count);
        if (count == 0)
            return;
        qFromLittleEndian<T>(m_bytes.constData() + m_at, qsizetype(count), values.data());
        m_at += qsizetype(count * sizeof(T));
    }
    /// One of takeDoubles(), takeIntegers().
    template <typename T, typename Take>
    void series(std::vector<T>& values, std::uint64_t count, const Take& take)
    {
        QByteArrayView rest = QByteArrayView(m_bytes).sliced(m_at);
        auto taken = take(rest, count);
        m_ok = m_ok && taken;
        if (!m_ok)
            return;
        m_at = m_bytes.size() - rest.size();
        values.assign(taken->begin(), taken->end());
    }
    [[nodiscard]] bool ok() const { return m_ok; }
    [[nodiscard]] bool atEnd() const { return m_at == m_bytes.size(); }

private:
    bool has(std::uint64_t size)
    {
        m_ok = m_ok && size <= std::uint64_t(m_bytes.size() - m_at);
        return m_ok;
    }
    const QByteArray& m_bytes;
    qsizetype m_at = 0;
    bool m_ok = true;
};

std::uint8_t holdCode(const std::optional<ForceHold>& hold)
{
    return !hold ? 0 : *hold == ForceHold::Zero ? 1 : 2;
}

void putChain(Writer& out, const MeasuringChain& chain)
{
    out.put(chain.forceLagUncertainty_s);
    out.put(chain.forceScaleUncertainty);
    out.put(chain.positionScaleUncertainty);
    out.put(chain.frameCompliance);
    out.put(chain.frameComplianceUncertainty);
    if (chain.forceNoiseDeviation != 0 || chain.friction)
        out.put(chain.forceNoiseDeviation);
    if (chain.friction) {
        out.put(chain.friction->value);
        out.put(chain.friction->standardError);
    }
    out.put(std::uint8_t(chain.baseline ? 1 : 0));
    if (!chain.baseline)
        return;
    for (const double value : chain.baseline->parameters)
        out.put(value);
    for (const double value : chain.baseline->standardErrors)
        out.put(value);
}

MeasuringChain getChain(Reader& in, std::uint16_t version)
{
    MeasuringChain chain;
    chain.forceLagUncertainty_s = in.get<double>();
    chain.forceScaleUncertainty = in.get<double>();
    chain.positionScaleUncertainty = in.get<double>();
    chain.frameCompliance = in.get<double>();
    chain.frameComplianceUncertainty = in.get<double>();
    if (version >= forceNoiseVersion)
        chain.forceNoiseDeviation = in.get<double>();
    if (version >= frictionVersion) {
        chain.friction.emplace();
        chain.friction->value = in.get<double>();
        chain.friction->standardError = in.get<double>();
    }
    if (in.get<std::uint8_t>() == 0)
        return chain;
    chain.baseline.emplace();
    for (double& value : chain.baseline->parameters)
        value = in.get<double>();
    for (double& value : chain.baseline->standardErrors)
        value = in.get<double>();
    return chain;
}

tl::unexpected<Error> damaged(const QString& reason)
{
    return failure(ErrorCode::StorageCorrupt, {Words::tr("A recording"), reason});
}

/// All that stands before the columns, and how many and which there are.
void putHead(Writer& out, const Recording& recording)
{
    // The oldest layout that holds it all, so that earlier programs read on what they can.
    const bool hasChain = !(recording.chain == MeasuringChain());
    const bool statesForceNoise = recording.chain.forceNoiseDeviation != 0;
    out.put(recording.chain.friction ? frictionVersion
            : statesForceNoise       ? forceNoiseVersion
            : hasChain               ? chainVersion
                                     : plainVersion);
    out.put(recording.sampleTime_s);
    out.put(recording.forceLag_s);
    out.put(holdCode(recording.hold));
    out.put(recording.forceUnit);
    out.put(recording.positionUnit);
    out.put(std::uint32_t(recording.provenance.size()));
    for (auto it = recording.provenance.cbegin(); it != recording.provenance.cend(); ++it) {
        out.put(it.key());
        out.put(it.value());
    }
    out.put(std::uint64_t(recording.size()));
    out.put(std::uint8_t((recording.sequence.empty() ? 0 : HasSequence) |
                         (recording.status.empty() ? 0 : HasStatus)));
}

void putTail(Writer& out, const Recording& recording)
{
    if (!(recording.chain == MeasuringChain()))
        putChain(out, recording.chain);
}

Expected<void> requireInRange(const Recording& recording)
{
    if (const std::optional<Finding> reason = outOfRange(recording))
        return failure(ErrorCode::Usage,
                       {Words::tr("The recording can't be kept: %1.").arg(reason->describe())});
    return {};
}

template <typename T>
std::vector<std::uint64_t> wholes(const std::vector<T>& values)
{
    return {values.begin(), values.end()};
}

void getColumns(Reader& in, Recording& recording, std::uint64_t samples, std::uint8_t columns)
{
    for (auto* column : {&recording.time_s, &recording.force, &recording.position})
        in.get(*column, samples);
    if (columns & HasSequence)
        in.get(recording.sequence, samples);
    if (columns & HasStatus)
        in.get(recording.status, samples);
}

void getSeries(Reader& in, Recording& recording, std::uint64_t samples, std::uint8_t columns)
{
    for (auto* column : {&recording.time_s, &recording.force, &recording.position})
        in.series(*column, samples, takeDoubles);
    if (columns & HasSequence)
        in.series(recording.sequence, samples, takeIntegers);
    if (columns & HasStatus)
        in.series(recording.status, samples, takeIntegers);
}

} // namespace

Expected<QByteArray> encodeRecording(const Recording& recording)
{
    RETURN_IF_ERROR(requireInRange(recording));
    Writer out;
    out.raw(plainMagic);
    putHead(out, recording);
    out.put(recording.time_s);
    out.put(recording.force);
    out.put(recording.position);
    out.put(recording.sequence);
    out.put(recording.status);
    putTail(out, recording);
    return out.take();
}

Expected<QByteArray> encodeInSeries(const Recording& recording)
{
    RETURN_IF_ERROR(requireInRange(recording));
    Writer out;
    out.raw(seriesMagic);
    putHead(out, recording);
    for (const auto* column : {&recording.time_s, &recording.force, &recording.position})
        out.raw(packedSeries(*column));
    if (!recording.sequence.empty())
        out.raw(packedSeries(recording.sequence));
    if (!recording.status.empty())
        out.raw(packedSeries(wholes(recording.status)));
    putTail(out, recording);
    return out.take();
}

Expected<Recording> decodeRecording(const QByteArray& bytes)
{
    const bool inSeries = bytes.startsWith(seriesMagic);
    if (!inSeries && !bytes.startsWith(plainMagic))
        return damaged(Words::tr("it does not begin like one"));
    const QByteArray body = bytes.mid(plainMagic.size());
    Reader in(body);
    const auto version = in.get<std::uint16_t>();
    if (version < plainVersion || version > frictionVersion)
        return damaged(Words::tr("its layout has version %1; this program knows up to %2")
                           .arg(version)
                           .arg(frictionVersion));
    Recording recording;
    recording.sampleTime_s = in.get<double>();
    recording.forceLag_s = in.get<double>();
    const auto hold = in.get<std::uint8_t>();
    if (hold > 2)
        return damaged(Words::tr("its hold is not known"));
    if (hold > 0)
        recording.hold = hold == 1 ? ForceHold::Zero : ForceHold::First;
    recording.forceUnit = in.text();
    recording.positionUnit = in.text();
    const auto facts = in.get<std::uint32_t>();
    if (facts > mostFacts)
        return damaged(Words::tr("more than %1 facts stand beside its samples").arg(mostFacts));
    for (auto left = facts; left > 0 && in.ok(); --left) {
        const QString key = in.text();
        recording.provenance.insert(key, in.text());
    }
    const auto samples = in.get<std::uint64_t>();
    const auto columns = in.get<std::uint8_t>();
    if (samples > mostSamples)
        return damaged(Words::tr("it is shorter or longer than it says"));
    (inSeries ? getSeries : getColumns)(in, recording, samples, columns);
    if (version >= chainVersion)
        recording.chain = getChain(in, version);
    if (!in.ok() || !in.atEnd())
        return damaged(Words::tr("it is shorter or longer than it says"));
    if (const std::optional<Finding> reason = outOfRange(recording))
        return damaged(reason->describe());
    return recording;
}

} // namespace gripscope
