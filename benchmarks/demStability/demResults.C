/*  SPDX-License-Identifier: GPL-3.0-or-later */
#include "demResults.hpp"

#include <cstdio>
#include <stdexcept>

namespace riprap
{

void DemResults::add(const DemResult& r)
{
    std::printf("%-8s %-34s %-15s %-46s %-10.4g %-10.4g %s\n", r.test.c_str(), r.scene.c_str(),
        r.integrator.c_str(), r.quantity.c_str(), r.measured, r.theory, r.note.c_str());
    std::fflush(stdout);
    rows_.push_back(r);
}

void DemResults::write() const
{
    if (csv_.empty()) return;
    std::FILE* f = std::fopen(csv_.c_str(), "w");
    if (!f) throw std::runtime_error("cannot write " + csv_);
    std::fprintf(f, "test,scene,integrator,quantity,measured,theory,note\n");
    for (const DemResult& r : rows_)
    {
        std::fprintf(f, "%s,\"%s\",%s,\"%s\",%.5g,", r.test.c_str(), r.scene.c_str(),
            r.integrator.c_str(), r.quantity.c_str(), r.measured);
        if (!std::isnan(r.theory)) std::fprintf(f, "%.5g", r.theory);
        std::fprintf(f, ",\"%s\"\n", r.note.c_str());
    }
    std::fclose(f);
}

} // namespace riprap
