#include "tests/atlas/report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace atlas {

namespace {

/// The worst that a case showed, as a row of any table.
struct Row {
    std::string id;
    std::string sentence;
    std::string remedy;
    std::string gate;
    std::string off;
    std::string on;
    std::string verdict;
};

Row row_of(const Outcome& one) {
    const Curve& curve = one.telling();
    const auto number = [](const std::vector<double>& values) {
        return values.empty() ? std::string("-") : fmt::format("{:.4g}", largest(values));
    };
    return {
        one.id,
        one.sentence,
        one.remedy.empty() ? "-" : one.remedy,
        fmt::format("{} <= {:g}", curve.figure, curve.at_most),
        number(curve.off),
        number(curve.on),
        one.verdict()};
}

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string field = "\"";
    for (const char letter : text)
        field += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    return field + "\"";
}

std::string number_at(const std::vector<double>& values, std::size_t step) {
    return step < values.size() ? fmt::format("{:.6g}", values[step]) : std::string();
}

std::string summary(const Findings& found) {
    const auto good =
        std::count_if(found.outcomes.begin(), found.outcomes.end(), [](const Outcome& one) {
            return one.good();
        });
    return fmt::format(
        "{} of {} cases hold, {} are refused, {} cannot occur",
        good,
        found.outcomes.size(),
        found.refusals.size(),
        found.impossible.size());
}

} // namespace

std::string text_table(const Findings& found) {
    std::string text = fmt::format(
        "{:<20} {:<23} {:<46} {:>9} {:>9}  {}\n", "case", "remedy", "gate", "off", "on", "verdict");
    for (const Outcome& one : found.outcomes) {
        const Row row = row_of(one);
        text += fmt::format(
            "{:<20} {:<23} {:<46} {:>9} {:>9}  {}\n",
            row.id,
            row.remedy,
            row.gate,
            row.off,
            row.on,
            row.verdict);
    }
    return text + summary(found) + "\n";
}

std::string markdown_table(const Findings& found) {
    std::string text = "| case | what goes wrong | remedy | gate | off | on | verdict |\n"
                       "|---|---|---|---|--:|--:|---|\n";
    for (const Outcome& one : found.outcomes) {
        const Row row = row_of(one);
        const std::string remedy = one.remedy.empty() ? "-" : "`" + row.remedy + "`";
        text += fmt::format(
            "| {} | {} | {} | {} | {} | {} | {} |\n",
            row.id,
            row.sentence,
            remedy,
            row.gate,
            row.off,
            row.on,
            row.verdict);
    }
    text += "\n| refused | what would go wrong | technique | what it says |\n|---|---|---|---|\n";
    for (const Refusal& one : found.refusals)
        text += fmt::format(
            "| {} | {} | `{}` | {} |\n", one.id, one.sentence, one.technique, one.reason);
    text += "\n| cannot occur | what goes wrong elsewhere | why not here |\n|---|---|---|\n";
    for (const Impossible& one : found.impossible)
        text += fmt::format("| {} | {} | {} |\n", one.id, one.sentence, one.why);
    return text + "\n" + summary(found) + ".\n";
}

std::string csv(const Findings& found) {
    std::string text = "case,remedy,figure,at_most,parameter,off,on\n";
    for (const Outcome& one : found.outcomes)
        for (const Curve& curve : one.curves)
            for (std::size_t step = 0; step < one.steps.size(); ++step)
                text += fmt::format(
                    "{},{},{},{:.6g},{:.6g},{},{}\n",
                    quoted(one.id),
                    one.remedy,
                    quoted(curve.figure),
                    curve.at_most,
                    one.steps[step],
                    number_at(curve.off, step),
                    number_at(curve.on, step));
    return text;
}

std::string json(const Findings& found) {
    nlohmann::json root;
    root["summary"] = summary(found);
    root["cases"] = nlohmann::json::array();
    for (const Outcome& one : found.outcomes) {
        nlohmann::json curves = nlohmann::json::array();
        for (const Curve& curve : one.curves)
            curves.push_back(
                {{"figure", curve.figure},
                 {"at_most", curve.at_most},
                 {"off", curve.off},
                 {"on", curve.on}});
        root["cases"].push_back(
            {{"id", one.id},
             {"sentence", one.sentence},
             {"remedy", one.remedy.empty() ? nlohmann::json() : nlohmann::json(one.remedy)},
             {"verdict", one.verdict()},
             {"good", one.good()},
             {"steps", one.steps},
             {"worst", one.worst},
             {"curves", curves}});
    }
    root["refusals"] = nlohmann::json::array();
    for (const Refusal& one : found.refusals)
        root["refusals"].push_back(
            {{"id", one.id},
             {"sentence", one.sentence},
             {"technique", one.technique},
             {"reason", one.reason}});
    root["impossible"] = nlohmann::json::array();
    for (const Impossible& one : found.impossible)
        root["impossible"].push_back(
            {{"id", one.id}, {"sentence", one.sentence}, {"why", one.why}});
    return root.dump(1);
}

} // namespace atlas
