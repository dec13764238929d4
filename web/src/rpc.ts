// SPDX-License-Identifier: MIT
// Commands to the daemon and their answers.
import type { Reply, RpcError } from "./socket/messages";

/** A command that was refused or failed: `code` is one of docs/protocol.md, or `offline`. */
export class CommandError extends Error {
  readonly code: string;
  readonly data: unknown;

  constructor(error: RpcError) {
    super(error.message);
    this.code = error.code;
    this.data = error.data;
  }
}

interface Waiting {
  resolve(result: unknown): void;
  reject(error: CommandError): void;
}

export class Rpc {
  private next = 1;
  private readonly waiting = new Map<number, Waiting>();

  /** `send` gives false when nobody is connected. */
  constructor(private readonly send: (text: string) => boolean) {}

  /** Runs a command of the daemon. Rejects with a `CommandError`. */
  call<Result = unknown>(method: string, params: object = {}): Promise<Result> {
    const id = this.next++;
    return new Promise<Result>((resolve, reject) => {
      this.waiting.set(id, { resolve: resolve as (result: unknown) => void, reject });
      if (!this.send(JSON.stringify({ id, method, params }))) {
        this.waiting.delete(id);
        reject(offline());
      }
    });
  }

  answer(reply: Reply): void {
    const waiting = this.waiting.get(reply.id);
    if (!waiting) return;
    this.waiting.delete(reply.id);
    if (reply.error) waiting.reject(new CommandError(reply.error));
    else waiting.resolve(reply.result);
  }

  /** The connection is gone: nobody will answer any more. */
  abandon(): void {
    const all = [...this.waiting.values()];
    this.waiting.clear();
    for (const waiting of all) waiting.reject(offline());
  }
}

function offline(): CommandError {
  return new CommandError({ code: "offline", message: "There is no connection to the daemon." });
}
