// SPDX-License-Identifier: MIT
#pragma once

#include "odas/studio/server_body.hpp"
#include "odas/studio/web_stream.hpp"

namespace odas {

/// Answers the requests of a connection, one after another, until it goes or asks for a WebSocket.
void start_http_session(WebStream stream, StudioServer::Body& server);

}  // namespace odas
