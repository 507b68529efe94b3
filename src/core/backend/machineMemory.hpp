/*  Memory of this machine, and what of it is free: what is asked for is compared with that before
    it is allocated.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstddef>

namespace riprap
{

//- Bytes that programs can still take, within a container's limit; infinity where the system does
//  not say
double freeMemory();

//- Bytes of memory that there are, within a container's limit; infinity where the system does not
//  say
double machineMemory();

//- Has the system provide memory that is not in use yet, by all threads at once and in large pages
//  where there are any: one thread would fault it in page by page. What it holds is lost
void touchMemory(void* memory, std::size_t bytes);

} // namespace riprap
