// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"
#include "core/signal/recording/recording.h"
#include "ui/windows/dialog.h"

#include <QString>

#include <vector>

namespace gripscope {

class ElidedLabel;
class OverlayPlots;
struct OverlaidSqueeze;
class Workbench;

/// Fetches the recording of a stored squeeze, identifies it anew in the pool and brings it up on the Fit
/// page, from where a person gets back to the page `backTo`. Errors go to the message bar. Nothing happens
/// once `context` is gone.
void openStoredSqueeze(Workbench& workbench, QObject* context, const QString& graspId, const QString& title,
                       const QString& backTo);

/// A simulated squeeze of an object in SI (2 kHz, one second, PRBS of 20 +- 10 N, position noise of 5 um),
/// for pages that have to show something before there is a gripper. Its provenance says that it is simulated.
[[nodiscard]] Recording simulatedSqueeze(const MassDampingStiffness& object, std::uint64_t seed);

/// Stored squeezes over each other, each from the start of what is identified of it: to be looked at, saved
/// and copied.
class OverlayDialog : public Dialog {
    Q_OBJECT
public:
    struct Chosen {
        QString graspId, name;
    };
    /// The first OverlayPlots::most of them are fetched, and prepared in the pool; they are the first of
    /// `all`.
    OverlayDialog(Workbench& workbench, std::vector<Chosen> chosen, std::size_t all, QWidget* parent);

    [[nodiscard]] OverlayPlots* plots() const { return m_plots; }

private:
    void fetch(std::vector<Chosen> chosen, std::size_t all);
    void showSqueezes(std::vector<OverlaidSqueeze> squeezes, std::size_t all);

    Workbench* m_workbench;
    OverlayPlots* m_plots;
    ElidedLabel* m_state;
};

} // namespace gripscope
