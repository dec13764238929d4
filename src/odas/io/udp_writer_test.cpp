// SPDX-License-Identifier: MIT
#include "odas/io/udp_writer.hpp"

#include "support/net_peer.hpp"
#include <gtest/gtest.h>
#include <netinet/in.h>

namespace odas::udp_writer_test {
namespace {

/// A UDP socket of this machine, and its port.
std::pair<FileDescriptor, int> udp_peer() {
  FileDescriptor socket(::socket(AF_INET, SOCK_DGRAM, 0));
  NetAddress here = look_up("127.0.0.1", 0, SOCK_DGRAM).all.front();
  EXPECT_EQ(::bind(socket.get(), here.get(), here.length), 0);
  EXPECT_EQ(::getsockname(socket.get(), reinterpret_cast<sockaddr*>(&here.storage), &here.length), 0);
  return {std::move(socket), here.port()};
}

TEST(UdpWriter, sends_each_record_as_a_datagram) {
  const auto [socket, port] = udp_peer();
  UdpWriter writer("127.0.0.1", port, {});
  EXPECT_TRUE(writer.write(std::string("first")).ok());
  EXPECT_TRUE(writer.write(std::string(20000, 'x')).ok());
  std::string got(65536, '\0');
  EXPECT_EQ(::recv(socket.get(), got.data(), got.size(), 0), 5);
  EXPECT_TRUE(got.starts_with("first"));
  EXPECT_EQ(::recv(socket.get(), got.data(), got.size(), 0), 20000);
  EXPECT_EQ(writer.lost_records(), 0U);
  EXPECT_EQ(writer.where(), "udp 127.0.0.1:" + std::to_string(port));
}

TEST(UdpWriter, goes_on_where_nobody_listens) {
  int port = 0;
  { port = udp_peer().second; }
  std::vector<std::string> said;
  UdpWriter writer("127.0.0.1", port, [&](const std::string& what) { said.push_back(what); });
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(writer.write(std::string("hop")).ok());
  EXPECT_TRUE(said.empty()) << "it is no fault of the sender's";
}

TEST(UdpWriter, tries_the_next_address_of_a_name_where_one_refuses) {
  int nobody = 0;
  { nobody = udp_peer().second; }
  const auto peer = udp_peer();
  UdpWriter writer("peer",
                   {look_up("127.0.0.1", nobody, SOCK_DGRAM).all.front(),
                    look_up("127.0.0.1", peer.second, SOCK_DGRAM).all.front()},
                   {});
  std::string got(16, '\0');
  ASSERT_TRUE(test::eventually([&] {
    return writer.write(std::string("hop")).ok() &&
           ::recv(peer.first.get(), got.data(), got.size(), MSG_DONTWAIT) == 3;
  }));
  EXPECT_TRUE(got.starts_with("hop"));
}

TEST(UdpWriter, a_record_that_no_datagram_holds_is_lost_and_said_once) {
  const auto [socket, port] = udp_peer();
  std::vector<std::string> said;
  UdpWriter writer("127.0.0.1", port, [&](const std::string& what) { said.push_back(what); });
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(writer.write(std::string(UdpWriter::kLongest + 1, 'x')).ok());
  EXPECT_EQ(writer.lost_records(), 3U);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].find("cannot send to udp 127.0.0.1"), std::string::npos) << said[0];
}

TEST(UdpWriter, a_host_that_is_not_known_loses_records_and_is_said) {
  std::vector<std::string> said;
  UdpWriter writer("no such host", 9, [&](const std::string& what) { said.push_back(what); });
  ASSERT_TRUE(test::eventually([&] { return writer.write(std::string("hop")).ok() && !said.empty(); }));
  EXPECT_NE(said[0].find("is not known as a host"), std::string::npos) << said[0];
  EXPECT_GT(writer.lost_records(), 0U);
}

}  // namespace
}  // namespace odas::udp_writer_test
