/*  Scenes with solids smaller than those that riprap takes: of them the experiment `size` asks what
    would come

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#define RIPRAP_SMALLEST_SOLID 0.25
#include "solvers/pic/createPicScene.C"
