/*  What picStability and picDemStability measure: rows, printed as they come, and written as CSV
    where a file is named.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>

namespace riprap
{

class PicRows
{
public:

    explicit PicRows(const std::string& csv) : name_(csv)
    {
        if (csv.empty()) return;
        csv_.open(csv);
        csv_ << "test,kind,setting,quantity,measured\n";
        write();
    }

    void add(const std::string& test, const std::string& kind, double setting,
        const std::string& quantity, double measured)
    {
        std::printf("%-10s %-32s %10.4g  %-50s %12.5g\n", test.c_str(), kind.c_str(), setting,
            quantity.c_str(), measured);
        std::fflush(stdout);
        if (name_.empty()) return;
        char numbers[2][32];
        std::snprintf(numbers[0], sizeof numbers[0], "%.6g", setting);
        std::snprintf(numbers[1], sizeof numbers[1], "%.6g", measured);
        csv_ << test << ",\"" << kind << "\"," << numbers[0] << ",\"" << quantity << "\","
            << numbers[1] << std::endl;
    }

    //- Rows are there already: did all of them reach the file?
    void write() const
    {
        if (!name_.empty() && !csv_) throw std::runtime_error("cannot write " + name_);
    }

private:

    std::string name_;
    std::ofstream csv_;
};

} // namespace riprap
