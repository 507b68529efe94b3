// SPDX-License-Identifier: GPL-3.0-or-later

#include "picTransfer.hpp"
#include "picPaths.hpp"
