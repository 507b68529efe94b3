/*  SPDX-License-Identifier: GPL-3.0-or-later  */
#include "experiments.hpp"

#include <cstdio>
#include <stdexcept>

namespace riprap
{

void CouplingRows::add(const CouplingRow& r)
{
    rows_.push_back(r);
    std::printf("%-8s %-22s %-13s %-7s %-28s %8.4g: %10.4g  theory %8.4g  %s\n", r.test.c_str(),
        r.coupling.c_str(), r.force.c_str(), r.body.c_str(), r.quantity.c_str(), r.setting,
        r.measured, r.theory, r.note.c_str());
    std::fflush(stdout);
}

void CouplingRows::write() const
{
    if (csv_.empty()) return;
    std::FILE* out = std::fopen(csv_.c_str(), "w");
    if (!out) throw std::runtime_error("cannot write " + csv_);
    std::fprintf(out, "test,coupling,force,body,quantity,setting,measured,theory,note\n");
    for (const CouplingRow& r : rows_)
        std::fprintf(out, "%s,%s,%s,%s,%s,%.6g,%.6g,%.6g,\"%s\"\n", r.test.c_str(),
            r.coupling.c_str(), r.force.c_str(), r.body.c_str(), r.quantity.c_str(), r.setting,
            r.measured, r.theory, r.note.c_str());
    std::fclose(out);
}

} // namespace riprap
