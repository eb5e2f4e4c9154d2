// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/windows/dialog.h"

#include <QString>

#include <vector>

namespace gripscope {

class ElidedLabel;
class OverlayPlots;
struct OverlaidSqueeze;

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
