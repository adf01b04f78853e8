// Values that may be an error.
//
// Result<T> is spelled like std::expected<T, Error> (C++23) so that it can become an alias of it.
// Use it for anything a person or a machine can get wrong: a scene file, a shader, a missing GPU.
// Use CHECK (check.hpp) for anything only a programmer can get wrong.

#pragma once

#include <string>
#include <utility>
#include <variant>

namespace engine {

/// Where a person should look: a place in a file they wrote.
struct SourcePlace {
    std::string file; ///< path as the person named it, "scenes/courtyard.lua"
    int line = 0;     ///< 1-based; 0 when the whole file is meant

    bool operator==(const SourcePlace&) const = default;
};

/// One sentence a person can act on, and where.
struct Error {
    std::string message; ///< what was found, then what was expected; no trailing full stop
    SourcePlace place = {};
};

/// "scenes/yard.lua:14: message", or the message alone when no file is known.
std::string to_string(const Error& error);

template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

    [[nodiscard]] bool has_value() const { return state_.index() == 0; }
    explicit operator bool() const { return has_value(); }

    /// @pre has_value()
    [[nodiscard]] T& operator*() & { return std::get<0>(state_); }
    [[nodiscard]] const T& operator*() const& { return std::get<0>(state_); }
    [[nodiscard]] T&& operator*() && { return std::get<0>(std::move(state_)); }
    [[nodiscard]] T* operator->() { return &std::get<0>(state_); }
    [[nodiscard]] const T* operator->() const { return &std::get<0>(state_); }

    /// @pre !has_value()
    [[nodiscard]] const Error& error() const { return std::get<1>(state_); }

private:
    std::variant<T, Error> state_;
};

template <>
class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Error error) : error_(std::move(error)), ok_(false) {}

    [[nodiscard]] bool has_value() const { return ok_; }
    explicit operator bool() const { return ok_; }

    /// @pre !has_value()
    [[nodiscard]] const Error& error() const { return error_; }

private:
    Error error_;
    bool ok_ = true;
};

} // namespace engine
