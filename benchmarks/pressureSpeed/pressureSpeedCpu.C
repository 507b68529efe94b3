/*  SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "pressureTime.hpp"

riprap::SpeedRow riprap::timePressure(Cpu, const SpeedCase& c) { return timeIn<Cpu>(c); }
