// SPDX-License-Identifier: GPL-3.0-or-later
/*  Trailing mean over a width of time, of values that are linear between samples at any times:

        mean(t) = 1/T int_(t - T)^t v dt

    exact for such values whatever the steps. It follows a signal T/2 late. Before a time T has
    passed the mean is that since the first sample; of one sample it is the value.
*/
#ifndef runningMean_hpp
#define runningMean_hpp

#include <algorithm>
#include <cstddef>
#include <deque>
#include <vector>

namespace riprap
{

class RunningMean
{
    struct Sample
    {
        double time;
        std::vector<double> values;
    };

    double width_ = 0;                      // [s]
    // the first at or before the window's begin, once there is one
    std::deque<Sample> samples_;

public:

    explicit RunningMean(double width = 0) : width_(width) {}

    //- A time that was there already, or has gone back, takes the place of what came after it
    void add(double time, const std::vector<double>& values)
    {
        while (!samples_.empty()
            && (samples_.back().time >= time || samples_.back().values.size() != values.size()))
        {
            samples_.pop_back();
        }
        samples_.push_back({time, values});

        while (samples_.size() > 1 && samples_[1].time <= time - width_) samples_.pop_front();
    }

    //- Of the window, once it is full; 0: it is not
    std::size_t intervals() const
    {
        const bool full = samples_.size() > 1
            && samples_.back().time - samples_.front().time >= width_;
        return full ? samples_.size() - 1 : 0;
    }

    std::vector<double> mean() const
    {
        if (samples_.empty()) return {};

        std::vector<double> sum(samples_.back().values.size(), 0.0);
        if (samples_.size() == 1) return samples_.back().values;

        const double end = samples_.back().time,
                     begin = std::max(samples_.front().time, end - width_);
        for (std::size_t k = 1; k < samples_.size(); ++k)
        {
            const Sample& a = samples_[k - 1];
            const Sample& b = samples_[k];
            const double from = std::max(a.time, begin), cut = (from - a.time)/(b.time - a.time);
            for (std::size_t i = 0; i < sum.size(); ++i)
            {
                const double first = a.values[i] + cut*(b.values[i] - a.values[i]);
                sum[i] += 0.5*(first + b.values[i])*(b.time - from);
            }
        }
        for (double& s : sum) s /= end - begin;
        return sum;
    }

    //- For a restart: time and values of each sample in turn
    std::vector<double> state() const
    {
        std::vector<double> all;
        for (const Sample& s : samples_)
        {
            all.push_back(s.time);
            all.insert(all.end(), s.values.begin(), s.values.end());
        }
        return all;
    }

    //- @param values  in each sample; a state of another number is not taken
    void restore(const std::vector<double>& state, std::size_t values)
    {
        samples_.clear();
        if (state.size() % (values + 1)) return;
        for (std::size_t k = 0; k < state.size(); k += values + 1)
        {
            add(state[k], {state.begin() + k + 1, state.begin() + k + 1 + values});
        }
    }
};

} // namespace riprap

#endif
