// SPDX-License-Identifier: MIT
#include "odas/studio/web_stream.hpp"

#include <string>
#include <vector>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <gtest/gtest.h>

namespace odas::web_stream_test {
namespace {

namespace asio = boost::asio;
using Tcp = asio::ip::tcp;

/// Two ends of a connection on loopback.
struct Ends {
  Ends() {
    Tcp::acceptor acceptor(io, {asio::ip::address_v4::loopback(), 0});
    Tcp::socket socket(io);
    socket.connect(acceptor.local_endpoint());
    near.emplace(WebStream::Plain(std::move(socket)));
    far.emplace(WebStream::Plain(acceptor.accept()));
  }
  asio::io_context io;
  std::optional<WebStream> near, far;
};

TEST(WebStream, takes_longer_sequences_of_buffers_than_it_holds_at_once) {
  Ends ends;
  std::string sent;
  std::vector<std::string> pieces;
  for (int i = 0; i < 50; ++i)
    pieces.push_back(i % 7 == 0 ? "" : std::string(std::size_t(i) * 10, char('a' + i % 26)));
  std::vector<asio::const_buffer> buffers;
  for (const std::string& piece : pieces) {
    sent += piece;
    buffers.push_back(asio::buffer(piece));
  }
  std::string heard(sent.size(), ' ');
  asio::async_write(*ends.near, buffers, [](auto error, std::size_t) { EXPECT_FALSE(error); });
  asio::async_read(*ends.far, asio::buffer(heard), [](auto error, std::size_t) { EXPECT_FALSE(error); });
  ends.io.run();
  EXPECT_EQ(heard, sent);
}

TEST(WebStream, tells_that_the_other_end_is_gone) {
  Ends ends;
  ends.near.reset();
  std::string heard(1, ' ');
  WebStream::Error told;
  ends.far->async_read_some(asio::buffer(heard), [&](auto error, std::size_t) { told = error; });
  ends.io.run();
  EXPECT_EQ(told, asio::error::eof);
  EXPECT_FALSE(ends.far->is_secure());
}

}  // namespace
}  // namespace odas::web_stream_test
