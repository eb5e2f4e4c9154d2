# SPDX-License-Identifier: GPL-3.0-or-later
# Stands for a test that cannot run here, and fails: cmake -DPACKAGES="xvfb xauth" -P missing_packages.cmake
message(FATAL_ERROR "This test was not run: it takes the packages ${PACKAGES}, which are not all installed. "
  "packaging/install_dependencies.sh test installs them; then configure again (packaging/test.sh does both).")
