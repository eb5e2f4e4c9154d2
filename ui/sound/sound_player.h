// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/inspect/inspect_session.h"

#include <QByteArray>
#include <QObject>

#include <vector>

class QThread;

namespace gripscope {

/// What the program lets be heard: a verdict, a batch that is whole, a code that no type has; that a squeeze
/// is about to begin by itself.
enum class Sound {
    AsExpected,
    OtherType,
    Unknown,
    Inconclusive,
    NotValid,
    BatchWhole,
    CodeUnknown,
    Suspect,
    Countdown,
    DoesNotConform
};
/// A verdict on a suspect measurement sounds like no other, whatever it says of the part.
[[nodiscard]] Sound soundOf(InspectionOutcome outcome, bool suspect = false);

/// One after another; frequency 0 is a rest.
struct Tone {
    double frequency_Hz = 0;
    double seconds = 0;
};
/// Told apart by their number and direction, not by pitch alone: one short high tone is as expected, whatever
/// is not has two or more; a measurement that is not valid is one long low tone, a suspect one two low tones;
/// a countdown is two very high ones at once, again each half second. None is over half a second.
[[nodiscard]] std::vector<Tone> tonesOf(Sound sound);

inline constexpr int soundRate_Hz = 48000;
/// Signed 16-bit samples of one channel at soundRate_Hz; each tone is faded in and out, so that none clicks.
[[nodiscard]] QByteArray samplesOf(const std::vector<Tone>& tones);

/// Lets sounds be heard. The audio system is asked on a thread of its own, at the
/// first sound: it may be slow, hang, or not be there at all, and the screen never waits for it. Without an
/// audio device there is silence. A new sound ends the one before.
class SoundPlayer : public QObject {
    Q_OBJECT
public:
    explicit SoundPlayer(QObject* parent = nullptr);
    ~SoundPlayer() override;
    void play(Sound sound);

signals:
    void playing(Sound sound); ///< it was handed to the audio system, there or not

private:
    class Output;
    QThread* m_thread = nullptr;
    Output* m_output = nullptr; ///< lives on the thread
};

} // namespace gripscope
