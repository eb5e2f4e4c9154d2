// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sound/sound_player.h"

#include <QAudioDevice>
#include <QAudioSink>
#include <QBuffer>
#include <QMediaDevices>
#include <QThread>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace gripscope {

namespace {
constexpr double loudness = 0.35; ///< of full scale: heard beside a machine, not felt
constexpr double fade_s = 0.006;
} // namespace

Sound soundOf(InspectionOutcome outcome, bool suspect)
{
    if (suspect && outcome != InspectionOutcome::NotValid)
        return Sound::Suspect;
    switch (outcome) {
    case InspectionOutcome::AsExpected:
        return Sound::AsExpected;
    case InspectionOutcome::OtherType:
        return Sound::OtherType;
    case InspectionOutcome::Unknown:
        return Sound::Unknown;
    case InspectionOutcome::Inconclusive:
        return Sound::Inconclusive;
    case InspectionOutcome::DoesNotConform:
        return Sound::DoesNotConform;
    case InspectionOutcome::NotValid:
        break;
    }
    return Sound::NotValid;
}

std::vector<Tone> tonesOf(Sound sound)
{
    switch (sound) {
    case Sound::AsExpected:
        return {{1320, 0.09}};
    case Sound::OtherType:
        return {{880, 0.12}, {0, 0.03}, {587, 0.18}};
    case Sound::Unknown:
        return {{880, 0.09}, {0, 0.04}, {880, 0.09}, {0, 0.04}, {880, 0.09}};
    case Sound::Inconclusive:
        return {{740, 0.1}, {0, 0.05}, {740, 0.1}};
    case Sound::NotValid:
        return {{294, 0.4}};
    case Sound::DoesNotConform: // down, and further than another type
        return {{988, 0.09}, {0, 0.03}, {740, 0.09}, {0, 0.03}, {494, 0.16}};
    case Sound::BatchWhole:
        return {{784, 0.1}, {988, 0.1}, {1319, 0.2}};
    case Sound::Suspect:
        return {{294, 0.14}, {0, 0.06}, {294, 0.2}};
    case Sound::Countdown:
        return {{1760, 0.05}, {0, 0.03}, {1760, 0.05}};
    case Sound::CodeUnknown:
        return {{392, 0.1}, {0, 0.05}, {294, 0.15}};
    }
    return {};
}

QByteArray samplesOf(const std::vector<Tone>& tones)
{
    std::vector<std::int16_t> samples;
    for (const Tone& tone : tones) {
        const auto count = static_cast<std::size_t>(std::llround(tone.seconds * soundRate_Hz));
        for (std::size_t i = 0; i < count; ++i) {
            const double at_s = static_cast<double>(i) / soundRate_Hz;
            const double left_s = tone.seconds - at_s;
            const double envelope = std::clamp(std::min(at_s, left_s) / fade_s, 0.0, 1.0);
            const double value = std::sin(2 * std::numbers::pi * tone.frequency_Hz * at_s);
            samples.push_back(static_cast<std::int16_t>(std::lround(loudness * envelope * value * 32767)));
        }
    }
    return {reinterpret_cast<const char*>(samples.data()),
            static_cast<qsizetype>(samples.size() * sizeof(std::int16_t))};
}

/// The side of the audio system.
class SoundPlayer::Output : public QObject {
public:
    void play(const QByteArray& samples)
    {
        m_sink.reset();
        const QAudioDevice device = QMediaDevices::defaultAudioOutput();
        if (device.isNull())
            return; // silence
        QAudioFormat format;
        format.setSampleRate(soundRate_Hz);
        format.setChannelCount(1);
        format.setSampleFormat(QAudioFormat::Int16);
        if (!device.isFormatSupported(format))
            return;
        m_samples.close();
        m_samples.setData(samples);
        m_samples.open(QIODevice::ReadOnly);
        m_sink = std::make_unique<QAudioSink>(device, format);
        m_sink->start(&m_samples);
    }

private:
    QBuffer m_samples;
    std::unique_ptr<QAudioSink> m_sink;
};

SoundPlayer::SoundPlayer(QObject* parent) : QObject(parent) {}

SoundPlayer::~SoundPlayer()
{
    if (!m_thread)
        return;
    m_thread->quit();
    // An audio system that hangs is left behind with the thread: the program must not hang with it.
    constexpr unsigned long patience_ms = 500;
    if (m_thread->wait(patience_ms))
        delete m_thread;
}

void SoundPlayer::play(Sound sound)
{
    if (!m_thread) {
        m_thread = new QThread;
        m_output = new Output;
        m_output->moveToThread(m_thread);
        connect(m_thread, &QThread::finished, m_output, &QObject::deleteLater);
        m_thread->start();
    }
    QMetaObject::invokeMethod(
        m_output, [output = m_output, samples = samplesOf(tonesOf(sound))] { output->play(samples); },
        Qt::QueuedConnection);
    emit playing(sound);
}

} // namespace gripscope
