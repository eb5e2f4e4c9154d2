// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/inspect/inspect_session.h"
#include "ui/pages/page.h"
#include "ui/sound/sound_player.h"

#include <memory>

class QBoxLayout;

namespace gripscope {

/// One part after another: squeeze, and read the verdict from 3 m. Space squeezes, and so does the gripper's
/// own button; a scanner chooses what is expected.
class InspectPage : public Page {
    Q_OBJECT
public:
    explicit InspectPage(Workbench& workbench, QWidget* parent = nullptr);
    ~InspectPage() override;

    [[nodiscard]] QString id() const override;
    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString iconName() const override;
    void setActive(bool active) override;
    void prepareTour() override;
    [[nodiscard]] bool tourReady() const override;

protected:
    void focusInEvent(QFocusEvent* event) override; ///< a click beside the buttons: shows what Space does

private:
    void buildTop(QBoxLayout* column);
    void buildVerdict(QBoxLayout* column);
    void buildActions(QBoxLayout* column);
    void listenToPeople(); ///< to the scanner, the key and the gripper's button
    void followTick();
    void takeButton();
    void expect(const QString& type);
    void focusSqueeze();
    [[nodiscard]] bool isOurs(const QWidget* focused) const; ///< the keys go where Space squeezes
    void squeeze();                                          ///< a person asked for it
    [[nodiscard]] bool startSqueeze();                       ///< whoever asked for it
    void followAutomatic();
    [[nodiscard]] bool attended() const; ///< in view, and nothing asks
    /// A batch is complete, and nobody has said yet that parts go on without one.
    [[nodiscard]] bool batchIsOver() const;
    void askToGoOn();
    void askToVoid();
    void takeScan(const QString& text); ///< a type's code, or the part's own number
    void refresh();
    void refreshPart();
    void refreshBatchEnd();
    /// Once: as it was when the program, or this window, ended; one that lacks its approval, with that.
    void recallExpected();
    void forgetExpected();
    [[nodiscard]] bool isInUse(const QString& type) const; ///< approved or not
    [[nodiscard]] int callAfter() const; ///< so many invalid squeezes in a row, then a supervisor
    void refreshExpected();
    void refreshActions();
    void refreshVerdict();
    void refreshDrift();
    void play(Sound sound); ///< unless it was switched off
    [[nodiscard]] bool isPast(const InspectSession::Result& result);
    void tellResult(const InspectSession::Result& result);
    void editRates();
    [[nodiscard]] QString squeezeText(bool commandable) const;
    [[nodiscard]] QString timeText() const; ///< how long a squeeze takes
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
