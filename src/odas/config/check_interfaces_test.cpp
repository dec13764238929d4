// SPDX-License-Identifier: MIT
#include "support/config_faults.hpp"

#include "odas/config/checks.hpp"

namespace odas::check_interfaces_test {
namespace {

using test::clean;
using test::errs;
using test::read_changed;
using test::read_with;
using test::warns;

LoadedConfiguration with_source(const std::string& interface) {
  return read_changed("nChannels = 2;", "nChannels = 2; interface: { " + interface + " };");
}

LoadedConfiguration with_text(const std::string& section, const std::string& stream,
                              const std::string& format, const std::string& type) {
  return read_with(section + ": { " + stream + ": { format = \"" + format + "\"; interface: { type = \"" +
                   type + "\"; path = \"out\"; ip = \"127.0.0.1\"; port = 9000; }; }; };");
}

TEST(CheckInterfaces, want_what_the_kind_of_source_needs) {
  EXPECT_TRUE(
      errs(with_source(R"(type = "file";)"), "raw.interface.path", "is missing; type = \"file\" needs it"));
  EXPECT_TRUE(errs(with_source(R"(type = "socket"; port = 1;)"), "raw.interface.ip", "is missing"));
  EXPECT_TRUE(errs(with_source(R"(type = "socket"; ip = "127.0.0.1";)"), "raw.interface.port", "is missing"));
  EXPECT_TRUE(errs(with_source(R"(type = "soundcard_name";)"), "raw.interface.devicename", "is missing"));
  EXPECT_TRUE(errs(with_source(R"(type = "pulseaudio";)"), "raw.interface.source", "is missing"));
  EXPECT_TRUE(clean(with_source(R"(type = "soundcard"; card = 1; device = 0;)")));
  EXPECT_TRUE(clean(with_source(R"(type = "pulseaudio"; source = "mic"; channelmap = ("left", "right");)")));
}

TEST(CheckInterfaces, want_a_token_of_a_sender_from_beyond_this_machine) {
  EXPECT_TRUE(clean(with_source(R"(type = "stdin";)")));
  EXPECT_TRUE(clean(with_source(R"(type = "socket_listen"; port = 9000;)")));
  EXPECT_TRUE(errs(with_source(R"(type = "socket_listen";)"), "raw.interface.port", "is missing"));
  EXPECT_TRUE(errs(with_source(R"(type = "socket_listen"; ip = "0.0.0.0"; port = 9000;)"),
                   "raw.interface.token", "is missing"));
  EXPECT_TRUE(
      clean(with_source(R"(type = "socket_listen"; ip = "0.0.0.0"; port = 9000; token = "secret";)")));
}

TEST(CheckInterfaces, take_the_formats_of_samples_by_their_names_in_ALSA) {
  const auto with_format = [](const std::string& format) {
    return read_changed("nChannels = 2;", "nChannels = 2; format = \"" + format + "\";");
  };
  for (const char* format : {"auto", "S8", "U8", "S16_LE", "S24_LE", "S24_3LE", "S32_LE", "FLOAT_LE"}) {
    EXPECT_TRUE(clean(with_format(format))) << format;
  }
  EXPECT_TRUE(errs(with_format("S24"), "raw.format", "must be"));
}

TEST(CheckInterfaces, keep_the_microphones_in_a_file_of_its_own) {
  const auto recording = [](const std::string& interface, const std::string& from = "a.raw") {
    return read_changed("nChannels = 2;", "nChannels = 2; interface: { type = \"file\"; path = \"" + from +
                                              "\"; }; record: { interface: { " + interface + " }; };");
  };
  EXPECT_TRUE(clean(recording(R"(type = "file"; path = "mics.wav";)")));
  EXPECT_TRUE(errs(recording(R"(type = "file";)"), "raw.record.interface.path", "is missing"));
  EXPECT_TRUE(errs(recording(R"(type = "file"; path = "mics.wav";)", "mics.wav"), "raw.record.interface.path",
                   "the file of raw.interface already"));
  EXPECT_TRUE(errs(recording(R"(type = "socket"; ip = "127.0.0.1"; port = 1;)"), "raw.record.interface.type",
                   "must be"));
}

TEST(CheckInterfaces, want_one_position_for_each_channel_of_pulseaudio) {
  EXPECT_TRUE(errs(with_source(R"(type = "pulseaudio"; source = "mic"; channelmap = ("left");)"),
                   "raw.interface.channelmap", "has 1 names, but raw.nChannels is 2"));
}

TEST(CheckInterfaces, know_that_a_source_is_no_sink_and_a_sink_no_source) {
  EXPECT_TRUE(
      errs(with_source(R"(type = "terminal";)"), "raw.interface.type", "must be \"blackhole\", \"file\""));
  EXPECT_TRUE(
      errs(with_text("sst", "tracked", "json", "soundcard"), "sst.tracked.interface.type", "must be"));
  EXPECT_TRUE(errs(read_with(R"(sss: { separated: { interface: { type = "terminal"; }; }; };)"),
                   "sss.separated.interface.type", "cannot show sound"));
}

TEST(CheckInterfaces, take_every_pair_that_ODAS_takes) {
  for (const char* type : {"file", "socket", "terminal"}) {
    EXPECT_TRUE(clean(with_text("ssl", "potential", "json", type))) << type;
    EXPECT_TRUE(clean(with_text("sst", "tracked", "json", type))) << type;
    EXPECT_TRUE(clean(with_text("classify", "category", "json", type))) << type;
  }
  EXPECT_TRUE(clean(with_text("ssl", "potential", "binary", "file")));
  EXPECT_TRUE(clean(with_text("ssl", "potential", "undefined", "blackhole")));
}

TEST(CheckInterfaces, take_JSON_lines_and_ignore_the_format_of_what_nobody_hears) {
  EXPECT_TRUE(clean(with_text("sst", "tracked", "jsonl", "file")));
  EXPECT_TRUE(clean(with_text("sst", "tracked", "jsonl", "terminal")));
  EXPECT_TRUE(clean(with_text("sst", "tracked", "json", "blackhole"))) << "ODAS refuses this one";
}

TEST(CheckInterfaces, refuse_pairs_that_cannot_be_written) {
  EXPECT_TRUE(errs(with_text("sst", "tracked", "undefined", "file"), "sst.tracked.format",
                   "is \"undefined\", but the interface is a file; must be \"json\" or \"jsonl\""));
  EXPECT_TRUE(errs(read_with(R"(sst: { tracked: { interface: { type = "terminal"; }; }; };)"),
                   "sst.tracked.format", "is missing, but the interface is a terminal"));
  EXPECT_TRUE(errs(with_text("ssl", "potential", "binary", "terminal"), "ssl.potential.format",
                   "which a terminal cannot show"));
  EXPECT_TRUE(errs(with_text("sst", "tracked", "binary", "file"), "sst.tracked.format",
                   "which only ssl.potential can be"));
}

TEST(CheckInterfaces, load_a_placeholder_for_an_address_and_say_so) {
  const auto loaded =
      read_with(R"(sss: { separated: { interface: { type = "socket"; ip = "<IP>"; port = 10000; }; }; };)");
  EXPECT_TRUE(loaded.ok());
  EXPECT_TRUE(warns(loaded, "sss.separated.interface.ip", "put the address of the peer here"));
}

TEST(CheckInterfaces, refuse_two_writers_of_one_file) {
  const auto loaded = read_with(R"(sss: {
    separated: { interface: { type = "file"; path = "voices.raw"; }; };
    postfiltered: { interface: { type = "file"; path = "./voices.raw"; }; }; };)");
  EXPECT_TRUE(errs(loaded, "sss.postfiltered.interface.path", "the file of sss.separated.interface already"));
  EXPECT_TRUE(clean(read_with(R"(sss: {
    separated: { interface: { type = "file"; path = "/dev/null"; }; };
    postfiltered: { interface: { type = "file"; path = "/dev/null"; }; }; };)")));
}

TEST(CheckInterfaces, A_listener_beyond_this_machine_needs_a_token) {
  const auto control = [](const std::string& keys) {
    return read_with("sst: { control: { interface: { type = \"socket_listen\"; " + keys + " }; }; };");
  };
  const char* const path = "sst.control.interface.token";
  EXPECT_TRUE(errs(control(R"(ip = "0.0.0.0"; port = 9010;)"), path, "beyond this machine"));
  EXPECT_TRUE(control(R"(ip = "0.0.0.0"; port = 9010; token = "s3cret";)").ok());
  EXPECT_TRUE(control(R"(port = 9010;)").ok());
  EXPECT_TRUE(control(R"(ip = "::1"; port = 9010;)").ok());
  EXPECT_TRUE(errs(control(""), "sst.control.interface.port", "is missing"));
}

LoadedConfiguration with_places(const std::string& places) {
  return read_with("sst: { tracked: { format = \"json\"; interfaces = (" + places + "); }; };");
}

TEST(CheckInterfaces, A_stream_may_go_to_many_places_each_with_a_format_of_its_own) {
  const auto loaded = with_places(R"({ type = "socket"; ip = "studio.local"; port = 9000; },
      { type = "file"; path = "tracks.jsonl"; format = "jsonl"; }, { type = "socket_listen"; port = 9100; },
      { type = "udp"; ip = "::1"; port = 9200; }, { type = "stdout"; })");
  ASSERT_TRUE(clean(loaded));
  ASSERT_EQ(loaded.config.tracked.interfaces.size(), 5U);
  const auto places = places_of("sst.tracked", loaded.config.tracked);
  ASSERT_EQ(places.size(), 6U);
  EXPECT_EQ(places[2].path, "sst.tracked.interfaces[1]");
  EXPECT_EQ(places[1].format, "json");
  EXPECT_EQ(places[2].format, "jsonl");
  EXPECT_TRUE(loaded.config.pipeline.wanted.tracks) << "though its first interface is none";
}

TEST(CheckInterfaces, Each_place_is_held_to_what_it_can_be) {
  EXPECT_TRUE(errs(with_places(R"({ type = "file"; path = "t"; format = "binary"; })"),
                   "sst.tracked.interfaces[0].format", "which only ssl.potential can be"));
  EXPECT_TRUE(
      errs(with_places(R"({ type = "udp"; ip = "a"; })"), "sst.tracked.interfaces[0].port", "is missing"));
  EXPECT_TRUE(errs(with_places(R"({ type = "socket_listen"; ip = "::"; port = 9000; })"),
                   "sst.tracked.interfaces[0].token", "is missing"));
  EXPECT_TRUE(errs(with_places(R"({ type = "file"; path = "t"; }, { type = "file"; path = "./t"; })"),
                   "sst.tracked.interfaces[1].path", "the file of sst.tracked.interfaces[0] already"));
  EXPECT_TRUE(errs(
      with_places(R"({ type = "socket_listen"; port = 9000; }, { type = "socket_listen"; port = 9000; })"),
      "sst.tracked.interfaces[1].port", "the port of sst.tracked.interfaces[0] already"));
  EXPECT_TRUE(errs(with_places(R"({ type = "stdout"; }, { type = "terminal"; })"),
                   "sst.tracked.interfaces[1].type", "where sst.tracked.interfaces[0] goes already"));
  EXPECT_TRUE(clean(with_places(R"({ type = "terminal"; }, { type = "terminal"; })"))) << "as in ODAS";
}

TEST(CheckInterfaces, A_block_of_sound_must_fit_a_datagram) {
  const auto loaded = read_with(R"(sss: { separated: { hopSize = 10000; nBits = 16;
    interface: { type = "udp"; ip = "127.0.0.1"; port = 1; }; }; };)");
  EXPECT_TRUE(errs(loaded, "sss.separated.hopSize", "makes blocks of 80000 bytes; a datagram holds 65507"));
}

}  // namespace
}  // namespace odas::check_interfaces_test
