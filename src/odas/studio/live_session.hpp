// SPDX-License-Identifier: MIT
#pragma once

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>

#include "odas/studio/server_body.hpp"
#include "odas/studio/web_stream.hpp"

namespace odas {

/// Makes of a connection that asked for it, by `request`, a WebSocket: messages of the browser go to
/// the hall, what its feed holds to the browser. It lives until either end drops it.
void start_live_session(WebStream stream, StudioServer::Body& server, Role role,
                        boost::beast::http::request<boost::beast::http::string_body> request);

}  // namespace odas
