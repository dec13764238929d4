// SPDX-License-Identifier: MIT
#include "odas/io/hop_encoder.hpp"
#include "odas/io/text_buffer.hpp"

namespace odas {
namespace {

constexpr Wanted kPotentialsAlone{
    .potentials = true, .tracks = false, .separated = false, .postfiltered = false};
constexpr Wanted kTracksAlone{.potentials = false, .tracks = true, .separated = false, .postfiltered = false};
constexpr std::size_t kAroundSize = 96;  // of the text around a list, with its stamp
constexpr std::size_t kPotentialSize = 64 + 4 * TextBuffer::kFixedSize;
constexpr std::size_t kTrackSize =
    96 + TextBuffer::kIntegerSize + TextBuffer::quoted_size(63) + 4 * TextBuffer::kFixedSize;

void put_xyz(TextBuffer& text, Vec3 direction) {
  text.put("\"x\": ");
  text.put_fixed(direction.x);
  text.put(", \"y\": ");
  text.put_fixed(direction.y);
  text.put(", \"z\": ");
  text.put_fixed(direction.z);
}

void put_row(TextBuffer& text, const Potential& potential) {
  text.need(kPotentialSize);
  text.put("        { ");
  put_xyz(text, potential.direction);
  text.put(", \"E\": ");
  text.put_fixed(potential.energy);
  text.put(" }");
}

void put_row(TextBuffer& text, const Track& track) {
  text.need(kTrackSize);
  text.put("        { \"id\": ");
  text.put_integer(track.id);
  text.put(", \"tag\": ");
  text.put_quoted(track.tag.view());
  text.put(", ");
  put_xyz(text, track.direction);
  text.put(", \"activity\": ");
  text.put_fixed(track.activity);
  text.put(" }");
}

/// A track as nothing but its class.
struct ClassRow {
  const Track& track;
};

void put_row(TextBuffer& text, const ClassRow& row) {
  text.need(kAroundSize);
  text.put("        { \"category\": \"");
  text.put(row.track.category == Category::speech ? "speech" : "nonspeech");
  text.put("\" }");
}

/// `Row`: as what each item is written.
template <class Row, class Item>
std::span<const char> put_hop(TextBuffer& text, HopIndex time, std::span<const Item> rows) {
  text.clear();
  text.need(kAroundSize);
  text.put("{\n    \"timeStamp\": ");
  text.put_integer(time);
  text.put(",\n    \"src\": [\n");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    put_row(text, Row{rows[i]});
    text.need(kAroundSize);
    if (i + 1 < rows.size()) text.put(',');
    text.put('\n');
  }
  text.put("    ]\n}\n");
  return text.text();
}

class OdasJsonPotentials : public HopEncoder {
 public:
  [[nodiscard]] Wanted wanted() const noexcept override { return kPotentialsAlone; }
  [[nodiscard]] std::span<const char> encode(const HopResult& hop) override {
    return put_hop<const Potential&>(text_, hop.time, hop.potentials);
  }

 private:
  TextBuffer text_{TextBuffer::kUsualSize};
};

class OdasJsonTracks : public HopEncoder {
 public:
  [[nodiscard]] Wanted wanted() const noexcept override { return kTracksAlone; }
  [[nodiscard]] std::span<const char> encode(const HopResult& hop) override {
    return put_hop<const Track&>(text_, hop.time, hop.tracks);
  }

 private:
  TextBuffer text_{TextBuffer::kUsualSize};
};

class OdasJsonCategories : public HopEncoder {
 public:
  [[nodiscard]] Wanted wanted() const noexcept override { return kTracksAlone; }
  [[nodiscard]] std::span<const char> encode(const HopResult& hop) override {
    return put_hop<ClassRow>(text_, hop.time, hop.tracks);
  }

 private:
  TextBuffer text_{TextBuffer::kUsualSize};
};

class BinaryPotentials : public HopEncoder {
 public:
  [[nodiscard]] Wanted wanted() const noexcept override { return kPotentialsAlone; }
  [[nodiscard]] std::span<const char> encode(const HopResult& hop) override {
    values_.clear();
    for (const Potential& p : hop.potentials) {
      values_.insert(values_.end(), {p.direction.x, p.direction.y, p.direction.z, p.energy});
    }
    return {reinterpret_cast<const char*>(values_.data()), values_.size() * sizeof(float)};
  }

 private:
  std::vector<float> values_;  // grows once
};

}  // namespace

std::unique_ptr<HopEncoder> make_odas_json_potentials() { return std::make_unique<OdasJsonPotentials>(); }
std::unique_ptr<HopEncoder> make_odas_json_tracks() { return std::make_unique<OdasJsonTracks>(); }
std::unique_ptr<HopEncoder> make_odas_json_categories() { return std::make_unique<OdasJsonCategories>(); }
std::unique_ptr<HopEncoder> make_binary_potentials() { return std::make_unique<BinaryPotentials>(); }

}  // namespace odas
