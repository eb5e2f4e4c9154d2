// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/sound/outcome_tones.h"

#include <QObject>

class QThread;

namespace gripscope {

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
