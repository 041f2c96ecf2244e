#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace aoscore {

/// Fills a Mustache template with a model of objects, lists, texts and booleans; numbers must be texts, so
/// that the model decides on their digits. {{name}} is escaped for HTML, {{{name}}} is not. `where` names the
/// template in errors. Throws file_error for a template that is no Mustache.
std::string fill_template(const std::string& text, const nlohmann::json& model, const std::string& where);

/// The text with <, >, &, " and ' escaped for HTML.
std::string escaped_html(const std::string& text);

/// A value as the text of a script element of type application/json, escaped so that it cannot end the
/// element.
std::string script_json(const nlohmann::json& value);

/// A script element of a type that browsers do not run, with dense_text() of a zlib stream; the page's scripts
/// find it by its name.
std::string data_block(const std::string& name, const std::string& text);

}  // namespace aoscore
