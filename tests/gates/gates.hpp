// Gates of accuracy and stability: what every technique promises on small committed scenes,
// standing still and in every motion. A gate is one figure of `gnomon measure` that stays at or
// below a limit, and says why that limit is the right one.

#pragma once

#include "engine/core/result.hpp"
#include "systems/shadows/remedies.hpp"

#include <span>
#include <string>
#include <vector>

#include "tools/measure/report.hpp"

namespace gates {

/// One figure of one row.
struct Gate {
    std::string protocol; ///< what moves, one of gnomon::protocol_names()
    std::string figure;   ///< a column of measure::Report
    double at_most = 0.0;
    std::string
        why; ///< as good as it can be; or what keeps the technique from that, and by how much
};

/// What a technique promises on a scene.
struct Promise {
    std::string scene;     ///< file name without its ending
    std::string technique; ///< as on the command line
    std::vector<Gate> gates;
    int frames = 16; ///< of each sequence; the same for all of a scene
};

/// Every gate there is.
const std::vector<Promise>& promises();
/// @pre there is one
const Promise& promise(const std::string& scene, const std::string& technique);
/// Of those promises, each once, in the order of promises().
std::vector<std::string> scenes();

/// A gate that was not passed.
struct Broken {
    Gate gate;
    std::string sentence; ///< scene, light, technique, protocol, figure, value, limit, command
};

/// Measures the scene's rows for some of its promises: all techniques in one run, since they share
/// the truth.
/// Errors: no OpenGL here, or a scene that cannot be loaded.
engine::Result<std::vector<measure::Row>>
measure_promises(std::span<const Promise> promised, const shadows::Remedies& remedies = {});

/// The value of a figure in a row; missing with a reason where the row does not have it.
/// @pre a column of stills or sequences
measure::Figure figure_of(const measure::Row& row, const std::string& name);

/// @pre rows hold the promise's technique and protocols
const measure::Row&
row_of(std::span<const measure::Row> rows, const Promise& promised, const std::string& protocol);

/// A figure that could not be measured breaks its gate, too.
std::vector<Broken> broken_gates(const Promise& promised, std::span<const measure::Row> rows);

/// What shows a row to a person who stands in the project's folder.
std::string command_of(const Promise& promised, const std::string& protocol);

} // namespace gates
