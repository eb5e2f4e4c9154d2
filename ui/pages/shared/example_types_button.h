// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>

namespace gripscope {

class Workbench;

/// The paper's cans, and made-up parts that yield.
enum class Examples { Cans, Simulated };

/// Offers example types where nothing is enrolled, and is hidden where something is.
class ExampleTypesButton : public QPushButton {
    Q_OBJECT
public:
    ExampleTypesButton(Workbench& workbench, Examples examples, QWidget* parent = nullptr);
};

/// Puts the example types into the library and tells the pages. Simulated ones are squeezed first, in the
/// pool.
void loadExampleTypes(Workbench& workbench, Examples examples);

} // namespace gripscope
