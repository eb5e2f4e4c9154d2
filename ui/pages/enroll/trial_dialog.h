// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/type_record.h"
#include "core/recognition/verdict/verdict.h"
#include "ui/windows/dialog.h"

#include <memory>

namespace gripscope {

/// What a part of a type, approved or not, would be called: a squeeze that is neither stored nor counted, and
/// says so.
class TrialDialog : public Dialog {
    Q_OBJECT
public:
    TrialDialog(Workbench& workbench, const QString& type, const Recipe& recipe, QWidget* parent = nullptr);
    ~TrialDialog() override;
    void done(int result) override;

private:
    void build();
    struct Private;
    std::unique_ptr<Private> d;
};

/// "Trial: it would be A (posterior 0.9998)." and why.
[[nodiscard]] QString trialWords(const Verdict& verdict);

} // namespace gripscope
