#pragma once

#include "screen/gl/context.h"

#include <memory>

namespace aoscore {

/// A context of OSMesa. Its source is the only one that sees the library.
class OsmesaContext final : public GlContext {
  public:
    /// Creates the context and makes it current. Throws internal_error when the library gives none.
    OsmesaContext();
    ~OsmesaContext() override;

    void make_current() override;
    Function function(const char* name) const override;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace aoscore
