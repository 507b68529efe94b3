// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/pic/transfer/gridToParticlesAll.hpp"

template class riprap::GridToParticles<riprap::Gpu, 3, float>;
template class riprap::GridToParticles<riprap::Gpu, 3, double>;
