/*  SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "pressureTime.hpp"

riprap::SpeedRow riprap::timePressure(Gpu, const SpeedCase& c) { return timeIn<Gpu>(c); }
