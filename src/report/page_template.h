#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace aoscore {

/// Fills a Mustache template with a model of objects, lists, texts and booleans; numbers must be texts
/// already, so that the model decides on their digits. {{name}} is escaped for HTML, {{{name}}} is not.
/// `where` names the template in errors. Throws file_error for a template that is no Mustache.
std::string fill_template(const std::string& text, const nlohmann::json& model, const std::string& where);

}  // namespace aoscore
