// A chart of cost against error: one point for every technique and setting that was tried on a
// light or on a whole scene, and other engines' points beside them. Plain values.

#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace chart {

/// What is counted over the pixels of a light. Those of several lights add up.
struct Errors {
    double valid_px = 0.0; ///< pixels that can be judged
    double wrong_px = 0.0; ///< misclassified ones
    double error_px = 0.0; ///< sum of |V - V*|
    double edge_px = 0.0;  ///< length of the true edge
    /// The least wrong_px, of soft lights error_px, that a shift of 1/16 px and of 1/2 px leaves.
    double precision_floor_px = 0.0;
    double half_pixel_floor_px = 0.0;

    Errors& operator+=(const Errors& other);
};

/// What lies along the horizontal axis, ms a frame.
enum class Across { measured, predicted };
/// What lies along the vertical axis.
enum class Up { wrong_percent, eps_px, error_px };

inline constexpr std::array kAcross = {Across::measured, Across::predicted};
inline constexpr std::array kUp = {Up::wrong_percent, Up::eps_px, Up::error_px};

/// A word without spaces: "measured", "wrong_percent"; keys of files and of the page.
std::string_view word_of(Across across);
std::string_view word_of(Up up);
/// Short, for buttons: "wrong %", "measured ms".
std::string_view short_title_of(Across across);
std::string_view short_title_of(Up up);
/// What the axis says, with its unit.
std::string_view title_of(Across across);
std::string_view title_of(Up up);

/// Pictures as addresses that a page can carry; empty ones were not made.
struct Pictures {
    std::string color;
    std::string mask;
    std::string error;
};

struct Point {
    std::string name;   ///< as one would type it: "map@1024:pcf"; of a peer "ogre pcf 1024"
    std::string series; ///< who drew it: "map", "ogre"; one colour and shape
    std::string family; ///< points of one family differ in size alone and are joined; empty: alone
    std::optional<double> measured_ms; ///< what shadows add to a frame; noise may make it negative
    std::optional<double> predicted_ms;
    std::optional<Errors> errors;
    std::optional<double> wrong_percent; ///< of a peer, whose counts are not known
    std::optional<double> budget_px;     ///< of what was picked: the error that was accepted
    /// The truth itself, to hold others against: never on the front.
    bool is_truth = false;
    std::vector<std::pair<std::string, std::string>> facts; ///< name and value, for people
    Pictures pictures;
};

/// Where a point lies on an axis, or nothing when that was not measured.
std::optional<double> value(const Point& point, Across across);
std::optional<double> value(const Point& point, Up up);

/// A setting that has no point, and why.
struct Refusal {
    std::string name;
    std::string reason;
};

struct Chart {
    std::string scene;
    std::string light; ///< empty: the whole scene
    bool soft = false; ///< some light has an area
    std::vector<Point> points;
    std::vector<Point> peers;
    std::vector<Refusal> refusals;
    std::string truth_mask; ///< a picture's address

    [[nodiscard]] std::string title() const;
    /// points and peers, in this order: how files and the page count them.
    [[nodiscard]] std::vector<const Point*> all() const;
};

/// What to look at first: wrong pixels, and where a light is soft the error per px of edge, since
/// no pixel of a penumbra is right or wrong.
Up usual_up(std::span<const Chart> charts);

/// A line that no picture of one sample a pixel gets below.
struct Floor {
    std::string name;
    double value = 0.0;
};

/// Of the chart's truth on an axis. Those of soft lights are known as error px and eps alone.
std::vector<Floor> floors(const Chart& chart, Up up);

} // namespace chart
