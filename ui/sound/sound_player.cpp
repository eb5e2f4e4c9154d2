// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sound/sound_player.h"

#include <QAudioDevice>
#include <QAudioSink>
#include <QBuffer>
#include <QMediaDevices>
#include <QThread>

#include <memory>

namespace gripscope {

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
