#include "core/printable.h"
#include "results/export/export_format.h"

#include <fmt/format.h>
#include <pugixml.hpp>

#include <algorithm>
#include <sstream>

namespace aoscore {
namespace {

// Every text is made printable: XML cannot hold some code points, not even escaped.
void add_case(pugi::xml_node suite, const ExportTable& table, const ExportRow& row) {
    pugi::xml_node test = suite.append_child("testcase");
    test.append_attribute("classname") = printable_lines(row.names.front()).c_str();
    test.append_attribute("name") = printable_lines(row.name).c_str();
    pugi::xml_node properties = test.append_child("properties");
    const auto add_property = [&](const std::string& name, const std::string& value) {
        pugi::xml_node property = properties.append_child("property");
        property.append_attribute("name") = name.c_str();
        property.append_attribute("value") = printable(value).c_str();
    };
    for (std::size_t i = 1; i < row.names.size(); ++i) add_property(table.name_columns[i], row.names[i]);
    for (std::size_t i = 0; i < row.numbers.size(); ++i) {
        if (row.numbers[i]) add_property(table.columns[i].key, fmt::format("{}", *row.numbers[i]));
    }
    for (std::size_t i = 0; i < row.texts.size(); ++i) add_property(table.text_columns[i], row.texts[i]);
    for (const std::string& failure : row.failures)
        test.append_child("failure").append_attribute("message") = printable_lines(failure).c_str();
    if (!row.error.empty())
        test.append_child("error").append_attribute("message") = printable_lines(row.error).c_str();
}

}  // namespace

std::string export_as::junit(const ExportTable& table) {
    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "UTF-8";
    pugi::xml_node suites = document.append_child("testsuites");
    suites.append_attribute("name") = printable_lines(table.title).c_str();
    std::vector<std::string> groups;
    for (const ExportRow& row : table.rows) {
        if (std::ranges::find(groups, row.names.front()) == groups.end()) groups.push_back(row.names.front());
    }
    for (const std::string& group : groups) {
        pugi::xml_node suite = suites.append_child("testsuite");
        suite.append_attribute("name") = printable_lines(group).c_str();
        int tests = 0, failures = 0, errors = 0;
        for (const ExportRow& row : table.rows) {
            if (row.names.front() != group) continue;
            ++tests;
            failures += !row.failures.empty();
            errors += !row.error.empty();
            add_case(suite, table, row);
        }
        suite.append_attribute("tests") = tests;
        suite.append_attribute("failures") = failures;
        suite.append_attribute("errors") = errors;
    }
    std::ostringstream out;
    document.save(out, " ");
    return out.str();
}

}  // namespace aoscore
