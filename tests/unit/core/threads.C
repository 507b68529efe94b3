/*  One thread unless OMP_NUM_THREADS says otherwise: the scenes here are small, and barriers of a
    busy machine would take the time. Tests of threads set their number themselves.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <cstdlib>
#include <gtest/gtest.h>
#include <omp.h>

namespace
{

class OneThread : public testing::Environment
{
public:
    void SetUp() override { if (!std::getenv("OMP_NUM_THREADS")) omp_set_num_threads(1); }
};

const testing::Environment* const oneThread = testing::AddGlobalTestEnvironment(new OneThread);

} // namespace
