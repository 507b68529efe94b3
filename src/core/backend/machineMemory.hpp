/*  Memory of this machine, and what of it is free: what is asked for is compared with that before
    it is allocated.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

namespace riprap
{

//- Bytes that programs can still take, within a container's limit; infinity where the system does
//  not say
double freeMemory();

//- Bytes of memory that there are, within a container's limit; infinity where the system does not
//  say
double machineMemory();

} // namespace riprap
