#include "page/document/page_template.h"

#include "core/error.h"
#include "core/json_text.h"
#include "core/printable.h"

#include <kainjow/mustache.hpp>

namespace aoscore {
namespace {

using kainjow::mustache::data;

data mustache_data(const nlohmann::json& value) {
    switch (value.type()) {
        case nlohmann::json::value_t::string:
            return data(printable_lines(value.get_ref<const std::string&>()));
        case nlohmann::json::value_t::boolean:
            return data(value.get<bool>());
        case nlohmann::json::value_t::array: {
            data list(data::type::list);
            for (const auto& item : value) list.push_back(mustache_data(item));
            return list;
        }
        case nlohmann::json::value_t::object: {
            data object(data::type::object);
            for (const auto& [name, member] : value.items()) object.set(name, mustache_data(member));
            return object;
        }
        default:
            throw internal_error("the page's model holds " + quoted_json(value) + ", which has no text",
                                 "page");
    }
}

}  // namespace

std::string fill_template(const std::string& text, const nlohmann::json& model, const std::string& where) {
    kainjow::mustache::mustache filled(text);
    if (!filled.is_valid()) throw file_error(filled.error_message(), where, "a Mustache template");
    return filled.render(mustache_data(model));
}

std::string escaped_html(const std::string& text) {
    return kainjow::mustache::html_escape(text);
}

std::string script_json(const nlohmann::json& value) {
    std::string text;
    for (const char c : printable_lines(json_text(value))) {
        if (c == '<') {
            text += "\\u003c";
        } else {
            text += c;
        }
    }
    return text;
}

std::string data_block(const std::string& name, const std::string& text) {
    return "<script type=\"application/octet-stream\" data-image=\"" + escaped_html(name) + "\">" + text +
           "</script>\n";
}

}  // namespace aoscore
