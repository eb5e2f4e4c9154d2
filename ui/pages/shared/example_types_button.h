// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>

namespace gripscope {

class Workbench;

/// Offers the example types where nothing is enrolled, and is hidden where something is.
class ExampleTypesButton : public QPushButton {
    Q_OBJECT
public:
    explicit ExampleTypesButton(Workbench& workbench, QWidget* parent = nullptr);
};

/// Puts the example types into the library and tells the pages.
void loadExampleTypes(Workbench& workbench);

} // namespace gripscope
