// The table of gates: scene, technique, what moves, figure, limit, and why that limit.

#include "tests/gates/gates.hpp"

#include <initializer_list>

namespace gates {

namespace {

using Gates = std::vector<Gate>;

/// A limit with its reason.
struct Limit {
    double at_most = 0.0;
    std::string why;
};

/// The truth of a light with a size is dear.
constexpr int kSoftFrames = 6;
constexpr const char* kWrongShape =
    "beyond the technique's own texels a wrong pixel is a wrong shape";
constexpr const char* kBitIdentical = "nothing moves";
constexpr const char* kNoPop = "what the eye takes for a sudden change";
constexpr const char* kNeverLate = "whatever moves is redrawn in the same frame";

/// Rasteriser and tracer disagree by 1/16 px: (2 / pi) / 16 of wrong pixels per px of edge.
const Limit kPrecision = {0.04, "edges are the true ones but for 1/16 px"};
/// (2 / pi) / 2.
const Limit kHalfPixel = {0.32, "a texel covers no more than a pixel: half a pixel of edge"};
const Limit kAsStill = {1.0, "as still as the truth sampled half a pixel beside"};
const Limit kNoCrawl = {0.01, "edges follow the true ones; 1/100 px for the mask's 8 bits"};

Gates operator+(Gates gates, const Gates& more) {
    gates.insert(gates.end(), more.begin(), more.end());
    return gates;
}

Gates still(const Limit& eps) {
    return {
        {"still", "false_shadow_far_px", 0.0, kWrongShape},
        {"still", "light_leak_far_px", 0.0, kWrongShape},
        {"still", "eps_px", eps.at_most, eps.why},
        {"still", "changed_px", 0.0, kBitIdentical}};
}

/// The same but for one figure.
Gates but(Gates gates, const char* figure, const Limit& limit) {
    for (Gate& gate : gates)
        if (gate.figure == figure) {
            gate.at_most = limit.at_most;
            gate.why = limit.why;
        }
    return gates;
}

Gates exact_still() {
    return still(kPrecision)
           + Gates{
               {"still", "false_shadow_in_px", 0.0, "exact but for edges"},
               {"still", "light_leak_in_px", 0.0, "exact but for edges"}};
}

/// The camera moves.
Gates camera_moves(
    const Limit& flicker, std::initializer_list<const char*> protocols = {"walk", "yaw", "zoom"}) {
    Gates gates;
    for (const char* protocol : protocols)
        gates = gates
                + Gates{
                    {protocol, "flicker_ratio", flicker.at_most, flicker.why},
                    {protocol, "pop", 0.05, kNoPop},
                    {protocol, "stale_px", 0.005, kNeverLate}};
    return gates;
}

/// Lights or casters move, the camera does not.
Gates scene_moves(const Limit& crawl, std::initializer_list<const char*> protocols) {
    Gates gates;
    for (const char* protocol : protocols)
        gates = gates
                + Gates{
                    {protocol, "crawl_px", crawl.at_most, crawl.why},
                    {protocol, "pop", 0.05, kNoPop},
                    {protocol, "stale_px", 0.005, kNeverLate}};
    return gates;
}

Gates exact(std::initializer_list<const char*> scene_protocols) {
    return exact_still() + camera_moves(kAsStill) + scene_moves(kNoCrawl, scene_protocols);
}

std::vector<Promise> make_promises() {
    const Limit texel_crawl = {
        0.05, "edges step from texel to texel: 0.035 of a pixel at most so far, of 0 that is best"};
    const Limit wide_filter = {
        2.0,
        "a filter of three texels has an edge of grey where the truth has one step: 1.8 so far"};
    const Limit budget = {1.0, "the error that is accepted where nobody says"};
    return {
        {"flat", "planar", exact({"sun", "casters"})},
        {"flat", "volume", exact({"sun", "casters"})},
        {"flat",
         "shadow_texture",
         still(kHalfPixel) + camera_moves({1.5, "its texels are larger than a pixel: 1.2 so far"})
             + scene_moves(
                 {0.08, "all casters share one texture, which grows as they part: 0.06 so far"},
                 {"sun", "casters"})},
        {"flat",
         "cascaded_map@1024",
         still(kHalfPixel) + camera_moves(kAsStill) + scene_moves(texel_crawl, {"sun", "casters"})},
        {"flat",
         "blob",
         {{"still", "eps_px", 1.0, "an ellipse for an outline: 0.9 so far"},
          {"still", "false_shadow_far_px", 0.0, "it is smaller than the true shadow"},
          {"still", "changed_px", 0.0, kBitIdentical},
          {"walk", "pop", 0.05, kNoPop},
          {"casters", "stale_px", 0.005, kNeverLate},
          {"walk",
           "flicker_ratio",
           5.0,
           "its edge is not the true one, so every flip is its own"}}},
        {"flat", "auto", still(budget) + camera_moves(kAsStill, {"walk"})},
        {"yard", "volume", exact({"sun", "casters"})},
        {"yard",
         "shadow_texture",
         still(kHalfPixel) + camera_moves(kAsStill) + scene_moves(texel_crawl, {"sun", "casters"})},
        {"yard",
         "cascaded_map@1024",
         still(kHalfPixel) + camera_moves(kAsStill) + scene_moves(texel_crawl, {"sun", "casters"})},
        {"yard",
         "cascaded_map@512:pcf",
         still(kHalfPixel) + camera_moves(wide_filter)
             + scene_moves(texel_crawl, {"sun", "casters"})},
        {"yard",
         "cascaded_map@256x1",
         still({0.7, "a third of its texels of 1.6 px: 0.54 so far"})
             + camera_moves({4.5, "ramps of two texels, each wider than a pixel: 3.2 so far"})
             + scene_moves({0.12, "a tenth of a texel: 0.09 so far"}, {"sun", "casters"})},
        {"yard", "auto", still(budget) + camera_moves(kAsStill, {"walk"})},
        {"room", "volume", exact({"light", "casters"})},
        {"room",
         "cube_map@512",
         still(kHalfPixel) + camera_moves(kAsStill)
             + scene_moves(texel_crawl, {"light", "casters"})},
        {"room", "auto", still(budget) + camera_moves(kAsStill, {"walk"})},
        {"torch", "volume", exact({"light", "casters"})},
        {"torch",
         "spot_map@1024",
         still(kHalfPixel) + camera_moves(kAsStill)
             + scene_moves(texel_crawl, {"light", "casters"})},
        {"torch",
         "shadow_texture",
         still(kHalfPixel) + camera_moves(kAsStill)
             + scene_moves(texel_crawl, {"light", "casters"})},
        {"torch", "auto", still(budget) + camera_moves(kAsStill, {"walk"})},
        {"field",
         "cascaded_map@64x4:nearest",
         but(
             Gates{
                 {"still", "eps_px", 0.7, "blocks of two pixels and more: 0.54 so far"},
                 {"still", "changed_px", 0.0, kBitIdentical}}
                 + camera_moves(
                     {3.9, "blocks end beside the true edge: 3.5 so far"}, {"walk", "zoom"})
                 + camera_moves({2.8, "blocks end beside the true edge: 2.4 so far"}, {"yaw"}),
             "pop",
             {0.07, "a block is a part of a tile: 0.047 so far"})},
        {"clipped", "planar", exact({"light", "casters"})},
        {"soft",
         "planar@64",
         but(still({0.1, "64 points of the light, 0.35 N^-0.75 of the penumbra's width"})
                 + camera_moves(kAsStill, {"walk"})
                 + scene_moves({0.03, "64 points of the light: 0.012 so far"}, {"light"}),
             "stale_px",
             {0.02, "it is kept in texels of its floor, and drawn anew it is not: 0.007 so far"}),
         kSoftFrames},
        {"soft",
         "cube_map@1024:pcss",
         still(kHalfPixel) + camera_moves(kAsStill, {"walk"}) + scene_moves(texel_crawl, {"light"}),
         kSoftFrames},
        {"soft",
         "shadow_texture@64",
         but(still(kHalfPixel)
                 + camera_moves(
                     {2.2, "sums of hard shadows, each of its texels: 1.7 so far"}, {"walk"})
                 + scene_moves(texel_crawl, {"light"}),
             "false_shadow_far_px",
             {1.0, "a texel's width is no bound of a sum of 64 of them: one pixel so far"}),
         kSoftFrames},
        {"soft", "auto", still(budget), kSoftFrames},
    };
}

} // namespace

const std::vector<Promise>& promises() {
    static const std::vector<Promise> kPromises = make_promises();
    return kPromises;
}

} // namespace gates
