// The one generator of random numbers: small, seeded, the same on every machine.

#pragma once

#include <cstdint>

namespace engine {

/// PCG32. Source: M. O'Neill, "PCG: A Family of Simple Fast Space-Efficient Statistically Good
/// Algorithms for Random Number Generation", 2014.
class Random {
public:
    explicit Random(std::uint64_t seed, std::uint64_t stream = 1)
        : increment_((stream << 1U) | 1U) {
        next();
        state_ += seed;
        next();
    }

    /// Uniform over all 32-bit values.
    std::uint32_t next() {
        const std::uint64_t old = state_;
        state_ = old * 6364136223846793005ULL + increment_;
        const auto shifted = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
        const auto turn = static_cast<std::uint32_t>(old >> 59U);
        return (shifted >> turn) | (shifted << ((32U - turn) & 31U));
    }

    /// Uniform in [0, 1).
    double uniform() { return next() * 0x1p-32; }

    /// Uniform in [low, high).
    double uniform(double low, double high) { return low + (high - low) * uniform(); }

    /// Uniform in [0, count). @pre count > 0
    std::uint32_t below(std::uint32_t count) {
        return static_cast<std::uint32_t>((static_cast<std::uint64_t>(next()) * count) >> 32U);
    }

private:
    std::uint64_t state_ = 0;
    std::uint64_t increment_;
};

} // namespace engine
