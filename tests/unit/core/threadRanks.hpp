/*  Ranks that are threads of one process: what tests need of several.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <omp.h>
#include "core/ranks/transport.hpp"

namespace riprap
{

//- What the threads share
class ThreadBoard
{
public:
    explicit ThreadBoard(int ranks)
        : bytes(ranks, std::vector<RankBytes>(ranks)), sums(ranks), numbers(ranks), ranks_(ranks)
    {}

    std::vector<std::vector<RankBytes>> bytes;      // [from][to]
    std::vector<std::vector<std::int64_t>> sums;
    std::vector<std::vector<double>> numbers;

    //- All have come here. Where one has failed the others do not wait for it
    void meet()
    {
        std::unique_lock<std::mutex> lock(mutex_);
        const long long turn = turn_;
        if (++here_ == ranks_) { here_ = 0; ++turn_; changed_.notify_all(); return; }
        changed_.wait(lock, [&] { return turn_ != turn || failed_; });
        if (turn_ == turn) throw std::runtime_error("another rank has failed");
    }
    void fail()
    {
        std::lock_guard<std::mutex> lock(mutex_);
        failed_ = true;
        changed_.notify_all();
    }

private:
    int ranks_, here_ = 0;
    long long turn_ = 0;
    bool failed_ = false;
    std::mutex mutex_;
    std::condition_variable changed_;
};

class ThreadTransport : public Transport
{
public:
    ThreadTransport(ThreadBoard& board, int rank, int size)
        : board_(board), rank_(rank), size_(size)
    {}

    int rank() const override { return rank_; }
    int size() const override { return size_; }

    void exchange(const std::vector<RankBytes>& out, std::vector<RankBytes>& in) override
    {
        const Call call(*this);
        for (int r = 0; r < size_; ++r) board_.bytes[rank_][r] = out[r];
        board_.meet();
        in.assign(size_, RankBytes());
        for (int r = 0; r < size_; ++r) in[r] = board_.bytes[r][rank_];
        board_.meet();
    }

    void swap(const std::vector<RankMessage>& out, std::vector<RankMessage>& in) override
    {
        const Call call(*this);
        for (RankBytes& b : board_.bytes[rank_]) b.clear();
        for (const RankMessage& m : out)
            board_.bytes[rank_][m.rank].assign(m.bytes, m.bytes + m.size);
        board_.meet();
        std::size_t foreseen = 0, came = 0;
        bool fits = true;
        for (RankMessage& m : in)
        {
            const RankBytes& b = board_.bytes[m.rank][rank_];
            fits = fits && b.size() == m.size;
            foreseen += b.size();
            std::copy_n(b.begin(), std::min(b.size(), m.size), m.bytes);
        }
        for (int r = 0; r < size_; ++r) came += board_.bytes[r][rank_].size();
        board_.meet();
        if (!fits || foreseen != came)
            throw std::logic_error(
                "a message of another length than foreseen, or from a rank that was not");
    }

    void sum(std::vector<std::int64_t>& values) override
    { reduce(values, board_.sums, [](std::int64_t a, std::int64_t b) { return a + b; }); }
    void largest(std::vector<double>& values) override
    { reduce(values, board_.numbers, [](double a, double b) { return std::max(a, b); }); }

private:

    template<class T, class Op>
    void reduce(std::vector<T>& values, std::vector<std::vector<T>>& all, Op op)
    {
        const Call call(*this);
        all[rank_] = values;
        board_.meet();
        for (int r = 0; r < size_; ++r)
        {
            if (all[r].size() != values.size())
                throw std::logic_error("ranks reduce different numbers of values");
            for (std::size_t k = 0; k < values.size(); ++k)
                values[k] = r == 0 ? all[r][k] : op(values[k], all[r][k]);
        }
        board_.meet();
    }

    ThreadBoard& board_;
    int rank_, size_;
};

//- f(transport) on so many ranks. What one of them throws is thrown here
template<class F>
void onRanks(int ranks, F f)
{
    ThreadBoard board(ranks);
    std::vector<std::exception_ptr> errors(ranks);
    std::vector<std::thread> threads;
    std::mutex mutex;
    std::exception_ptr first;
    for (int r = 0; r < ranks; ++r)
        threads.emplace_back([&, r]
        {
            omp_set_num_threads(1);
            ThreadTransport transport(board, r, ranks);
            try { f(static_cast<Transport&>(transport)); }
            catch (...)
            {
                {
                    std::lock_guard<std::mutex> lock(mutex);
                    if (!first) first = std::current_exception();
                }
                board.fail();
            }
        });
    for (std::thread& t : threads) t.join();
    if (first) std::rethrow_exception(first);
}

} // namespace riprap
