#include "jobs/contest/folder_image.h"

#include "core/error.h"
#include "core/files.h"
#include "core/hash.h"

#include <utility>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

class FolderImage final : public Contestant {
  public:
    FolderImage(const OutsideMethod& outside, std::string view) : outside_(outside), view_(std::move(view)) {}

    std::string_view code() const override { return "folder_image"; }

    std::string digest(bool) const override {
        const VisibilityReading& reading = outside_.reading;
        Digest digest;
        digest.text(reading.channel).value(reading.coding == Coding::srgb).value(reading.invert);
        std::error_code ec;
        const fs::path file = path();
        if (fs::is_regular_file(file, ec)) digest.text(read_file(file));
        return digest.hex();
    }

    ContestantImage image(const ContestantSources& sources) const override {
        const fs::path file = path();
        if (file.empty()) {
            throw file_error("has no image of the view " + view_,
                             (outside_.folder / "contestant.json").string() + ": images");
        }
        const ImageF image =
            read_outside_image(file, outside_.reading, sources.frame.width(), sources.frame.height());
        return {{image, image, {}, {}}, {}};
    }

  private:
    /// Empty where the folder names none for the view.
    fs::path path() const {
        const auto found = outside_.images.find(view_);
        return found == outside_.images.end() ? fs::path() : outside_.folder / found->second;
    }

    const OutsideMethod& outside_;
    std::string view_;
};

}  // namespace

std::shared_ptr<const Contestant> folder_image(const OutsideMethod& outside, const std::string& view) {
    return std::make_shared<FolderImage>(outside, view);
}

}  // namespace aoscore
