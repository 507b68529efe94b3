// SPDX-License-Identifier: GPL-3.0-or-later

#include "resultTable.hpp"

#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace riprap
{

namespace
{

std::string show(double v)
{
    if (std::isnan(v)) return "";
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", v);
    return text;
}

} // namespace

void ResultTable::add(const Result& r)
{
    if (rows_.empty())
        std::printf("%-9s %-12s %5s %-11s %-18s %-13s %-40s %10s %10s  %s\n", "test", "kernel",
            "h/dp", "integrator", "terms", "walls", "quantity", "measured", "theory", "note");
    std::printf("%-9s %-12s %5s %-11s %-18s %-13s %-40s %10s %10s  %s\n", r.test.c_str(),
        r.kernel.c_str(), show(r.ratio).c_str(), r.integrator.c_str(), r.terms.c_str(),
        r.walls.c_str(), r.quantity.c_str(), show(r.measured).c_str(), show(r.theory).c_str(),
        r.note.c_str());
    std::fflush(stdout);
    rows_.push_back(r);
}

void ResultTable::write() const
{
    if (csv_.empty()) return;
    std::ofstream out(csv_);
    if (!out) throw std::runtime_error("cannot write " + csv_);
    out << "test,kernel,ratio,integrator,terms,walls,quantity,measured,theory,note\n";
    for (const Result& r : rows_)
        out << r.test << ',' << r.kernel << ',' << show(r.ratio) << ',' << r.integrator << ','
            << r.terms << ',' << r.walls << ',' << r.quantity << ',' << show(r.measured) << ','
            << show(r.theory) << ',' << r.note << '\n';
}

} // namespace riprap
