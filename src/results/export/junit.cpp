#include "results/export/export_format.h"

#include <fmt/format.h>
#include <pugixml.hpp>

#include <algorithm>
#include <sstream>

namespace aoscore {
namespace {

/// XML has no control characters, not even escaped ones.
std::string printable(std::string text) {
    for (char& c : text) {
        if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') c = '?';
    }
    return text;
}

void add_case(pugi::xml_node suite, const ExportTable& table, const ExportRow& row) {
    pugi::xml_node test = suite.append_child("testcase");
    test.append_attribute("classname") = printable(row.names.front()).c_str();
    test.append_attribute("name") = printable(row.name).c_str();
    pugi::xml_node properties = test.append_child("properties");
    for (std::size_t i = 1; i < row.names.size(); ++i) {
        pugi::xml_node property = properties.append_child("property");
        property.append_attribute("name") = table.name_columns[i].c_str();
        property.append_attribute("value") = printable(row.names[i]).c_str();
    }
    for (std::size_t i = 0; i < row.numbers.size(); ++i) {
        if (!row.numbers[i]) continue;
        pugi::xml_node property = properties.append_child("property");
        property.append_attribute("name") = table.columns[i].key.c_str();
        property.append_attribute("value") = fmt::format("{}", *row.numbers[i]).c_str();
    }
    for (const std::string& failure : row.failures)
        test.append_child("failure").append_attribute("message") = printable(failure).c_str();
    if (!row.error.empty())
        test.append_child("error").append_attribute("message") = printable(row.error).c_str();
}

}  // namespace

std::string export_as::junit(const ExportTable& table) {
    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "UTF-8";
    pugi::xml_node suites = document.append_child("testsuites");
    suites.append_attribute("name") = printable(table.title).c_str();
    std::vector<std::string> groups;
    for (const ExportRow& row : table.rows) {
        if (std::ranges::find(groups, row.names.front()) == groups.end()) groups.push_back(row.names.front());
    }
    for (const std::string& group : groups) {
        pugi::xml_node suite = suites.append_child("testsuite");
        suite.append_attribute("name") = printable(group).c_str();
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
