// What the atlas showed, for people and for other programs.

#pragma once

#include "tests/atlas/sweep.hpp"

#include <span>
#include <string>

namespace atlas {

/// All that a run of the atlas has to tell.
struct Findings {
    std::vector<Outcome> outcomes;
    std::vector<Refusal> refusals;
    std::vector<Impossible> impossible;
};

/// A row a case for the terminal, and the verdict in numbers under them.
std::string text_table(const Findings& found);

/// The same as a table of the manual.
std::string markdown_table(const Findings& found);

/// RFC 4180: a row for each case, gate and step: case, remedy, figure, at_most, parameter, off, on.
/// What was not run is an empty field.
std::string csv(const Findings& found);

/// {"cases": [{id, sentence, remedy, verdict, steps, worst, curves}], "refusals": [...],
/// "impossible": [...]}
std::string json(const Findings& found);

/// One HTML page that needs no other file: for each case its curves and the masks of its worst
/// step.
std::string html_page(const Findings& found);

} // namespace atlas
