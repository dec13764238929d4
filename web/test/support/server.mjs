// SPDX-License-Identifier: MIT
// Serves a folder as the daemon serves the page: same types, same policy. It answers no WebSocket: tests route those.
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";

const kTypes = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".css": "text/css; charset=utf-8",
  ".svg": "image/svg+xml",
  ".txt": "text/plain; charset=utf-8",
};

export const kPolicy =
  "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; connect-src 'self'; " +
  "media-src 'self' blob:; worker-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/** Resolves with the server, listening on a port of the system's choice on `host`. */
export function serve(folder, host = "127.0.0.1") {
  const server = createServer(async (request, response) => {
    const path = normalize(new URL(request.url, "http://page").pathname);
    const name = path === "/" ? "/index.html" : path;
    try {
      const body = await readFile(join(folder, name));
      response.writeHead(200, {
        "Content-Type": kTypes[extname(name)] ?? "application/octet-stream",
        "Content-Security-Policy": kPolicy,
        "X-Content-Type-Options": "nosniff",
        "Cache-Control": "no-cache",
      });
      response.end(body);
    } catch {
      response.writeHead(404, { "Content-Type": "text/plain" });
      response.end("not found\n");
    }
  });
  return new Promise((resolve) => server.listen(0, host, () => resolve(server)));
}
