// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/pic/transfer/gridToParticlesAll.hpp"

template class riprap::GridToParticles<riprap::Gpu, 2, float>;
template class riprap::GridToParticles<riprap::Gpu, 2, double>;
