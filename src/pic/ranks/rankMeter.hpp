/*  What a rank of a scene does and sends in steps, where bricks do not follow the work: messages go
    through it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/sceneTypes.hpp"
#include "core/ranks/rankCosts.hpp"

namespace riprap
{

class RankMeter : public Transport
{
public:

    std::int64_t arrivals = 0;              // particles that came from others

    explicit RankMeter(Transport& by) : by_(by), costs_(by) {}

    int rank() const override { return by_.rank(); }
    int size() const override { return by_.size(); }
    void exchange(const std::vector<RankBytes>& out, std::vector<RankBytes>& in) override
    {
        for (int r = 0; r < size(); ++r) if (r != rank()) send(out[r].size());
        by_.exchange(out, in);
    }
    void swap(const std::vector<RankMessage>& out, std::vector<RankMessage>& in) override
    {
        for (const RankMessage& m : out) send(m.size);
        by_.swap(out, in);
    }
    void sum(std::vector<std::int64_t>& values) override { by_.sum(values); }
    void largest(std::vector<double>& values) override { by_.largest(values); }

    //- Steps begin
    void begin()
    {
        on_ = true;
        costs_.work(true);
    }

    //- They have ended, with so many particles here
    RankReport end(std::size_t owned, std::size_t ghosts)
    {
        on_ = false;
        costs_.work(false);
        RankReport report;
        report.owned = owned;
        report.ghosts = ghosts;
        report.arrivals = arrivals;
        report.bytesInSteps = bytes_;
        report.atWork = costs_.atWork();
        return report;
    }

private:

    void send(std::size_t bytes) { if (on_) bytes_ += std::int64_t(bytes); }

    Transport& by_;
    RankCosts costs_;
    std::int64_t bytes_ = 0;
    bool on_ = false;
};

} // namespace riprap
