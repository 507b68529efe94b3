// SPDX-License-Identifier: GPL-3.0-or-later
/*  Dictionaries that are edited while a run goes on. */

#include "editedFiles.H"
#include "scratchCase.hpp"

#include <chrono>
#include <gtest/gtest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <thread>

using namespace Foam;

namespace
{
    struct EditedCase : ScratchCase
    {
        explicit EditedCase(const std::string& control)
        :
            ScratchCase("maxCo 0.5; " + control)
        {
            writeDict("constant/g", "value 1;");
            writeDict("constant/other", "value 1;");
            writeDict("constant/gone", "value 1;");
        }

        //- As seen by file systems that count seconds
        void edit(const std::string& name, double later) const
        {
            const timespec times[2] = {{0, UTIME_OMIT},
                {std::time(nullptr) + std::time_t(later), 0}};
            ASSERT_EQ(utimensat(AT_FDCWD, (path()/name).c_str(), times, 0), 0);
        }
    };

    std::string warning(editedFiles& files)
    {
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        files.warn();
        return testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
    }
}

//- Each edit once, none within a second of the last look, and only where a run looks for them
TEST(EditedFiles, areToldOnce)
{
    EditedCase c("runTimeModifiable yes;"), fixed("runTimeModifiable no;");
    editedFiles files(c.time()), ofFixed(fixed.time());
    for (const EditedCase* edited : {&c, &fixed}) edited->edit("constant/g", 10);
    EXPECT_TRUE(rm(c.path()/"constant/gone"));
    const_cast<dictionary&>(c.time().controlDict()).set("maxCo", 0.7);
    const_cast<dictionary&>(c.time().controlDict()).set("maxDeltaT", 1);
    EXPECT_EQ(warning(files), "");
    std::this_thread::sleep_for(std::chrono::milliseconds(1010));
    const std::string said(warning(files));
    EXPECT_TRUE(holds(said,
        "constant/g has been edited. It is read once: the run goes on with what "
        "it read at its start; a run that begins or continues reads it again"))
        << said;
    EXPECT_TRUE(holds(said, "system/controlDict has been edited. Of (maxCo maxDeltaT) the run goes "
                            "on with what it read at its start; a run that begins or continues "
                            "reads them again")) << said;
    EXPECT_FALSE(holds(said, "constant/other")) << said;
    EXPECT_FALSE(holds(said, "constant/gone")) << said;
    EXPECT_EQ(warning(files), "");
    EXPECT_EQ(warning(ofFixed), "");
}
